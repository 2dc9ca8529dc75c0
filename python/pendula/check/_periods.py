"""Characteristic times that programs find: the right one, and those of mistakes, each as a row."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from pendula import _core
from pendula.check._program import ROUGH_PIS, Start, analysis

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from pendula.check._finding import Value

ALMOST_FREE = 1e-12  # factor of gravity, for a rotation that hardly feels it


def first_term(start: Start) -> float:
    """T0 of the series (3.6): the period without gravity, or without the amplitude's part in it [s]."""
    return small_period(start) if analysis(start)[0] < 0 else rotation_period(start)


def rotation_period(start: Start) -> float:
    """π/A (3.8), the period of a rotation without gravity [s]."""
    energy_ratio = _core.energy(*start) / _core.energy(0.0, 1.0, start.alpha)
    return analysis(Start(0.0, math.sqrt(energy_ratio), start.alpha * ALMOST_FREE))[2]


def small_period(start: Start) -> float:
    """The period of small oscillations [s]."""
    return analysis(Start(0.0, 0.0, start.alpha))[2]


def limit_time(start: Start, fraction: float, pi: float = math.pi) -> float:
    """The time (3.5) to a fraction of θM on the separatrix, as a program in double precision finds it [s]."""
    sign = -1.0 if start.omega0 < 0 else 1.0
    there = math.tan(fraction * pi / 4 + pi / 4)
    here = math.tan(sign * float(_core.wrap(start.theta0)) / 4 + pi / 4)
    return math.log(there / here) / math.sqrt(start.alpha)


def _of_pi(pi: float) -> Callable[[Start], float]:
    return lambda start: limit_time(start, 0.999, pi)


def amplitude_of(r: float) -> float:
    """The amplitude of the oscillation that has this r in the series (3.7) [rad]."""
    return 2 * math.asin(min(1.0, abs(r)))


def half_velocity(start: Start) -> float:
    """A of (3.8) [rad/s]."""
    return _at_bottom(start) / 2


def _of_a(a: Callable[[Start], float]) -> Callable[[Start], float]:
    """The period (3.6) with another A. The series has no sum where its r is not below 1."""

    def tau(start: Start) -> float:
        regime, _, found = analysis(Start(0.0, 2 * a(start), start.alpha))
        return found if regime == 1 else math.nan

    return tau


def _sum(r: float) -> float:
    """1 + a1 + a2 + … (3.6). There is no sum where r is not below 1."""
    return analysis(Start(amplitude_of(r), 0.0, 1.0))[2] / (2 * math.pi) if r < 1 else math.nan


def _of_r(r: Callable[[Start], float]) -> Callable[[Start], float]:
    """The period (3.6) of a rotation with another r."""

    def tau(start: Start) -> float:
        return rotation_period(start) * _sum(r(start))

    return tau


# Limit angles that programs find in place of (3.2).
LIMITS: tuple[tuple[str, Callable[[Start], float]], ...] = (
    ("|θ0|", lambda start: abs(float(_core.wrap(start.theta0)))),
    ("arccos(cos θ0 + ω0²/(2α))", lambda start: math.acos(math.cos(start.theta0) + start.omega0**2 / (2 * start.alpha))),
    ("arccos(cos θ0 − ω0²/α)", lambda start: math.acos(math.cos(start.theta0) - start.omega0**2 / start.alpha)),
    ("arccos(cos θ0 − ω0²/2)", lambda start: math.acos(math.cos(start.theta0) - start.omega0**2 / 2)),
    ("arccos(cos θ0 − ω0²·α/2)", lambda start: math.acos(math.cos(start.theta0) - start.omega0**2 * start.alpha / 2)),
    ("arccos(cos ω0 − θ0²/(2α))", lambda start: math.acos(math.cos(start.omega0) - start.theta0**2 / (2 * start.alpha))),
    (
        "arccos(cos(180·θ0/π) − ω0²/(2α))",
        lambda start: math.acos(math.cos(start.theta0 * 180 / math.pi) - start.omega0**2 / (2 * start.alpha)),
    ),
    ("arccos(cos θ0 − ω0/(2α))", lambda start: math.acos(math.cos(start.theta0) - start.omega0 / (2 * start.alpha))),
)


def wrong_limits(start: Start) -> Iterator[tuple[str, float]]:
    """Formulas of limit angles, and what they give [rad]."""
    for formula, limit in LIMITS:
        try:
            yield formula, limit(start)
        except (ValueError, ArithmeticError):  # it is no cosine, or no double
            continue


def _of_limit(limit: Callable[[Start], float]) -> Callable[[Start], float]:
    return lambda start: analysis(Start(limit(start), 0.0, start.alpha))[2]


def partial_sums(start: Start, terms: int = 1 << 14) -> np.ndarray:
    """T0 times the sums of the series (3.6) of one term, two, and so on [s]."""
    n = np.arange(1.0, terms)
    return first_term(start) * np.append(1.0, 1 + _sums((2 * n - 1) / (2 * n) * _modulus(start)))


def _sums(factors: np.ndarray) -> np.ndarray:
    """a1, a1 + a2, and so on (3.6), where each term is the one before times the square of its factor (3.7)."""
    return np.cumsum(np.cumprod(factors**2))


def _sum_with_odd(r: float, terms: int = 1 << 14) -> float:
    """The sum in (3.6) with 2n + 1 in place of 2n."""
    n = np.arange(1.0, terms)
    return 1 + float(_sums((2 * n - 1) / (2 * n + 1) * r)[-1])


def periods_on_separatrix(start: Start) -> np.ndarray:
    """What programs find that take a pendulum on the separatrix for one that oscillates or turns over [s].

    Its r is 1, and the series has no sum: it is cut after some terms, or where they are small. Or rounding makes r less.
    """
    cut = np.array([base * 10.0**power for base in (1, 2, 5) for power in (5, 6, 7)])
    small = 10.0 ** np.arange(5, 9) / np.pi  # a_n tends to 1/(π n)
    sums = (np.log(16 * np.append(cut, small)) + np.euler_gamma) / np.pi
    rounded = np.log(16 / (np.arange(1, 33) * 2.0**-54)) / np.pi
    either = np.concatenate([partial_sums(start) / first_term(start), sums, rounded])
    return math.pi / math.sqrt(start.alpha) * np.append(either, 2 * either)


def _modulus(start: Start) -> float:
    """r of (3.8)."""
    regime, theta_max, _ = analysis(start)
    if regime < 0:
        return math.sin(theta_max / 2)
    if regime == 0:
        return 1.0
    return math.sqrt(2 * start.alpha / float(_core.energy(*start)))


class Period(NamedTuple):
    """A row: the mistake, the regimes in which it matters, and the time that a program with it finds."""

    name: str
    values: dict[str, Value]
    regimes: tuple[int, ...]
    tau: Callable[[Start], float]
    is_sum: bool = False
    """Whether it is a sum of other terms, which a program may cut, too."""


def row(name: str, regimes: tuple[int, ...], tau: Callable[[Start], float], **values: Value) -> Period:
    """A row of the table below."""
    return Period(name, values, regimes, tau)


def _of_amplitude(r: Callable[[Start], float]) -> Callable[[Start], float]:
    return lambda start: analysis(Start(amplitude_of(r(start)), 0.0, start.alpha))[2]


def _root(start: Start, square: float, factor: float, height: float) -> float:
    return math.sqrt(square * start.omega0**2 + factor * height) / 2


# A of (3.8) as programs write it wrongly.
WRONG_A: tuple[tuple[str, Callable[[Start], float]], ...] = (
    ("√(ω0² + 2α(1 + cos θ0))/2", lambda start: _root(start, 1, 2 * start.alpha, 1 + math.cos(start.theta0))),
    ("√(ω0² − 2α(1 − cos θ0))/2", lambda start: _root(start, 1, -2 * start.alpha, 1 - math.cos(start.theta0))),
    ("√(ω0² + 2α(1 − sin θ0))/2", lambda start: _root(start, 1, 2 * start.alpha, 1 - math.sin(start.theta0))),
    ("√(ω0² + 2α·cos θ0)/2", lambda start: _root(start, 1, 2 * start.alpha, math.cos(start.theta0))),
    ("√(ω0² + α(1 − cos θ0))/2", lambda start: _root(start, 1, start.alpha, 1 - math.cos(start.theta0))),
    ("√(ω0² + 2(1 − cos θ0))/2", lambda start: _root(start, 1, 2, 1 - math.cos(start.theta0))),
    ("√((ω0² + 2α(1 − cos θ0))/2)", lambda start: _root(start, 2, 4 * start.alpha, 1 - math.cos(start.theta0))),
    ("|ω0|/2", lambda start: abs(start.omega0) / 2),
)

BOTH, OSCILLATION, SEPARATRIX, ROTATION = (-1, 1), (-1,), (0,), (1,)

# What programs take for the series (3.6).
OTHER_SERIES: tuple[tuple[str, tuple[int, ...], Callable[[Start], float]], ...] = (
    ("T0(1 + θM²/16)", OSCILLATION, lambda start: first_term(start) * (1 + analysis(start)[1] ** 2 / 16)),
    ("T0(1 + θ0²/16)", OSCILLATION, lambda start: first_term(start) * (1 + float(_core.wrap(start.theta0)) ** 2 / 16)),
    ("T0(2 + a1 + a2 + …)", BOTH, lambda start: first_term(start) + analysis(start)[2]),
    ("T0(1 + r² + r⁴ + …)", BOTH, lambda start: first_term(start) / (1 - _modulus(start) ** 2)),
    ("√(2π/α)(1 + a1 + a2 + …)", OSCILLATION, lambda start: analysis(start)[2] / math.sqrt(2 * math.pi)),
)
# Sums of other terms, as factors of T0.
OTHER_SUMS: tuple[tuple[str, Callable[[float], float]], ...] = (
    ("T0(1 + a1 + a2 + …) with r in place of r²", lambda r: _sum(math.sqrt(r))),
    ("T0(1 + a1 + a2 + …) with r⁴ in place of r²", lambda r: _sum(r * r)),
    ("T0(1 + a1 + a2 + …) with 2n + 1 in place of 2n", _sum_with_odd),
)


def _of_sum(sum_of: Callable[[float], float]) -> Callable[[Start], float]:
    return lambda start: first_term(start) * sum_of(_modulus(start))


MISTAKES = (
    row("period_first_term", BOTH, lambda start: first_term(start)),
    row("period_small", BOTH, lambda start: small_period(start)),
    row("period_doubled", BOTH, lambda start: 2 * analysis(start)[2]),
    row("period_halved", BOTH, lambda start: analysis(start)[2] / 2),
    row("period_without_half", ROTATION, lambda start: analysis(Start(0.0, 2 * _at_bottom(start), start.alpha))[2]),
    row("period_modulus", OSCILLATION, _of_amplitude(lambda start: math.sin(analysis(start)[1])), r="sin θM"),
    row("period_modulus", OSCILLATION, _of_amplitude(lambda start: math.sin(analysis(start)[1]) / 2), r="sin(θM)/2"),
    row("period_modulus", OSCILLATION, _of_amplitude(lambda start: math.sin(start.theta0 / 2)), r="sin(θ0/2)"),
    *(row("theta_max", OSCILLATION, _of_limit(limit), formula=formula) for formula, limit in LIMITS),
    *(row("period_a", ROTATION, _of_a(a), formula=formula) for formula, a in WRONG_A),
    row("period_modulus", ROTATION, _of_r(lambda start: 1 / half_velocity(start)), r="1/A"),
    row("period_modulus", ROTATION, _of_r(lambda start: start.alpha / half_velocity(start)), r="α/A"),
    row("period_modulus", ROTATION, _of_r(lambda start: math.sqrt(start.alpha) / _at_bottom(start)), r="√α/(2A)"),
    row("series_without_first", BOTH, lambda start: analysis(start)[2] - first_term(start)),
    *(row("series_other", regimes, tau, formula=formula) for formula, regimes, tau in OTHER_SERIES),
    *(row("series_other", BOTH, _of_sum(sum_of), formula=formula)._replace(is_sum=True) for formula, sum_of in OTHER_SUMS),
    row("series_not_squared", BOTH, lambda start: first_term(start) / math.sqrt(1 - _modulus(start)))._replace(is_sum=True),
    row("period_alpha", (-1, 0, 1), lambda start: analysis(start)[2] * math.sqrt(start.alpha), factor="√α"),
    row("period_alpha", (-1, 0, 1), lambda start: analysis(start)[2] / math.sqrt(start.alpha), factor="1/√α"),
    row("period_alpha", (-1, 0, 1), lambda start: analysis(start)[2] * start.alpha, factor="α"),
    row("period_alpha", (-1, 0, 1), lambda start: analysis(start)[2] / start.alpha, factor="1/α"),
    row("logarithm_base_10", SEPARATRIX, lambda start: analysis(start)[2] / math.log(10)),
    *(row("rough_pi", SEPARATRIX, _of_pi(pi), pi=pi) for pi in ROUGH_PIS),
    row("limit_099", SEPARATRIX, lambda start: limit_time(start, 0.99)),
    row("limit_not_0999", SEPARATRIX, lambda start: limit_time(start, 1.0)),
    row("regime", BOTH, lambda start: limit_time(start, 0.999)),
    row("regime", OSCILLATION, lambda start: rotation_period(start)),
)


def _at_bottom(start: Start) -> float:
    """The angular velocity at the bottom [rad/s]."""
    return math.sqrt(2 * float(_core.energy(*start)))


def wrong_periods(start: Start) -> Iterator[tuple[Period, float]]:
    """The mistakes that matter for a pendulum, and the times that they give [s]."""
    regime, _, tau = analysis(start)
    for mistake in MISTAKES:
        if regime not in mistake.regimes:
            continue
        try:
            found = mistake.tau(start)
        except (ValueError, ArithmeticError):  # no number is its logarithm, its root, or its size
            continue
        if math.isfinite(found) and found > 0 and abs(found - tau) > 1e-6 * tau:
            yield mistake, found
