"""Known mistakes, each as a hypothesis: a function that gives what a program with that mistake prints."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from pendula._solve import solve
from pendula.check._problem import (
    PERIOD,
    Asked,
    Motion,
    Start,
    closed_form,
    differences,
    fits,
    right,
    right_sine,
    with_unsure_times,
    wrap,
)
from pendula.check._table import Column

if TYPE_CHECKING:
    from collections.abc import Callable

    from pendula._solution import Solution
    from pendula._tables import Method
    from pendula.check._table import Columns, Floats

DEGREE = np.pi / 180

# Of angle and velocity, in the order in which they are tried.
UNITS = ((1.0, 1.0), (DEGREE, 1.0), (1.0, DEGREE), (DEGREE, DEGREE))

MOST_STEPS = 1 << 20  # of a run whose every step is kept
MOST_SINGLE_STEPS = 1 << 16  # each is a call of `solve`, some 20 µs
SINGLE = float(np.finfo(np.float32).eps)
TINY = 1e-7  # factor of an angle, after which sin θ is θ


class Explanation(NamedTuple):
    """A hypothesis: what the program took for the pendulum, what it computed of that, and when."""

    name: str
    """In FINDINGS; empty where nothing is wrong."""
    start: Callable[[Start], Start]
    motion: Callable[[Start, Asked, Floats], Motion | None]
    """At given times; None where the hypothesis cannot be tried."""
    times: Callable[[Start, Asked, Floats], Floats]
    """Of the states, for the times that were printed."""


class Reading(NamedTuple):
    """The explanation of a table's states, the times that they belong to, and the units of angle and velocity [rad]."""

    explanation: Explanation
    times: Column
    angle_unit: float
    velocity_unit: float


def explain(problem: Asked, columns: Columns) -> Reading | None:
    """The first hypothesis within whose tolerance all states are."""
    for explanation in EXPLANATIONS:
        start = explanation.start(problem.start)
        try:
            times = Column(explanation.times(start, problem, columns.t.values), columns.t.units)
            motions = [explanation.motion(start, problem, each) for each in times.nearby()]
        except ValueError:  # with this mistake there is no legal pendulum
            continue
        tried = [motion for motion in motions if motion is not None]
        if len(tried) < len(motions):
            continue
        motion = with_unsure_times(*tried)
        for angle_unit, velocity_unit in UNITS:
            if all(map(np.all, fits(motion, columns.theta.scaled(angle_unit), columns.omega.scaled(velocity_unit)))):
                return Reading(explanation, times, angle_unit, velocity_unit)
    return None


# What the program took for the pendulum.


def as_given(start: Start) -> Start:
    """As it should."""
    return start


def scaled(theta0: float, omega0: float) -> Callable[[Start], Start]:
    """The initial state times these factors."""
    return lambda start: start._replace(theta0=start.theta0 * theta0, omega0=start.omega0 * omega0)


# When the states are those of.


def as_printed(_start: Start, _problem: Asked, t: Floats) -> Floats:
    """The times that stand in the table."""
    return t


def later(steps: float, rows: float) -> Callable[[Start, Asked, Floats], Floats]:
    """Times some steps and rows later than those printed."""
    return lambda _start, problem, t: t + steps * problem.dt + rows * problem.every


def in_periods(start: Start, _problem: Asked, t: Floats) -> Floats:
    """The times printed, if their unit is the characteristic time."""
    return t * start.tau


def of_rows(_start: Start, problem: Asked, t: Floats) -> Floats:
    """The times that the rows should have."""
    return np.arange(float(t.size)) * problem.every


# What the program computed; `right` is in _problem.py.


def nearly(start: Start, problem: Asked, t: Floats) -> Motion:
    """The right motion, with slack for a period that is not quite right, too."""
    motion = right(start, problem, t)
    theta_off, omega_off = differences(start, t * (1 + PERIOD), motion.theta, motion.omega)
    return Motion(motion.theta, motion.omega, motion.theta_slack + theta_off, motion.omega_slack + omega_off)


def upside_down(start: Start, problem: Asked, t: Floats) -> Motion:
    """With the wrong sign of the acceleration the top is where a pendulum hangs."""
    motion = right(start._replace(theta0=start.theta0 + np.pi), problem, t)
    return motion._replace(theta=wrap(motion.theta - np.pi))


def straightened(start: Start, _problem: Asked, t: Floats) -> Motion:
    """Small oscillations, as if sin θ were θ: those of a ten-millionth of the angle, magnified."""
    theta, omega = closed_form(Start(start.theta0 * TINY, start.omega0 * TINY, start.alpha), t)
    return Motion(wrap(theta / TINY), omega / TINY)


def by_euler(start: Start, problem: Asked, t: Floats) -> Motion | None:
    """Euler's method at the problem's step."""
    run = _by_steps(start, _step(start, problem), t, "euler")
    if run is None:
        return None
    return _worse(start, t, np.interp(t, run.t, run.unwrapped), np.interp(t, run.t, run.omega))


def by_euler_cromer(start: Start, problem: Asked, t: Floats) -> Motion | None:
    """Euler's method with the new velocity: its angles are those of Verlet's method with another initial velocity, and its
    velocities are the differences of angles over the step.
    """
    step = _step(start, problem)
    instant = step / 1000  # so short that acceleration is constant
    kick = (closed_form(start, instant)[1] - start.omega0) * (step / 2 / instant)
    run = _by_steps(start._replace(omega0=start.omega0 + float(kick)), step, t, "verlet")
    if run is None:
        return None
    omega = np.append(start.omega0, np.diff(run.unwrapped) / step)
    return _worse(start, t, np.interp(t, run.t, run.unwrapped), np.interp(t, run.t, omega))


def in_single_precision(start: Start, problem: Asked, t: Floats) -> Motion | None:
    """The right motion, within three times the errors of a Runge-Kutta whose time and state have 24 bits after each step."""
    steps = round(float(t.max()) / problem.dt)
    if not 0 < steps <= MOST_SINGLE_STEPS:
        return None
    run_t, run_theta, run_omega = _rounded_run(start, np.float32(problem.dt), steps)
    errors = differences(start, run_t, run_theta, run_omega)
    slacks = [3 * np.interp(t, run_t, np.maximum.accumulate(error)) + 4 * SINGLE for error in errors]
    return Motion(*closed_form(start, t), *slacks)


def _rounded_run(start: Start, dt: np.float32, steps: int) -> Floats:
    """[t, theta, omega] of every step."""
    run = np.empty((3, steps + 1), np.float32)
    run[:, 0] = 0, start.theta0, start.omega0
    step = float(dt)
    for i in range(steps):
        after = solve(float(run[1, i]), float(run[2, i]), alpha=start.alpha, every=step, until=step, dt=step)
        run[:, i + 1] = run[0, i] + dt, after.unwrapped[1], after.omega[1]
    return run.astype(np.float64)


def _step(start: Start, problem: Asked) -> float:
    """The problem's factor of the characteristic time of the pendulum that was taken for it."""
    return problem.dt * start.tau / problem.tau


def _by_steps(start: Start, step: float, t: Floats, method: Method) -> Solution | None:
    """Every step of a method, to beyond the last of the times."""
    last = float(t.max())
    if not 0 < last / step <= MOST_STEPS:
        return None
    return solve(start.theta0, start.omega0, alpha=start.alpha, every=step, until=last + 2 * step, dt=step, method=method)


def _worse(start: Start, t: Floats, theta: Floats, omega: Floats) -> Motion:
    """A motion by a worse method, within a twentieth of its errors: programs differ in where their steps end."""
    slacks = (np.maximum.accumulate(each) / 20 for each in differences(start, t, theta, omega))
    return Motion(wrap(theta), omega, *slacks)


# Where several explain a table, the first is told.
EXPLANATIONS = (
    Explanation("", as_given, right, as_printed),
    Explanation("theta0 in degrees", scaled(1 / DEGREE, 1), right, as_printed),
    Explanation("omega0 in degrees", scaled(1, 1 / DEGREE), right, as_printed),
    Explanation("both in degrees", scaled(1 / DEGREE, 1 / DEGREE), right, as_printed),
    Explanation("theta0 as degrees", scaled(DEGREE, 1), right, as_printed),
    Explanation("omega0 as degrees", scaled(1, DEGREE), right, as_printed),
    Explanation("both as degrees", scaled(DEGREE, DEGREE), right, as_printed),
    Explanation("euler", as_given, by_euler, as_printed),
    Explanation("euler cromer", as_given, by_euler_cromer, as_printed),
    Explanation("straightened", as_given, straightened, as_printed),
    Explanation("other sign of omega0", scaled(1, -1), right, as_printed),
    Explanation("other sign of theta0", scaled(-1, 1), right, as_printed),
    Explanation("upside down", as_given, upside_down, as_printed),
    Explanation("root of alpha", lambda start: start._replace(alpha=start.alpha**0.5), right, as_printed),
    Explanation("square of alpha", lambda start: start._replace(alpha=start.alpha * start.alpha), right, as_printed),
    Explanation("alpha of 1", lambda start: start._replace(alpha=1.0), right, as_printed),
    Explanation("a step late", as_given, right, later(1, 0)),
    Explanation("a step early", as_given, right, later(-1, 0)),
    Explanation("a row late", as_given, right, later(0, 1)),
    Explanation("a row early", as_given, right, later(0, -1)),
    Explanation("times in periods", as_given, right, in_periods),
    Explanation("single precision", as_given, in_single_precision, as_printed),
    Explanation("times", as_given, nearly, of_rows),
)


# The sinusoid (3.4), of the pendulum that was solved, at the times that were printed; `right_sine` is in _problem.py.


class Sinusoid(NamedTuple):
    """A hypothesis."""

    name: str
    """In FINDINGS; empty where nothing is wrong."""
    column: Callable[[Start, Floats], Floats]


def other_sign(start: Start, t: Floats) -> Floats:
    """The phase as if the velocity had the other sign: that of the arcsine alone, where the velocity is negative."""
    return right_sine(start._replace(omega0=-start.omega0), t)


def no_phase(start: Start, t: Floats) -> Floats:
    """The sinusoid of a pendulum of the same amplitude that starts at the bottom."""
    _, omega = closed_form(Start(start.theta_max, 0.0, start.alpha), -start.tau / 4)
    return right_sine(Start(0.0, float(omega), start.alpha), t)


def quarter_turn(start: Start, t: Floats) -> Floats:
    """The cosine for the sine."""
    return right_sine(start, t + start.tau / 4)


def initial_amplitude(start: Start, t: Floats) -> Floats:
    """θ0 for θM."""
    return right_sine(start, t) * (start.theta0 / start.theta_max if start.theta_max != 0 else 1.0)


def small_period(start: Start, t: Floats) -> Floats:
    """The period of small oscillations."""
    return right_sine(start, t * (start.tau / Start(0.0, 0.0, start.alpha).tau))


def double_period(start: Start, t: Floats) -> Floats:
    """Twice the period."""
    return right_sine(start, t / 2)


def angle(start: Start, t: Floats) -> Floats:
    """The pendulum's own angle."""
    return closed_form(start, t)[0]


SINUSOIDS = (
    Sinusoid("", right_sine),
    Sinusoid("sine other sign", other_sign),
    Sinusoid("sine no phase", no_phase),
    Sinusoid("sine quarter turn", quarter_turn),
    Sinusoid("sine initial amplitude", initial_amplitude),
    Sinusoid("sine small period", small_period),
    Sinusoid("sine double period", double_period),
    Sinusoid("sine is the angle", angle),
)
