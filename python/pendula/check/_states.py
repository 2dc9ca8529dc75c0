"""Wrong states: the programs that print them, or what else there is to say of them."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from pendula import _core
from pendula.check._clock import has_single_sums
from pendula.check._explain import Explanation, Search
from pendula.check._finding import Finding, Where, error
from pendula.check._fit import fitted
from pendula.check._methods import SINGLE, Mistake
from pendula.check._predict import AS_ASKED, DECIDES, MOST_WORK, Prediction, misfits, wrap, wrong_locally
from pendula.check._program import RIGHT, Problem, Start, closed_form, replay, taken
from pendula.check._timing import Timing, timings
from pendula.check._view import View, first_wrong

if TYPE_CHECKING:
    from collections.abc import Sequence

    from pendula.check._finding import Value
    from pendula.check._table import Columns

FEWEST_ROWS = 4  # that show a motion
ELSEWHERE = 0.01  # rad, and relative of ω: a nearer start is that of the problem, read or printed wrongly
SINGLE_IN_A_ROW = 1e-3  # rad, and of ω/√α: more than single precision loses between two rows


def explained(problem: Problem, view: View, search: Search) -> list[Explanation] | Finding:
    """The programs that print the states, or what else there is to say of them."""
    columns, where = view.columns, first_wrong(view)
    rows = columns.t.values.size
    still = np.all(np.abs(wrap(columns.theta.values - columns.theta.values[0])) <= columns.theta.units)
    if rows > 1 and still and np.all(np.abs(columns.omega.values - columns.omega.values[0]) <= columns.omega.units):
        return Finding("nothing_moves", {}, where=where, alternatives=(error("integer_division"),))
    are_only_times = not any(wrong.any() for wrong in view.wrong[:2])
    found = [] if are_only_times else search.explanations(1)
    if found and any(mistake.is_rare for mistake in found[0].candidate.mistakes) and _is_in_single(problem, view):
        return [found[0]._replace(also=(error("single_precision"),)), *found[1:]]
    if found:
        return found
    if are_only_times and not view.are_cells and has_single_sums(columns.t, view.timing.clock):
        return error("time_single")
    if view.are_cells:
        return Finding("wrong_cell", {"count": sum(int(each.sum()) for each in view.wrong)}, where=where)
    found = fitted(problem, view.timing, columns, view.places) or search.explanations(2)
    if found:
        return found
    if _is_in_single(problem, view):
        return Finding("single_precision", {}, where=where, alternatives=(error("single_constants"),))
    found = search.explanations(3)
    if found:
        return found
    if any(wrong[0] for wrong in view.wrong[:2]):
        if _on_a_circle(columns):
            return error("cartesian")
        if elsewhere := _other_start(problem, view):
            return elsewhere
    return Finding("unexplained", _symptoms(problem, view), where=where)


def _other_start(problem: Problem, view: View) -> Finding | None:
    """A table that begins elsewhere, and follows from there."""
    columns, clock = view.columns, view.timing.clock
    theta, omega = float(columns.theta.values[0]), float(columns.omega.values[0])
    if clock.steps.size < FEWEST_ROWS:
        return None
    theta0, omega0, alpha = taken(RIGHT, problem)
    rate = float(np.sqrt(alpha))
    if abs(wrap(np.array(theta - theta0))) < ELSEWHERE and abs(omega - omega0) < ELSEWHERE * (abs(omega0) + rate):
        return None
    start = Start(theta, omega, alpha)
    if any(wrong.any() for wrong in wrong_locally(start, clock, columns)):
        return None
    values: dict[str, Value] = {"theta": theta, "omega": omega, "angle": float(wrap(np.array(theta0))), "velocity": omega0}
    return Finding("other_start", values, where=first_wrong(view))


def _on_a_circle(columns: Columns) -> bool:
    """Whether the two columns are x and y of a pendulum, whose length is always the same."""
    x, y = columns.theta.values, columns.omega.values
    squares = x * x + y * y
    return bool(np.ptp(squares) <= 1e-3 * squares.max() and np.ptp(x) > 0.01 * np.sqrt(squares.max()))


def told(found: Sequence[Explanation], where: Where | None) -> list[Finding]:
    """The mistakes of the first explanation; where others explain as well, they stand beside."""
    own = [_key(mistake) for mistake in found[0].mistakes]
    findings = []
    for i, mistake in enumerate(found[0].mistakes):
        reading = found[0].candidate.reading
        others = {_key(each): each for each in reading.same if mistake in reading.mistakes}
        for other in found[1:]:
            keys = [_key(each) for each in other.mistakes]
            if len(keys) == len(own) and keys[i] != own[i] and keys[:i] + keys[i + 1 :] == own[:i] + own[i + 1 :]:
                others[keys[i]] = other.mistakes[i]
        others.pop(own[i], None)
        alternatives = tuple(error(each.name, **each.values) for each in list(others.values())[:3])
        alternatives += found[0].also if i == 0 else ()
        findings.append(Finding(mistake.name, dict(mistake.values), where=where if i == 0 else None, alternatives=alternatives))
    return findings


def _key(mistake: Mistake) -> tuple[str, tuple[tuple[str, float | str], ...]]:
    """What is told of it: rows of which the same is told are one mistake."""
    return mistake.name, tuple(mistake.values.items())


def _symptoms(problem: Problem, view: View) -> dict[str, float | int | str]:
    """What there is to say of states that nothing explains: the order that their errors are of, and their energy."""
    columns = view.columns
    theta, omega = columns.theta.values, columns.omega.values
    with np.errstate(all="ignore"):
        energy = _core.energy(theta, omega, problem.alpha)
        scale = float(np.max(_core.energy(np.append(theta, np.pi), np.append(omega, 0), problem.alpha)))
        step = view.timing.clock.dt * np.sqrt(problem.alpha)
        off = float(np.max(np.abs(wrap(theta - view.wanted.theta))))
        order = round(np.log(max(off, 1e-15)) / np.log(step)) if 0 < step < 0.5 else 0
    drift, spread = float(energy[-1] - energy[0]), float(np.ptp(energy))
    if not spread > 1e-5 * scale:
        how = "kept"
    elif abs(drift) > 0.6 * spread:
        how = "grows" if drift > 0 else "falls"
    else:
        how = "swings"
    return {"order": int(order) if 1 <= order <= 3 else "?", "energy": how}


def _is_in_single(problem: Problem, view: View) -> bool:
    """Whether single precision explains the states."""
    found = timings(problem, taken(RIGHT, problem), view.columns.t, view.places)
    return any(_in_single_precision(problem, timing, view.columns) for timing in found)


def _in_single_precision(problem: Problem, timing: Timing, columns: Columns) -> bool:
    """Whether the states are as inaccurate as those of a run in single precision: within three times its errors."""
    clock = timing.clock
    if not 0 < clock.steps.max() <= MOST_WORK // 16:
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
    wrong = misfits(Prediction(wrap(theta), omega, slacks[0], slacks[1], theta), AS_ASKED, columns.theta, columns.omega)
    # Where its roundings decide, each row must follow from the one before.
    is_open = ~(slacks[0] <= DECIDES)
    if any(each[~is_open].any() for each in wrong):
        return False
    near = wrong_locally(start, clock, _widened(columns, SINGLE_IN_A_ROW, SINGLE_IN_A_ROW * math.sqrt(start.alpha)))
    return not any((np.where(is_open, local, far)).any() for far, local in zip(wrong, near, strict=True))


def _widened(columns: Columns, theta: float, omega: float) -> Columns:
    """The columns with units that are at least so large."""
    units = np.maximum(columns.theta.units, theta), np.maximum(columns.omega.units, omega)
    return columns._replace(theta=columns.theta._replace(units=units[0]), omega=columns.omega._replace(units=units[1]))
