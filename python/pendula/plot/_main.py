"""`pendula plot`: draws what the program computes."""

from __future__ import annotations

import io
import math
import os
import stat
import subprocess
import sys
from pathlib import Path
from typing import TYPE_CHECKING

from pendula._command import (
    BAD_DATA,
    BAD_USAGE,
    DONE,
    NO_MATPLOTLIB,
    NOT_WRITTEN,
    Command,
    Option,
    RefusedError,
    Text,
    run,
    solve,
)
from pendula.plot._figures import animate, phase_portrait, time_series
from pendula.plot._style import new_figure

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.animation import FuncAnimation
    from matplotlib.figure import Figure

    from pendula._solution import Solution

PICTURES, FILMS = (".png", ".svg", ".pdf"), (".gif", ".mp4")
MOST_PROBLEMS = 40  # each is a row of the picture
MOST_PIXELS = 1 << 15  # along a side; matplotlib's limit is twice that

# What the program takes together with problems from standard input; any other option states one.
READING_OPTIONS = ("--method", "--tolerance")

PLOT = Command(
    "pendula plot",
    "[--output FILE] [--flow] [--animate] ...",
    (
        "Draws angle and velocity against time, and phase space. Problems come from standard input, or one from options: those "
        "of pendula and of pendula solve (see pendula --help).",
        "Dibuja el ángulo y la velocidad frente al tiempo, y el espacio de fases. Los problemas llegan por la entrada "
        "estándar, o uno por opciones: las de pendula y pendula solve (consulta pendula --help).",
    ),
    (
        Option(
            "--output",
            (
                "picture: .png, .svg or .pdf; animation: .gif or .mp4; a window where left out",
                "dibujo: .png, .svg o .pdf; animación: .gif o .mp4; si falta, una ventana",
            ),
            "FILE",
        ),
        Option("--flow", ("arrows of the flow in phase space", "flechas del flujo en el espacio de fases")),
        Option(
            "--animate",
            ("the pendulum swinging beside its phase plane", "el péndulo junto a su plano de fases, en movimiento"),
        ),
        Option("--speed", ("of the animation; 1 is real time", "de la animación; 1 es tiempo real"), "S"),
        Option("--dpi", ("pixels per inch", "píxeles por pulgada"), "N"),
    ),
)

TEXTS: dict[str, Text] = {
    "not positive": ("{0} must be a positive number, got {1!r}", "{0} debe ser un número positivo, y es {1!r}"),
    "suffix": ("--output must end in {0}, got {1!r}", "--output debe terminar en {0}, y es {1!r}"),
    "no display": (
        "there is no display to open a window on; name a file with --output",
        "no hay pantalla en la que abrir una ventana; da el nombre de un fichero con --output",
    ),
    "one problem": (
        "an animation shows one problem of two rows or more, got {0} of {1}",
        "una animación muestra un problema de dos filas o más, y hay {0} de {1}",
    ),
    "too many": (
        "a picture shows at most {1} problems, got {0}",
        "un dibujo muestra {1} problemas como mucho, y hay {0}",
    ),
    "too large": (
        "at --dpi {0:g} the picture would have {1:.6g} pixels along a side, more than {2}",
        "con --dpi {0:g} el dibujo tendría {1:.6g} píxeles de lado, más de {2}",
    ),
    "too slow": (
        "at --speed {0:g} a frame would last longer than a minute",
        "con --speed {0:g} un fotograma duraría más de un minuto",
    ),
    "ffmpeg": (
        "MP4 needs the program ffmpeg, which is not there; GIF does not",
        "MP4 necesita el programa ffmpeg, que no está; GIF no",
    ),
    "input": (
        "{0!r} is what standard input is read from; write to another file",
        "{0!r} es de donde se lee la entrada estándar; escribe en otro fichero",
    ),
    "not written": ("{0!r} could not be written: {1}", "no se ha podido escribir {0!r}: {1}"),
}


def main() -> int:
    """The console script."""
    return run(PLOT, _plot)


def _plot(given: dict[str, str], words: list[str], lang: str) -> int:
    dpi, speed = _positive("--dpi", given.get("--dpi", "150")), _positive("--speed", given.get("--speed", "1"))
    output, is_film = given.get("--output"), "--animate" in given
    suffixes = FILMS if is_film else PICTURES
    if output is None:
        _require_display()
    elif Path(output).suffix.lower() not in suffixes:
        raise RefusedError(BAD_USAGE, TEXTS["suffix"], ", ".join(suffixes), output)
    elif _is_input(output):
        raise RefusedError(BAD_USAGE, TEXTS["input"], output)
    _require_matplotlib(has_window=output is None)
    states_problem = any(word.startswith("--") and word.split("=")[0] not in READING_OPTIONS for word in words)
    solved = solve([*words, "--lang", lang], states_problem=states_problem)
    solutions = [each.solution for each in solved]
    if is_film:
        film = _film(solutions, speed, dpi)
    else:
        picture = _picture(solutions, "--flow" in given, dpi)
    if output is None:
        from matplotlib import pyplot

        pyplot.show()
        return DONE
    try:
        if is_film:
            film.save(output, writer=_writer(output), dpi=dpi)
        else:
            _save(picture, output, dpi)
    except (OSError, subprocess.CalledProcessError) as error:  # the file, ffmpeg
        reason = error.strerror if isinstance(error, OSError) else None
        raise RefusedError(NOT_WRITTEN, TEXTS["not written"], output, reason or error) from error
    return DONE


def _is_input(output: str) -> bool:
    """Whether the file, by whatever name, is what standard input is read from."""
    try:
        given, written = os.fstat(0), Path(output).stat()
    except OSError:
        return False
    return stat.S_ISREG(given.st_mode) and os.path.samestat(given, written)


def _positive(name: str, text: str) -> float:
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not 0 < value < math.inf:
        raise RefusedError(BAD_USAGE, TEXTS["not positive"], name, text)
    return value


def _require_display() -> None:
    if sys.platform.startswith("linux") and not (os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY")):
        raise RefusedError(BAD_USAGE, TEXTS["no display"])


def _require_matplotlib(has_window: bool) -> None:
    try:
        from matplotlib import pyplot
    except ImportError:
        raise RefusedError(BAD_USAGE, NO_MATPLOTLIB) from None
    if not has_window:
        pyplot.switch_backend("agg")


def _picture(solutions: Sequence[Solution], flow: bool, dpi: float) -> Figure:
    """A row for each problem: time series and phase portrait."""
    if len(solutions) > MOST_PROBLEMS:
        raise RefusedError(BAD_DATA, TEXTS["too many"], len(solutions), MOST_PROBLEMS)
    figure = _figure((10, 3.8 * len(solutions)), dpi)
    rows = figure.subplots(len(solutions), 2, squeeze=False)
    for solution, (series, portrait) in zip(solutions, rows, strict=True):
        time_series(solution, ax=series)
        phase_portrait(solution, ax=portrait, flow=flow)
    return figure


def _film(solutions: Sequence[Solution], speed: float, dpi: float) -> FuncAnimation:
    if len(solutions) != 1 or solutions[0].t.size < 2:
        raise RefusedError(BAD_DATA, TEXTS["one problem"], len(solutions), solutions[0].t.size)
    figure = _figure((8, 4), dpi)
    try:
        return animate(solutions[0], figure=figure, speed=speed)
    except ValueError:
        raise RefusedError(BAD_USAGE, TEXTS["too slow"], speed) from None


def _figure(size: tuple[float, float], dpi: float) -> Figure:
    side = max(size) * dpi
    if side > MOST_PIXELS:
        raise RefusedError(BAD_USAGE, TEXTS["too large"], dpi, side, MOST_PIXELS)
    return new_figure(size)


def _save(picture: Figure, output: str, dpi: float) -> None:
    """All of the picture at once, so that an interruption leaves no half of it."""
    data = io.BytesIO()
    picture.savefig(data, format=Path(output).suffix[1:].lower(), dpi=dpi)
    Path(output).write_bytes(data.getbuffer())


def _writer(output: str) -> str:
    from matplotlib.animation import FFMpegWriter

    if output.lower().endswith(".gif"):
        return "pillow"
    if not FFMpegWriter.isAvailable():
        raise RefusedError(BAD_USAGE, TEXTS["ffmpeg"])
    return "ffmpeg"
