"""Marks as people and as autograders read them."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any, NamedTuple

from pendula._language import LANGUAGES
from pendula.check._columns import ROLES, WORDS
from pendula.check._findings import REMARK, Finding, error
from pendula.check._texts import FINDINGS, REGIMES, REPORT

if TYPE_CHECKING:
    from collections.abc import Sequence

    from pendula.check._asked import Asked
    from pendula.check._judge import Judgement
    from pendula.check._reading import Table

RIGHT, WRONG, UNREADABLE = 0, 1, 2


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
        """The program's."""
        return RIGHT if self.tables <= len(self.marks) and all(map(self.is_right, self.marks)) else WRONG


def message(finding: Finding, lang: str) -> str:
    """A finding in words."""
    place = LANGUAGES.index(lang)
    values = dict(finding.values)
    if "k" in values:
        values["regime"] = REGIMES[values["k"]][place]
    return FINDINGS[finding.name][place].format(**values)


def as_text(marks: Marks, lang: str) -> str:
    """A paragraph for each problem, and a summary."""

    def say(name: str, *values: object) -> str:
        return REPORT[name][LANGUAGES.index(lang)].format(*values)

    lines = []
    for number, mark in enumerate(marks.marks, start=1):
        lines.append(f"{say('table', number)}: {say('right' if marks.is_right(mark) else 'wrong')}")
        if mark.table is not None and mark.judgement is not None:
            rows = len(mark.table.values)
            lines.append("  " + say("rows", rows, mark.problem.rows))
            for role, off in mark.judgement.deviations.items():
                word = WORDS[ROLES.index(role)]
                lines.append(
                    "  " + say("sine" if role == "sine" else "column", word, off.right, rows, off.from_exact, off.from_rk4)
                )
        for finding in marks.findings(mark):
            lead = say("remark") if finding.severity == REMARK else ""
            lines.append(f"  - {lead}{message(finding, lang)}")
    if marks.tables > len(marks.marks):
        lines.append(say("too many tables", marks.tables, len(marks.marks)))
    lines.append(say("summary", sum(map(marks.is_right, marks.marks)), len(marks.marks)))
    return "\n".join(lines)


def as_json(marks: Marks, lang: str) -> str:
    """One object; names of findings stay as they are, whatever the language of the messages."""
    report = {
        "verdict": "right" if marks.status == RIGHT else "wrong",
        "status": marks.status,
        "right": sum(map(marks.is_right, marks.marks)),
        "problems": len(marks.marks),
        "tables": marks.tables,
        "marks": [_mark(marks, number, mark, lang) for number, mark in enumerate(marks.marks, start=1)],
    }
    return json.dumps(report, ensure_ascii=False, indent=2)


def unreadable_as_json(text: str) -> str:
    """The report on what is no table."""
    return json.dumps({"verdict": "unreadable", "status": UNREADABLE, "message": text}, ensure_ascii=False, indent=2)


def _mark(marks: Marks, number: int, mark: Mark, lang: str) -> dict[str, Any]:
    deviations = mark.judgement.deviations if mark.judgement else {}
    return {
        "problem": number,
        "verdict": "right" if marks.is_right(mark) else "wrong",
        "rows": {"expected": mark.problem.rows, "found": len(mark.table.values) if mark.table else 0},
        "columns": {
            role: {"right": off.right, "largest_from_exact": off.from_exact, "largest_from_rk4": off.from_rk4}
            for role, off in deviations.items()
        },
        "findings": [
            {
                "name": finding.name.replace(" ", "_"),
                "severity": finding.severity,
                "message": message(finding, lang),
                "values": finding.values,
            }
            for finding in marks.findings(mark)
        ],
    }
