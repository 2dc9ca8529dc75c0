"""Random problems, and right tables for them, as other people's right programs print them."""

from __future__ import annotations

import functools
import math
from typing import NamedTuple

import numpy as np
from check_layouts import LAYOUTS, Row
from check_marking import solved
from hypothesis import strategies as st
from pendula import _core, analyze

MOST_STEPS = 20_000
FINEST = 0.0005  # step, but for the rows that are closer
TAU = 1e-7  # relative error of a period that (3.9) allows
ROUNDING = 1e-12  # what 20,000 steps round, relative to the largest state, with room
GROWTH = 1e-11  # what rounding of the initial state can grow to, relative to the largest state
EPSILON = float(np.finfo(float).eps)
SAME_STEP = 1e-6  # a time that is reached up to rounding is reached


class Problem(NamedTuple):
    step: float
    every: float
    until: float
    theta0: str
    omega0: str
    alpha: float
    kind: str
    """Of start, for those who look for what fails."""
    is_in_steps: bool
    """Whether rows are at the ends of steps."""
    is_whole: bool
    """Whether the last row is at the end of the run."""

    def text(self, scale: float = 1.0) -> str:
        """As the program reads it, with all times scaled."""
        factors = " ".join(repr(factor * scale) for factor in (self.step, self.every, self.until))
        return f"{factors} {self.theta0} {self.omega0} {self.alpha!r}"


class Case(NamedTuple):
    """A right table: its problem, and what is its program's own."""

    problem: Problem
    method: str
    tau_error: float
    """Of the program's period, in units of what (3.9) allows."""
    noise: int
    """Seed of the program's rounding, 0 for pendula's own."""
    is_at_step_ends: bool
    """Whether a row is printed at the end of the step that reaches its time, and not in the middle of a step."""
    is_last_lost: bool
    is_sine_as_written: bool
    """Whether (3.2) and (3.4) are computed as they stand in the assignment."""
    layout: str
    digits: int


# Starts.


def powers(low: float, high: float) -> st.SearchStrategy[float]:
    return st.floats(low, high).map(lambda exponent: 10.0**exponent)


signs = st.sampled_from([1.0, -1.0])
alphas = st.one_of(st.sampled_from([1.0, 9.81, 2.5, 0.25]), powers(-3, 3))


@st.composite
def starts(draw) -> tuple[str, str, float, str]:
    """θ0 and ω0 with their units, α, and the kind of start."""
    kind = draw(st.sampled_from(["any", "at rest", "near separatrix", "separatrix", "tiny", "fast", "degrees", "outside"]))
    alpha = draw(alphas)
    root = math.sqrt(alpha)
    theta0, omega0 = draw(st.floats(-3.1, 3.1)), root * draw(st.floats(-4, 4))
    if kind == "at rest":
        omega0 = 0.0
    elif kind == "near separatrix":
        away = draw(signs) * draw(powers(-14, -2))
        omega0 = draw(signs) * root * math.sqrt(2 * (1 + math.cos(theta0)) * (1 + away))
    elif kind == "separatrix":
        alpha = draw(st.sampled_from([0.25, 1.0, 4.0, 2.25]))
        theta0, omega0 = 0.0, draw(signs) * 2 * math.sqrt(alpha)
    elif kind == "tiny":
        size = draw(powers(-9, -3))
        theta0, omega0 = size * draw(st.floats(-1, 1)), draw(st.sampled_from([0.0, 1.0, -0.3])) * size * root
    elif kind == "fast":
        omega0 = draw(signs) * root * draw(powers(0.5, 3))
    elif kind == "outside":
        theta0 += 2 * math.pi * draw(st.integers(-20, 20))
    if kind == "degrees":
        units = draw(st.sampled_from(["ss", "sr", "rs"]))
        theta0, omega0 = (
            float(f"{math.degrees(value):.6g}") if unit == "s" else value
            for value, unit in zip((theta0, omega0), units, strict=True)
        )
    else:
        units = "rr"
    return f"{theta0!r} {units[0]}", f"{omega0!r} {units[1]}", alpha, kind


@st.composite
def problems(draw, longest: float = 0.02, in_steps: bool = False) -> Problem:
    """Legal ones of bounded work; Runge-Kutta in steps longer than `longest` gives no solution."""
    theta0, omega0, alpha, kind = draw(starts())
    rows = draw(st.integers(2, 120))
    every = draw(st.sampled_from([0.02, 0.01, 0.005, 0.1, draw(powers(-3, -0.3))]))
    fewest = math.ceil(every / longest)  # steps between rows
    steps = float(draw(st.integers(fewest, max(fewest, min(MOST_STEPS // rows, math.floor(every / FINEST))))))
    after = draw(st.sampled_from([0.0, 0.0, draw(st.floats(0.1, 0.9))]))
    in_steps = in_steps or draw(st.sampled_from([True, True, False]))
    steps += 0 if in_steps else draw(st.floats(0.01, 0.99))
    return Problem(every / steps, every, every * (rows + after), theta0, omega0, alpha, kind, in_steps, after == 0)


@st.composite
def cases(draw) -> Case:
    chosen = draw(problems())
    return Case(
        problem=chosen,
        method=draw(st.sampled_from(["rk4", "rk4", "exact", "taylor"])),
        tau_error=draw(st.one_of(st.just(0.0), st.floats(-1, 1))),
        noise=draw(st.integers(0, 1000)),
        is_at_step_ends=not chosen.is_in_steps and draw(st.booleans()),
        is_last_lost=chosen.is_in_steps and chosen.is_whole and draw(st.booleans()),
        is_sine_as_written=draw(st.booleans()),
        layout=draw(st.sampled_from(sorted(LAYOUTS))),
        digits=draw(st.integers(5, 15)),
    )


# Tables.


class Truth(NamedTuple):
    """A problem's own rows, by Runge-Kutta at its step, and what is known of its pendulum."""

    theta0: float
    omega0: float
    alpha: float
    regime: int
    theta_max: float
    tau: float
    columns: tuple[np.ndarray, ...]
    """t, theta, omega and, where it oscillates, the sinusoid."""


@functools.lru_cache(maxsize=64)
def truth(text: str) -> Truth:
    solution = solved(text).solution
    theta0, omega0, alpha = solution.parameters[:3]
    regime, theta_max, tau = analyze(theta0, omega0, alpha=alpha)
    sine = (_core.sine(theta0, omega0, alpha, solution.t),) if regime == -1 else ()
    columns = (solution.t, solution.theta, solution.omega, *sine)
    return Truth(theta0, omega0, alpha, int(regime), float(theta_max), float(tau), columns)


def doubts(known: Truth) -> np.ndarray:
    """How far t, θ, ω and sinusoid of another right program of Runge-Kutta may be, by its τ and by rounding."""
    t, theta, omega = known.columns[:3]
    late = TAU * t
    theta_doubt = np.abs(omega) * late + GROWTH * np.abs(theta).max()
    omega_doubt = known.alpha * late + GROWTH * np.abs(omega).max()
    # An arccosine (3.2) has a relative error δ by the last bit of its cosine; an arcsine near π/2 has √(2δ).
    theta_max = abs(known.theta_max)
    delta = 4 * EPSILON / max(theta_max * np.sin(theta_max), EPSILON)
    # An angle of many turns is wrapped by as many subtractions.
    delta = min(1.0, delta + 4 * EPSILON * abs(known.theta0) / max(theta_max, EPSILON))
    sine_doubt = theta_max * (2 * np.pi * late / known.tau + delta + np.sqrt(2 * delta))
    return np.array([late, theta_doubt, omega_doubt, sine_doubt][: len(known.columns)])


def rows_of(case: Case) -> list[Row]:
    """What a right program with the case's own τ, rounding, last row and sinusoid has to print."""
    text = case.problem.text()
    known = truth(text)
    tau_error = case.tau_error * TAU if known.regime != 0 else 0.0  # on the separatrix (3.5) has no series
    t, theta, omega = states(case, 1 + tau_error)
    sine = sinusoid(known, t / (1 + tau_error), case.is_sine_as_written)
    if case.noise:
        random = np.random.default_rng(case.noise)
        grown = np.linspace(0, 1, t.size)  # nothing is rounded in the initial state
        for values, size in ((t, t), (theta, np.abs(theta).max()), (omega, np.abs(omega).max())):
            values += ROUNDING * size * grown * random.uniform(-1, 1, t.size)
        theta = _core.wrap(theta)
    return rows(t, theta, omega, sine)[: -1 if case.is_last_lost else None]


def rows(t: np.ndarray, theta: np.ndarray, omega: np.ndarray, sine: np.ndarray | None = None) -> list[Row]:
    fourth = [None] * t.size if sine is None else sine.tolist()
    return list(zip(t.tolist(), theta.tolist(), omega.tolist(), fourth, strict=True))


def states(case: Case, scale: float) -> list[np.ndarray]:
    """Times, angles and velocities at the rows."""
    step, every, until = case.problem[:3]
    solution = solved(case.problem.text(scale), "--method", case.method).solution
    if case.is_at_step_ends:
        reached = np.ceil(np.arange(solution.t.size) * (every / step) - SAME_STEP).astype(int)
        every_step = case.problem._replace(every=step, until=until)
        solution = solved(every_step.text(scale), "--method", case.method).solution
        reached = reached[reached < solution.t.size]  # no step begins that ends after the run
        return [values[reached] for values in (solution.t, solution.theta, solution.omega)]
    return [np.array(values) for values in (solution.t, solution.theta, solution.omega)]


def sinusoid(known: Truth, t: np.ndarray, is_as_written: bool) -> np.ndarray | None:
    if known.regime != -1:
        return None
    omega0, alpha = known.omega0, known.alpha
    theta0 = float(_core.wrap(known.theta0))
    cosine = math.cos(theta0) - omega0**2 / (2 * alpha)
    if not is_as_written or not -1 < cosine < 1:  # too near to rest or to the separatrix for (3.2)
        return _core.sine(theta0, omega0, alpha, t)
    theta_max = math.acos(cosine)
    return theta_max * np.sin(2 * np.pi / known.tau * t + phase(theta0 / theta_max, omega0))


def phase(sine: float, sign: float) -> float:
    """The assignment's `fase`."""
    if abs(sine) >= 1:
        return math.copysign(math.pi / 2, sine)
    return math.pi - math.asin(sine) if sign < 0 else math.asin(sine)


def file_of(case: Case) -> bytes:
    return LAYOUTS[case.layout](rows_of(case), case.digits)
