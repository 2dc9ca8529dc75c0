"""`pendula check`: marks the tables of a file."""

from __future__ import annotations

from itertools import zip_longest

from pendula._command import BAD_DATA, BAD_USAGE, TEXTS, Command, Option, RefusedError, Text, run, say, solve, write
from pendula.check._judge import judge
from pendula.check._problem import asked
from pendula.check._report import Mark, Marks, as_json, as_text, unreadable_as_json
from pendula.check._table import UNREADABLE, UnreadableError, opened, read_file

CHECK = Command(
    "pendula check",
    "TABLE --input PROBLEM [--json] [--strict]",
    (
        "Marks a table that a student's program has printed: compares it with the closed form and with Runge-Kutta, and tells "
        "what mistake explains it. Status: 0 right, 1 wrong, 2 unreadable.",
        "Corrige la tabla que ha escrito el programa de un estudiante: la compara con la solución exacta y con Runge-Kutta, y "
        "dice qué error la explica. Estado: 0 bien, 1 mal, 2 ilegible.",
    ),
    (
        Option("TABLE", ("file with the tables; - for standard input", "fichero con las tablas; - es la entrada estándar")),
        Option(
            "--input",
            (
                "file with the problem or problems, as pendula reads them",
                "fichero con el problema o los problemas, como los lee pendula",
            ),
            "PROBLEM",
        ),
        Option("--json", ("a report for machines", "un informe para máquinas")),
        Option("--strict", ("remarks make a table wrong, too", "también las notas hacen que una tabla esté mal")),
    ),
)

MISSING: Text = ("{0} is missing; see pendula check --help", "falta {0}; consulta pendula check --help")
ONE_FILE: Text = ("one file is marked at a time; {0!r} is one more", "se corrige un fichero cada vez; sobra {0!r}")


def main() -> int:
    """The console script."""
    return run(CHECK, _check)


def _check(given: dict[str, str], words: list[str], lang: str) -> int:
    for word in words:
        if word.startswith("-") and word != "-":
            raise RefusedError(BAD_USAGE, TEXTS["unknown option"], word, CHECK.name)
    if not words or "--input" not in given:
        raise RefusedError(BAD_USAGE, MISSING, "--input" if words else "TABLE")
    if len(words) > 1:
        raise RefusedError(BAD_USAGE, ONE_FILE, words[1])
    try:
        marks = _marks(words[0], given["--input"], "--strict" in given, lang)
    except UnreadableError as unreadable:
        if "--json" in given:
            write(unreadable_as_json(say(UNREADABLE[unreadable.name], lang, *unreadable.values)))
        raise
    write((as_json if "--json" in given else as_text)(marks, lang))
    return marks.status


def _marks(path: str, problems: str, strict: bool, lang: str) -> Marks:
    found = read_file(path)
    with opened(problems) as file:
        try:
            solved = solve(["--lang", lang], file)
        except RefusedError as refused:
            if refused.status != BAD_DATA:  # nothing that the problems are to blame for
                raise
            raise UnreadableError("no problems", problems) from None  # the program has said why
    marks = []
    for each, table in zip_longest(solved, found[: len(solved)]):
        problem = asked(each)
        marks.append(Mark(problem, table, judge(problem, table) if table else None))
    return Marks(marks, len(found), strict)
