"""Ways to get the motion wrong, each with the table that it gives. The core computes all of them."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from pendula import _core, solve
from pendula.check._asked import PERIOD, ROUNDING, Asked, Start, closed_form, method_error

if TYPE_CHECKING:
    from collections.abc import Callable

    from pendula import Solution

MOST_STEPS = 1 << 20  # of a run whose every step is kept
MOST_SINGLE_STEPS = 1 << 16  # each is a call of the core
SINGLE = float(np.finfo(np.float32).eps)
DEGREE = 180 / np.pi
TINY = 1e-7  # of the angle, in a pendulum that hardly leaves the bottom


class Motion(NamedTuple):
    """States at given times, and how far off they may be for what is not known about the program."""

    theta: Any
    omega: Any
    theta_slack: Any = 0.0
    omega_slack: Any = 0.0


def as_printed(_start: Start, _problem: Asked, t: Any) -> Any:
    """The times that stand in the table."""
    return t


class Explanation(NamedTuple):
    """A hypothesis: what the program took for the pendulum, and what it computed of that."""

    name: str
    """In TEXTS; empty where nothing is wrong."""
    start: Callable[[Start], Start]
    motion: Callable[[Start, Asked, Any], Motion | None]
    """At given times; None where the hypothesis cannot be tried."""
    times: Callable[[Start, Asked, Any], Any] = as_printed
    """Of the states, for the times that were printed."""


def right(start: Start, problem: Asked, t: Any) -> Motion:
    """The closed form, within twice Runge-Kutta's error at the problem's step and what rounding can grow to."""
    theta, omega = closed_form(start, t)
    rounded = [Start(start.theta0 * factor, start.omega0 * factor, start.alpha) for factor in (1 - ROUNDING, 1 + ROUNDING)]
    spreads = np.max([_differences(other, t, theta, omega) for other in rounded], axis=0)
    slacks = np.maximum.accumulate(2 * np.abs(method_error(problem, t)) + spreads + ROUNDING, axis=1)
    return Motion(theta, omega, *slacks)


def later(steps: float, rows: float) -> Callable[[Start, Asked, Any], Any]:
    """Times some steps and rows later than those printed."""
    return lambda _start, problem, t: t + steps * problem.dt + rows * problem.every


def in_periods(start: Start, _problem: Asked, t: Any) -> Any:
    """The times printed, if these count the characteristic time."""
    return t * start.tau


def of_rows(_start: Start, problem: Asked, t: Any) -> Any:
    """The times that the rows should have."""
    return np.arange(t.size) * problem.every


def nearly(start: Start, problem: Asked, t: Any) -> Motion:
    """The closed form, within what a period that is not quite right makes of it, too."""
    motion = right(start, problem, t)
    theta_off, omega_off = _differences(start, t * (1 + PERIOD), motion.theta, motion.omega)
    return Motion(motion.theta, motion.omega, motion.theta_slack + theta_off, motion.omega_slack + omega_off)


def upside_down(start: Start, problem: Asked, t: Any) -> Motion:
    """With the acceleration's sign wrong the pendulum is one that hangs from where the top was."""
    motion = right(start._replace(theta0=start.theta0 + np.pi), problem, t)
    return motion._replace(theta=_core.wrap(motion.theta - np.pi))


def straightened(start: Start, _problem: Asked, t: Any) -> Motion:
    """Small oscillations, as if sin θ were θ: those of a millionth of the angle, magnified."""
    theta, omega = closed_form(Start(start.theta0 * TINY, start.omega0 * TINY, start.alpha), t)
    return Motion(_core.wrap(theta / TINY), omega / TINY)


def by_euler(start: Start, problem: Asked, t: Any) -> Motion | None:
    """Euler's method at the problem's step."""
    run = _by_steps(start, _step(start, problem), t, "euler")
    if run is None:
        return None
    return _mistaken(start, t, np.interp(t, run.t, run.unwrapped), np.interp(t, run.t, run.omega))


def by_euler_cromer(start: Start, problem: Asked, t: Any) -> Motion | None:
    """Euler's method with the new velocity: the angles are those of Verlet's, the velocities what lies between two of them."""
    step = _step(start, problem)
    instant = step / 1000  # so short that acceleration is constant
    kick = (closed_form(start, instant)[1] - start.omega0) * (step / 2 / instant)
    run = _by_steps(start._replace(omega0=start.omega0 + float(kick)), step, t, "verlet")
    if run is None:
        return None
    omega = np.append(start.omega0, np.diff(run.unwrapped) / step)
    return _mistaken(start, t, np.interp(t, run.t, run.unwrapped), np.interp(t, run.t, omega))


def in_single_precision(start: Start, problem: Asked, t: Any) -> Motion | None:
    """The closed form, within three times the errors of a Runge-Kutta whose time and state have 24 bits after each step."""
    steps = round(float(t.max()) / problem.dt)
    if not 0 < steps <= MOST_SINGLE_STEPS:
        return None
    run = _rounded_run(start, np.float32(problem.dt), steps)
    theta, omega = closed_form(start, run[0])
    errors = (np.abs(_core.wrap(run[1] - theta)), np.abs(run[2] - omega))
    slacks = [3 * np.interp(t, run[0], np.maximum.accumulate(error)) + 4 * SINGLE for error in errors]
    return Motion(*closed_form(start, t), *slacks)


def _rounded_run(start: Start, dt: np.float32, steps: int) -> Any:
    """[t, theta, omega] of every step."""
    run = np.empty((3, steps + 1), np.float32)
    run[:, 0] = 0, start.theta0, start.omega0
    parameters = (start.alpha, 0.0, 0.0, 0.0, 0.0, 0.0)
    for i in range(steps):
        state = (float(run[1, i]), float(run[2, i]), *parameters)
        theta, omega, turns = _core.solve(state, 0.0, float(dt), 1, 2, 1.0, 0, 1e-15, 1)[:, 1, 0]
        run[:, i + 1] = run[0, i] + dt, _core.unwrap(theta, turns), omega
    return run.astype(float)


def _step(start: Start, problem: Asked) -> float:
    """The problem's factor of the characteristic time of the pendulum that was taken for it."""
    return problem.dt * start.tau / problem.tau


def _by_steps(start: Start, step: float, t: Any, method: str) -> Solution | None:
    """Every step of a method, to beyond the last of the times."""
    last = float(t.max())
    if not 0 < last / step <= MOST_STEPS:
        return None
    return solve(start.theta0, start.omega0, alpha=start.alpha, every=step, until=last + 2 * step, dt=step, method=method)


def _differences(start: Start, t: Any, theta: Any, omega: Any) -> tuple[Any, Any]:
    """How far a pendulum is from the states of another."""
    near_theta, near_omega = closed_form(start, t)
    return np.abs(_core.wrap(near_theta - theta)), np.abs(near_omega - omega)


def _mistaken(start: Start, t: Any, theta: Any, omega: Any) -> Motion:
    """A motion by a worse method, within a twentieth of what is worse: programs differ in where their steps end."""
    slacks = (np.maximum.accumulate(each) / 20 for each in _differences(start, t, theta, omega))
    return Motion(_core.wrap(theta), omega, *slacks)


def _as_given(start: Start) -> Start:
    return start


# In the order in which they are believed, where several explain a table.
EXPLANATIONS = (
    Explanation("", _as_given, right),
    Explanation("theta0 in degrees", lambda s: s._replace(theta0=s.theta0 * DEGREE), right),
    Explanation("omega0 in degrees", lambda s: s._replace(omega0=s.omega0 * DEGREE), right),
    Explanation("both in degrees", lambda s: Start(s.theta0 * DEGREE, s.omega0 * DEGREE, s.alpha), right),
    Explanation("theta0 as degrees", lambda s: s._replace(theta0=s.theta0 / DEGREE), right),
    Explanation("omega0 as degrees", lambda s: s._replace(omega0=s.omega0 / DEGREE), right),
    Explanation("both as degrees", lambda s: Start(s.theta0 / DEGREE, s.omega0 / DEGREE, s.alpha), right),
    Explanation("euler", _as_given, by_euler),
    Explanation("euler cromer", _as_given, by_euler_cromer),
    Explanation("straightened", _as_given, straightened),
    Explanation("other sign of omega0", lambda s: s._replace(omega0=-s.omega0), right),
    Explanation("other sign of theta0", lambda s: s._replace(theta0=-s.theta0), right),
    Explanation("upside down", _as_given, upside_down),
    Explanation("root of alpha", lambda s: s._replace(alpha=s.alpha**0.5), right),
    Explanation("square of alpha", lambda s: s._replace(alpha=s.alpha**2), right),
    Explanation("alpha of 1", lambda s: s._replace(alpha=1.0), right),
    Explanation("a step late", _as_given, right, later(1, 0)),
    Explanation("a step early", _as_given, right, later(-1, 0)),
    Explanation("a row late", _as_given, right, later(0, 1)),
    Explanation("a row early", _as_given, right, later(0, -1)),
    Explanation("times in periods", _as_given, right, in_periods),
    Explanation("single precision", _as_given, in_single_precision),
    Explanation("times", _as_given, nearly, of_rows),
)
