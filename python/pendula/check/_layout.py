"""Which column of a table is which."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pendula.check._columns import ROLES, WORDS, roles_of
from pendula.check._findings import Finding, remark
from pendula.check._states import Column, Columns

if TYPE_CHECKING:
    from collections.abc import Iterator

    from pendula.check._asked import Asked
    from pendula.check._reading import Table

STATE = ("t", "theta", "omega")


def header_findings(problem: Asked, table: Table) -> list[Finding]:
    """What is to be said of the header; nothing is wrong with a table that lacks one."""
    named = roles_of(table.header)
    has_sine = "sine" in named if table.header else problem.regime == -1
    words = WORDS if has_sine else WORDS[:3]
    if not table.header:
        return [remark("no header", words=" ".join(words))]
    if table.header[: len(words)] != words:
        return [remark("other header", header=" ".join(table.header), words=" ".join(words))]
    return []


def placements(problem: Asked, table: Table) -> Iterator[tuple[str, dict[str, int]]]:
    """Where the columns may be, and the mistake that puts them there: as the header says, in order, and swapped."""
    width = table.values.shape[1]
    named = {role: place for role, place in roles_of(table.header).items() if place < width}
    in_order = dict(zip(ROLES, range(width), strict=False))
    if problem.regime != -1 and (width > len(ROLES) or (named and "sine" not in named)):
        in_order.pop("sine", None)  # what is there is something else
    is_named = set(STATE) <= named.keys()
    if is_named:
        yield "", named
    if not set(STATE) <= in_order.keys():
        return
    yield "header order" if is_named else "", in_order
    if not is_named and width > len(ROLES):  # the rows may be numbered
        yield "", {role: place + 1 for role, place in in_order.items()}
    yield "swapped", in_order | {"theta": in_order["omega"], "omega": in_order["theta"]}


def columns_at(table: Table, places: dict[str, int]) -> Columns | None:
    """The columns at these places, in whole rows that have a time and a state; None if there are none."""
    state = [places[role] for role in STATE]
    rows = np.isfinite(table.values[:, state]).all(axis=1) & ~np.isin(table.lines, table.ragged)
    if not rows.any():
        return None
    found = {role: Column(table.values[rows, place], table.units[rows, place]) for role, place in places.items()}
    digits = int(table.digits[state[1:]].min())
    return Columns(found["t"], found["theta"], found["omega"], found.get("sine"), table.lines[rows], digits)
