"""The fourth column: the sinusoid (3.4), and the mistakes that students make in it."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from pendula import _core
from pendula.check._program import DEGREE, Start, analysis, closed_form, small_period

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    import numpy.typing as npt

    from pendula.check._program import Floats
    from pendula.check._table import Column

TINY = 1e-290  # rad: of smaller limit angles the quotients here are no doubles
EPSILON = float(np.finfo(float).eps)
UNKNOWN = 1e-7  # relative: how well a program knows its period


class Sinusoid(NamedTuple):
    """amplitude sin(rate t + phase)."""

    amplitude: float
    rate: float
    """[rad/s]"""
    phase: float

    def at(self, t: Floats) -> Floats:
        """Its values, in [-π, π)."""
        values: Floats = _core.wrap(self.amplitude * np.sin(self.rate * t + self.phase))
        return values


def right_sinusoid(start: Start, tau: float) -> Sinusoid:
    """That of a program that has found this period."""
    theta_max = analysis(start)[1]
    ratio = float(_core.wrap(start.theta0)) / theta_max if theta_max else 0.0
    phase = math.asin(min(1.0, max(-1.0, ratio)))
    return Sinusoid(theta_max, 2 * math.pi / tau, math.pi - phase if start.omega0 < 0 else phase)


def wrong_sinusoids(start: Start, tau: float, dt: float) -> Iterator[tuple[str, Sinusoid]]:
    """Names of mistakes, and what they print, in the order in which students make them."""
    right = right_sinusoid(start, tau)
    theta_max = right.amplitude or 1.0
    ratio = min(1.0, max(-1.0, start.theta0 / theta_max))
    yield "sine_other_sign", right._replace(phase=math.pi - right.phase)
    yield "sine_no_phase", right._replace(phase=0.0)
    yield "sine_quarter_turn", right._replace(phase=right.phase + math.pi / 2)
    yield "sine_quarter_turn", right._replace(phase=right.phase - math.pi / 2)
    yield "sine_initial_amplitude", right._replace(amplitude=start.theta0)
    yield "sine_small_period", right._replace(rate=2 * math.pi / small_period(start))
    yield "sine_double_period", right._replace(rate=right.rate / 2)
    yield "sine_half_period", right._replace(rate=2 * right.rate)
    yield "sine_without_two_pi", right._replace(rate=1 / tau)
    yield "sine_without_amplitude", right._replace(amplitude=1.0)
    yield "sine_phase_degrees", right._replace(phase=right.phase / DEGREE)
    yield "sine_phase_degrees", right._replace(phase=right.phase * DEGREE)
    yield "sine_by_acos", right._replace(phase=math.acos(ratio))
    yield "sine_by_acos", right._replace(phase=-math.acos(ratio))
    yield "sine_by_acos", right._replace(phase=math.pi - math.acos(ratio))
    yield "sine_negated", right._replace(phase=-right.phase)
    yield "sine_negated", right._replace(amplitude=-right.amplitude)
    yield "sine_step_late", right._replace(phase=right.phase + right.rate * dt)
    yield "sine_step_late", right._replace(phase=right.phase - right.rate * dt)


def fits(
    wanted: Callable[[Floats], Floats], start: Start, t: Column, sine: Column, tau_doubt: float = UNKNOWN
) -> npt.NDArray[np.bool_]:
    """Rows in which the fourth column is that."""
    at, before, after = (wanted(times) for times in t.nearby())
    off: Floats = np.abs(_core.wrap(sine.values - at))
    fit: npt.NDArray[np.bool_] = off <= sine.units + np.abs(_core.wrap(after - before)) + _slack(start, t.values, tau_doubt)
    return fit


def _slack(start: Start, t: Floats, tau_doubt: float) -> Floats:
    """How far off a right sinusoid may be: θM, an arccosine (3.2), has a relative error δ.

    δ comes from the last bit of the cosine. Where θ0 is θM, it changes the phase, the arcsine of their ratio, by √(2δ).
    """
    _, theta_max, tau = analysis(start)
    theta_max = abs(theta_max)
    if not theta_max > TINY:
        return np.zeros_like(t)
    delta = min(1.0, 4 * EPSILON / (theta_max * max(math.sin(theta_max), EPSILON)))
    slack: Floats = theta_max * (tau_doubt * (1 + 2 * np.pi * np.abs(t) / tau) + delta + np.sqrt(2 * delta))
    return slack


def angle(start: Start, t: Floats) -> Floats:
    """The pendulum's own angle."""
    wrapped: Floats = _core.wrap(closed_form(start, t)[0])
    return wrapped
