"""The fourth column: the sinusoid (3.4), and the mistakes that students make in it."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from pendula import _core
from pendula.check._finding import Finding, Where, error
from pendula.check._mistakes import SINGLE_PI
from pendula.check._periods import small_period
from pendula.check._predict import ROUNDING, are_cells, without_digits
from pendula.check._program import DEGREE, RIGHT, Problem, Start, analysis, closed_form, taken
from pendula.check._table import WORDS, Column, Columns

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    import numpy.typing as npt

    from pendula.check._program import Floats
    from pendula.check._timing import Timing

TINY = 1e-290  # rad: of smaller limit angles the quotients here are no doubles
EPSILON = float(np.finfo(float).eps)
UNKNOWN = 1e-7  # relative: how well a program knows its period


class Sinusoid(NamedTuple):
    """amplitude sin(rate t + phase) + offset."""

    amplitude: float
    rate: float
    """[rad/s]"""
    phase: float
    offset: float = 0.0

    def at(self, t: Floats) -> Floats:
        """Its values, in [-π, π)."""
        values: Floats = _core.wrap(self.amplitude * np.sin(self.rate * t + self.phase) + self.offset)
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
    yield "sine_phase_outside", right._replace(phase=0.0, offset=right.phase)
    yield "sine_period_inverted", right._replace(rate=2 * math.pi * tau)
    yield "sine_without_period", right._replace(rate=2 * math.pi)
    for phase in (math.asin(min(1.0, max(-1.0, start.theta0))), math.pi - math.asin(min(1.0, max(-1.0, start.theta0)))):
        yield "sine_phase_theta0", right._replace(phase=phase)
    yield "sine_phase_degrees", right._replace(phase=right.phase / DEGREE)
    yield "sine_phase_degrees", right._replace(phase=right.phase * DEGREE)
    yield "sine_by_acos", right._replace(phase=math.acos(ratio))
    yield "sine_by_acos", right._replace(phase=-math.acos(ratio))
    yield "sine_by_acos", right._replace(phase=math.pi - math.acos(ratio))
    if start.omega0 < 0:  # π is in the phase, too
        yield "single_constants", right._replace(phase=right.phase + math.pi * (SINGLE_PI - 1), rate=right.rate * SINGLE_PI)
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
    fit: npt.NDArray[np.bool_] = ~without_digits(sine.units) & (
        off <= sine.units + np.abs(_core.wrap(after - before)) + _slack(start, t.values, tau_doubt)
    )
    return fit


def _slack(start: Start, t: Floats, tau_doubt: float) -> Floats:
    """How far off a right sinusoid may be: θM, an arccosine (3.2), has a relative error δ.

    δ comes from the last bit of the cosine. It changes the phase, the arcsine of θ0/θM, by up to √(2δ) where θ0 is θM.
    """
    _, theta_max, tau = analysis(start)
    theta_max = abs(theta_max)
    if not theta_max > TINY:
        return np.full_like(t, 1e-7 * theta_max)
    delta = 4 * EPSILON / (theta_max * max(math.sin(theta_max), EPSILON))
    # An angle of many turns loses digits where it is wrapped.
    delta = min(1.0, delta + 4 * EPSILON * abs(start.theta0) / theta_max)
    ratio = float(_core.wrap(start.theta0)) / theta_max
    phase = min(math.sqrt(2 * delta), delta / math.sqrt(max(1 - ratio**2, EPSILON)))
    rough = tau_doubt if tau_doubt > UNKNOWN else ROUNDING  # constants that are off are so in the phase, too
    slack: Floats = theta_max * (rough + tau_doubt * 2 * np.pi * np.abs(t) / tau + delta + phase)
    return slack


def angle(start: Start, t: Floats) -> Floats:
    """The pendulum's own angle."""
    wrapped: Floats = _core.wrap(closed_form(start, t)[0])
    return wrapped


def of_sinusoid(
    problem: Problem, start: Start, timing: Timing, columns: Columns, is_rough: bool, factor: float, doubt: float
) -> list[Finding]:
    """The fourth column, which is there where the pendulum oscillates and only there."""
    sine, regime = columns.sine, analysis(start)[0]
    if start != taken(RIGHT, problem) and (sine is not None) == (regime == -1) and regime != problem.regime:
        return []  # right for the pendulum that the program took for the problem's
    if regime != -1:
        return [error("sine_too_many")] if sine is not None and problem.regime != -1 else []
    if sine is None:
        return [error("sine_missing")]
    if not np.all(np.isfinite(sine.values)):
        return [error("sine_not_numbers", line=int(columns.lines[~np.isfinite(sine.values)][0]))]
    t = Column(columns.t.values * timing.unit, columns.t.units * timing.unit)
    rows = Column(timing.clock.t, timing.clock.unsure)
    # Where the times printed are wrong, it may be that of them or of the states.
    bases = (rows, t, columns.t) if timing.changes else (rows,)
    right = right_sinusoid(start, timing.tau)
    if factor != 1 and not np.all(fits(right.at, start, rows, sine)):
        sine = sine.scaled(1 / factor)  # told with the angle
    for times in bases:
        if np.all(fits(right.at, start, times, sine, doubt)):
            outside = np.any(np.abs(sine.values) > np.pi + sine.units)
            return [error("sine_not_wrapped")] if outside else []
    if is_rough:
        return []  # as inaccurate as the states
    named = []
    for times in bases:
        for name, wrong in wrong_sinusoids(start, timing.tau, timing.clock.dt):
            if name not in named and np.all(fits(wrong.at, start, times, sine)):
                named.append(name)
        if np.all(fits(lambda at: angle(start, at), start, times, sine)):
            named.append("sine_is_the_angle")
        if named:
            break
    row = int(np.argmax(~fits(right.at, start, rows, sine)))
    wanted = float(right.at(rows.values)[row])
    where = Where(int(columns.lines[row]), float(columns.t.values[row]), WORDS[3], float(sine.values[row]), wanted)
    few = int((~fits(right.at, start, rows, sine)).sum())
    if not named and are_cells(few, sine.values.size):
        return [Finding("wrong_cell", {"count": few}, where=where)]
    alternatives = tuple(error(name) for name in named[1:3])
    return [Finding(named[0] if named else "sine_unexplained", {}, where=where, alternatives=alternatives)]
