"""What `pendula check` says, in both languages. Numbers are in seconds and radians, or as the table has them."""

from pendula.check._texts_columns import COLUMNS, TIMES
from pendula.check._texts_states import STATES, WHERE

UNREADABLE = {
    "directory": ("{0!r} is a directory, no table", "{0!r} es un directorio, no una tabla"),
    "no file": ("{0!r} does not exist", "{0!r} no existe"),
    "no permission": ("{0!r} may not be read", "no hay permiso para leer {0!r}"),
    "not read": ("{0!r} could not be read: {1}", "no se ha podido leer {0!r}: {1}"),
    "too large": ("{0!r} is larger than {1} MiB", "{0!r} ocupa más de {1} MiB"),
    "empty": ("{0!r} is empty", "{0!r} está vacío"),
    "binary": ("{0!r} is no text: it holds control characters", "{0!r} no es texto: contiene caracteres de control"),
    "no table": (
        "there is no table: no line of two numbers or more",
        "no hay ninguna tabla: ninguna línea de dos números o más",
    ),
    "no problems": ("{0!r} holds no problem that could be read", "{0!r} no trae ningún problema que se pueda leer"),
}

REGIMES = {
    -1: ("it is smaller, the pendulum oscillates (k = −1)", "es menor, el péndulo oscila (k = −1)"),
    0: ("it is equal (k = 0)", "es igual (k = 0)"),
    1: ("it is larger, the pendulum turns over (k = 1)", "es mayor, el péndulo se voltea (k = 1)"),
}

REPORT = {
    "table": ("Table {0}", "Tabla {0}"),
    "right": ("right", "bien"),
    "wrong": ("wrong", "mal"),
    "rows": ("{0} rows of {1}", "{0} filas de {1}"),
    "column": (
        "{0}: {1} of {2} rows right; at most {3:.1e} from the closed form, {4:.1e} from Runge-Kutta",
        "{0}: {1} de {2} filas bien; como mucho a {3:.1e} de la solución exacta y a {4:.1e} de Runge-Kutta",
    ),
    "sine": ("{0}: {1} of {2} rows right", "{0}: {1} de {2} filas bien"),
    "remark": ("remark: ", "nota: "),
    "summary": ("{0} of {1} tables right.", "{0} de {1} tablas bien."),
    "too many tables": ("There are {0} tables for {1} problems.", "Hay {0} tablas para {1} problemas."),
}

FINDINGS = {name: tuple(text + place for text, place in zip(texts, WHERE, strict=True)) for name, texts in STATES.items()}
FINDINGS |= TIMES | COLUMNS
FINDINGS["table missing"] = ("There is no table for this problem.", "No hay tabla para este problema.")

OPTIONS = {
    "about": (
        "Marks a table that a student's program has printed: compares it with the closed form and with Runge-Kutta, and tells "
        "what mistake explains it. Status: 0 right, 1 wrong, 2 unreadable.",
        "Corrige la tabla que ha escrito el programa de un estudiante: la compara con la solución exacta y con Runge-Kutta, y "
        "dice qué error la explica. Estado: 0 bien, 1 mal, 2 ilegible.",
    ),
    "table": (
        "file with the tables; - for standard input",
        "fichero con las tablas; - es la entrada estándar",
    ),
    "input": (
        "file with the problem or problems, as pendula reads them",
        "fichero con el problema o los problemas, como los lee pendula",
    ),
    "json": ("a report for machines", "un informe para máquinas"),
    "strict": ("remarks make a table wrong, too", "también las notas hacen que una tabla esté mal"),
    "lang": ("language of messages", "idioma de los mensajes"),
    "help": ("show this and end", "muestra esto y termina"),
}
