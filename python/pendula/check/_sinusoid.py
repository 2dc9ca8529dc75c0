"""The fourth column: the sinusoid (3.4), and the mistakes that students make in it."""

from __future__ import annotations

import math
from itertools import product
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from pendula import _core
from pendula.check._finding import Finding, Value, Where, error
from pendula.check._mistakes import SINGLE_PI
from pendula.check._periods import small_period, wrong_limits
from pendula.check._predict import ROUNDING, are_cells, without_digits
from pendula.check._program import DEGREE, RIGHT, Clock, Problem, Start, analysis, closed_form, taken
from pendula.check._table import WORDS, Column, Columns

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Sequence

    import numpy.typing as npt

    from pendula.check._program import Floats
    from pendula.check._timing import Timing

TINY = 1e-290  # rad: of smaller limit angles the quotients here are no doubles
EPSILON = float(np.finfo(float).eps)
FIRST_ROWS = 4  # that a wrong sinusoid must predict before the others are looked at
UNKNOWN = 1e-7  # relative: how well a program knows its period


class Sinusoid(NamedTuple):
    """amplitude sin(rate (t − late) + phase) + offset."""

    amplitude: float
    rate: float
    """[rad/s]"""
    phase: float
    offset: float = 0.0
    late: float = 0.0
    """[s]"""
    earliest: float = -math.inf
    """Of t − late [s]."""

    def at(self, t: Floats) -> Floats:
        """Its values, in [-π, π)."""
        argument = self.rate * np.maximum(t - self.late, self.earliest) + self.phase
        values: Floats = _core.wrap(self.amplitude * np.sin(argument) + self.offset)
        return values


def right_sinusoid(start: Start, tau: float) -> Sinusoid:
    """That of a program that has found this period."""
    theta_max = analysis(start)[1]
    ratio = float(_core.wrap(start.theta0)) / theta_max if theta_max else 0.0
    return Sinusoid(theta_max, 2 * math.pi / tau, _phase(ratio, start.omega0))


def _phase(sine: float, sign: float) -> float:
    """The angle with this sine whose cosine has this sign (fase), but for sines beyond 1, where it is ±π/2."""
    phase = math.asin(min(1.0, max(-1.0, sine)))
    return math.pi - phase if sign < 0 else phase


class Wrong(NamedTuple):
    """A row: the mistake, what of the sinusoid is wrong, and what a program with it prints in place of another sinusoid."""

    name: str
    group: str
    """Two mistakes of a pair are from different groups."""
    change: Callable[[Sinusoid], Sinusoid]
    values: dict[str, Value]


def _to(name: str, group: str, of: dict[str, Value] | None = None, **fields: float) -> Wrong:
    """A row that sets fields."""
    return Wrong(name, group, lambda other: other._replace(**fields), of or {})


def wrong_sinusoids(start: Start, right: Sinusoid, clock: Clock) -> list[Wrong]:
    """Mistakes in the order in which students make them."""
    rows = [*_amplitudes(start, right), *_rates(start, right, float(clock.t[-1])), *_phases(start, right), *_lags(clock)]
    return sorted(rows, key=lambda row: ORDER.index(row.name) if row.name in ORDER else len(ORDER))


ORDER = ("sine_other_sign", "sine_no_phase", "sine_quarter_turn")


def _amplitudes(start: Start, right: Sinusoid) -> Iterator[Wrong]:
    theta0, omega0, _ = start
    wrapped = float(_core.wrap(theta0))
    yield _to("sine_initial_amplitude", "amplitude", amplitude=theta0)
    yield _to("sine_without_amplitude", "amplitude", amplitude=1.0)
    yield Wrong("sine_negated", "amplitude", lambda other: other._replace(amplitude=-other.amplitude), {})
    yield Wrong("sine_in_degrees", "amplitude", lambda other: other._replace(amplitude=other.amplitude / DEGREE), {})
    degrees = right.amplitude / DEGREE
    if degrees > 0:
        yield _to("sine_in_degrees", "all", amplitude=degrees, phase=_phase(wrapped / degrees, omega0))
    for formula, limit in wrong_limits(start):
        if limit > 0:
            phase = _phase(wrapped / limit, omega0)
            yield _to("theta_max", "all", {"formula": formula}, amplitude=limit, phase=phase)


def _rates(start: Start, right: Sinusoid, until: float) -> Iterator[Wrong]:
    rate, tau = right.rate, 2 * math.pi / right.rate
    yield _to("sine_small_period", "rate", rate=2 * math.pi / small_period(start))
    yield _to("sine_double_period", "rate", rate=rate / 2)
    yield _to("sine_half_period", "rate", rate=2 * rate)
    yield _to("sine_without_two_pi", "rate", rate=1 / tau)
    yield _to("sine_period_inverted", "rate", rate=2 * math.pi * tau)
    yield _to("sine_without_period", "rate", rate=2 * math.pi)
    if until > 0:
        yield _to("sine_rate", "rate", {"rate": "2πt/t_simul"}, rate=2 * math.pi / until)
    yield _to("sine_rate", "rate", {"rate": "α·t"}, rate=start.alpha)
    yield _to("sine_rate", "rate", {"rate": "ω0·t"}, rate=start.omega0)
    yield _to("sine_argument_degrees", "rate", rate=rate / DEGREE)
    for factor in (1 / DEGREE, DEGREE):
        yield _to("sine_argument_degrees", "all", rate=rate * factor, phase=right.phase * factor)
    small = math.sqrt(start.alpha)
    for own in (small, rate):
        size, phase = math.hypot(start.theta0, start.omega0 / own), math.atan2(start.theta0, start.omega0 / own)
        yield _to("sine_harmonic", "all", amplitude=size, rate=own, phase=phase)
    yield _to("sine_harmonic", "all", amplitude=start.theta0, rate=small, phase=math.pi / 2)


def _phases(start: Start, right: Sinusoid) -> Iterator[Wrong]:
    phase = right.phase
    named = (
        ("sine_other_sign", math.pi - phase),
        ("sine_no_phase", 0.0),
        ("sine_quarter_turn", phase + math.pi / 2),
        ("sine_quarter_turn", phase - math.pi / 2),
        ("sine_from_rest", math.pi / 2),
        ("sine_from_rest", -math.pi / 2),
        *(("sine_phase_theta0", each) for each in _both_branches(start.theta0)),
        ("sine_phase_is_theta0", start.theta0),
        ("sine_phase_is_theta0", math.pi - start.theta0),
        ("sine_phase_degrees", phase / DEGREE),
        ("sine_phase_degrees", phase * DEGREE),
        ("sine_phase_scaled", 2 * math.pi * phase),
        ("sine_phase_scaled", right.rate * phase),
        *(("sine_by_acos", each) for each in _by_acos(start, right)),
        ("sine_negated", -phase),
    )
    for name, wrong in named:
        yield _to(name, "phase", phase=wrong)
    yield _to("sine_phase_outside", "phase", phase=0.0, offset=phase)
    if start.omega0 < 0:  # π is in the phase, too
        rough = math.pi * (SINGLE_PI - 1)
        yield _to("single_constants", "all", phase=phase + rough, rate=right.rate * SINGLE_PI)


def _both_branches(sine: float) -> tuple[float, float]:
    phase = _phase(sine, 1)
    return phase, math.pi - phase


def _by_acos(start: Start, right: Sinusoid) -> tuple[float, ...]:
    phase = math.acos(min(1.0, max(-1.0, start.theta0 / (right.amplitude or 1.0))))
    return phase, -phase, math.pi - phase


def _lags(clock: Clock) -> Iterator[Wrong]:
    row = clock.dt * float(np.median(np.diff(clock.steps))) if clock.steps.size > 1 else 0.0
    for name, lag in (("sine_step_late", clock.dt), ("sine_row_late", row)):
        for late in (lag, -lag):
            yield _to(name, "time", late=late)
        yield _to(name, "time", late=lag, earliest=0.0)


def explained(
    start: Start, right: Sinusoid, clock: Clock, times: Sequence[Column], sine: Column
) -> tuple[tuple[Wrong, ...], tuple[Wrong, ...]]:
    """The mistakes, one or a pair, that print a fourth column; and those that do so as well as the first."""
    rows = wrong_sinusoids(start, right, clock)
    singles: list[tuple[Wrong, ...]] = [(row,) for row in rows]
    pairs = [(one, other) for i, one in enumerate(rows) for other in rows[i + 1 :] if _may_meet(one, other)]
    if sine.values.size <= FIRST_ROWS:
        pairs = []  # some pair prints any few numbers
    for tried in (singles, pairs):
        for column in times:
            found = [each for each in tried if _prints(each, start, right, column, sine)]
            if found:
                return found[0], tuple(each[0] for each in found[1:] if len(each) == 1)
    return (), ()


def _may_meet(one: Wrong, other: Wrong) -> bool:
    return one.group != other.group and "all" not in (one.group, other.group)


def _prints(mistakes: tuple[Wrong, ...], start: Start, right: Sinusoid, t: Column, sine: Column) -> bool:
    wrong = right
    for mistake in mistakes:
        wrong = mistake.change(wrong)
    size = max(1.0, abs(wrong.amplitude) / (abs(right.amplitude) or 1.0)) * max(1.0, abs(wrong.rate / right.rate))
    first_t, first_sine = (each.at(slice(FIRST_ROWS)) for each in (t, sine))
    return bool(
        np.all(fits(wrong.at, start, first_t, first_sine, size=size)) and np.all(fits(wrong.at, start, t, sine, size=size))
    )


def fits(
    wanted: Callable[[Floats], Floats], start: Start, t: Column, sine: Column, tau_doubt: float = UNKNOWN, size: float = 1.0
) -> npt.NDArray[np.bool_]:
    """Rows in which the fourth column is that; size: how many times more it moves than the right one."""
    at, before, after = (wanted(times) for times in t.nearby())
    off: Floats = np.abs(_core.wrap(sine.values - at))
    fit: npt.NDArray[np.bool_] = ~without_digits(sine.units) & (
        off <= sine.units + np.abs(_core.wrap(after - before)) + size * _slack(start, t.values, tau_doubt)
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
    # Or the problem's own: what is wrong with the motion may have come after it.
    own = right_sinusoid(taken(RIGHT, problem), problem.tau) if problem.regime == -1 else right
    for known, times in product((right, own), bases):
        if np.all(fits(known.at, start, times, sine, doubt)):
            outside = np.any(np.abs(sine.values) > np.pi + sine.units)
            return [error("sine_not_wrapped")] if outside else []
    if is_rough:
        return []  # as inaccurate as the states
    return _told(start, right, timing.clock, bases, columns._replace(sine=sine))


def _told(start: Start, right: Sinusoid, clock: Clock, bases: Sequence[Column], columns: Columns) -> list[Finding]:
    """What to say of a fourth column that is wrong."""
    sine, rows = columns.sine, bases[0]
    assert sine is not None
    if any(np.all(fits(lambda at: angle(start, at), start, times, sine)) for times in bases):
        mistakes, others = (Wrong("sine_is_the_angle", "all", lambda other: other, {}),), ()
    else:
        mistakes, others = explained(start, right, clock, bases, sine)
    fit = fits(right.at, start, rows, sine)
    row = int(np.argmax(~fit))
    wanted = float(right.at(rows.values)[row])
    where = Where(int(columns.lines[row]), float(columns.t.values[row]), WORDS[3], float(sine.values[row]), wanted)
    few = int((~fit).sum())
    if len(mistakes) != 1 and are_cells(few, sine.values.size):
        return [Finding("wrong_cell", {"count": few}, where=where)]
    if not mistakes:
        return [Finding("sine_unexplained", {}, where=where)]
    found = [Finding(each.name, each.values) for each in mistakes]
    different = {each.name: error(each.name, **each.values) for each in others if each.name != mistakes[0].name}
    return [found[0]._replace(where=where, alternatives=tuple(different.values())[:2]), *found[1:]]
