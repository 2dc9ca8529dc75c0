"""A table's states beside those of the hypotheses."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from pendula import _core
from pendula.check import _sines
from pendula.check._asked import Asked, Start, method_error
from pendula.check._motions import EXPLANATIONS, Explanation, Motion, right

if TYPE_CHECKING:
    from collections.abc import Callable

DEGREE = np.pi / 180


class Column(NamedTuple):
    """What was printed of a quantity."""

    values: Any
    units: Any
    """Of the last digits."""


class Columns(NamedTuple):
    """What was printed, in rows that have a time and a state."""

    t: Column
    theta: Column
    omega: Column
    sine: Column | None
    lines: Any
    """The rows' lines in the file."""
    digits: int
    """Significant ones of the states."""


class Reading(NamedTuple):
    """A hypothesis that explains the states, if they are of these times, and angle and velocity in these units [rad]."""

    explanation: Explanation
    times: Column
    angle_unit: float
    velocity_unit: float


class Deviation(NamedTuple):
    """How far a column is from what it should be."""

    right: int
    """Rows that are as they should be."""
    first_wrong: int | None
    """The first row that is not."""
    wanted: Any
    """What should be there."""
    from_exact: float
    """The largest distance from the closed form [rad, rad/s]."""
    from_rk4: float
    """The same from Runge-Kutta at the problem's step."""


def explain(problem: Asked, columns: Columns) -> Reading | None:
    """The first hypothesis within whose tolerance all states are."""
    for explanation in EXPLANATIONS:
        start = explanation.start(problem.start)
        times = Column(explanation.times(start, problem, columns.t.values), columns.t.units)
        motion = explanation.motion(start, problem, times.values)
        if motion is None:
            continue
        blurred = _blurred(motion, partial(explanation.motion, start, problem), times)
        for angle_unit, velocity_unit in ((1.0, 1.0), (DEGREE, 1.0), (1.0, DEGREE), (DEGREE, DEGREE)):
            theta, omega = _scaled(columns.theta, angle_unit), _scaled(columns.omega, velocity_unit)
            if all(np.all(fits) for fits in _fits(blurred, theta, omega)):
                return Reading(explanation, times, angle_unit, velocity_unit)
    return None


def is_right(problem: Asked, columns: Columns) -> bool:
    """Whether all states are."""
    motion = _blurred(right(problem.start, problem, columns.t.values), partial(right, problem.start, problem), columns.t)
    return all(np.all(fits) for fits in _fits(motion, columns.theta, columns.omega))


def deviations(problem: Asked, columns: Columns) -> dict[str, Deviation]:
    """Each column against the closed form and against Runge-Kutta, at the times printed."""
    t, theta, omega, sine = columns[:4]
    motion = _blurred(right(problem.start, problem, t.values), partial(right, problem.start, problem), t)
    theta_fits, omega_fits = _fits(motion, theta, omega)
    theta_error, omega_error = method_error(problem, t.values)
    # An angle that is right but for whole turns is told apart by the hypotheses, not here.
    theta_off, omega_off = _core.wrap(theta.values - motion.theta), omega.values - motion.omega
    found = {
        "theta": _deviation(theta_fits, motion.theta, theta_off, _core.wrap(theta_off - theta_error)),
        "omega": _deviation(omega_fits, motion.omega, omega_off, omega_off - omega_error),
    }
    if problem.regime == -1 and sine is not None:
        wanted = _sines.right(problem.start, t.values)
        off = sine.values - wanted
        found["sine"] = _deviation(sine_fits(_sines.right, problem.start, t, sine), wanted, off, off)
    return found


def sine_fits(column: Callable[[Start, Any], Any], start: Start, t: Column, sine: Column) -> Any:
    """Rows in which the sinusoid is that of a hypothesis."""
    before, wanted, after = (column(start, t.values + shift * t.units) for shift in (-1, 0, 1))
    return np.abs(sine.values - wanted) <= sine.units + np.abs(after - before) + _sines.slack(start, t.values)


def _blurred(motion: Motion, at: Callable[[Any], Motion | None], t: Column) -> Motion:
    """A motion with slack for how far it goes in what the printed times leave open."""
    before, after = at(t.values - t.units), at(t.values + t.units)
    if before is None or after is None:
        return motion
    theta_blur = np.abs(_core.wrap(after.theta - before.theta))
    omega_blur = np.abs(after.omega - before.omega)
    return motion._replace(theta_slack=motion.theta_slack + theta_blur, omega_slack=motion.omega_slack + omega_blur)


def _scaled(column: Column, unit: float) -> Column:
    return Column(column.values * unit, column.units * unit)


def _fits(motion: Motion, theta: Column, omega: Column) -> tuple[Any, Any]:
    """Rows in which angle, but for whole turns, and velocity are those of the motion."""
    theta_off = np.abs(_core.wrap(theta.values - motion.theta))
    omega_off = np.abs(omega.values - motion.omega)
    return theta_off <= theta.units + motion.theta_slack, omega_off <= omega.units + motion.omega_slack


def _deviation(fits: Any, wanted: Any, from_exact: Any, from_rk4: Any) -> Deviation:
    wrong = np.flatnonzero(~fits)
    first = int(wrong[0]) if wrong.size else None
    return Deviation(int(fits.sum()), first, wanted, float(np.abs(from_exact).max()), float(np.abs(from_rk4).max()))
