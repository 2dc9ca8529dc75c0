"""Mistakes with a number of their own, which is fitted: damping, torque or a drive left in, and a wrong factor of α."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pendula.check._clock import KNOWN
from pendula.check._explain import Candidate, Explanation, Reading
from pendula.check._methods import STEPPERS, Mistake
from pendula.check._predict import AS_ASKED, fits, predictions, wrap
from pendula.check._program import RIGHT, Clock, Program, Start, analysis, replay, taken
from pendula.check._timing import off, timings

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from pendula.check._program import Floats, Problem
    from pendula.check._table import Columns
    from pendula.check._timing import Timing

LEAST = 1e-4  # relative to the pendulum's own: a smaller term is no mistake that a person makes
LARGEST_STRETCH = 1e-3  # relative: the times show a period that is farther off
ROUNDS = 12  # of Gauss and Newton's method
SURE = 3  # after so many, they at least halve what is left where the term is the mistake
STALLED = 30  # units of the digits printed, below which roundings may be all that is left
NEAR = 1e-5  # rad, and of ω/√α: what is unknown may be worth that in a row
MOST_STEPS = 1 << 20
MOST_FITTED = 1 << 14  # steps
FEWEST_ROWS = 20
BESIDE = ("euler_cromer", "euler", "verlet", "heun", "midpoint")  # methods with which such a term is left in
FREQUENCIES = np.arange(0.05, 3.0, 0.05)  # of a drive, tried first, in those of small swings


class Term:
    """A term with numbers of its own."""

    def __init__(self, name: str, made: Callable[[Floats], Mistake], guesses: list[list[float]], nothing: float = 0.0) -> None:
        self.name, self.made, self.guesses, self.nothing = name, made, guesses, nothing


def terms(problem: Problem) -> Iterator[Term]:
    """Those that are tried, with numbers to begin with."""
    rate = float(np.sqrt(problem.alpha))

    def damping(x: Floats) -> Mistake:
        return Mistake("damping", "equation", {"beta": float(x[0])}, {"beta": float(x[0])})

    def torque(x: Floats) -> Mistake:
        return Mistake("torque", "equation", {"torque": float(x[0])}, {"torque": float(x[0])})

    def factor(x: Floats) -> Mistake:
        used = {"alpha": float(x[0]) * problem.alpha, "given": problem.alpha}
        return Mistake("alpha_factor", "alpha", {"alpha": (float(x[0]), 1.0)}, used)

    def drive(x: Floats) -> Mistake:
        values = {"amplitude": float(x[0]), "frequency": abs(float(x[1]))}
        return Mistake("drive", "equation", {"drive": (float(x[0]), abs(float(x[1])))}, values)

    yield Term("damping", damping, [[0.01 * rate]])
    yield Term("torque", torque, [[0.01 * problem.alpha]])
    yield Term("alpha_factor", factor, [[1.01]], 1.0)
    yield Term("drive", drive, [[0.01 * problem.alpha, f * rate] for f in FREQUENCIES])


def fitted(problem: Problem, timing: Timing, columns: Columns, places: Floats) -> list[Explanation]:
    """A program with one such term, and Runge-Kutta or another method, that prints the table's states."""
    if not 0 < timing.clock.steps.max() <= MOST_STEPS:
        return []
    slower = _stretched(problem, timing, columns)
    if slower:
        return [slower]
    steppers = [None, *(each for each in STEPPERS if each.name in BESIDE)]
    for stepper in steppers:
        for term in terms(problem):
            if stepper is not None and term.name not in ("damping", "torque"):
                continue
            found = _fit(problem, timing, columns, term, stepper)
            if found:
                return [_in_own_time(problem, found, columns, places)]
    return []


def _stretched(problem: Problem, timing: Timing, columns: Columns) -> Explanation | None:
    """The right program, with a period that is nearly right: the times tell it to fewer digits than the states."""
    start, clock = taken(RIGHT, problem), timing.clock
    stretch, small = 0.0, 1e-6
    for _ in range(ROUNDS):
        clocks = [clock._replace(dt=clock.dt * (1 + each)) for each in (stretch, stretch + small)]
        at, after = _residuals(problem, clocks, columns, [RIGHT, RIGHT])
        slope = (after - at) / small
        change = -float(slope @ at) / max(float(slope @ slope), 1e-300)
        stretch += change
        if not abs(stretch) <= LARGEST_STRETCH:
            return None
        if abs(change) <= 1e-3 * abs(stretch):
            break
    if abs(stretch) <= KNOWN:  # nobody's fault
        return None
    own = timing.tau * (1 + stretch)
    tau = analysis(start)[2]
    said = off(start, own, 1.0, {"tau": tau, "got": own, "every": problem.every, "spacing": problem.every * (1 + stretch)})
    findings = timing.findings if timing.changes else (*timing.findings, said)  # a period is told once
    moved = timing._replace(clock=clock._replace(dt=clock.dt * (1 + stretch)), tau=own, findings=findings)
    candidate = Candidate(RIGHT, Reading(start), moved, ())
    prediction = predictions([candidate.run])[0]
    return Explanation(candidate, AS_ASKED, prediction) if fits(prediction, AS_ASKED, columns) else None


def _in_own_time(problem: Problem, found: Explanation, columns: Columns, places: Floats) -> Explanation:
    """The explanation with the times that follow from another α, where they are those of the table."""
    candidate = found.candidate
    if candidate.program.alpha == RIGHT.alpha or candidate.timing.changes == 0:
        return found
    for timing in timings(problem, candidate.reading.start, columns.t, places):
        if timing.changes < candidate.timing.changes:
            return found._replace(candidate=candidate._replace(timing=timing))
    return found


def _first_part(timing: Timing, columns: Columns) -> tuple[Timing, Columns]:
    """The first rows, which tell a term's numbers in few steps."""
    rows = max(FEWEST_ROWS, int(np.searchsorted(timing.clock.steps, MOST_FITTED)))
    t, theta, omega = (each.at(slice(rows)) for each in columns[:3])
    return timing._replace(clock=timing.clock.first(rows)), columns._replace(t=t, theta=theta, omega=omega)


def _fit(problem: Problem, timing: Timing, columns: Columns, term: Term, stepper: Mistake | None) -> Explanation | None:
    base = stepper.of(RIGHT) if stepper else RIGHT
    first = _first_part(timing, columns)
    numbers: Floats | None = np.array(_nearest(problem, *first, term, base))
    for part in (first, (timing, columns)):
        numbers = None if numbers is None else _converged(problem, *part, term, base, numbers)
    if numbers is None or abs(numbers[0] - term.nothing) < LEAST * (term.guesses[0][0] - term.nothing) * 100:
        return None
    mistake = term.made(_round(numbers, columns.digits))
    mistakes = (mistake, stepper) if stepper else (mistake,)
    fallback = term.made(numbers)
    for each in (mistake, fallback):
        reading = Reading(taken(each.of(RIGHT), problem))
        candidate = Candidate(each.of(base), reading, timing, (each, *mistakes[1:]))
        prediction = predictions([candidate.run])[0]
        # A fitted number makes up for a part of what is unknown, and is itself no nearer than that.
        wider = prediction._replace(theta_slack=3 * prediction.theta_slack, omega_slack=3 * prediction.omega_slack)
        if fits(wider, AS_ASKED, columns):
            return Explanation(candidate, AS_ASKED, prediction)
    return None


def _converged(problem: Problem, timing: Timing, columns: Columns, term: Term, base: Program, numbers: Floats) -> Floats | None:
    """The numbers with which the term prints the states best; None where it does not print them."""
    printed = float(np.linalg.norm(np.append(columns.theta.units, columns.omega.units)))
    size, least = np.inf, max(STALLED * printed, NEAR * float(np.sqrt(columns.t.values.size)))
    for turn in range(ROUNDS):
        tried = [numbers, *(numbers + step for step in np.diag(1e-6 * np.maximum(np.abs(numbers), 1e-3)))]
        residuals = _residuals(problem, [timing.clock], columns, [term.made(each).of(base) for each in tried])
        before, size = size, float(np.linalg.norm(residuals[0]))
        if not np.isfinite(residuals).all() or (turn >= SURE and size > max(0.5 * before, least)):
            return None
        steps = [np.linalg.norm(each - numbers) for each in tried[1:]]
        slopes = np.stack([(each - residuals[0]) / step for each, step in zip(residuals[1:], steps, strict=True)], axis=1)
        change, *_ = np.linalg.lstsq(slopes, -residuals[0], rcond=None)
        numbers = numbers + change
        if np.all(np.abs(change) <= 1e-9 * np.abs(numbers)):
            break
    return numbers if size <= least else None


def _round(numbers: Floats, digits: int) -> Floats:
    """The numbers that a person would type, if they are near."""
    rounded = np.array([float(f"{each:.3g}") for each in numbers])
    return np.where(np.abs(rounded - numbers) <= 10.0 ** (1 - digits) * np.abs(numbers) * 10, rounded, numbers)


def _nearest(problem: Problem, timing: Timing, columns: Columns, term: Term, base: Program) -> list[float]:
    if len(term.guesses) == 1:
        return term.guesses[0]
    residuals = _residuals(
        problem, [timing.clock], columns, [base, *(term.made(np.array(each)).of(base) for each in term.guesses)]
    )
    best, where = np.inf, term.guesses[0]
    for guess, each in zip(term.guesses, residuals[1:], strict=True):
        slope = (each - residuals[0]) / guess[0]
        amplitude = -float(slope @ residuals[0]) / max(float(slope @ slope), 1e-300)
        left = float(np.linalg.norm(residuals[0] + amplitude * slope))
        if left < best:
            best, where = left, [amplitude, *guess[1:]]
    return where


def _residuals(problem: Problem, clocks: list[Clock], columns: Columns, programs: list[Program]) -> Floats:
    """[program, angles and velocities]: what the programs compute less what is printed."""
    starts: list[Start] = [taken(program, problem) for program in programs]
    with np.errstate(all="ignore"):
        clocks = clocks * len(programs) if len(clocks) == 1 else clocks
        theta, omega = replay(programs, clocks, starts)
        rate = float(np.sqrt(problem.alpha))
        off = np.hstack([wrap(theta - columns.theta.values), (omega - columns.omega.values) / rate])
    found: Floats = off
    return found
