"""Marks as people, spreadsheets and autograders read them."""

from __future__ import annotations

import csv
import io
import json
import math
import unicodedata
from typing import TYPE_CHECKING, NamedTuple, TypeAlias

from pendula._command import DONE, say
from pendula.check import _pages
from pendula.check._finding import ERROR
from pendula.check._table import ROLES, WORDS

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping, Sequence

    from pendula._command import Text
    from pendula.check._class import Mark, Student
    from pendula.check._finding import Finding, Where
    from pendula.check._scale import Scale

Json: TypeAlias = "Mapping[str, Json] | Sequence[Json] | float | str | None"

MOST_TITLES = 3  # on a student's line
MOST_ALIGNED = 32  # letters of a name; longer ones push their own lines only
MOST_DECIMALS = 6  # of points that a teacher gives
SURE_DIGITS = 15  # more would show how the last bits were rounded
FORMULAS = ("=", "+", "-", "@")  # what they begin with in spreadsheets

TEXTS: dict[str, Text] = {
    "table": ("Table {0}", "Tabla {0}"),
    "right": ("right", "bien"),
    "wrong": ("wrong", "mal"),
    "unreadable": ("unreadable", "ilegible"),
    "rows": ("{0} of {1} {1:row|rows}", "{0} de {1} {1:fila|filas}"),
    "column": (
        "{0}: {1} of {2} {2:row|rows} right; at most {3:.1e} from what is right",
        "{0}: {1} de {2} {2:fila|filas} bien; error máximo {3:.1e}",
    ),
    "sine": ("{0}: {1} of {2} {2:row|rows} right", "{0}: {1} de {2} {2:fila|filas} bien"),
    "remark": ("remark: ", "nota: "),
    "where": (
        " First in line {0}, t = {1}: {2} is {3} and should be {4}.",
        " Se ve primero en la línea {0}, t = {1}: {2} es {3} y debería ser {4}.",
    ),
    "or": (" Or: {0}", " O bien: {0}"),
    "summary": ("{0} of {1} {1:table|tables} right.", "{0} de {1} {1:tabla|tablas} bien."),
    "points": ("{0:.6g} of {1:.6g} {1:point|points}.", "{0:.6g} de {1:.6g} {1:punto|puntos}."),
    "class": (
        "{0} {0:file|files}: {1} right, {2} wrong, {3} unreadable.",
        "{0} {0:fichero|ficheros}: {1} bien, {2} mal, {3} {3:ilegible|ilegibles}.",
    ),
    "files": ("{0} of {1} {1:file|files}", "{0} de {1} {1:fichero|ficheros}"),
    "in": (" ({0:table|tables} {1})", " ({0:tabla|tablas} {1})"),
    "student": ("student", "estudiante"),
    "right tables": ("tables right", "tablas bien"),
    "verdict": ("verdict", "resultado"),
    "scored": ("points", "puntos"),
    "findings": ("findings", "qué se ha visto"),
}


class Number(NamedTuple):
    """A number in a text, where "{0:row|rows}" is the noun that goes with it."""

    value: float

    def __format__(self, spec: str) -> str:
        one, is_noun, several = spec.partition("|")
        return format(self.value, spec) if not is_noun else one if self.value == 1 else several


class Terms(NamedTuple):
    """How marks are told."""

    lang: str
    scale: Scale
    strict: bool
    tells_points: bool
    """To people; machines are always told."""

    def line(self, name: str, *values: object) -> str:
        """A text of this report."""
        return say(TEXTS[name], self.lang, *(Number(each) if isinstance(each, int | float) else each for each in values))

    def verdict(self, student: Student) -> str:
        """In a word."""
        return self.line(_verdict(student))

    def message(self, finding: Finding, digits: int) -> str:
        """A finding in words: what it is, what else it may be, where it shows."""
        text = _pages.say(finding.name, self.lang, finding.values, digits)
        for each in finding.alternatives:
            text += self.line("or", _pages.say(each.name, self.lang, each.values, digits))
        return shown(text + (self._place(finding.where, digits) if finding.where else ""))

    def _place(self, where: Where, digits: int) -> str:
        # As many digits as the table has, and more where these do not show the difference.
        several = range(min(max(digits, 1), SURE_DIGITS), _pages.MOST_DIGITS + 1)
        digits = next((each for each in several if f"{where.value:.{each}g}" != f"{where.wanted:.{each}g}"), digits)
        t, value, wanted = (f"{each:.{digits}g}" for each in (where.t, where.value, where.wanted))
        return self.line("where", where.line, t, where.column, value, wanted)


def _verdict(student: Student) -> str:
    return "unreadable" if student.unreadable else "right" if student.status == DONE else "wrong"


def status(students: Sequence[Student]) -> int:
    """The command's: that of the worst file."""
    return max(student.status for student in students)


def shown(text: str) -> str:
    """Words of others without what a terminal or a page would obey: controls, and marks that turn the direction of text."""
    return "".join(letter if _is_harmless(letter) else "\N{REPLACEMENT CHARACTER}" for letter in text)


def _is_harmless(letter: str) -> bool:
    return letter.isprintable() or unicodedata.category(letter) == "Zs"  # spaces of other widths


# For people.


def file_as_text(student: Student, terms: Terms) -> str:
    """A paragraph for each problem, and a summary."""
    lines = []
    for mark in student.marks:
        lines.append(f"{terms.line('table', mark.problem)}: {terms.line('right' if mark.is_right else 'wrong')}")
        lines += [f"  {line}" for line in column_lines(mark, terms)]
        lines += [f"  - {line}" for line in finding_lines(mark.findings, mark.digits, terms)]
    lines += finding_lines(student.findings, 0, terms)
    lines.append(terms.line("summary", student.right, len(student.marks)))
    if terms.tells_points:
        lines.append(terms.line("points", terms.scale.of_student(student, terms.strict), terms.scale.points))
    return "\n".join(lines) + "\n"


def column_lines(mark: Mark, terms: Terms) -> list[str]:
    """How many rows there are, and how each column fits."""
    if mark.found is None:
        return []
    lines = [terms.line("rows", mark.found, mark.expected)]
    for role, fit in mark.columns.items():
        name, word = "sine" if role == "sine" else "column", WORDS[ROLES.index(role)]
        lines.append(terms.line(name, word, fit.right, mark.found, fit.from_exact))
    return lines


def finding_lines(findings: Iterable[Finding], digits: int, terms: Terms) -> list[str]:
    """Findings in words."""
    return [
        (terms.line("remark") if finding.severity != ERROR else "") + terms.message(finding, digits) for finding in findings
    ]


def class_as_text(students: Sequence[Student], terms: Terms) -> str:
    """A line for each student below one that says what is in it, and how many are right."""
    heads = [terms.line(name) for name in ("student", "right tables", "verdict", "findings")]
    rows = [
        (shown(each.name), f"{each.right}/{len(each.marks)}" if each.marks else "-", terms.verdict(each), titles(each, terms))
        for each in students
    ]
    if terms.tells_points:
        rows = [
            (*row[:3], f"{terms.scale.of_student(each, terms.strict):.4g}", row[3])
            for row, each in zip(rows, students, strict=True)
        ]
        heads.insert(3, terms.line("scored"))
    rows = [tuple(heads), *rows]
    widths = [min(max(map(len, column)), MOST_ALIGNED) for column in zip(*rows, strict=True)]
    widths[-1] = 0
    lines = ["  ".join(map(str.ljust, row, widths)).rstrip() for row in rows]
    return "\n".join(lines) + f"\n{count_line(students, terms)}\n"


def count_line(students: Sequence[Student], terms: Terms) -> str:
    """How many files are right, wrong and unreadable."""
    verdicts = [_verdict(each) for each in students]
    return terms.line("class", len(students), *map(verdicts.count, ("right", "wrong", "unreadable")))


def titles(student: Student, terms: Terms) -> str:
    """The first findings in a few words, mistakes before remarks, with the problems that they are found in."""
    if student.unreadable:
        return reason(student, terms.lang)
    found: dict[str, list[int]] = {}
    every = [(finding, mark.problem) for mark in student.marks for finding in mark.findings]
    every += [(finding, 0) for finding in student.findings]
    for finding, problem in sorted(every, key=lambda each: each[0].severity != ERROR):
        found.setdefault(finding.name, []).append(problem)
    shorts = []
    for name, problems in found.items():
        is_of_some = len(problems) < len(student.marks) and any(problems)
        places = terms.line("in", len(problems), ", ".join(map(str, problems))) if is_of_some else ""
        shorts.append(_pages.page(name, terms.lang).title + places)
    return "; ".join(shorts[:MOST_TITLES]) + ("; …" if len(shorts) > MOST_TITLES else "")


def reason(student: Student, lang: str) -> str:
    """Why a file is unreadable."""
    return shown(say(student.unreadable.text, lang, *student.unreadable.values)) if student.unreadable else ""


# For spreadsheets.

COLUMNS = ("student", "problem", "verdict", "findings", "line", "points")


def as_csv(students: Sequence[Student], terms: Terms) -> bytes:
    """A row for each problem of each student, in UTF-8 with a mark, without which some spreadsheets take it for Latin-1."""
    text = io.StringIO(newline="")
    # Words are quoted, for some spreadsheets separate at a semicolon, which a name may hold.
    table = csv.writer(text, quoting=csv.QUOTE_NONNUMERIC)
    table.writerow(COLUMNS)
    for student in students:
        name = _harmless(student.name)
        if student.unreadable:
            table.writerow((name, "", "unreadable", student.unreadable.name.replace(" ", "_"), "", 0))
        for mark in student.marks:
            points = _plain(terms.scale.of_mark(student, mark, terms.strict))
            names = " ".join(finding.name for finding in mark.findings)
            line = min((finding.where.line for finding in mark.findings if finding.where), default="")
            table.writerow((name, mark.problem, "right" if mark.is_right else "wrong", names, line, points))
        for finding in student.findings:
            cost = terms.scale.findings.get(finding.name, 0.0)
            table.writerow((name, "", "wrong", finding.name, finding.values.get("line", ""), _plain(-cost)))
    return text.getvalue().encode("utf-8-sig", errors="backslashreplace")


def _plain(points: float) -> float:
    """Points with few digits where these are all, else with all: the shares of thirds add up to the whole."""
    rounded = round(points, MOST_DECIMALS)
    exact = rounded if math.isclose(rounded, points, rel_tol=1e-12) else points  # sums of costs have rounding errors
    return int(exact) if float(exact).is_integer() else exact


def _harmless(name: str) -> str:
    """A name that no spreadsheet takes for a formula."""
    name = shown(name)
    first = unicodedata.normalize("NFKC", name.lstrip()[:1])  # wide signs are signs, too
    return f"'{name}" if first in FORMULAS else name


# For autograders. Names of findings stay as they are, whatever the language of the messages.


def file_as_json(student: Student, terms: Terms) -> str:
    """One object."""
    return _dumped(_student(student, terms), indent=2)


def class_as_json(students: Sequence[Student], terms: Terms) -> str:
    """One object, with those of the students."""
    verdict = ("right", "wrong", "unreadable")[status(students)]
    right = sum(each.status == DONE for each in students)
    marked = [_student(each, terms) for each in students]
    return _dumped({"verdict": verdict, "status": status(students), "right": right, "students": marked}, indent=2)


def as_json_lines(students: Sequence[Student], terms: Terms) -> str:
    """One object a line."""
    return "".join(_dumped(_student(each, terms), indent=None) for each in students)


def _dumped(report: Json, indent: int | None) -> str:
    text = json.dumps(report, ensure_ascii=False, indent=indent, allow_nan=False)
    # What is not shown is escaped; line ends are those of the document, for those of names are escaped already.
    return "".join(each if _is_harmless(each) or each == "\n" else json.dumps(each)[1:-1] for each in text) + "\n"


def _finite(value: float | int | str) -> float | int | str | None:
    """JSON has no word for a number that is not finite."""
    return value if isinstance(value, str) or math.isfinite(value) else None


def _student(student: Student, terms: Terms) -> Json:
    lead: dict[str, Json] = {"student": student.name, "file": student.path}
    lead |= {"verdict": _verdict(student), "status": student.status}
    if student.unreadable:
        return {**lead, "points": 0.0, "message": reason(student, terms.lang)}
    return {
        **lead,
        "right": student.right,
        "problems": len(student.marks),
        "tables": student.tables,
        "points": terms.scale.of_student(student, terms.strict),
        "marks": [_mark(student, mark, terms) for mark in student.marks],
        "findings": [_finding(finding, 0, terms) for finding in student.findings],
    }


def _mark(student: Student, mark: Mark, terms: Terms) -> Json:
    return {
        "problem": mark.problem,
        "verdict": "right" if mark.is_right else "wrong",
        "points": terms.scale.of_mark(student, mark, terms.strict),
        "rows": {"expected": mark.expected, "found": mark.found or 0},
        "columns": {
            role: {"right": fit.right, "largest_from_exact": _finite(fit.from_exact)} for role, fit in mark.columns.items()
        },
        "findings": [_finding(finding, mark.digits, terms) for finding in mark.findings],
    }


def _finding(finding: Finding, digits: int, terms: Terms) -> Json:
    return {
        "name": finding.name,
        "severity": finding.severity,
        "message": terms.message(finding, digits),
        "values": {name: _finite(value) for name, value in finding.values.items()},
        "where": {name: _finite(value) for name, value in finding.where._asdict().items()} if finding.where else None,
        "alternatives": [each.name for each in finding.alternatives],
    }
