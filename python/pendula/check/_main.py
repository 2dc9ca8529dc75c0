"""`pendula check`: marks the tables of one student or of a class."""

from __future__ import annotations

from importlib.util import find_spec
from pathlib import Path

from pendula._command import BAD_DATA, BAD_USAGE, DONE, NO_MATPLOTLIB, TEXTS, Command, Option, RefusedError, Text, run, write
from pendula.check import _pages
from pendula.check import _report as report
from pendula.check._class import Task, files, mark_all
from pendula.check._page import prepare, require_summary, write_file, write_pages
from pendula.check._program import Problem, problems
from pendula.check._scale import read_scale
from pendula.check._table import UnreadableError, opened

CHECK = Command(
    "pendula check",
    "TABLE... --input PROBLEM ... | --explain NAME | --list",
    (
        "Marks tables that students' programs have printed: compares them with the closed form and with Runge-Kutta, and tells "
        "what mistake explains them. Status: 0 all right, 1 some wrong, 2 some unreadable or bad usage, 3 not all written.",
        "Corrige las tablas que han escrito los programas de los estudiantes: las compara con la solución exacta y con "
        "Runge-Kutta, y dice qué error las explica. Estado: 0 todo bien, 1 algo mal, 2 algo ilegible o mal uso, 3 algo sin "
        "escribir.",
    ),
    (
        Option(
            "TABLE",
            (
                "file with a student's tables, - for standard input; several, folders or patterns are a class",
                "fichero con las tablas de un estudiante, - es la entrada estándar; varios, carpetas o patrones son una clase",
            ),
        ),
        Option(
            "--input",
            (
                "file with the problem or problems, as pendula reads them",
                "fichero con el problema o los problemas, como los lee pendula",
            ),
            "PROBLEM",
        ),
        Option("--strict", ("remarks make a table wrong, too", "también las notas hacen que una tabla esté mal")),
        Option(
            "--json",
            ("a report for machines; of a class, one object", "un informe para máquinas; el de una clase, un solo objeto"),
        ),
        Option("--json-lines", ("the same, an object a line for each file", "lo mismo, un objeto por línea y fichero")),
        Option(
            "--summary",
            ("table of students and problems, in CSV", "tabla de estudiantes y problemas, en CSV"),
            "FILE",
        ),
        Option(
            "--report",
            (
                "a page for each student, with pictures, and one for the class, in HTML; the folder must be new, empty or of "
                "this command",
                "una página por estudiante, con dibujos, y una de la clase, en HTML; la carpeta debe ser nueva, estar vacía "
                "o ser de esta orden",
            ),
            "FOLDER",
        ),
        Option(
            "--points",
            (
                "of a file without mistakes, shared evenly by the problems; 10 where left out",
                "de un fichero sin errores, a partes iguales entre los problemas; si falta, 10",
            ),
            "N",
        ),
        Option("--scale", ("what findings cost, in TOML", "lo que cuesta cada diagnóstico, en TOML"), "FILE"),
        Option("--explain", ("show the page of a finding and end", "muestra la página de un diagnóstico y termina"), "NAME"),
        Option(
            "--list",
            ("show the findings' names and titles and end", "muestra los nombres y títulos de los diagnósticos y termina"),
        ),
    ),
)

MISSING: Text = ("{0} is missing; see pendula check --help", "falta {0}; consulta pendula check --help")
EITHER: Text = ("{0} and {1} exclude each other", "{0} y {1} se excluyen")


def main() -> int:
    """The console script."""
    return run(CHECK, _check)


def _check(given: dict[str, str], words: list[str], lang: str) -> int:
    for word in words:
        if word.startswith("-") and word != "-":
            raise RefusedError(BAD_USAGE, TEXTS["unknown option"], word, CHECK.name)
    if "--explain" in given:
        write(_pages.as_text(_pages.page(given["--explain"], lang)))
        return DONE
    if "--list" in given:
        names = _pages.names()
        width = max(map(len, names))
        write("".join(f"{name.ljust(width)}  {_pages.page(name, lang).title}\n" for name in names))
        return DONE
    if not words or "--input" not in given:
        raise RefusedError(BAD_USAGE, MISSING, "--input" if words else "TABLE")
    if "--json" in given and "--json-lines" in given:
        raise RefusedError(BAD_USAGE, EITHER, "--json", "--json-lines")
    return _mark(given, words, lang)


def _mark(given: dict[str, str], words: list[str], lang: str) -> int:
    folder, summary = given.get("--report"), given.get("--summary")
    scale = read_scale(given.get("--scale"), given.get("--points"))
    terms = report.Terms(lang, scale, "--strict" in given, "--scale" in given or "--points" in given)
    if summary is not None:
        require_summary(summary, report.as_csv([], terms))
    entries, is_class = files(words, [given[name] for name in ("--input", "--scale", "--summary") if name in given])
    task = Task(_problems(given["--input"], lang), terms.strict, folder is not None, lang)
    if folder is not None:
        if find_spec("matplotlib") is None:
            raise RefusedError(BAD_USAGE, NO_MATPLOTLIB)
        prepare(folder)
    students = mark_all(task, entries)
    if "--json-lines" in given:
        write(report.as_json_lines(students, terms))
    elif "--json" in given:
        write(report.class_as_json(students, terms) if is_class else report.file_as_json(students[0], terms))
    elif is_class:
        write(report.class_as_text(students, terms))
    elif students[0].unreadable is None:
        write(report.file_as_text(students[0], terms))
    if summary is not None:
        write_file(Path(summary), report.as_csv(students, terms))
    if folder is not None:
        write_pages(folder, students, terms)
    if not is_class and students[0].unreadable is not None:
        _, text, values = students[0].unreadable
        raise RefusedError(BAD_USAGE, text, *values)
    return report.status(students)


def _problems(path: str, lang: str) -> list[Problem]:
    with opened(path) as file:
        try:
            return problems(file, lang)
        except RefusedError as refused:
            if refused.status != BAD_DATA:  # nothing that the problems are to blame for
                raise
            raise UnreadableError("no problems", path) from None  # the program has said why
