"""When a table's rows are: what their times say of the program's period, and how many steps were taken before each."""

from __future__ import annotations

import math
from fractions import Fraction
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from pendula.check._clock import (
    KNOWN,
    MOST_STEPS,
    PERIOD,
    Grid,
    clock_of,
    grid_of,
    has_single_sums,
    is_on_time,
    latest,
    numbered,
    one_of,
    usual,
)
from pendula.check._finding import Finding, error, remark
from pendula.check._periods import Period, first_term, partial_sums, periods_on_separatrix, wrong_periods
from pendula.check._program import ROUGH_PIS, Clock, Problem, Start, analysis

if TYPE_CHECKING:
    from collections.abc import Iterator

    from pendula.check._program import Floats
    from pendula.check._table import Column

MOST_DOUBT = 1e-5  # relative: of a period that is known by the times printed alone
NEAREST = 1e-4  # relative: how near a wrong period must be to that of a formula
APART = 1e-3  # relative: a sum nearer to τ may be the right one, cut
FEWEST_STEPS = 4  # between rows; a step more or less of fewer may as well be another period
LARGEST_RATIO = 12  # of whole numbers that a period may be off by, from zeros that were counted


class Timing(NamedTuple):
    """An explanation of the times."""

    clock: Clock
    tau: float
    """The characteristic time that the program has found [s]."""
    findings: tuple[Finding, ...] = ()
    unit: float = 1.0
    """Of the times printed [s]."""
    start: Start | None = None
    """Whose period it is, if not that of the motion."""

    @property
    def changes(self) -> int:
        """How many mistakes there are in it."""
        return sum(finding.severity == "error" for finding in self.findings)


def timings(problem: Problem, start: Start, t: Column, places: Floats, pi: float = math.pi) -> Iterator[Timing]:
    """Explanations of the times, those without a mistake first, for a program that took the pendulum for `start`.

    places: the numbers of the rows, of which some may have been lost; pi: what the program takes for π.
    """
    tau = analysis(start)[2]
    factor_every, factor_dt = problem.every / problem.tau, problem.dt / problem.tau
    grid = grid_of(t, places, problem.dt)
    if grid.rows == 1 or not grid.every > 0:
        dt = factor_dt * tau
        expected = int(min(problem.rows, MOST_STEPS))
        findings = (error("one_row", expected=expected),) if grid.rows == 1 and problem.rows > 1 else ()
        if grid.rows > 1 or (problem.rows == 1 and abs(float(t.values[0])) > 1e-6 * dt):
            yield Timing(numbered(problem, grid, dt), tau, (*findings, error("times_off")))
            return
        yield Timing(clock_of(t, grid, dt, dt * problem.steps_per_row, KNOWN), tau, findings)
        return
    right = tau * (pi / math.pi)
    if _is_spacing(grid, t, factor_every * right, factor_dt * right):
        for timing in _timing(problem, t, grid, right, ()):
            yield timing._replace(tau=timing.tau * (math.pi / pi))
        clock = numbered(problem, grid, factor_dt * right)
        if not is_on_time(t, grid, factor_every * right) and has_single_sums(t, clock):
            yield Timing(clock, tau, (error("time_single"),))
        return
    of_run = problem.every * problem.until / problem.tau
    is_whole_run = abs(t.values[-1] - problem.until) < of_run and abs(problem.until / problem.tau - 1) > PERIOD
    if is_whole_run and _is_spacing(grid, t, of_run, problem.dt):
        spacing = {"every": problem.every, "spacing": grid.every}
        yield Timing(clock_of(t, grid, problem.dt, of_run, KNOWN), tau, (error("interval_of_run", **spacing),))
        return
    if known := _known(problem, start, t, grid):
        said = [_said(mistake, problem, tau, own) for mistake, own in known]
        others = tuple({each.name: each for each in said if each.name != said[0].name}.values())[:2]
        yield from _timing(problem, t, grid, known[0][1], (said[0]._replace(alternatives=others),))
    elif counted := _miscounted(problem, tau, t, grid):
        yield counted
        return
    else:
        yield from _other_spacings(problem, start, t, grid)
    clock = numbered(problem, grid, factor_dt * tau)
    name = "time_single" if has_single_sums(t, clock) else "times_off"
    yield Timing(clock, tau, (error(name),))


def _known(problem: Problem, start: Start, t: Column, grid: Grid) -> list[tuple[Period, float]]:
    """The mistakes that give the period of the rows [s], or sums that do where they are cut."""
    tau, periods = analysis(start)[2], list(wrong_periods(start))
    factor_every, factor_dt = problem.every / problem.tau, problem.dt / problem.tau
    return [each for each in periods if _is_spacing(grid, t, factor_every * each[1], factor_dt * each[1])] or [
        (mistake, own)
        for mistake, own in periods
        if mistake.is_sum and abs(own / tau - 1) > APART and abs(grid.every / (factor_every * own) - 1) <= NEAREST
    ]


def _miscounted(problem: Problem, tau: float, t: Column, grid: Grid) -> Timing | None:
    """Rows that are a wrong whole number of steps apart: one too many or too few, or those of a factor in seconds."""
    factor, dt = problem.every / problem.tau, problem.dt / problem.tau * tau
    wanted = round(problem.steps_per_row)
    counts: list[tuple[str, float]] = []
    if abs(problem.steps_per_row - wanted) <= PERIOD * wanted and wanted >= FEWEST_STEPS:
        counts += [("interval_miscounted", wanted + 1), ("interval_miscounted", wanted - 1)]
    counts += [("seconds", each) for each in (math.floor(factor / dt), math.ceil(factor / dt)) if each > 1]
    for name, count in counts:
        if count != wanted and is_on_time(t, grid, count * dt):
            is_seconds = name == "seconds"
            told = {"every": factor * tau, "spacing": count * dt} if is_seconds else {"steps": count, "wanted": wanted}
            return Timing(clock_of(t, grid, dt, count * dt, KNOWN), tau, (error(name, **told),))
    return None


def _said(mistake: Period, problem: Problem, tau: float, own: float) -> Finding:
    values = {"k": problem.regime} if mistake.name == "regime" else {}
    return error(mistake.name, tau=tau, got=own, **values, **mistake.values)


def _is_spacing(grid: Grid, t: Column, every: float, dt: float) -> bool:
    """Whether rows are as far apart as that; a program may print each at the end of the step that reaches its time."""
    late = latest(every, dt)
    ends = np.round(t.values / dt) * dt
    is_at_end = np.abs(t.values - ends) <= t.units + PERIOD * np.abs(t.values)
    fits = is_at_end & (np.abs(t.values - grid.places * every) <= late + t.units)
    if np.sum(~fits) <= one_of(fits.size):
        return True
    off = usual(np.abs(t.values - grid.values) / t.units) * grid.unit
    drift = 2 * grid.unit if off <= 2 * grid.unit else late + grid.unit
    return bool(abs(grid.every - every) * (grid.rows - 1) <= drift + PERIOD * every * grid.rows)


def _timing(problem: Problem, t: Column, grid: Grid, own: float, findings: tuple[Finding, ...]) -> Iterator[Timing]:
    """The timings of a program whose rows are evenly spaced by its own period."""
    every, dt = (each / problem.tau * own for each in (problem.every, problem.dt))
    doubt = KNOWN
    last = abs(float(t.values[-1]))
    if last > 0 and usual(np.abs(t.values - grid.values) / t.units) <= 2 and abs(grid.first) <= grid.unit:
        seen = grid.unit / last
        # A wrong period is known by its times alone: where its series is cut may be another mistake.
        most, near = (MOST_DOUBT, NEAREST) if findings else (KNOWN, PERIOD)
        if seen < most and abs(grid.every / every - 1) <= near:  # the times tell the period better than theory
            own, doubt = own * (grid.every / every), max(seen, 1e-14)
            every, dt = (each / problem.tau * own for each in (problem.every, problem.dt))
    yield Timing(clock_of(t, grid, dt, every, doubt), own, (*findings, *_layout(problem, t, grid, every, dt)))
    # Digits may be too few to tell a row at its time from one at the end of the step that reaches it, or at the nearest.
    per_row = every / dt
    if abs(per_row - round(per_row)) > PERIOD * per_row:
        layout = _layout(problem, t, grid, every, dt)
        ends, nearest = (
            Clock(whole.astype(np.int64), dt, doubt, np.zeros(whole.size))
            for whole in (np.ceil(grid.places * per_row * (1 - 1e-9)), np.round(grid.places * per_row))
        )
        for clock in (ends, nearest) if grid.unit > 1e-3 * dt else ():
            if np.all(np.abs(clock.t - t.values) <= t.units + PERIOD * np.abs(t.values)):
                yield Timing(clock, own, (*findings, *layout))
        if is_on_time(t, grid, every) and not findings:
            yield Timing(ends, own, (error("times_nominal"), *layout))
    # The times of all rows may be off by a step or a row, and the states those of t = 0 and so on.
    for name, moved in (("step_late", -dt), ("step_early", dt), ("row_late", -every), ("row_early", every)):
        if abs(moved) > 2 * grid.unit and abs(grid.first - moved) <= grid.unit + PERIOD * every:
            shifted = grid._replace(first=0.0)
            yield Timing(numbered(problem, grid, dt), own, (*findings, error(name), *_ends(problem, shifted)))


def _other_spacings(problem: Problem, start: Start, t: Column, grid: Grid) -> Iterator[Timing]:
    """Rows at other distances than the factor times a period that is known: what else they may be."""
    tau = analysis(start)[2]
    factor, factor_dt = problem.every / problem.tau, problem.dt / problem.tau
    spacing = {"every": factor * tau, "spacing": grid.every}
    doubt = grid.unit / (grid.every * max(grid.rows - 1, 1)) + PERIOD
    whole = np.ceil(factor / (factor_dt * tau) * (1 - 1e-9)) * factor_dt * tau
    if _is_spacing(grid, t, factor, factor_dt):
        scaled = t._replace(values=t.values * tau, units=t.units * tau)
        inside = grid._replace(first=grid.first * tau, every=grid.every * tau, unit=grid.unit * tau)
        rows = _layout(problem, scaled, inside, factor * tau, factor_dt * tau)
        clock = clock_of(scaled, inside, factor_dt * tau, factor * tau, KNOWN)
        yield Timing(clock, tau, (error("times_in_periods"), *rows), tau)
    per_row = problem.steps_per_row
    for rounded in {math.floor(per_row), round(per_row), math.ceil(per_row)} - {0}:
        every = rounded * factor_dt * tau
        if abs(per_row - round(per_row)) > PERIOD * per_row and is_on_time(t, grid, every):
            said = remark("interval_rounded", **spacing)
            yield Timing(clock_of(t, grid, factor_dt * tau, every, KNOWN), tau, (said,))
            return
    for every in (factor, whole):
        if _is_spacing(grid, t, every, factor_dt * tau):
            yield Timing(clock_of(t, grid, factor_dt * tau, every, KNOWN), tau, (error("seconds", **spacing),))
    if abs(grid.every - factor_dt * tau) <= grid.unit / max(grid.rows - 1, 1) + PERIOD * grid.every:
        yield Timing(
            clock_of(t, grid, factor_dt * tau, factor_dt * tau, KNOWN), tau, (error("every_step", every=factor * tau),)
        )
    own = grid.every / factor
    values = {"tau": tau, "got": own, **spacing}
    rows = _layout(problem, t, grid, grid.every, factor_dt * own)
    if any(finding.name == "uneven_rows" for finding in rows):
        yield Timing(clock_of(t, grid, factor_dt * tau, factor * tau, KNOWN), tau, rows)
        return
    said = off(start, own, doubt, values)
    sinusoid = own * (math.pi / float(said.values["pi"])) if said.name == "rough_pi" else own
    yield Timing(clock_of(t, grid, factor_dt * own, grid.every, min(doubt, MOST_DOUBT)), sinusoid, (said, *rows))


def off(start: Start, own: float, doubt: float, values: dict[str, float]) -> Finding:
    """What to say of a period that no mistake of its own gives."""
    regime, _, tau = analysis(start)
    ratio = own / tau
    least = _least(start)
    for pi in ROUGH_PIS:
        if regime != 0 and abs(ratio * math.pi / pi - 1) <= min(doubt, 1e-8 + PERIOD / 10):
            return error("rough_pi", pi=pi, **values)
    simple = Fraction(ratio).limit_denominator(LARGEST_RATIO)
    if simple != 1 and 0 < simple.numerator <= LARGEST_RATIO and abs(ratio - float(simple)) <= doubt * ratio and doubt < 1e-4:
        return error("tau_off", **values, ratio=str(simple))
    if regime == 0 and np.min(np.abs(periods_on_separatrix(start) - own)) <= min(doubt, MOST_DOUBT) * own:
        return error("regime", **values, k=regime)
    if regime != 0 and least < own < tau:
        sums = partial_sums(start)
        # Beyond the last of them, sums are as near to each other as the doubt.
        if np.min(np.abs(sums - own)) <= min(doubt, MOST_DOUBT) * own or own > sums[-1]:
            return error("series_cut", **values, relative=1 - ratio)
    return error("tau", **values)


# The first row, the last, and those between.


def _layout(problem: Problem, t: Column, grid: Grid, every: float, dt: float) -> tuple[Finding, ...]:
    """What is wrong with the rows of a program whose period is known."""
    late = latest(every, dt)
    slack = late + grid.unit
    off = np.minimum(np.abs(t.values - grid.values), np.abs(t.values - grid.places * every))
    wrong = np.flatnonzero(off > late + 2 * t.units)
    if wrong.size > one_of(off.size):  # fewer are wrong cells
        return (error("uneven_rows", row=int(wrong[0]) + 1, every=every),)
    if abs(grid.first) <= grid.unit or (abs(grid.first) <= slack and abs(abs(grid.first) - dt) > grid.unit):
        return _ends(problem, grid)
    name = "late_start"
    if abs(grid.first - dt) <= grid.unit + PERIOD * dt:
        name = "starts_at_step"
    elif abs(grid.first - every) <= slack:
        name = "starts_at_interval"
    return (error(name, first=grid.first), *_ends(problem, grid))


def _ends(problem: Problem, grid: Grid) -> tuple[Finding, ...]:
    """Rows that are missing or too many; whether there is a row at the very end may depend on rounding."""
    more = grid.rows + round(grid.first / grid.every) - problem.rows
    last, until = grid.first + grid.every * (grid.rows - 1), problem.until / problem.every * grid.every
    counts = {"rows": grid.rows, "expected": int(min(problem.rows, MOST_STEPS)), "last": last, "until": until}
    if abs(more) < 0.5:
        return ()
    is_near = abs(until / grid.every - round(until / grid.every)) * problem.steps_per_row <= 1.01
    if abs(more) == 1 and is_near:
        name = "last_row_lost" if more < 0 else "last_row_won"
        return (remark(name, **{value: counts[value] for value in ("until", "last")}),)
    return (error("early_end" if more < 0 else "late_end", **counts),)


def _least(start: Start) -> float:
    """T0; no period is shorter where it is no double."""
    try:
        return first_term(start)
    except (ValueError, ArithmeticError):
        return math.inf
