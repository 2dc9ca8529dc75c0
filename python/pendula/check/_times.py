"""The times of a table's rows against those that the problem asks for."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from pendula import _core
from pendula.check._asked import PERIOD, Asked, Start
from pendula.check._findings import Finding, error, remark

if TYPE_CHECKING:
    from collections.abc import Iterator

BISECTIONS = 60  # from a speed's binary digits to the last of them
ALMOST_FREE = 1e-12  # of gravity, for a rotation that hardly feels it


class Grid(NamedTuple):
    """Times t0 + j every, as far as their digits tell."""

    first: float
    every: float
    rows: int
    unit: float
    """Of the last time's last digit."""


def grid(t: Any, units: Any) -> Grid:
    """The evenly spaced times nearest to those printed."""
    every = (t[-1] - t[0]) / (t.size - 1) if t.size > 1 else 0.0
    return Grid(float(t[0]), float(every), int(t.size), float(units.max()))


def judge_times(problem: Asked, taken: Start, t: Any, units: Any, has_sine: bool) -> list[Finding]:
    """What is wrong with the times of a program that took the pendulum for `taken`."""
    if t.size < 2:
        return [error("one row", expected=problem.rows)] if problem.rows > 1 else []
    have = grid(t, units)
    slack = 1.01 * problem.dt + have.unit  # a row may wait for the end of a step
    off = np.abs(t - (have.first + have.every * np.arange(t.size)))
    if off.max() > slack:
        return [error("uneven rows", row=int(np.argmax(off > slack)) + 1, every=problem.every)]
    findings = [error("late start", first=have.first)] if abs(have.first) > slack else []
    # Rows that nothing has made to wait show the period to the last digit.
    drift = 2 * have.unit if off.max() <= 2 * have.unit else slack
    as_taken = problem.every * taken.tau / problem.tau
    expected = min((problem.every, as_taken), key=lambda every: abs(every - have.every))
    if abs(have.every - expected) * (have.rows - 1) <= drift + PERIOD * expected * have.rows:
        return findings + _length(problem, have, slack)
    return [*findings, _spacing(problem, taken, have, has_sine)]


def _length(problem: Asked, have: Grid, slack: float) -> list[Finding]:
    """A last row may be lost, or won, by how sums of times are rounded."""
    more = have.rows + round(have.first / problem.every) - problem.rows
    counts = {
        "rows": have.rows,
        "expected": problem.rows,
        "last": have.first + have.every * (have.rows - 1),
        "until": problem.until,
    }
    if more == 0:
        return []
    if abs(more) == 1 and abs(problem.until - round(problem.until / problem.every) * problem.every) <= slack:
        return [remark("last row lost" if more < 0 else "last row won", **counts)]
    return [error("early end" if more < 0 else "late end", **counts)]


def _spacing(problem: Asked, taken: Start, have: Grid, has_sine: bool) -> Finding:
    """The first wrong characteristic time, or forgotten factor, that gives the spacing there is."""
    factor = problem.every / problem.tau
    uncertainty = have.unit / (have.rows - 1) + PERIOD * have.every
    values = {"tau": taken.tau, "got": have.every / factor, "every": problem.every, "spacing": have.every, "k": problem.regime}
    for name, every, slack in _spacings(problem, taken, factor):
        if abs(every - have.every) <= uncertainty + slack:
            return error(name, **values)
    if problem.regime == 0 or (problem.regime == -1 and not has_sine):
        return error("regime", **values)
    if problem.regime != 0 and first_term(taken, problem.regime) < values["got"] < taken.tau:
        return error("series cut", relative=1 - values["got"] / taken.tau, **values)
    return error("tau", **values)


def _spacings(problem: Asked, taken: Start, factor: float) -> Iterator[tuple[str, float, float]]:
    """Mistakes, the times between rows that they give, and how far these may be off."""
    yield "period doubled", 2 * taken.tau * factor, 0
    yield "period halved", taken.tau / 2 * factor, 0
    if problem.regime != 0:
        yield "series not begun", first_term(taken, problem.regime) * factor, 0
        yield "regime", separatrix(taken).tau * factor, 0
    yield "seconds", factor, problem.dt  # no whole number of steps
    yield "every step", problem.dt, 0


def first_term(start: Start, regime: int) -> float:
    """T0 of the series (3.6): the period without gravity's, or without the amplitude's, part in it."""
    if regime < 0:
        return Start(0.0, 0.0, start.alpha).tau
    energy_of_1 = _core.energy(0.0, 1.0, start.alpha)
    at_bottom = float(np.sqrt(_core.energy(start.theta0, start.omega0, start.alpha) / energy_of_1))
    return Start(0.0, at_bottom, start.alpha * ALMOST_FREE).tau


def separatrix(start: Start) -> Start:
    """The pendulum nearest to the separatrix of those that start from the same angle, the same way round."""
    low, high = 0.0, 1.0
    way = -1.0 if start.omega0 < 0 else 1.0
    while _regime(start._replace(omega0=high)) < 0:
        high *= 2
    for _ in range(BISECTIONS):
        middle = (low + high) / 2
        regime = _regime(start._replace(omega0=middle))
        if regime == 0:
            return start._replace(omega0=way * middle)
        low, high = (middle, high) if regime < 0 else (low, middle)
    return start._replace(omega0=way * high)


def _regime(start: Start) -> int:
    return int(_core.analyze(*start)[0])
