"""Finds the program that prints a table: every row is predicted, the first wrong one rejects, the fewest mistakes win."""

from __future__ import annotations

import math
from functools import cache
from itertools import combinations, islice
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from pendula.check._methods import STEPPERS, Mistake
from pendula.check._mistakes import ALPHAS, EQUATIONS, ROWS, STARTS
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
    misfits,
    predictions,
    wrap,
)
from pendula.check._program import RIGHT, Problem, Program, Start, paced, replay, taken
from pendula.check._timing import Timing, timings

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from pendula.check._finding import Finding
    from pendula.check._program import Floats
    from pendula.check._table import Column, Columns

ROUGHLY = 1e-8  # relative: what roundings may grow to in the first rows
FIRST_ROWS = (2, 4)  # that a program must predict before it is replayed with what is unknown
MORE_ROWS = (16, 64, 256, 1024, 4096)  # before it is replayed to the end
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
    also: tuple[Finding, ...] = ()
    """What else explains them, and is no program of these."""

    @property
    def mistakes(self) -> tuple[Mistake, ...]:
        """In what it differs from the right program, but for its times."""
        return (*self.candidate.mistakes, *self.printing.mistakes)


class Search:
    """For the programs that print a table's states."""

    def __init__(self, problem: Problem, columns: Columns, places: Floats) -> None:
        self._columns = columns
        self._found: dict[int, list[Explanation]] = {}
        right = Reading(taken(RIGHT, problem))
        self._known = [
            (reading, _timings(problem, reading, right, columns.t, places))
            for reading in (right, *readings(problem, (*STARTS, *ALPHAS)))
        ]

    def explanations(self, changes: int) -> list[Explanation]:
        """The programs with so many mistakes, up to two of them in states and printing, that print the table's states."""
        if changes not in self._found:
            self._found[changes] = self._explanations(changes)
        return self._found[changes]

    def _explanations(self, changes: int) -> list[Explanation]:
        found: list[Explanation] = []
        for batch in _batches(_candidates(self._known, self._columns, changes)):
            found += _tried(batch, self._columns, changes)
            if len(found) > MOST_ALTERNATIVES:
                break
        return found


def _is_idle(mistake: Mistake, problem: Problem) -> bool:
    """Whether a mistake in both quantities would need another unit of one of them."""
    units = {"theta0": problem.theta0_unit, "omega0": problem.omega0_unit}
    factors = [mistake.changes[name][unit == "s"] for name, unit in units.items() if name in mistake.changes]
    return mistake.name.startswith("both_") and 1.0 in factors


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


def _candidates(known: Sequence[tuple[Reading, list[Timing]]], columns: Columns, changes: int) -> Iterator[Candidate]:
    """Programs with so many mistakes, or one less where that is in the printing, whose first row may be that of the table."""
    for reading, of_reading in known:
        for timing in of_reading:
            left = changes - timing.changes - len(reading.mistakes)
            is_there = _starts_there(reading.start, timing, columns, left)
            for count, printing in ((left - 1, 1), (left, 0)):
                if not 0 <= count <= MOST_IN_STATES - printing - len(reading.mistakes):
                    continue
                for program, mistakes in _programs(count, count + len(reading.mistakes) > 1):
                    # A pull stands for the α that was read.
                    if (is_there or program.starts_elsewhere) and not (program.pull and reading.mistakes):
                        yield Candidate(program, reading, timing, (*reading.mistakes, *mistakes))


def _starts_there(start: Start, timing: Timing, columns: Columns, left: int) -> bool:
    """Whether the first row, where it is that of the start, is as the start is printed."""
    if timing.clock.steps[0] != 0:
        return True
    theta, omega = np.array([[start.theta0], [start.omega0]])
    first = Prediction(wrap(theta), omega, ROUNDING * (1 + np.abs(theta)), ROUNDING * (1 + np.abs(omega)), theta)
    return any(fits(first, printing, columns) for printing in (AS_ASKED, *(WRONGLY if left > 0 else ())))


@cache
def _programs(count: int, are_usual: bool) -> list[tuple[Program, tuple[Mistake, ...]]]:
    """Programs with so many mistakes in equation, stepper and rows, all from different groups; all of them, or no rare ones."""
    single = [mistake for mistake in (*EQUATIONS, *STEPPERS, *ROWS) if not (are_usual and mistake.is_rare)]
    made = []
    for mistakes in combinations(single, count):
        if len({mistake.group for mistake in mistakes}) == count:
            program = RIGHT
            for mistake in mistakes:
                program = mistake.of(program)
            made.append((program, mistakes))
    return made


def _batches(candidates: Iterator[Candidate]) -> Iterator[list[Candidate]]:
    while batch := list(islice(candidates, 512)):
        yield batch


def _tried(candidates: list[Candidate], columns: Columns, changes: int) -> list[Explanation]:
    """The candidates that print all rows, where mistakes are left of `changes` with one in the printing."""
    likely = [each for each in candidates if each.timing.clock.steps.max(initial=0) <= MOST_WORK]
    for rows in FIRST_ROWS:
        likely = _likely(likely, columns, changes, rows)
    size = columns.t.values.size
    found: list[Explanation] = []
    for rows in (*(each for each in MORE_ROWS if each < size // 2), size):
        found = _explaining(likely, columns, changes, rows)
        likely = [each.candidate for each in found]
    return [each for each in found if matters(each.printing, each.prediction)]


def _explaining(candidates: Sequence[Candidate], columns: Columns, changes: int, rows: int) -> list[Explanation]:
    """The candidates that print so many rows, each with the first way of printing that does."""
    runs = [each.run for each in candidates]
    runs = [run._replace(clock=run.clock.first(rows)) for run in runs]
    found = []
    for each, exact in zip(candidates, predictions(runs), strict=True):
        prediction = _wrapped_with(each.reading, exact)
        for printing in _printings(changes - each.changes):
            if fits(prediction, printing, columns):
                found.append(Explanation(each, printing, prediction))
                break
    return found


def _wrapped_with(reading: Reading, prediction: Prediction) -> Prediction:
    """The prediction of a program that takes another number for π in each turn, too."""
    turns = np.abs(np.rint(prediction.turning / (2 * np.pi)))
    off = 2 * abs(reading.pi - math.pi) * np.maximum.accumulate(turns)
    return prediction._replace(
        theta_slack=prediction.theta_slack + off, omega_slack=prediction.omega_slack + off * math.sqrt(reading.start.alpha)
    )


def _likely(candidates: Sequence[Candidate], columns: Columns, changes: int, rows: int) -> list[Candidate]:
    """The candidates that print the first rows, within more than what is legitimately unknown."""
    if not candidates:
        return []
    first = _first_rows(candidates, rows)
    left = np.array([changes - each.changes for each in candidates])
    is_likely = np.zeros(left.size, bool)
    for count in np.unique(left):
        for printing in _printings(int(count)):
            wrong = misfits(first, printing, columns.theta, columns.omega)
            is_likely |= (left == count) & ~np.any(wrong, axis=(0, 2))
    return [each for each, is_one in zip(candidates, is_likely, strict=True) if is_one]


def _first_rows(candidates: Sequence[Candidate], rows: int) -> Prediction:
    """[candidate, row]: what they print."""
    clocks = [each.run.clock.first(rows) for each in candidates]
    motion = replay([each.program for each in candidates], clocks, [each.reading.start for each in candidates])
    alpha = np.array([[each.program.sign * each.reading.start.alpha] for each in candidates])
    unsure = np.stack([clock.unsure + 2 * clock.doubt * clock.t for clock in clocks])
    with np.errstate(invalid="ignore", over="ignore"):
        late = (np.abs(motion.omega) * unsure, np.abs(alpha) * unsure)
        floors = [ROUGHLY * (1 + np.abs(each)) for each in motion]
        slacks = [np.nan_to_num(a + b, nan=0.0, posinf=1e300) for a, b in zip(late, floors, strict=True)]
    return Prediction(wrap(motion.theta), motion.omega, slacks[0], slacks[1], motion.theta)


def _printings(left: int) -> tuple[Printing, ...]:
    """How states may be printed with so many mistakes."""
    return WRONGLY if left == 1 else (AS_ASKED,)
