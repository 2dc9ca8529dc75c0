"""The rows that evenly spaced times are of, and after how many steps each is."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from pendula.check._program import Clock

if TYPE_CHECKING:
    from pendula.check._program import Floats, Problem
    from pendula.check._table import Column

PERIOD = 1e-6  # relative: periods that differ by less are equal (3.9 allows 1e-7, and programs add up steps)
KNOWN = 1e-7  # relative: how well a right program knows its own period
MOST_STEPS = 2**52


class Grid(NamedTuple):
    """Times first + j every, as far as their digits tell."""

    first: float
    every: float
    places: Floats
    """The rows' j, from 0; some may be missing."""
    unit: float
    """Of the last digit of the last time."""

    @property
    def rows(self) -> int:
        """How many there are up to the last."""
        return int(self.places[-1]) + 1

    @property
    def values(self) -> Floats:
        """The times."""
        return self.first + self.every * self.places


def grid_of(t: Column, places: Floats, dt: float) -> Grid:
    """The evenly spaced times nearest to those printed; a few wrong ones among them do not matter."""
    most = usual(t.units)
    unit = max(most, min(float(t.units[-1]), 10 * most))
    if places.size < 2 or not places[-1] > places[0]:
        return Grid(float(t.values[0]), 0.0, places, unit)
    every = float((t.values[-1] - t.values[0]) / (places[-1] - places[0]))
    first = float(t.values[0]) - places[0] * every
    off = np.abs(t.values - first - places * every)
    if np.sum(off > 2 * t.units) > one_of(places.size):
        # The first or the last may be among the wrong ones.
        robust = float(np.median(np.diff(t.values) / np.diff(places)))
        level = float(np.median(t.values - places * robust))
        near = np.abs(t.values - level - places * robust) <= np.maximum(2 * t.units, robust / 20)
        if robust > 0 and np.sum(near) == places.size - one_of(places.size):
            fitted = np.polyfit(places[near], t.values[near], 1)
            away = np.abs(t.values - np.polyval(fitted, places))[~near]
            if np.all(away > 1.01 * dt + 2 * t.units[~near]):  # no end of a step
                every, first = map(float, fitted)
                first = 0.0 if abs(first) <= 2 * unit else first
    return Grid(first, every, places, unit)


def one_of(rows: int) -> int:
    """How many wrong times among so many are a wrong cell, and no mistake of the program."""
    return 1 if rows > 3 else 0


def usual(off: Floats) -> float:
    """The largest, but for one that may be wrong."""
    return float(np.sort(off)[-1 - one_of(off.size)])


def latest(every: float, dt: float) -> float:
    """How late a row may be that is printed at the end of the step that reaches its time."""
    per_row = every / dt
    return min(1.01 * dt, every / 2) if abs(per_row - round(per_row)) <= PERIOD * per_row else 1.01 * dt


def clock_of(t: Column, grid: Grid, dt: float, every: float, doubt: float) -> Clock:
    """After how many steps the rows are. Where their times lie between steps, the steps are taken to be shorter."""
    values = np.where(np.isfinite(t.values), t.values, 0)
    places = grid.places + (round(grid.first / every) if every > 0 and abs(grid.first) < MOST_STEPS * every else 0)
    nominal = places * every
    slack = t.units + 1e-9 * np.abs(values)
    is_at_end = np.abs(values - np.round(values / dt) * dt) <= slack + PERIOD * np.abs(values)
    is_on_grid = np.abs(values - nominal) <= slack + (0 if is_at_end.all() else 0.01 * dt)
    unsure, coarser = np.zeros_like(values), 1.0
    if np.sum(~is_on_grid) <= one_of(values.size):
        whole = np.ceil(every / dt * (1 - 1e-9))
        longest, dt = dt, every / whole
        # A sum of many Δt prints a row, now and then, at the end of the next step; few digits do not show it.
        is_late = (np.abs(values - nominal - dt) <= slack) & (t.units < 0.4 * dt) & (whole > 1)
        steps = places * whole + is_late
        unsure = np.where((t.units > 0.4 * dt) & (whole > 1) & (places > 0), dt, 0.0)
        coarser = max(longest / dt, 1.0)
    else:
        off = np.abs(values - nominal) > max(every / 2, 1.01 * dt) + t.units
        values = np.where(off, nominal, values) if np.sum(off) <= one_of(values.size) else values
        steps = np.round(values / dt)
        unsure = np.where((t.units > 0.4 * dt) & (places > 0), t.units, 0)
    # A row that is earlier than the one before is wrong by its time.
    steps = np.maximum.accumulate(np.clip(steps, 0, MOST_STEPS))
    return Clock(steps.astype(np.int64), dt, doubt, unsure, coarser)


def numbered(problem: Problem, grid: Grid, dt: float) -> Clock:
    """The rows by their numbers, whatever their times."""
    whole = grid.places * round(max(problem.steps_per_row, 1))
    return Clock(whole.astype(np.int64), dt, KNOWN, np.zeros(whole.size))


def has_single_sums(t: Column, clock: Clock) -> bool:
    """Whether the times are no farther off than single precision makes sums of so many steps."""
    late = np.finfo(np.float32).eps * np.abs(clock.t) * (1 + clock.steps / 4)
    return bool(np.all(np.abs(t.values - clock.t) <= t.units + np.minimum(late, clock.dt)))


def is_on_time(t: Column, grid: Grid, every: float) -> bool:
    """Whether every row is at its own multiple of that, but for one that may be wrong."""
    off = np.abs(t.values - grid.places * every) > t.units + PERIOD * np.abs(t.values)
    return bool(np.sum(off) <= one_of(off.size))
