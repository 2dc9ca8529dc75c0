"""What a table's judges hand on."""

from __future__ import annotations

from typing import Any, NamedTuple

REMARK, ERROR = "remark", "error"


class Finding(NamedTuple):
    """Something to tell the student."""

    name: str
    """In TEXTS."""
    values: dict[str, Any]
    """What stands in the text's places: numbers and words."""
    severity: str = ERROR
    """A remark does not make the table wrong."""


def error(name: str, **values: Any) -> Finding:
    """A mistake."""
    return Finding(name, values)


def remark(name: str, **values: Any) -> Finding:
    """Something that could be better, or that a teacher may want to know."""
    return Finding(name, values, REMARK)
