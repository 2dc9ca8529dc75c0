"""What there is to say of a table."""

from __future__ import annotations

from typing import NamedTuple, TypeAlias

REMARK, ERROR = "remark", "error"

Value: TypeAlias = float | int | str


class Where(NamedTuple):
    """The first cell that is not what it should be."""

    line: int
    t: float
    column: str
    """The assignment's word."""
    value: float
    wanted: float


class Finding(NamedTuple):
    """Something to tell the student."""

    name: str
    """Of its page."""
    values: dict[str, Value]
    """What stands in the places of the page's sentence."""
    severity: str = ERROR
    """A remark does not make the table wrong."""
    where: Where | None = None
    alternatives: tuple[Finding, ...] = ()
    """What explains the table equally well."""


def error(name: str, **values: Value) -> Finding:
    """A mistake."""
    return Finding(name, values)


def remark(name: str, **values: Value) -> Finding:
    """Something that could be better, or that a teacher may want to know."""
    return Finding(name, values, REMARK)
