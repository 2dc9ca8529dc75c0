"""Finds the program that prints a table: every row is predicted, the first wrong one rejects, the fewest mistakes win."""

from __future__ import annotations

import math
from itertools import islice
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from pendula.check._mistakes import ALPHAS, EQUATIONS, ROWS, SINGLE, STARTS, STEPPERS, Mistake
from pendula.check._predict import (
    AS_ASKED,
    MOST_WORK,
    ROUNDING,
    WRONGLY,
    Prediction,
    Printing,
    Run,
    fits,
    matters,
    predictions,
    wrap,
)
from pendula.check._program import RIGHT, Problem, Program, Start, closed_form, paced, replay, taken
from pendula.check._timing import Timing, timings

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from pendula.check._program import Floats
    from pendula.check._table import Column, Columns

ROUGHLY = 1e-8  # relative: what roundings may grow to in the first rows
FIRST_ROWS = 4  # that a program must predict before it is replayed to the end
MOST_ALTERNATIVES = 3
MOST_IN_STATES = 2  # mistakes in what is read, computed and printed of states


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
    def run(self) -> Run:
        """What is replayed of it."""
        return Run(self.program, paced(self.program, self.timing.clock), self.reading.start)

    @property
    def changes(self) -> int:
        """How many mistakes there are in it."""
        return len(self.mistakes) + self.timing.changes


def readings(problem: Problem, mistakes: Sequence[Mistake]) -> list[Reading]:
    """The pendulums that a program may take for the problem's with one of these mistakes, each once."""
    right = taken(RIGHT, problem)
    found: dict[tuple[Start, float], Reading] = {}
    for mistake in mistakes:
        program = mistake.of(RIGHT)
        start = taken(program, problem)
        key = (start, program.pi)
        if key == (right, math.pi) or _is_idle(mistake, problem) or not all(map(np.isfinite, start)) or not start.alpha > 0:
            continue
        if key in found:
            found[key] = found[key]._replace(same=(*found[key].same, mistake))
        else:
            found[key] = Reading(start, (mistake,), program.pi)
    return list(found.values())


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
        found += _tried(batch, columns, changes)
        if len(found) > MOST_ALTERNATIVES:
            break
    return found


def _is_idle(mistake: Mistake, problem: Problem) -> bool:
    """Whether a mistake in both quantities would need another unit of one of them."""
    units = {"theta0": problem.theta0_unit, "omega0": problem.omega0_unit}
    factors = [mistake.changes[name][unit == "s"] for name, unit in units.items() if name in mistake.changes]
    return mistake.name.startswith("both_") and 1.0 in factors


def _candidates(known: Sequence[tuple[Reading, list[Timing]]], columns: Columns, changes: int) -> Iterator[Candidate]:
    """Programs with up to so many mistakes, at most two of them not in the times, whose first row may be that of the table."""
    for reading, of_reading in known:
        for timing in of_reading:
            left = min(changes - timing.changes, MOST_IN_STATES) - len(reading.mistakes)
            if left < 0:
                continue
            is_there = _starts_there(reading.start, timing, columns, left)
            for each in _programs(reading, timing, left):
                if is_there or each.program.starts_elsewhere:
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
            if reading.mistakes and (mistake.is_rare or "pull" in mistake.changes):
                continue  # a pull stands for the α that was read
            yield Candidate(mistake.of(base), reading, timing, (*reading.mistakes, mistake))
    if most >= 2:
        often = [mistake for mistake in single if not mistake.is_rare]
        for i, one in enumerate(often):
            for other in often[i + 1 :]:
                if one.group != other.group and not ("pull" in one.changes and reading.mistakes):
                    yield Candidate(other.of(one.of(base)), reading, timing, (*reading.mistakes, one, other))


def _batches(candidates: Iterator[Candidate]) -> Iterator[list[Candidate]]:
    while batch := list(islice(candidates, 512)):
        yield batch


def _tried(candidates: list[Candidate], columns: Columns, changes: int) -> list[Explanation]:
    """The candidates that print all rows, with as many mistakes in the printing as are left of `changes`."""
    light = [each for each in candidates if each.timing.clock.steps.max(initial=0) <= MOST_WORK]
    likely = [
        each
        for each, prediction in zip(light, _roughly(light), strict=True)
        if any(fits(prediction, printing, columns) for printing in _printings(changes - each.changes))
    ]
    found = []
    for each, prediction in zip(likely, predictions([each.run for each in likely]), strict=True):
        for printing in _printings(changes - each.changes):
            if matters(printing, prediction) and fits(prediction, printing, columns):
                found.append(Explanation(each, printing, prediction))
                break
    return found


def _roughly(candidates: Sequence[Candidate]) -> list[Prediction]:
    """The first rows that the candidates print, within more than what is legitimately unknown."""
    if not candidates:
        return []
    clocks = [each.run.clock for each in candidates]
    clocks = [clock._replace(steps=clock.steps[:FIRST_ROWS]) for clock in clocks]
    motion = replay([each.program for each in candidates], clocks, [each.reading.start for each in candidates])
    rough = []
    for each, clock, theta, omega in zip(candidates, clocks, *motion, strict=True):
        alpha = each.reading.start.alpha
        unsure = each.timing.clock.unsure[:FIRST_ROWS] + 2 * each.timing.clock.doubt * clock.t
        with np.errstate(invalid="ignore", over="ignore"):
            late = (np.abs(omega) * unsure, np.abs(each.program.sign * alpha) * unsure)
            floors = [ROUGHLY * (1 + np.abs(motion)) for motion in (theta, omega)]
            slacks = [np.nan_to_num(a + b, nan=0.0, posinf=1e300) for a, b in zip(late, floors, strict=True)]
        rough.append(Prediction(wrap(theta), omega, slacks[0], slacks[1], theta))
    return rough


def _printings(left: int) -> tuple[Printing, ...]:
    return (AS_ASKED,) if left == 0 else WRONGLY if left == 1 else ()


def in_single_precision(problem: Problem, timing: Timing, columns: Columns) -> bool:
    """Whether the states are as inaccurate as those of a run in single precision: within three times its errors."""
    clock = timing.clock
    if not 0 < clock.steps.max() <= MOST_WORK:
        return False
    start = taken(RIGHT, problem)
    rounded = replay([SINGLE.of(RIGHT)], [clock], [start])
    theta, omega = closed_form(start, clock.t)
    single = float(np.finfo(np.float32).eps)
    slacks = [
        3 * np.maximum.accumulate(np.abs(each)) + 4 * single
        for each in (wrap(rounded.theta[0] - theta), rounded.omega[0] - omega)
    ]
    # A time that is added up in single precision is wrong by its own roundings.
    late = np.maximum.accumulate(clock.steps * single * clock.dt * np.sqrt(clock.steps + 1.0))
    slacks = [slacks[0] + np.abs(omega) * late, slacks[1] + start.alpha * late]
    return fits(Prediction(wrap(theta), omega, slacks[0], slacks[1], theta), AS_ASKED, columns)
