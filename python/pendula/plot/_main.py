"""`pendula plot`: draws what the program computes."""

from __future__ import annotations

import argparse
import math
import os
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

from pendula import _program
from pendula._language import LANGUAGES, language
from pendula.plot._animation import animate
from pendula.plot._axes import pyplot
from pendula.plot._portrait import phase_portrait
from pendula.plot._series import time_series
from pendula.plot._texts import TEXTS

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.figure import Figure

    from pendula import Solution

BAD_DATA, BAD_USAGE, NOT_WRITTEN, INTERRUPTED = 1, 2, 3, 130  # the program's

PICTURES, FILMS = (".png", ".svg", ".pdf"), (".gif", ".mp4")
MOST_PROBLEMS = 40  # each is a row of the picture

# What the program takes together with problems from standard input; any other option states one.
READING_OPTIONS = ("--method", "--tolerance")


class RefusedError(Exception):
    """What is wrong, as a name in TEXTS with its values, and the status to end with."""

    def __init__(self, status: int, name: str, *values: object) -> None:
        super().__init__(name)
        self.status, self.name, self.values = status, name, values


def main() -> int:
    """The console script."""
    arguments = sys.argv[1:]
    lang = language(arguments)
    try:
        return _run(arguments, lang)
    except RefusedError as refused:
        message, status = TEXTS[refused.name][lang].format(*refused.values), refused.status
    except (ImportError, FileNotFoundError) as missing:  # matplotlib, the program
        message, status = str(missing), BAD_USAGE
    except _program.FailedError as failed:
        return failed.status
    except KeyboardInterrupt:
        return INTERRUPTED
    print(f"pendula plot: {message}", file=sys.stderr)
    return status


def _run(arguments: Sequence[str], lang: str) -> int:
    options, rest = _parser(lang).parse_known_args(arguments)
    dpi, speed = _positive("--dpi", options.dpi), _positive("--speed", options.speed)
    suffixes = FILMS if options.animate else PICTURES
    if options.output is None:
        _require_display()
    elif Path(options.output).suffix.lower() not in suffixes:
        raise RefusedError(BAD_USAGE, "suffix", ", ".join(suffixes), options.output)
    plt = pyplot()
    if options.output is not None:
        plt.switch_backend("agg")
    states_problem = any(word.startswith("--") and word.split("=")[0] not in READING_OPTIONS for word in rest)
    solved = _program.solve([*(["solve"] if states_problem else []), *rest, "--lang", lang])
    solutions = [each.solution for each in solved]
    if options.animate:
        _show(_film(solutions, speed), options.output, dpi)
    else:
        _show(_picture(solutions, options.flow), options.output, dpi)
    return 0


def _parser(lang: str) -> argparse.ArgumentParser:
    def text(name: str) -> str:
        return TEXTS[name][lang]

    parser = argparse.ArgumentParser("pendula plot", description=text("about"), allow_abbrev=False, add_help=False)
    parser.add_argument("--output", metavar="FILE", help=text("output"))
    parser.add_argument("--flow", action="store_true", help=text("flow"))
    parser.add_argument("--animate", action="store_true", help=text("animate"))
    parser.add_argument("--speed", default="1", metavar="S", help=text("speed"))
    parser.add_argument("--dpi", default="150", metavar="N", help=text("dpi"))
    parser.add_argument("--lang", choices=LANGUAGES, help=text("lang"))
    parser.add_argument("--help", action="help", help=text("help"))
    return parser


def _positive(name: str, text: str) -> float:
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not 0 < value < math.inf:
        raise RefusedError(BAD_USAGE, "not positive", name, text)
    return value


def _require_display() -> None:
    if sys.platform.startswith("linux") and not (os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY")):
        raise RefusedError(BAD_USAGE, "no display")


def _picture(solutions: Sequence[Solution], flow: bool) -> Figure:
    """A row for each problem: time series and phase portrait."""
    if len(solutions) > MOST_PROBLEMS:
        raise RefusedError(BAD_DATA, "too many", len(solutions), MOST_PROBLEMS)
    size = (10, 3.8 * len(solutions))
    figure, rows = pyplot().subplots(len(solutions), 2, figsize=size, layout="constrained", squeeze=False)
    for solution, (series, portrait) in zip(solutions, rows, strict=True):
        time_series(solution, ax=series)
        phase_portrait(solution, ax=portrait, flow=flow)
    return figure  # type: ignore[no-any-return]


def _film(solutions: Sequence[Solution], speed: float) -> Any:
    if len(solutions) != 1 or solutions[0].t.size < 2:
        raise RefusedError(BAD_DATA, "one problem", len(solutions), solutions[0].t.size)
    return animate(solutions[0], speed=speed)


def _show(drawn: Any, output: str | None, dpi: float) -> None:
    """Saves a figure or an animation, or opens a window."""
    if output is None:
        pyplot().show()
        return
    try:
        if hasattr(drawn, "savefig"):
            drawn.savefig(output, dpi=dpi)
        else:
            drawn.save(output, dpi=dpi, writer=_writer(output))
    except OSError as error:
        raise RefusedError(NOT_WRITTEN, "not written", output, error.strerror or error) from error


def _writer(output: str) -> str:
    from matplotlib.animation import FFMpegWriter

    if output.lower().endswith(".gif"):
        return "pillow"
    if not FFMpegWriter.isAvailable():
        raise RefusedError(BAD_USAGE, "ffmpeg")
    return "ffmpeg"
