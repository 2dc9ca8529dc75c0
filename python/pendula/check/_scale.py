"""What tables are worth: a scale of points that a teacher can give."""

from __future__ import annotations

import math
import tomllib
from typing import TYPE_CHECKING, Any, NamedTuple

from pendula._command import BAD_USAGE, LANGUAGES, RefusedError, Text
from pendula.check._finding import ERROR
from pendula.check._pages import page
from pendula.check._table import opened

if TYPE_CHECKING:
    from collections.abc import Mapping

    from pendula.check._class import Mark, Student
    from pendula.check._finding import Finding

TEXTS: dict[str, Text] = {
    "not positive": ("{0} must be a positive number, got {1!r}", "{0} debe ser un número positivo, y es {1!r}"),
    "not toml": ("{0!r} is no scale: {1}", "{0!r} no es una escala: {1}"),
    "no number": ("{0!r}: {1} must be a number, 0 or larger", "{0!r}: {1} debe ser un número, 0 o mayor"),
    "no table": ("{0!r}: findings must be a table", "{0!r}: findings debe ser una tabla"),
    "unknown": ("{0!r}: there is no {1!r} in a scale; it has {2}", "{0!r}: en una escala no hay {1!r}; tiene {2}"),
}

MOST_BYTES = 1 << 14  # of a scale
MOST_POINTS = 1e9


class Scale(NamedTuple):
    """Points, and what is taken off them."""

    points: float = 10.0
    """Of a file whose tables are all right; each has an even share."""
    error: float = math.inf
    """What a mistake costs, but never more than the table's share."""
    remark: float = 0.0
    findings: Mapping[str, float] = {}
    """What these cost, by their names."""

    def cost(self, finding: Finding, strict: bool) -> float:
        """What a finding costs; where several explain a table equally well, the cheapest counts."""
        by_severity = self.error if finding.severity == ERROR or strict else self.remark
        return min(self.findings.get(each.name, by_severity) for each in (finding, *finding.alternatives))

    def of_mark(self, student: Student, mark: Mark, strict: bool) -> float:
        """A table's points."""
        share = self.points / len(student.marks)
        return max(0.0, share - sum(self.cost(finding, strict) for finding in mark.findings))

    def of_student(self, student: Student, strict: bool) -> float:
        """A file's points. What is said of it as a whole costs only what the scale says of it by name."""
        total = sum(self.of_mark(student, mark, strict) for mark in student.marks)
        return max(0.0, total - sum(self.findings.get(finding.name, 0.0) for finding in student.findings))


def read_scale(path: str | None, points: str | None) -> Scale:
    """A scale from a file, if there is one, with the points of the option, if it is given. Raises RefusedError."""
    scale = Scale(**_read(path)) if path else Scale()
    if points is not None:
        scale = scale._replace(points=_number(points))
        if not 0 < scale.points < math.inf:
            raise RefusedError(BAD_USAGE, TEXTS["not positive"], "--points", points)
    return scale


def _read(path: str) -> dict[str, Any]:
    with opened(path) as file:
        try:
            text = file.read(MOST_BYTES + 1)
            if len(text) > MOST_BYTES:
                raise ValueError(f"> {MOST_BYTES} bytes")
            given = tomllib.loads(text.decode("utf-8-sig"))
        except (ValueError, RecursionError) as error:  # not TOML, not UTF-8, or too deep
            raise RefusedError(BAD_USAGE, TEXTS["not toml"], path, error) from None
    costs = given.get("findings", {})
    if not isinstance(costs, dict):
        raise RefusedError(BAD_USAGE, TEXTS["no table"], path)
    for name in costs:
        page(name, LANGUAGES[0])  # refuses a name that no finding has
    for name in given:
        if name not in Scale._fields:
            raise RefusedError(BAD_USAGE, TEXTS["unknown"], path, name, ", ".join(Scale._fields))
    for name, value in ({**given, **costs}).items():
        is_number = isinstance(value, int | float) and not isinstance(value, bool)
        if name != "findings" and not (is_number and 0 <= value <= MOST_POINTS):
            raise RefusedError(BAD_USAGE, TEXTS["no number"], path, name)
    return given


def _number(text: str) -> float:
    try:
        return float(text)
    except ValueError:
        return math.nan
