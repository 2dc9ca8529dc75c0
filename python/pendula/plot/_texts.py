"""What `pendula plot` says, in both languages, with {0}, {1} where values go."""

TEXTS = {
    "about": {
        "en": "Draws angle and velocity against time, and phase space. Problems come from standard input, or one from options: "
        "those of pendula and of pendula solve (see pendula --help).",
        "es": "Dibuja el ángulo y la velocidad frente al tiempo, y el espacio de fases. Los problemas llegan por la entrada "
        "estándar, o uno por opciones: las de pendula y pendula solve (consulta pendula --help).",
    },
    "output": {
        "en": "picture: .png, .svg or .pdf; animation: .gif or .mp4; a window where left out",
        "es": "dibujo: .png, .svg o .pdf; animación: .gif o .mp4; si falta, una ventana",
    },
    "animate": {
        "en": "the pendulum swinging beside its phase plane",
        "es": "el péndulo junto a su plano de fases, en movimiento",
    },
    "speed": {"en": "of the animation; 1 is real time", "es": "de la animación; 1 es tiempo real"},
    "flow": {"en": "arrows of the flow in phase space", "es": "flechas del flujo en el espacio de fases"},
    "dpi": {"en": "pixels per inch", "es": "píxeles por pulgada"},
    "lang": {"en": "language of messages", "es": "idioma de los mensajes"},
    "help": {"en": "show this and end", "es": "muestra esto y termina"},
    "not positive": {"en": "{0} must be a positive number, got {1!r}", "es": "{0} debe ser un número positivo, y es {1!r}"},
    "suffix": {"en": "--output must end in {0}, got {1!r}", "es": "--output debe terminar en {0}, y es {1!r}"},
    "no display": {
        "en": "there is no display to open a window on; name a file with --output",
        "es": "no hay pantalla en la que abrir una ventana; da el nombre de un fichero con --output",
    },
    "one problem": {
        "en": "an animation shows one problem of two rows or more, got {0} of {1}",
        "es": "una animación muestra un problema de dos filas o más, y hay {0} de {1}",
    },
    "too many": {
        "en": "a picture shows at most {1} problems, got {0}",
        "es": "un dibujo muestra {1} problemas como mucho, y hay {0}",
    },
    "ffmpeg": {
        "en": "MP4 needs the program ffmpeg, which is not there; GIF does not",
        "es": "MP4 necesita el programa ffmpeg, que no está; GIF no",
    },
    "not written": {"en": "{0!r} could not be written: {1}", "es": "no se ha podido escribir {0!r}: {1}"},
}
