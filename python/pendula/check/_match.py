"""Which table is which problem's: by its start, its times and its sinusoid, and only where these do not tell, by its place."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pendula.check._predict import wrap
from pendula.check._table import columns_at, placements

if TYPE_CHECKING:
    from collections.abc import Sequence

    from pendula.check._program import Problem
    from pendula.check._table import Columns, Table

SPACING = 1e-3  # relative: how far apart the rows of a problem's table may be from what it asks for
SIGNS = 3  # that speak for a table: its start, its times, and whether it has a sinusoid
FAR = 32  # places: beyond so many, tables are not exchanged but others


def match(problems: Sequence[Problem], tables: Sequence[Table]) -> tuple[list[Table | None], list[Table]]:
    """The table of each problem, or None, and the tables that belong to none.

    Tables that show all signs of a problem go to it, the nearest place first. Those that are left go to the problems that are
    left, in order: they are wrong, and one missing table costs only its own problem.
    """
    columns = [_columns(table) for table in tables]
    signs = {
        (i, j): _signs(problem, columns[j])
        for i, problem in enumerate(problems)
        for j in range(max(0, i - FAR), min(len(tables), i + FAR + 1))
    }
    found: dict[int, int] = {}
    for least in (SIGNS, SIGNS - 1):
        for i, j in sorted(signs, key=lambda pair: (abs(pair[0] - pair[1]), pair)):
            if i not in found and j not in found.values() and signs[i, j] >= least:
                found[i] = j
    left = [j for j in range(len(tables)) if j not in found.values()]
    for i in range(len(problems)):
        if i in found or not left:
            continue
        before = max((found[k] for k in range(i) if k in found), default=-1)
        after = min((found[k] for k in range(i + 1, len(problems)) if k in found), default=len(tables))
        between = [j for j in left if before < j < after]
        if between:
            found[i] = between[0]
            left.remove(between[0])
    return [tables[found[i]] if i in found else None for i in range(len(problems))], [tables[j] for j in left]


def _columns(table: Table) -> Columns | None:
    for name, places in placements(table, True):
        columns = columns_at(table, places)
        if columns is not None and not name:
            return columns
    return None


def _signs(problem: Problem, columns: Columns | None) -> int:
    """How much speaks for a table's being a problem's."""
    if columns is None:
        return 0
    t = columns.t.values
    theta_off = abs(float(wrap(columns.theta.values[0] - problem.theta0)))
    omega_off = abs(float(columns.omega.values[0] - problem.omega0))
    starts = theta_off <= columns.theta.units[0] + 1e-9 and omega_off <= columns.omega.units[0] + 1e-9
    every = float(np.median(np.diff(t))) if t.size > 1 else problem.every
    in_time = abs(every - problem.every) <= SPACING * problem.every + 2 * float(columns.t.units.max())
    oscillates = (columns.sine is not None) == (problem.regime == -1)
    return int(starts) + int(in_time) + int(oscillates)
