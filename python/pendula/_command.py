"""What the console scripts share: language, options, the program `pendula`, and how they end."""

from __future__ import annotations

import json
import os
import shutil
import signal
import subprocess
import sys
import sysconfig
import textwrap
from contextlib import suppress
from pathlib import Path
from typing import IO, TYPE_CHECKING, Any, NamedTuple, TypeAlias

import numpy as np

from pendula._arguments import Parameters
from pendula._core import Status, language_of, version
from pendula._solution import Solution

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Sequence

DONE, BAD_DATA, BAD_USAGE, NOT_WRITTEN, INTERRUPTED = map(int, Status)

LANGUAGES = ("en", "es")
Text: TypeAlias = tuple[str, str]
"""English and Spanish, with {} where values go."""

TEXTS: dict[str, Text] = {
    "usage": ("usage: {0}", "uso: {0}"),
    "lang": ("language of messages: en, es", "idioma de los mensajes: en, es"),
    "help": ("show this and end", "muestra esto y termina"),
    "version": ("show the version and end", "muestra la versión y termina"),
    "unknown option": ("unknown option {0!r}; see {1} --help", "opción desconocida {0!r}; consulta {1} --help"),
    "no value": ("option {0} needs a value", "la opción {0} necesita un valor"),
    "a value": ("option {0} takes no value", "la opción {0} no lleva valor"),
    "twice": ("option {0} is given twice", "la opción {0} está dos veces"),
    "which language": ("--lang must be en or es, got {0!r}", "--lang debe ser en o es, y es {0!r}"),
    "not written": ("standard output could not be written: {0}", "no se ha podido escribir la salida estándar: {0}"),
    "closed": (
        "standard output could not be written: it is closed",
        "no se ha podido escribir la salida estándar: está cerrada",
    ),
    "too many rows": ("the problems have too many rows", "los problemas tienen demasiadas filas"),
    "no program": (
        "the program pendula is neither among this Python's scripts nor on PATH",
        "el programa pendula no está entre los de este Python ni en PATH",
    ),
}

NO_MATPLOTLIB: Text = (
    "matplotlib is missing; install it with: pip install 'pendula[plot]'",
    "falta matplotlib; instálalo con: pip install 'pendula[plot]'",
)


def say(text: Text, lang: str, *values: object, **named: object) -> str:
    """A text in a language, with its values."""
    return text[LANGUAGES.index(lang)].format(*values, **named)


class RefusedError(Exception):
    """Ends a script with a status and, unless somebody else has told it, what is wrong."""

    def __init__(self, status: int, text: Text | None = None, *values: object) -> None:
        super().__init__(text[0].format(*values) if text else f"pendula ended with status {status}")
        self.status, self.text, self.values = status, text, values


class Option(NamedTuple):
    """An option, or an argument that the manual explains beside the options."""

    name: str
    about: Text
    value: str = ""
    """What the manual calls its value; empty for a switch."""


class Command(NamedTuple):
    """A console script, as its manual shows it."""

    name: str
    usage: str
    """What follows the name."""
    about: Text
    options: tuple[Option, ...]


COMMON = (Option("--lang", TEXTS["lang"], "L"), Option("--help", TEXTS["help"]), Option("--version", TEXTS["version"]))


def run(command: Command, work: Callable[[dict[str, str], list[str], str], int]) -> int:
    """A console script: does the work with its options, other words and language, and returns the status to end with."""
    arguments = sys.argv[1:]
    lang = language_of([word.encode(errors="replace").decode() for word in arguments])  # names of files need be no text
    try:
        given, rest = read_options(command, arguments)
        if "--help" in given:
            write(manual(command, lang))
        elif "--version" in given:
            write(f"{command.name} {version}\n")
        else:
            return work(given, rest, lang)
    except RefusedError as refused:
        if refused.text is not None:
            tell(f"{command.name}: {say(refused.text, lang, *refused.values)}")
        return refused.status
    except KeyboardInterrupt:
        signal.signal(signal.SIGINT, signal.SIG_IGN)  # once is enough: what is left is to end
        return INTERRUPTED
    return DONE


def read_options(command: Command, arguments: Sequence[str]) -> tuple[dict[str, str], list[str]]:
    """The options given, with their values, and the words that belong to none of the command's."""
    options = {option.name: option for option in (*command.options, *COMMON) if option.name.startswith("--")}
    given: dict[str, str] = {}
    rest = []
    words = iter(arguments)
    for word in words:
        name, equals, value = word.partition("=")
        name = "--help" if name == "-h" else name
        if name not in options:
            rest.append(word)
            continue
        if name in given:
            raise RefusedError(BAD_USAGE, TEXTS["twice"], name)
        if not options[name].value and equals:
            raise RefusedError(BAD_USAGE, TEXTS["a value"], name)
        if options[name].value:
            value = value if equals else next(words, "")
            if not value or (not equals and value.startswith("--")):
                raise RefusedError(BAD_USAGE, TEXTS["no value"], name)
        given[name] = value
    if given.get("--lang", "en") not in LANGUAGES:
        raise RefusedError(BAD_USAGE, TEXTS["which language"], given["--lang"])
    return given, rest


def manual(command: Command, lang: str) -> str:
    """What --help shows."""
    options = [*command.options, *COMMON]
    words = [f"{option.name} {option.value}".strip() for option in options]
    indent = " " * (max(map(len, words)) + 4)
    lines = [say(TEXTS["usage"], lang, f"{command.name} {command.usage}"), ""]
    lines += [*textwrap.wrap(say(command.about, lang), 80), ""]
    for option, word in zip(options, words, strict=True):
        lead = f"  {word}".ljust(len(indent))
        lines += textwrap.wrap(say(option.about, lang), 80, initial_indent=lead, subsequent_indent=indent)
    return "\n".join(lines) + "\n"


def write(text: str) -> None:
    """Writes all of a text to standard output, as UTF-8; a reader that has closed the pipe has had enough.

    Not through sys.stdout, whose buffer would be written, and fail, once more at the end.
    """
    if sys.stdout is None:  # it was closed when Python started; its number may be that of another file
        raise RefusedError(NOT_WRITTEN, TEXTS["closed"])
    left = memoryview(text.encode(errors="backslashreplace"))
    try:
        while left:
            left = left[os.write(1, left) :]
    except BrokenPipeError:
        return
    except OSError as error:
        raise RefusedError(NOT_WRITTEN, TEXTS["not written"], error.strerror) from error


def tell(message: str) -> None:
    """Writes a line to standard error; there is nobody to tell if that fails."""
    if sys.stderr is not None:
        with suppress(OSError):
            os.write(2, f"{message}\n".encode(errors="backslashreplace"))


class Solved(NamedTuple):
    """A problem as the program read and solved it."""

    solution: Solution
    every: float
    """Time between rows [s]."""
    until: float
    """The last time asked for [s]."""


COLUMNS = ("t", "theta", "omega", "turns")
MOST_CHARACTERS = 1 << 28  # some three million rows


def solve(arguments: Sequence[str], problems: IO[bytes] | None = None, *, states_problem: bool = False) -> list[Solved]:
    """What the program prints, to the last bit, for problems from a file, else from standard input.

    states_problem: the arguments are those of `pendula solve` and state the one problem. RefusedError where the program is not
    found or does not end with status 0.
    """
    lines = printed([*(["solve"] if states_problem else []), "--columns", ",".join(COLUMNS), *arguments], problems)
    solved: list[tuple[dict[str, Any], list[list[float]]]] = []
    for values in lines:
        if "problem" in values:
            solved.append((values, []))
        else:
            solved[-1][1].append([np.nan if values[name] is None else values[name] for name in COLUMNS])
    return [_solved(problem, rows) for problem, rows in solved]


def printed(arguments: Sequence[str], problems: IO[bytes] | None = None) -> Iterator[dict[str, Any]]:
    """What the program prints, to the last bit, as an object a line; it reads from a file, else from standard input.

    RefusedError where the program is not found or does not end with status 0.
    """
    # A word of the arguments may be the name of a command, which comes first.
    command = [path(), *arguments, "--format", "json", "--precision", "full"]
    with subprocess.Popen(command, stdin=problems, stdout=subprocess.PIPE, encoding="utf-8") as process:
        try:
            assert process.stdout is not None
            text = process.stdout.read(MOST_CHARACTERS + 1)
            if len(text) > MOST_CHARACTERS:
                raise RefusedError(BAD_USAGE, TEXTS["too many rows"])
            status = process.wait()
        except BaseException:
            process.kill()  # nobody wants its results any more
            raise
    if status != 0:  # negative: the signal that ended it
        raise RefusedError(status if status > 0 else 128 - status)
    return map(json.loads, text.splitlines())


def path() -> str:
    """The program among this Python's scripts, or the user's, or on PATH; never one of the current directory."""
    scripts = (sysconfig.get_path("scripts"), sysconfig.get_path("scripts", f"{os.name}_user"))
    folders = (*scripts, *os.environ.get("PATH", os.defpath).split(os.pathsep))
    found = shutil.which("pendula", path=os.pathsep.join(folder for folder in folders if Path(folder).is_absolute()))
    if found is None:
        raise RefusedError(BAD_USAGE, TEXTS["no program"])
    return found


def _solved(problem: dict[str, Any], rows: list[list[float]]) -> Solved:
    t, theta, omega, turns = np.array(rows, float).reshape(-1, len(COLUMNS)).T.copy()
    given = {name: float(problem[name]) for name in Parameters._fields if name in problem}
    tolerance = float(problem.get("tolerance", 1e-15))
    solution = Solution(t, theta, omega, turns, Parameters(**given), problem["method"], problem.get("dt"), tolerance)
    return Solved(solution, float(problem["every"]), float(problem["until"]))
