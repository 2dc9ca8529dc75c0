"""Finds the program that prints a table: every row is predicted, the first wrong one rejects, the fewest mistakes win."""

from __future__ import annotations

import math
from itertools import islice
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from pendula import _core
from pendula.check._mistakes import (
    ALPHAS,
    BOTH_IN_DEGREES,
    EQUATIONS,
    PRINTINGS,
    ROWS,
    SINGLE,
    STARTS,
    STEPPERS,
    Mistake,
)
from pendula.check._program import RIGHT, Clock, Motion, Problem, Program, Start, analysis, closed_form, replay, taken
from pendula.check._timing import Timing, timings

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    import numpy.typing as npt

    from pendula.check._program import Floats
    from pendula.check._table import Column, Columns

ROUGHLY = 1e-8  # relative: what roundings may grow to in the first rows
ROUNDING = 1e-11  # relative: what the roundings of ten thousand steps may be worth
FIRST_ROWS = 4  # that a program must predict before it is replayed to the end
MOST_WORK = 1 << 22  # steps of a program that is replayed; more are taken by the closed form
MOST_ALTERNATIVES = 3
MOST_IN_STATES = 2  # mistakes in what is read, computed and printed of states
DECIDES = 0.1  # rad: beyond this, what rounding may be worth leaves nothing to judge


class Reading(NamedTuple):
    """What a program takes for the pendulum, and the mistakes with which it does."""

    start: Start
    mistakes: tuple[Mistake, ...] = ()
    pi: float = math.pi
    same: tuple[Mistake, ...] = ()
    """Others with which it would take the same."""


class Candidate(NamedTuple):
    """A program that may have printed the table."""

    program: Program
    reading: Reading
    timing: Timing
    mistakes: tuple[Mistake, ...]

    @property
    def changes(self) -> int:
        """How many mistakes there are in it."""
        return len(self.mistakes) + self.timing.changes


class Prediction(NamedTuple):
    """States at a table's rows, and how far a table may be from them, because programs differ."""

    theta: Floats
    """In [-π, π); whole turns are judged apart."""
    omega: Floats
    theta_slack: Floats
    omega_slack: Floats
    turning: Floats
    """The angle with its whole turns."""


def wrap(theta: Floats) -> Floats:
    """Angles in [-π, π)."""
    wrapped: Floats = _core.wrap(theta)
    return wrapped


def readings(problem: Problem, mistakes: Sequence[Mistake]) -> list[Reading]:
    """The pendulums that a program may take for the problem's with one of these mistakes, each once."""
    right = taken(RIGHT, problem)
    found: dict[tuple[Start, float], Reading] = {}
    for mistake in mistakes:
        program = mistake.of(RIGHT)
        start = taken(program, problem)
        key = (start, program.pi)
        if key == (right, math.pi) or not all(map(np.isfinite, start)) or not start.alpha > 0:
            continue
        if key in found:
            found[key] = found[key]._replace(same=(*found[key].same, mistake))
        else:
            found[key] = Reading(start, (mistake,), program.pi)
    return list(found.values())


# How far a table may be from a prediction.


def predictions(candidates: Sequence[Candidate], problem: Problem) -> list[Prediction]:
    """What the candidates print, each with the spread of what is legitimately unknown: roundings, and the period."""
    three: list[tuple[Program, Clock, Start]] = []
    for candidate in candidates:
        clock, start = candidate.timing.clock, candidate.reading.start
        moved = start._replace(theta0=start.theta0 * (1 + ROUNDING), omega0=start.omega0 * (1 + ROUNDING))
        slower = clock._replace(dt=clock.dt * (1 + clock.doubt))
        three += [(candidate.program, clock, start), (candidate.program, clock, moved), (candidate.program, slower, start)]
    theta, omega = replay([each[0] for each in three], problem, [each[1] for each in three], [each[2] for each in three])
    return [
        _prediction(Motion(theta[i : i + 3], omega[i : i + 3]), three[i][1].unsure, three[i][2].alpha)
        for i in range(0, len(three), 3)
    ]


def _prediction(spread: Motion, unsure: Floats, alpha: float) -> Prediction:
    with np.errstate(invalid="ignore", over="ignore"):
        slacks = [np.abs(each[1] - each[0]) + np.abs(each[2] - each[0]) for each in spread]
        scales = (1.0, float(np.sqrt(alpha)))
        floors = [ROUNDING * (scale + np.abs(each[0])) for scale, each in zip(scales, spread, strict=True)]
        late = (np.abs(spread.omega[0]) * unsure, alpha * unsure)
        theta_slack, omega_slack = (
            np.maximum.accumulate(np.nan_to_num(slack, nan=0.0, posinf=1e300) + floor) + open_time
            for slack, floor, open_time in zip(slacks, floors, late, strict=True)
        )
    return Prediction(wrap(spread.theta[0]), spread.omega[0], theta_slack, omega_slack, spread.theta[0])


def right_prediction(problem: Problem, timing: Timing, start: Start) -> Prediction:
    """The closed form, within twice Runge-Kutta's error at the problem's step and what is legitimately unknown.

    A better method than was asked for is right.
    """
    clock = timing.clock
    t = clock.steps * clock.dt
    theta, omega = closed_form(start, t)
    if clock.steps.max(initial=0) <= MOST_WORK:
        by_rk4 = predictions([Candidate(RIGHT, Reading(start), timing, ())], problem)[0]
    else:
        by_rk4 = by_closed_form(start, clock)
    theta_error, omega_error = np.abs(wrap(by_rk4.theta - theta)), np.abs(by_rk4.omega - omega)
    errors = (np.maximum.accumulate(2 * np.nan_to_num(error, nan=np.inf)) for error in (theta_error, omega_error))
    theta_slack, omega_slack = (a + b for a, b in zip(errors, by_rk4[2:4], strict=True))
    return Prediction(wrap(theta), omega, theta_slack, omega_slack, theta)


def by_closed_form(start: Start, clock: Clock) -> Prediction:
    """The closed form with the spread that Runge-Kutta would have, where its steps are too many to be taken."""
    t = clock.steps * clock.dt
    moved = start._replace(theta0=start.theta0 * (1 + ROUNDING), omega0=start.omega0 * (1 + ROUNDING))
    three = ((start, t), (moved, t), (start, t * (1 + clock.doubt)))
    motions = [closed_form(each, times) for each, times in three]
    theta, omega = (np.array([motion[i] for motion in motions]) for i in (0, 1))
    return _prediction(Motion(theta, omega), clock.unsure, start.alpha)


def not_judged_from(prediction: Prediction) -> int:
    """The first row in which roundings may be worth so much that nothing can be said of it; the number of rows if there is none.

    Near the separatrix a right program falls to either side.
    """
    open_rows = np.flatnonzero(~(prediction.theta_slack <= DECIDES))
    return int(open_rows[0]) if open_rows.size else prediction.theta.size


def wrong_locally(start: Start, timing: Timing, columns: Columns) -> tuple[npt.NDArray[np.bool_], ...]:
    """Rows, but the first, that do not follow by Runge-Kutta from the row before, as far as its digits tell."""
    clock = timing.clock
    theta, omega = columns.theta, columns.omega
    between = np.maximum(np.diff(clock.steps), 0)
    wrong = [np.zeros(theta.values.size, bool) for _ in range(2)]
    if between.max(initial=0) > MOST_WORK // 64 or between.size == 0:
        return tuple(wrong)
    # As printed; one unit farther on; and with half the step, for Runge-Kutta's own error.
    moved = ((0, 0), (1, 0), (0, 1), (0, 0))
    starts = [
        Start(float(theta.values[i] + a * theta.units[i]), float(omega.values[i] + b * omega.units[i]), start.alpha)
        for i in range(between.size)
        for a, b in moved
    ]
    usual = [clock._replace(steps=between[i : i + 1]) for i in range(between.size)]
    finer = [clock._replace(steps=2 * each.steps, dt=clock.dt / 2) for each in usual]
    clocks = [each for pair in zip(usual, finer, strict=True) for each in (pair[0], pair[0], pair[0], pair[1])]
    motion = replay([RIGHT] * len(starts), Problem(*start, *[0.0] * 7), clocks, starts)
    for each, column, is_angle in zip(wrong, (theta, omega), (True, False), strict=True):
        after = (motion.theta if is_angle else motion.omega).reshape(-1, len(moved))
        slack = np.abs(after[:, 1:] - after[:, :1]).sum(axis=1) + column.units[1:] + ROUNDING
        off = column.values[1:] - after[:, 0]
        each[1:] = ~(np.abs(wrap(off) if is_angle else off) <= 2 * slack)
    return tuple(wrong)


# Printed states.


class Printing(NamedTuple):
    """How states are printed, and the mistakes in it."""

    theta_factor: float = 1.0
    omega_factor: float = 1.0
    form: str = "signed"
    mistakes: tuple[Mistake, ...] = ()


def _printing(mistakes: tuple[Mistake, ...]) -> Printing:
    program = RIGHT
    for mistake in mistakes:
        program = mistake.of(program)
    return Printing(program.theta_factor, program.omega_factor, program.form, mistakes)


AS_ASKED = Printing()
WRONGLY = tuple(_printing((mistake,)) for mistake in (*PRINTINGS, BOTH_IN_DEGREES))


def misfits(prediction: Prediction, printing: Printing, theta: Column, omega: Column) -> tuple[npt.NDArray[np.bool_], ...]:
    """Rows in which the angle, but for whole turns, and the velocity are not those predicted."""
    n = prediction.theta.size
    angle, velocity = theta.scaled(1 / printing.theta_factor), omega.scaled(1 / printing.omega_factor)
    wanted_theta = np.abs(prediction.theta) if printing.form == "absolute" else prediction.theta
    wanted_omega = wrap(prediction.omega) if printing.form == "normalised" else prediction.omega
    with np.errstate(invalid="ignore"):
        theta_off = np.abs(wrap(angle.values[:n] - wanted_theta))
        omega_off = np.abs(velocity.values[:n] - wanted_omega)
        return (
            ~(theta_off <= np.abs(angle.units[:n]) + prediction.theta_slack),
            ~(omega_off <= np.abs(velocity.units[:n]) + prediction.omega_slack),
        )


def fits(prediction: Prediction, printing: Printing, columns: Columns) -> bool:
    """Whether all rows are as predicted."""
    return not any(wrong.any() for wrong in misfits(prediction, printing, columns.theta, columns.omega))


# The search.


class Explanation(NamedTuple):
    """A program that prints the table's states."""

    candidate: Candidate
    printing: Printing
    prediction: Prediction

    @property
    def mistakes(self) -> tuple[Mistake, ...]:
        """In what it differs from the right program, but for its times."""
        return (*self.candidate.mistakes, *self.printing.mistakes)


def explanations(problem: Problem, columns: Columns, places: Floats, changes: int) -> list[Explanation]:
    """The programs with so many mistakes, up to two of them in states and printing, that print the table's states."""
    right = Reading(taken(RIGHT, problem))
    known = [
        (reading, _timings(problem, reading, right, columns.t, places))
        for reading in (right, *readings(problem, (*STARTS, *ALPHAS)))
    ]
    found: list[Explanation] = []
    for batch in _batches(_candidates(known, columns, changes)):
        found += _tried(batch, problem, columns, changes)
        if len(found) > MOST_ALTERNATIVES:
            break
    return found


def _candidates(known: Sequence[tuple[Reading, list[Timing]]], columns: Columns, changes: int) -> Iterator[Candidate]:
    """Programs with up to so many mistakes, at most two of them not in the times, whose first row may be that of the table."""
    for reading, of_reading in known:
        for timing in of_reading:
            left = min(changes - timing.changes, MOST_IN_STATES) - len(reading.mistakes)
            if left < 0:
                continue
            is_there = _starts_there(reading.start, timing, columns, left)
            for each in _programs(reading, timing, left):
                if is_there or each.program.steps_late or each.program.rows_late:
                    yield each


def _starts_there(start: Start, timing: Timing, columns: Columns, left: int) -> bool:
    """Whether the first row, where it is that of the start, is as the start is printed."""
    if timing.clock.steps[0] != 0:
        return True
    theta, omega = np.array([[start.theta0], [start.omega0]])
    first = Prediction(wrap(theta), omega, ROUNDING * (1 + np.abs(theta)), ROUNDING * (1 + np.abs(omega)), theta)
    return any(fits(first, printing, columns) for printing in (AS_ASKED, *(WRONGLY if left > 0 else ())))


def _timings(problem: Problem, reading: Reading, right: Reading, t: Column, places: Floats) -> list[Timing]:
    """What explains the times of a program that took the pendulum for another, before or after it had found its period."""
    try:
        found = list(timings(problem, reading.start, t, places, reading.pi))
    except ValueError:  # with this mistake there is no legal pendulum
        return []
    if reading.start == right.start and reading is not right:  # seen by its period alone
        return [timing for timing in found if not timing.changes]
    if reading is not right:
        found += [
            timing._replace(start=right.start) for timing in timings(problem, right.start, t, places) if timing.changes == 0
        ]
    return found


def _programs(reading: Reading, timing: Timing, most: int) -> Iterator[Candidate]:
    """Programs with up to so many mistakes in equation, stepper and rows; those that are left may be in the printing."""
    base = RIGHT
    single = (*EQUATIONS, *STEPPERS, *ROWS)
    yield Candidate(base, reading, timing, reading.mistakes)
    if most >= 1:
        for mistake in single:
            if "pull" in mistake.changes and reading.mistakes:
                continue  # it stands for the α that was read
            yield Candidate(mistake.of(base), reading, timing, (*reading.mistakes, mistake))
    if most >= 2:
        for i, one in enumerate(single):
            for other in single[i + 1 :]:
                if one.group != other.group and not ("pull" in one.changes and reading.mistakes):
                    yield Candidate(other.of(one.of(base)), reading, timing, (*reading.mistakes, one, other))


def _batches(candidates: Iterator[Candidate]) -> Iterator[list[Candidate]]:
    while batch := list(islice(candidates, 512)):
        yield batch


def _tried(candidates: list[Candidate], problem: Problem, columns: Columns, changes: int) -> list[Explanation]:
    """The candidates that print all rows, with as many mistakes in the printing as are left of `changes`."""
    light = [each for each in candidates if each.timing.clock.steps.max(initial=0) <= MOST_WORK]
    likely = [
        each
        for each, prediction in zip(light, _roughly(light, problem), strict=True)
        if any(fits(prediction, printing, columns) for printing in _printings(changes - each.changes))
    ]
    found = []
    for each, prediction in zip(likely, predictions(likely, problem), strict=True):
        for printing in _printings(changes - each.changes):
            if fits(prediction, printing, columns):
                found.append(Explanation(each, printing, prediction))
                break
    return found


def _roughly(candidates: Sequence[Candidate], problem: Problem) -> list[Prediction]:
    """The first rows that the candidates print, within more than what is legitimately unknown."""
    if not candidates:
        return []
    clocks = [each.timing.clock for each in candidates]
    clocks = [clock._replace(steps=clock.steps[:FIRST_ROWS]) for clock in clocks]
    motion = replay([each.program for each in candidates], problem, clocks, [each.reading.start for each in candidates])
    rough = []
    for each, clock, theta, omega in zip(candidates, clocks, *motion, strict=True):
        alpha = each.reading.start.alpha
        unsure = each.timing.clock.unsure[:FIRST_ROWS] + 2 * each.timing.clock.doubt * clock.steps * clock.dt
        with np.errstate(invalid="ignore", over="ignore"):
            late = (np.abs(omega) * unsure, np.abs(each.program.sign * alpha) * unsure)
            floors = [ROUGHLY * (1 + np.abs(motion)) for motion in (theta, omega)]
            slacks = [np.nan_to_num(a + b, nan=0.0, posinf=1e300) for a, b in zip(late, floors, strict=True)]
        rough.append(Prediction(wrap(theta), omega, *slacks, theta))
    return rough


def _printings(left: int) -> tuple[Printing, ...]:
    return (AS_ASKED,) if left == 0 else WRONGLY if left == 1 else ()


def in_single_precision(problem: Problem, timing: Timing, columns: Columns) -> bool:
    """Whether the states are as inaccurate as those of a run in single precision: within three times its errors."""
    clock = timing.clock
    if not 0 < clock.steps.max() <= MOST_WORK:
        return False
    start = taken(RIGHT, problem)
    rounded = replay([SINGLE.of(RIGHT)], problem, [clock])
    theta, omega = closed_form(start, clock.steps * clock.dt)
    single = float(np.finfo(np.float32).eps)
    slacks = [
        3 * np.maximum.accumulate(np.abs(each)) + 4 * single
        for each in (wrap(rounded.theta[0] - theta), rounded.omega[0] - omega)
    ]
    # A time that is added up in single precision is wrong by its own roundings.
    late = np.maximum.accumulate(clock.steps * single * clock.dt * np.sqrt(clock.steps + 1.0))
    slacks = [slacks[0] + np.abs(omega) * late, slacks[1] + start.alpha * late]
    return fits(Prediction(wrap(theta), omega, *slacks, theta), AS_ASKED, columns)


def regime_of(start: Start) -> int:
    """The assignment's k."""
    return analysis(start)[0]
