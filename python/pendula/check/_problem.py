"""What a problem asks for: the right states and sinusoid at the times printed, and how far a table is from them."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple, TypeAlias

import numpy as np

from pendula import _core
from pendula._closed_form import analyze, exact

if TYPE_CHECKING:
    from collections.abc import Callable

    import numpy.typing as npt

    from pendula._command import Solved
    from pendula.check._table import Column, Columns, Floats

    Rows: TypeAlias = npt.NDArray[np.bool_]

# How far a program of double precision may be off: it adds up ten thousand steps and knows its period to 1e-7 (3.9).
ROUNDING = 1e-11
PERIOD = 1e-6

BISECTIONS = 60  # from a velocity's first binary digit to its last
ALMOST_FREE = 1e-12  # factor of gravity, for a rotation that hardly feels it
EPSILON = float(np.finfo(float).eps)
LATEST = 1e9  # periods; no table's digits tell the phase of a later time


class Start(NamedTuple):
    """A pendulum and its initial state."""

    theta0: float
    omega0: float
    alpha: float

    @property
    def regime(self) -> int:
        """The assignment's k."""
        return int(analyze(self.theta0, self.omega0, alpha=self.alpha).regime)

    @property
    def theta_max(self) -> float:
        """Limit angle θM [rad]."""
        return float(analyze(self.theta0, self.omega0, alpha=self.alpha).theta_max)

    @property
    def tau(self) -> float:
        """Characteristic time [s]."""
        return float(analyze(self.theta0, self.omega0, alpha=self.alpha).tau)

    @property
    def first_term(self) -> float:
        """T0 of the series (3.6): the period without gravity, or without the amplitude's part in it [s]."""
        if self.regime < 0:
            return Start(0.0, 0.0, self.alpha).tau
        energy_ratio = _core.energy(self.theta0, self.omega0, self.alpha) / _core.energy(0.0, 1.0, self.alpha)
        return Start(0.0, float(np.sqrt(energy_ratio)), self.alpha * ALMOST_FREE).tau

    def on_separatrix(self) -> Start:
        """The same with the angular velocity, of the same sign, that is nearest to the separatrix."""
        way = -1.0 if self.omega0 < 0 else 1.0
        low, high = 0.0, 1.0
        while self._replace(omega0=high).regime < 0:
            high *= 2
        for _ in range(BISECTIONS):
            middle = (low + high) / 2
            regime = self._replace(omega0=middle).regime
            if regime == 0:
                return self._replace(omega0=way * middle)
            low, high = (middle, high) if regime < 0 else (low, middle)
        return self._replace(omega0=way * high)


class Asked(NamedTuple):
    """A problem, solved by Runge-Kutta at its step."""

    start: Start
    regime: int
    tau: float
    dt: float
    every: float
    until: float
    t: Floats
    """The rows' times [s]."""
    theta: Floats
    """By Runge-Kutta, in [-π, π)."""
    omega: Floats

    @property
    def rows(self) -> int:
        """How many rows there are."""
        return int(self.t.size)


def asked(solved: Solved) -> Asked:
    """The problem as the program has read and solved it."""
    solution, every, until = solved
    start = Start(*map(float, solution.parameters[:3]))
    dt = float(solution.dt or np.nan)
    return Asked(start, start.regime, start.tau, dt, every, until, t=solution.t, theta=solution.theta, omega=solution.omega)


class Motion(NamedTuple):
    """States at given times, and how far a table may be from them, because programs differ."""

    theta: Floats
    omega: Floats
    theta_slack: Floats | float = 0.0
    omega_slack: Floats | float = 0.0


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
    from_rk4: float
    """The same from Runge-Kutta at the problem's step."""


def wrap(theta: Floats | float) -> Floats:
    """Angles in [-π, π)."""
    wrapped: Floats = _core.wrap(theta)
    return wrapped


def closed_form(start: Start, t: Floats | float) -> tuple[Floats, Floats]:
    """(theta in [-π, π), omega) at times t."""
    theta, omega = exact(start.theta0, start.omega0, _clipped(start, t), alpha=start.alpha)
    return wrap(theta), omega


def differences(start: Start, t: Floats, theta: Floats, omega: Floats) -> tuple[Floats, Floats]:
    """How far a pendulum is from other states at times t."""
    near_theta, near_omega = closed_form(start, t)
    return np.abs(wrap(near_theta - theta)), np.abs(near_omega - omega)


def method_error(problem: Asked, t: Floats) -> tuple[Floats, Floats]:
    """Runge-Kutta at the problem's step less the closed form, (theta, omega) interpolated at times t."""
    theta, omega = closed_form(problem.start, problem.t)
    errors = (wrap(problem.theta - theta), problem.omega - omega)
    theta_error, omega_error = (np.interp(t, problem.t, error) for error in errors)
    return theta_error, omega_error


def right(start: Start, problem: Asked, t: Floats) -> Motion:
    """The closed form, within twice Runge-Kutta's error at the problem's step and what rounding can grow to."""
    theta, omega = closed_form(start, t)
    rounded = [Start(start.theta0 * factor, start.omega0 * factor, start.alpha) for factor in (1 - ROUNDING, 1 + ROUNDING)]
    spreads = np.max([differences(other, t, theta, omega) for other in rounded], axis=0)
    theta_slack, omega_slack = np.maximum.accumulate(2 * np.abs(method_error(problem, t)) + spreads + ROUNDING, axis=1)
    return Motion(theta, omega, theta_slack, omega_slack)


def right_sine(start: Start, t: Floats) -> Floats:
    """The sinusoid (3.4)."""
    sine: Floats = _core.sine(*start, _clipped(start, t))
    return sine


def _clipped(start: Start, t: Floats | float) -> Floats:
    """Times that the closed form can be trusted at; a row that claims to be later is wrong by its time, whatever its state."""
    latest = LATEST * start.tau
    return np.clip(t, -latest, latest)


def with_unsure_times(at: Motion, before: Motion, after: Motion) -> Motion:
    """A motion at the times printed, with slack for how far it goes from a unit of their last digits before to one after."""
    theta_slack = at.theta_slack + np.abs(wrap(after.theta - before.theta))
    omega_slack = at.omega_slack + np.abs(after.omega - before.omega)
    return at._replace(theta_slack=theta_slack, omega_slack=omega_slack)


def right_at_times(problem: Asked, t: Column) -> Motion:
    """The right motion at the times printed."""
    return with_unsure_times(*(right(problem.start, problem, times) for times in t.nearby()))


def fits(motion: Motion, theta: Column, omega: Column) -> tuple[Rows, Rows]:
    """Rows in which the angle, except for whole turns, and the velocity are those of the motion."""
    theta_off = np.abs(wrap(theta.values - motion.theta))
    omega_off = np.abs(omega.values - motion.omega)
    return theta_off <= theta.units + motion.theta_slack, omega_off <= omega.units + motion.omega_slack


def sine_fits(sinusoid: Callable[[Start, Floats], Floats], start: Start, t: Column, sine: Column) -> Rows:
    """Rows in which the fourth column is that sinusoid."""
    wanted, before, after = (sinusoid(start, times) for times in t.nearby())
    fit: Rows = np.abs(sine.values - wanted) <= sine.units + np.abs(after - before) + _sine_slack(start, t.values)
    return fit


def _sine_slack(start: Start, t: Floats) -> Floats:
    """How far off a right sinusoid may be: its period is known to 1e-6, and θM, an arccosine (3.2), has a relative error δ.

    δ comes from the last bit of the cosine. Where θ0 is θM, it changes the phase, the arcsine of their ratio, by √(2δ).
    """
    theta_max = abs(start.theta_max)
    if theta_max == 0:
        return np.zeros_like(t)
    delta = min(1.0, 4 * EPSILON / (theta_max * max(float(np.sin(theta_max)), EPSILON)))
    slack: Floats = theta_max * (PERIOD * (1 + 2 * np.pi * np.abs(t) / start.tau) + delta + np.sqrt(2 * delta))
    return slack


def deviations(problem: Asked, columns: Columns) -> dict[str, Deviation]:
    """Each column against the closed form and against Runge-Kutta, at the times printed."""
    t, theta, omega, sine = columns[:4]
    motion = right_at_times(problem, t)
    theta_fits, omega_fits = fits(motion, theta, omega)
    theta_error, omega_error = method_error(problem, t.values)
    # Whole turns in the angle are judged elsewhere.
    theta_off, omega_off = wrap(theta.values - motion.theta), omega.values - motion.omega
    found = {
        "theta": _deviation(theta_fits, motion.theta, theta_off, wrap(theta_off - theta_error)),
        "omega": _deviation(omega_fits, motion.omega, omega_off, omega_off - omega_error),
    }
    if problem.regime == -1 and sine is not None:
        wanted = right_sine(problem.start, t.values)
        off = sine.values - wanted
        found["sine"] = _deviation(sine_fits(right_sine, problem.start, t, sine), wanted, off, off)
    return found


def _deviation(fit: Rows, wanted: Floats, from_exact: Floats, from_rk4: Floats) -> Deviation:
    wrong = np.flatnonzero(~fit)
    first = int(wrong[0]) if wrong.size else None
    return Deviation(int(fit.sum()), first, wanted, float(np.abs(from_exact).max()), float(np.abs(from_rk4).max()))
