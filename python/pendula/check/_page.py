"""A page for each student and one for the class, in a folder of their own."""

from __future__ import annotations

import base64
import errno
import os
import re
import sys
from html import escape
from pathlib import Path
from textwrap import dedent
from typing import TYPE_CHECKING

from pendula._command import BAD_USAGE, NOT_WRITTEN, RefusedError, Text, say
from pendula.check import _pages
from pendula.check._finding import ERROR
from pendula.check._report import column_lines, count_line, finding_lines, reason, shown, titles

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from pendula.check._class import Mark, Student
    from pendula.check._finding import Finding
    from pendula.check._report import Terms

TEXTS: dict[str, Text] = {
    "foreign": (
        "{0!r} holds {1!r}, which this command has not made; give a folder that is empty or new",
        "{0!r} contiene {1!r}, que no es de esta orden; da una carpeta vacía o nueva",
    ),
    "no summary": (
        "{0!r} is there and is no summary; give the name of a new file",
        "{0!r} ya existe y no es un resumen; da el nombre de un fichero nuevo",
    ),
    "no reader": ("{0!r} is a pipe that nobody reads", "{0!r} es una tubería que nadie lee"),
    "not written": ("{0!r} could not be written: {1}", "no se ha podido escribir {0!r}: {1}"),
    "class": ("The class", "La clase"),
    "table": ("table {0}", "tabla {0}"),
    "often": ("What was found most often", "Lo que más se ha visto"),
    "meaning": ("What it means", "Qué significa"),
    "picture": (
        "Angle and velocity against time, and phase space: the table over what is right",
        "Ángulo y velocidad frente al tiempo, y espacio de fases: la tabla sobre lo correcto",
    ),
    "more": ("more", "más"),
}

# The first bytes of each page: a folder that holds nothing else may be written again.
MADE_HERE = "<!DOCTYPE html><!-- pendula check -->"
LONGEST_NAME = 60
# Names that Windows keeps for devices, and that of the class's page.
TAKEN = ("index", "con", "prn", "aux", "nul", *(f"{port}{digit}" for port in ("com", "lpt") for digit in range(10)))

STYLE = """
body { font: 16px/1.5 system-ui, sans-serif; max-width: 62rem; margin: 2rem auto; padding: 0 1rem; color: #222; }
h1 { margin-bottom: 0; } h2 { border-top: 1px solid #ccc; padding-top: 1rem; margin-top: 2rem; }
h3 { margin: 2rem 0 0; } h4 { margin: 1rem 0 0; color: #666; } h4 + p { margin-top: 0; }
img { width: 100%; } pre { white-space: pre-wrap; background: #f5f5f5; padding: .5rem 1rem; }
table { border-collapse: collapse; } th, td { text-align: left; padding: .25rem .75rem; border-bottom: 1px solid #ddd; }
.right { color: #00704f; } .wrong { color: #b34700; } .unreadable, .remark, .fit { color: #666; } .fit { font-size: 14px; }
@media print { body { margin: 0; max-width: none; } section { break-inside: avoid; } }
"""


# Writing.


def prepare(folder: str) -> None:
    """Makes the folder, or refuses one that holds anything that is not a page of this command."""
    path = Path(folder)
    try:
        path.mkdir(parents=True, exist_ok=True)
        # Hidden ones are of the system, or what an interrupted run has left; no page has such a name.
        entries = sorted(each for each in path.iterdir() if not each.name.startswith("."))
        foreign = next((each.name for each in entries if each.is_symlink() or not _begins(each, MADE_HERE.encode())), None)
    except OSError as error:
        raise RefusedError(NOT_WRITTEN, TEXTS["not written"], folder, error.strerror) from error
    if foreign is not None:
        raise RefusedError(BAD_USAGE, TEXTS["foreign"], folder, foreign)


def require_summary(path: str, head: bytes) -> None:
    """Refuses a folder, and a file that is not what was written before: the name may be that of a student's file."""
    try:
        is_other = Path(path).is_file() and Path(path).stat().st_size > 0 and not _begins(Path(path), head)
        foreign = is_other or Path(path).is_dir()
    except OSError as error:
        raise RefusedError(NOT_WRITTEN, TEXTS["not written"], path, error.strerror) from error
    if foreign:
        raise RefusedError(BAD_USAGE, TEXTS["no summary"], path)


def _begins(path: Path, head: bytes) -> bool:
    if not path.is_file():
        return False
    with path.open("rb") as file:
        return file.read(len(head)) == head


def write_pages(folder: str, students: Sequence[Student], terms: Terms) -> None:
    """The class's page last: where it is, all are."""
    names = page_names([student.name for student in students])
    for student, name in zip(students, names, strict=True):
        # Names are UTF-8, as the links to them are, whatever the locale says.
        write_file(Path(folder) / os.fsdecode(name.encode()), student_page(student, terms).encode(errors="backslashreplace"))
    write_file(Path(folder) / "index.html", class_page(students, names, terms).encode(errors="backslashreplace"))


def write_file(path: Path, data: bytes) -> None:
    """Writes a file whole or not at all: under another name first. What is no regular file is written as it is."""
    try:
        if path.exists() and not path.is_file():  # a device or a pipe
            _write_to_device(path, data)
            return
        target = path.resolve()  # a link stays a link
        temporary = target.with_name(f".{os.getpid()}.tmp")
        try:
            temporary.write_bytes(data)
            temporary.replace(target)
        except BaseException:
            temporary.unlink(missing_ok=True)
            raise
    except BrokenPipeError:
        return
    except (OSError, RuntimeError) as error:  # links in a circle
        why = error.strerror if isinstance(error, OSError) else error
        if isinstance(error, OSError) and error.errno == errno.ENXIO:
            raise RefusedError(NOT_WRITTEN, TEXTS["no reader"], str(path)) from error
        raise RefusedError(NOT_WRITTEN, TEXTS["not written"], str(path), why) from error


def _write_to_device(path: Path, data: bytes) -> None:
    """Does not wait for somebody who would read a pipe."""
    if sys.platform == "win32":  # has no pipes among its files
        path.write_bytes(data)
        return
    # Opened like this, a pipe that nobody reads is an error.
    with open(path, "wb", opener=lambda name, flags: os.open(name, flags | os.O_NONBLOCK)) as file:
        os.set_blocking(file.fileno(), True)
        file.write(data)


def page_names(names: Iterable[str]) -> list[str]:
    """File names of pages: letters, digits and _ of the students' names, no two the same in capitals or not."""
    taken = set(TAKEN)
    found = []
    for name in names:
        plain = re.sub(r"[^\w-]+", "_", name).strip("_")[:LONGEST_NAME] or "_"
        several = (plain if place == 1 else f"{plain}-{place}" for place in range(1, len(taken) + 2))
        free = next(each for each in several if each.casefold() not in taken)
        taken.add(free.casefold())
        found.append(f"{free}.html")
    return found


# Pages.


def _document(title: str, body: str, terms: Terms) -> str:
    return (
        f'{MADE_HERE}\n<html lang="{terms.lang}">\n<meta charset="utf-8">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        f"<title>{escape(title)}</title>\n<style>{STYLE}</style>\n{body}\n</html>\n"
    )


def student_page(student: Student, terms: Terms) -> str:
    """What came of a file: each table with its picture, and what the findings mean."""

    def text(name: str) -> str:
        return say(TEXTS[name], terms.lang)

    head = [f"<h1>{escape(shown(student.name))}</h1>"]
    if student.unreadable:
        head.append(f'<p class="unreadable">{escape(reason(student, terms.lang))}</p>')
        return _document(shown(student.name), "\n".join(head), terms)
    summary = terms.line("summary", student.right, len(student.marks))
    if terms.tells_points:
        points = terms.line("points", terms.scale.of_student(student, terms.strict), terms.scale.points)
        summary += f" {points}"
    body = [*head, f"<p>{escape(summary)}</p>", _findings(student.findings, 0, terms)]
    body += [_mark(mark, terms) for mark in student.marks]
    every = [*student.findings, *(finding for mark in student.marks for finding in mark.findings)]
    names = dict.fromkeys(each.name for finding in every for each in (finding, *finding.alternatives))
    if names:
        body += [f"<h2>{escape(text('meaning'))}</h2>", *(_explained(name, terms.lang) for name in names)]
    return _document(shown(student.name), "\n".join(body), terms)


def _mark(mark: Mark, terms: Terms) -> str:
    verdict = "right" if mark.is_right else "wrong"
    title = f'{escape(terms.line("table", mark.problem))}: <span class="{verdict}">{escape(terms.line(verdict))}</span>'
    fits = "<br>".join(map(escape, column_lines(mark, terms)))
    picture = ""
    if mark.picture:
        data = base64.b64encode(mark.picture.encode()).decode()
        picture = f'<img src="data:image/svg+xml;base64,{data}" alt="{escape(say(TEXTS["picture"], terms.lang))}">'
    found = _findings(mark.findings, mark.digits, terms)
    return f'<section><h2>{title}</h2>\n{found}\n{picture}\n<p class="fit">{fits}</p></section>'


def _findings(findings: Sequence[Finding], digits: int, terms: Terms) -> str:
    more = escape(say(TEXTS["more"], terms.lang))
    items = [
        f'<li class="{escape(finding.severity)}">{escape(line)} <a href="#{escape(finding.name)}">{more}</a></li>'
        for finding, line in zip(findings, finding_lines(findings, digits, terms), strict=True)
    ]
    return f"<ul>{''.join(items)}</ul>" if items else ""


def _explained(name: str, lang: str) -> str:
    """A finding's page."""
    page = _pages.page(name, lang)
    parts = [f'<h3 id="{escape(name)}">{escape(page.title)}</h3>']
    for part, text in (("looks", page.looks), ("why", page.why), ("find", page.find)):
        parts.append(f"<h4>{escape(say(_pages.TEXTS[part], lang))}</h4>")
        for is_code, block in _pages.blocks(text):
            parts.append(f"<pre>{escape(dedent(block))}</pre>" if is_code else f"<p>{escape(block)}</p>")
    return f"<section>{''.join(parts)}</section>"


def class_page(students: Sequence[Student], names: Sequence[str], terms: Terms) -> str:
    """A row for each student, a column for each problem, and what was found most often."""

    problems = max((len(student.marks) for student in students), default=0)
    heads = [terms.line("student"), *(say(TEXTS["table"], terms.lang, place) for place in range(1, problems + 1))]
    heads += map(terms.line, ("verdict", "scored", "findings") if terms.tells_points else ("verdict", "findings"))
    rows = []
    for student, name in zip(students, names, strict=True):
        cells = [f'<a href="{escape(name)}">{escape(shown(student.name))}</a>']
        signs = ("✓" if mark.is_right else "✗" for mark in student.marks)
        cells += [*signs] if student.marks else ["–"] * problems
        cells += [f'<span class="{("right", "wrong", "unreadable")[student.status]}">{escape(terms.verdict(student))}</span>']
        cells += [f"{terms.scale.of_student(student, terms.strict):.4g}"] if terms.tells_points else []
        cells += [escape(titles(student, terms))]
        rows.append("".join(f"<td>{cell}</td>" for cell in cells))
    table = f"<tr>{''.join(f'<th>{escape(head)}</th>' for head in heads)}</tr>" + "".join(f"<tr>{row}</tr>\n" for row in rows)
    often = "".join(
        f"<li>{escape(_pages.page(name, terms.lang).title)}: {escape(terms.line('files', count, len(students)))}</li>"
        for name, count in _often(students)
    )
    title = say(TEXTS["class"], terms.lang)
    body = f"<h1>{escape(title)}</h1>\n<p>{escape(count_line(students, terms))}</p>\n<table>{table}</table>\n"
    return _document(
        title, body + (f"<h2>{escape(say(TEXTS['often'], terms.lang))}</h2>\n<ul>{often}</ul>" if often else ""), terms
    )


def _often(students: Sequence[Student]) -> list[tuple[str, int]]:
    """Mistakes and in how many files they are, the commonest first."""
    counts: dict[str, int] = {}
    for student in students:
        every = [*student.findings, *(finding for mark in student.marks for finding in mark.findings)]
        for name in {finding.name for finding in every if finding.severity == ERROR}:
            counts[name] = counts.get(name, 0) + 1
    return sorted(counts.items(), key=lambda each: (-each[1], each[0]))
