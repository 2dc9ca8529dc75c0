"""What a problem asks for: the pendulum, its times, and what the core gives for them."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from pendula import _core, analyze

if TYPE_CHECKING:
    from pendula._program import Solved

# How far a program of double precision may be off: it adds up ten thousand steps and knows its period to 1e-7 (3.9).
ROUNDING = 1e-11
PERIOD = 1e-6


class Start(NamedTuple):
    """A pendulum and its initial state."""

    theta0: float
    omega0: float
    alpha: float

    @property
    def tau(self) -> float:
        """Characteristic time [s]."""
        return float(analyze(self.theta0, self.omega0, alpha=self.alpha).tau)


class Asked(NamedTuple):
    """A problem, solved by Runge-Kutta at its step."""

    start: Start
    regime: int
    tau: float
    dt: float
    every: float
    until: float
    t: Any
    """The rows' times [s]."""
    theta: Any
    """By Runge-Kutta, in [-π, π)."""
    omega: Any

    @property
    def rows(self) -> int:
        """How many rows there are."""
        return int(self.t.size)


def asked(solved: Solved) -> Asked:
    """The problem as the program has read and solved it."""
    problem, solution = solved
    given = solution.parameters
    return Asked(
        start=Start(given.theta0, given.omega0, given.alpha),
        regime=problem["k"],
        tau=problem["tau"],
        dt=problem["dt"],
        every=problem["every"],
        until=problem["until"],
        t=solution.t,
        theta=solution.theta,
        omega=solution.omega,
    )


def closed_form(start: Start, t: Any) -> tuple[Any, Any]:
    """(theta in [-π, π), omega) at times t."""
    theta, omega, _ = _core.states(*start, t)
    return theta, omega


def method_error(problem: Asked, t: Any) -> tuple[Any, Any]:
    """How far Runge-Kutta at the problem's step is from the closed form, (theta, omega) interpolated at times t."""
    theta, omega = closed_form(problem.start, problem.t)
    errors = (_core.wrap(problem.theta - theta), problem.omega - omega)
    theta_error, omega_error = (np.interp(t, problem.t, error) for error in errors)
    return theta_error, omega_error
