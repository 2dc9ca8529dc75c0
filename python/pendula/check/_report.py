"""Marks as people and as autograders read them."""

from __future__ import annotations

import json
import math
from typing import TYPE_CHECKING, NamedTuple, TypeAlias

from pendula._command import BAD_DATA, BAD_USAGE, DONE, say
from pendula.check._findings import REMARK, Finding, Value, error, message
from pendula.check._table import ROLES, WORDS

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from pendula._command import Text
    from pendula.check._judge import Judgement
    from pendula.check._problem import Asked
    from pendula.check._table import Table

Json: TypeAlias = "Mapping[str, Json] | Sequence[Json] | float | str | None"

REPORT: dict[str, Text] = {
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


class Mark(NamedTuple):
    """A problem, the table that was handed in for it, and what came of it; None where there is no table."""

    problem: Asked
    table: Table | None
    judgement: Judgement | None


class Marks(NamedTuple):
    """All of a file's."""

    marks: Sequence[Mark]
    tables: int
    """How many there are in the file."""
    strict: bool
    """Whether remarks count."""

    def findings(self, mark: Mark) -> list[Finding]:
        """What there is to say of a problem."""
        return mark.judgement.findings if mark.judgement else [error("table missing")]

    def is_right(self, mark: Mark) -> bool:
        """Whether its table stands."""
        return all(finding.severity == REMARK and not self.strict for finding in self.findings(mark))

    @property
    def status(self) -> int:
        """The program's: done where all is right, else bad data."""
        return DONE if self.tables <= len(self.marks) and all(map(self.is_right, self.marks)) else BAD_DATA


def as_text(marks: Marks, lang: str) -> str:
    """A paragraph for each problem, and a summary."""

    def line(name: str, *values: object) -> str:
        return say(REPORT[name], lang, *values)

    lines = []
    for number, mark in enumerate(marks.marks, start=1):
        lines.append(f"{line('table', number)}: {line('right' if marks.is_right(mark) else 'wrong')}")
        if mark.table is not None and mark.judgement is not None:
            rows = len(mark.table.values)
            lines.append("  " + line("rows", rows, mark.problem.rows))
            for role, off in mark.judgement.deviations.items():
                name, word = "sine" if role == "sine" else "column", WORDS[ROLES.index(role)]
                lines.append("  " + line(name, word, off.right, rows, off.from_exact, off.from_rk4))
        for finding in marks.findings(mark):
            lead = line("remark") if finding.severity == REMARK else ""
            lines.append(f"  - {lead}{message(finding, lang)}")
    if marks.tables > len(marks.marks):
        lines.append(line("too many tables", marks.tables, len(marks.marks)))
    lines.append(line("summary", sum(map(marks.is_right, marks.marks)), len(marks.marks)))
    return "\n".join(lines) + "\n"


def as_json(marks: Marks, lang: str) -> str:
    """One object; names of findings stay as they are, whatever the language of the messages."""
    status = marks.status
    report = {
        "verdict": "right" if status == DONE else "wrong",
        "status": status,
        "right": sum(map(marks.is_right, marks.marks)),
        "problems": len(marks.marks),
        "tables": marks.tables,
        "marks": [_mark(marks, number, mark, lang) for number, mark in enumerate(marks.marks, start=1)],
    }
    return _dumped(report)


def unreadable_as_json(text: str) -> str:
    """The report on what is no table."""
    return _dumped({"verdict": "unreadable", "status": BAD_USAGE, "message": text})


def _dumped(report: Json) -> str:
    return json.dumps(report, ensure_ascii=False, indent=2, allow_nan=False) + "\n"


def _finite(value: Value) -> Value | None:
    """JSON has no word for a number that is not finite."""
    return value if isinstance(value, str) or math.isfinite(value) else None


def _mark(marks: Marks, number: int, mark: Mark, lang: str) -> Json:
    deviations = mark.judgement.deviations if mark.judgement else {}
    return {
        "problem": number,
        "verdict": "right" if marks.is_right(mark) else "wrong",
        "rows": {"expected": mark.problem.rows, "found": len(mark.table.values) if mark.table else 0},
        "columns": {
            role: {
                "right": off.right,
                "largest_from_exact": _finite(off.from_exact),
                "largest_from_rk4": _finite(off.from_rk4),
            }
            for role, off in deviations.items()
        },
        "findings": [
            {
                "name": finding.name.replace(" ", "_"),
                "severity": finding.severity,
                "message": message(finding, lang),
                "values": {name: _finite(value) for name, value in finding.values.items()},
            }
            for finding in marks.findings(mark)
        ],
    }
