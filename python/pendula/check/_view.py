"""A table's columns beside what is right at its times."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from pendula.check._finding import Where
from pendula.check._predict import (
    AS_ASKED,
    DECIDES,
    MOST_WORK,
    Prediction,
    are_cells,
    by_closed_form,
    misfits,
    not_judged_from,
    right_prediction,
    wrap,
    wrong_in_energy,
    wrong_locally,
)
from pendula.check._program import RIGHT, Clock, Problem, Start, taken
from pendula.check._sinusoid import fits, right_sinusoid
from pendula.check._table import ROLES, WORDS, Column, Columns
from pendula.check._timing import Timing, timings

if TYPE_CHECKING:
    import numpy.typing as npt

    from pendula.check._program import Floats
    from pendula.check._table import Table


LOOSE = 1e-4  # rad: beyond, what roundings may be worth hides wrong cells, and rows must follow from those before


class Deviation(NamedTuple):
    """How far a column is from what it should be."""

    right: int
    """Rows that are as they should be."""
    first_wrong: int | None
    """The first row that is not."""
    wanted: Floats
    """What should be there."""
    from_exact: float
    """The largest distance from the closed form [rad, rad/s]."""


class View(NamedTuple):
    """A table's columns, compared with what is right at its times."""

    columns: Columns
    places: Floats
    """The numbers of the rows."""
    timing: Timing
    wanted: Prediction
    wrong: tuple[npt.NDArray[np.bool_], ...]
    """Rows in which angle, velocity and time are not right."""
    judged: int
    """Rows before the first that cannot be judged."""

    @property
    def is_right(self) -> bool:
        """Whether times and states are right, as far as they are judged."""
        return not any(wrong.any() for wrong in self.wrong)

    @property
    def are_cells(self) -> bool:
        """Whether so few cells are wrong that they are no mistake of the program."""
        return are_cells(int(np.any(self.wrong, axis=0).sum()), self.columns.t.values.size)


def view_of(problem: Problem, table: Table, columns: Columns) -> View:
    """The first explanation of the times under which the states are right; else the first."""
    start = taken(RIGHT, problem)
    places = np.searchsorted(table.lines, columns.lines).astype(float)
    views = []
    for timing in timings(problem, start, columns.t, places):
        wanted = right_prediction(timing.clock, start)
        wrong = misfits(wanted, AS_ASKED, columns.theta, columns.omega)
        judged = not_judged_from(wanted)
        far = int(np.any([each[:judged] for each in wrong], axis=0).sum())
        if np.any(wanted.theta_slack > LOOSE) and are_cells(far, columns.t.values.size):
            wrong = _from_row_to_row(start, timing.clock, columns, wanted, judged, wrong)
        views.append(View(columns, places, timing, wanted, (*wrong, _wrong_times(columns.t, timing)), judged))
        if views[-1].is_right:
            return views[-1]
    return views[0]


def _from_row_to_row(
    start: Start,
    clock: Clock,
    columns: Columns,
    wanted: Prediction,
    judged: int,
    wrong: tuple[npt.NDArray[np.bool_], ...],
) -> tuple[npt.NDArray[np.bool_], ...]:
    """Wrong rows where roundings may have grown: those that do not follow from the row before are wrong, too.

    From the row that is not judged on, a row is wrong that neither follows nor has the closed form's state, or whose energy is
    not that of the start.
    """
    is_loose = wanted.theta_slack > LOOSE
    near = wrong_locally(start, clock, columns)
    # A row does not follow from a wrong one: of rows one after another, the last may be right.
    any_near = np.append(near[0] | near[1], False)
    may_be_right = np.append(False, any_near[:-2]) & ~any_near[1:]
    near = tuple(each & is_loose & ~may_be_right for each in near)
    wrong = tuple(far | local for far, local in zip(wrong, near, strict=True))
    if judged == is_loose.size:
        return wrong
    on_time = by_closed_form(start, clock)
    closed = [each | ~(on_time.theta_slack <= DECIDES) for each in misfits(on_time, AS_ASKED, columns.theta, columns.omega)]
    energy = wrong_in_energy(clock, start, columns) if clock.steps[-1] <= MOST_WORK // 4 else np.zeros_like(is_loose)
    tails = (closed[0] & near[0] | energy, closed[1] & near[1])
    return tuple(np.append(each[:judged], tail[judged:]) for each, tail in zip(wrong, tails, strict=True))


def _wrong_times(t: Column, timing: Timing) -> npt.NDArray[np.bool_]:
    """Rows whose times are not those of their steps, where nothing else is wrong with the times."""
    clock = timing.clock
    if timing.changes:
        return np.zeros(t.values.size, bool)
    slack = t.units + (clock.doubt + 1e-9) * np.abs(clock.t) + clock.unsure
    wrong: npt.NDArray[np.bool_] = ~(np.abs(t.values * timing.unit - clock.t) <= slack)
    return wrong | (np.diff(t.values, prepend=t.values[0]) < 0)


def has_same_states(one: View, other: View) -> bool:
    pairs = zip(one.columns[:3], other.columns[:3], strict=True)
    return all(np.array_equal(a.values, b.values) for a, b in pairs)


def first_wrong(view: View) -> Where | None:
    """The first state that is not what it should be."""
    rows = [(int(np.argmax(wrong)), i) for i, wrong in enumerate(view.wrong) if wrong.any()]
    if not rows:
        return None
    row, i = min(rows)
    columns = view.columns
    column = (columns.theta, columns.omega, columns.t)[i]
    wanted = (view.wanted.theta, view.wanted.omega, view.timing.clock.t)[i][row]
    word = (WORDS[1], WORDS[2], WORDS[0])[i]
    return Where(int(columns.lines[row]), float(columns.t.values[row]), word, float(column.values[row]), float(wanted))


def deviations(problem: Problem, view: View) -> dict[str, Deviation]:
    """Each column against what is right at its times."""
    columns, wanted = view.columns, view.wanted
    off = (wrap(columns.theta.values - wanted.theta), columns.omega.values - wanted.omega)
    found = {}
    for role, wrong, distance, right in zip(ROLES[1:3], view.wrong[:2], off, wanted[:2], strict=True):
        found[role] = _deviation(wrong, right, distance)
    if problem.regime == -1 and columns.sine is not None:
        start = taken(RIGHT, problem)
        rows = Column(view.timing.clock.t, view.timing.clock.unsure)
        sinusoid = right_sinusoid(start, problem.tau)
        right = sinusoid.at(rows.values)
        fit = fits(sinusoid.at, start, rows, columns.sine)
        found["sine"] = _deviation(~fit, right, columns.sine.values - right)
    return found


def _deviation(wrong: npt.NDArray[np.bool_], wanted: Floats, off: Floats) -> Deviation:
    rows = np.flatnonzero(wrong)
    first = int(rows[0]) if rows.size else None
    with np.errstate(invalid="ignore"):
        return Deviation(int((~wrong).sum()), first, wanted, float(np.nanmax(np.abs(off), initial=0.0)))
