"""Characteristic times that programs find: the right one, and those of mistakes, each as a row."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from pendula import _core
from pendula.check._program import Start, analysis

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


def limit_time(start: Start, fraction: float) -> float:
    """The time (3.5) to a fraction of θM on the separatrix, as a program in double precision finds it [s]."""
    sign = -1.0 if start.omega0 < 0 else 1.0
    there = math.tan(fraction * math.pi / 4 + math.pi / 4)
    here = math.tan(sign * float(_core.wrap(start.theta0)) / 4 + math.pi / 4)
    return math.log(there / here) / math.sqrt(start.alpha)


def amplitude_of(r: float) -> float:
    """The amplitude of the oscillation that has this r in the series (3.7) [rad]."""
    return 2 * math.asin(min(1.0, abs(r)))


def partial_sums(start: Start, terms: int = 1 << 14) -> np.ndarray:
    """T0 times the sums of the series (3.6) of one term, two, and so on [s]."""
    n = np.arange(1.0, terms)
    factors = ((2 * n - 1) / (2 * n) * _modulus(start)) ** 2
    return first_term(start) * np.append(1.0, 1 + np.cumsum(np.cumprod(factors)))


def _modulus(start: Start) -> float:
    """r of (3.8)."""
    regime, theta_max, _ = analysis(start)
    if regime < 0:
        return math.sin(theta_max / 2)
    return math.sqrt(2 * start.alpha / float(_core.energy(*start)))


class Period(NamedTuple):
    """A row: the mistake, the regimes in which it matters, and the time that a program with it finds."""

    name: str
    values: dict[str, Value]
    regimes: tuple[int, ...]
    tau: Callable[[Start], float]


def row(name: str, regimes: tuple[int, ...], tau: Callable[[Start], float], **values: Value) -> Period:
    """A row of the table below."""
    return Period(name, values, regimes, tau)


def _of_amplitude(r: Callable[[Start], float]) -> Callable[[Start], float]:
    return lambda start: analysis(Start(amplitude_of(r(start)), 0.0, start.alpha))[2]


BOTH, OSCILLATION, SEPARATRIX, ROTATION = (-1, 1), (-1,), (0,), (1,)
MISTAKES = (
    row("period_first_term", BOTH, lambda start: first_term(start)),
    row("period_small", BOTH, lambda start: small_period(start)),
    row("period_doubled", BOTH, lambda start: 2 * analysis(start)[2]),
    row("period_halved", BOTH, lambda start: analysis(start)[2] / 2),
    row("period_without_half", ROTATION, lambda start: analysis(Start(0.0, 2 * _at_bottom(start), start.alpha))[2]),
    row("period_modulus", OSCILLATION, _of_amplitude(lambda start: math.sin(analysis(start)[1])), r="sin θM"),
    row("period_modulus", OSCILLATION, _of_amplitude(lambda start: math.sin(analysis(start)[1]) / 2), r="sin(θM)/2"),
    row("period_modulus", OSCILLATION, _of_amplitude(lambda start: math.sin(start.theta0 / 2)), r="sin(θ0/2)"),
    row("series_without_first", BOTH, lambda start: analysis(start)[2] - first_term(start)),
    row("series_not_squared", BOTH, lambda start: first_term(start) / math.sqrt(1 - _modulus(start))),
    row("period_alpha", (-1, 0, 1), lambda start: analysis(start)[2] * math.sqrt(start.alpha), factor="√α"),
    row("period_alpha", BOTH, lambda start: analysis(start)[2] / math.sqrt(start.alpha), factor="1/√α"),
    row("period_alpha", BOTH, lambda start: analysis(start)[2] * start.alpha, factor="α"),
    row("period_alpha", BOTH, lambda start: analysis(start)[2] / start.alpha, factor="1/α"),
    row("logarithm_base_10", SEPARATRIX, lambda start: analysis(start)[2] / math.log(10)),
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
