"""Marks a table: what is wrong with its layout, times, states, their printing and the sinusoid, each mistake told once."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from pendula import _core
from pendula.check._explain import Explanation, explanations, in_single_precision
from pendula.check._finding import ERROR, REMARK, Finding, Value, Where, error, remark
from pendula.check._fit import fitted
from pendula.check._predict import (
    AS_ASKED,
    DECIDES,
    Prediction,
    are_cells,
    by_closed_form,
    misfits,
    not_judged_from,
    right_prediction,
    wrap,
    wrong_locally,
)
from pendula.check._program import RIGHT, Problem, Start, analysis, taken
from pendula.check._sinusoid import UNKNOWN, fits, of_sinusoid, right_sinusoid
from pendula.check._table import ROLES, WORDS, Column, Columns, columns_at, placements, roles_of
from pendula.check._timing import Timing, timings
from pendula.check._wrapping import of_wrapping

if TYPE_CHECKING:
    from collections.abc import Sequence

    import numpy.typing as npt

    from pendula.check._program import Floats
    from pendula.check._table import Table

FEW_DIGITS = 5
ROUGH = 2e-3  # relative: what 3.14 for π does to a sinusoid
MOST_PLACEMENTS = 12
MOST_WRONG = 4  # placements that a wrong table's columns are tried in


class Deviation(NamedTuple):
    """How far a column is from what it should be."""

    right: int
    """Rows that are as they should be."""
    first_wrong: int | None
    """The first row that is not."""
    wanted: Floats
    """What should be there."""
    from_exact: float
    """The largest distance from the closed form [rad, rad/s]."""


class Judgement(NamedTuple):
    """What there is to say of a table."""

    findings: list[Finding]
    deviations: dict[str, Deviation]
    """By the columns' roles."""
    columns: Columns | None = None
    digits: int = 6
    """With how many its numbers are told."""

    @property
    def is_right(self) -> bool:
        """Whether there are no mistakes; remarks are none."""
        return all(finding.severity != ERROR for finding in self.findings)


class View(NamedTuple):
    """A table's columns, compared with what is right at its times."""

    columns: Columns
    places: Floats
    """The numbers of the rows."""
    timing: Timing
    wanted: Prediction
    wrong: tuple[npt.NDArray[np.bool_], ...]
    """Rows in which angle, velocity and time are not right."""
    judged: int
    """Rows before the first that cannot be judged."""


def judge(problem: Problem, table: Table) -> Judgement:
    """Predicts every column and, where the table differs, finds the program that prints it."""
    with np.errstate(all="ignore"):  # numbers that overflow are no right ones, and that is all there is to it
        return _judged(problem, table)


def _judged(problem: Problem, table: Table) -> Judgement:
    findings = _of_header(problem, table)
    found: list[tuple[str, Columns]] = []
    for name, places in placements(table, problem.regime == -1):
        columns = columns_at(table, places)
        if columns is not None and len(found) < MOST_PLACEMENTS:
            found.append((name, columns))
    if not found:
        is_told = any(finding.name in ("no_time", "cartesian") for finding in findings)
        return Judgement(findings if is_told else [*findings, error("columns", found=table.values.shape[1])], {})
    # As the header says or, where only that makes the states right, in another order.
    is_twice = len(table.values) > 2 and np.array_equal(table.values[0], table.values[1])
    if is_twice:
        table = _without_first(table)
        found = [(name, _without_first_row(columns)) for name, columns in found if columns.lines.size > 2]
    views = [(name, _view(problem, table, columns)) for name, columns in found]
    name, view, of_states = _best(problem, views)
    if name:
        findings.append(error(name, header=" ".join(table.header)))
    if is_twice:
        findings.append(error("first_row_twice"))
    findings += _of_rows(table, view.columns)
    findings += of_states
    off = _deviations(problem, view)
    if any(finding.name == "cartesian" for finding in findings):
        findings = [finding for finding in findings if finding.name not in ("sine_missing", "sine_unexplained")]
    findings = list({finding.name: finding for finding in reversed(findings)}.values())[::-1]
    return Judgement(findings, off, view.columns, max(view.columns.digits, 3))


def _best(problem: Problem, views: Sequence[tuple[str, View]]) -> tuple[str, View, list[Finding]]:
    """The columns that there is least to say of: those with right states, else those whose states one mistake explains."""
    right = [each for each in views if _is_right(each[1])]
    view = (right[0] if right else _likeliest(problem, views))[1]
    explained = None if right else _explained(problem, view)
    # Where nothing tells which column is the sinusoid, it is the one that fits.
    same = [each for each in right or views if _has_same_states(each[1], view)]
    best, least = None, np.inf
    for each_name, each in same:
        findings = _of_states(problem, each, explained)
        weight = sum(3 if finding.name == "sine_unexplained" else 1 for finding in findings if finding.severity == ERROR)
        if weight + 0.5 * bool(each_name) < least:
            best, least = (each_name, each, findings), weight + 0.5 * bool(each_name)
        if least == 0:
            break
    assert best is not None
    return best


def _has_same_states(one: View, other: View) -> bool:
    pairs = zip(one.columns[:3], other.columns[:3], strict=True)
    return all(np.array_equal(a.values, b.values) for a, b in pairs)


def _likeliest(problem: Problem, views: Sequence[tuple[str, View]]) -> tuple[str, View]:
    """Of columns with wrong states, those with few wrong cells; else those that one mistake explains; else the first."""
    tried: list[View] = []
    for each in views:
        if len(tried) < MOST_WRONG and not any(_has_same_states(each[1], view) for view in tried):
            tried.append(each[1])
            if _are_cells(each[1]) or explanations(problem, each[1].columns, each[1].places, 1):
                return each
    return views[0]


def _are_cells(view: View) -> bool:
    """Whether so few cells are wrong that they are no mistake of the program."""
    return are_cells(int(np.any(view.wrong, axis=0).sum()), view.columns.t.values.size)


def _without_first(table: Table) -> Table:
    return table._replace(values=table.values[1:], units=table.units[1:], lines=table.lines[1:])


def _without_first_row(columns: Columns) -> Columns:
    def rest(column: Column) -> Column:
        return Column(column.values[1:], column.units[1:])

    sine = None if columns.sine is None else rest(columns.sine)
    t, theta, omega = map(rest, columns[:3])
    return columns._replace(t=t, theta=theta, omega=omega, sine=sine, lines=columns.lines[1:])


# Layout.


def _of_header(problem: Problem, table: Table) -> list[Finding]:
    """Remarks on the header; nothing is wrong with a table that lacks one."""
    findings = [Finding(name, values, _severity(name, values)) for name, values in table.notes]
    has_sine = "sine" in roles_of(table.header) if table.header else problem.regime == -1
    words = WORDS if has_sine else WORDS[:3]
    if not table.header:
        return [*findings, remark("no_header", words=" ".join(words))]
    if table.header[: len(words)] != words:
        return [*findings, remark("other_header", header=" ".join(table.header), words=" ".join(words))]
    return findings


def _severity(name: str, values: dict[str, Value]) -> str:
    """A comma that is decimal and separator is a remark where all rows could be read."""
    return ERROR if name in ("no_time", "cartesian") or (name == "comma_ambiguous" and values["count"]) else REMARK


def _of_rows(table: Table, columns: Columns) -> list[Finding]:
    """Rows that lack numbers, and numbers of few digits."""
    findings = []
    lost = np.setdiff1d(table.lines, columns.lines)
    if table.ragged and all(name != "comma_ambiguous" for name, _ in table.notes):
        findings.append(error("ragged", line=table.ragged[0], count=len(table.ragged)))
    lost = np.setdiff1d(lost, table.ragged)
    if lost.size:
        findings.append(error("not_numbers", line=int(lost[0]), count=int(lost.size)))
    if columns.digits < FEW_DIGITS and np.ptp(columns.theta.values) > 0:
        findings.append(remark("few_digits", digits=columns.digits))
    return findings


# States.


def _view(problem: Problem, table: Table, columns: Columns) -> View:
    """The first explanation of the times under which the states are right; else the first."""
    start = taken(RIGHT, problem)
    places = np.searchsorted(table.lines, columns.lines).astype(float)
    views = []
    for timing in timings(problem, start, columns.t, places):
        wanted = right_prediction(timing.clock, start)
        wrong = misfits(wanted, AS_ASKED, columns.theta, columns.omega)
        judged = not_judged_from(wanted)
        if judged < columns.t.values.size:
            local = wrong_locally(start, timing.clock, columns)
            on_time = by_closed_form(start, timing.clock)
            closed = [
                each | ~(on_time.theta_slack <= DECIDES) for each in misfits(on_time, AS_ASKED, columns.theta, columns.omega)
            ]
            wrong = tuple(
                np.append(each[:judged], (near & far)[judged:]) for each, near, far in zip(wrong, local, closed, strict=True)
            )
        views.append(View(columns, places, timing, wanted, (*wrong, _wrong_times(columns.t, timing)), judged))
        if _is_right(views[-1]):
            return views[-1]
    return views[0]


def _wrong_times(t: Column, timing: Timing) -> npt.NDArray[np.bool_]:
    """Rows whose times are not those of their steps, where nothing else is wrong with the times."""
    clock = timing.clock
    if timing.changes:
        return np.zeros(t.values.size, bool)
    slack = t.units + (clock.doubt + 1e-9) * np.abs(clock.t) + clock.unsure
    wrong: npt.NDArray[np.bool_] = ~(np.abs(t.values * timing.unit - clock.t) <= slack)
    return wrong | (np.diff(t.values, prepend=t.values[0]) < 0)


def _is_right(view: View) -> bool:
    return not any(wrong.any() for wrong in view.wrong)


def _of_states(problem: Problem, view: View, found: list[Explanation] | Finding | None) -> list[Finding]:
    """What is wrong with times, angle, velocity and sinusoid. found: what explains states that are wrong."""
    columns = view.columns
    start, timing, prediction = taken(RIGHT, problem), view.timing, view.wanted
    findings: list[Finding] = []
    printing = AS_ASKED
    doubt = UNKNOWN
    is_rough = False
    if not _is_right(view):
        if isinstance(found, Finding):
            findings.append(found)
            is_rough = found.name == "single_precision"
        elif found:
            best = found[0]
            timing, prediction = best.candidate.timing, best.prediction
            start = timing.start or best.candidate.reading.start
            doubt = max(UNKNOWN, 2 * abs(best.candidate.reading.pi / np.pi - 1))
            if any(each.name in ("rough_pi", "single_constants") for each in best.mistakes):
                doubt = max(doubt, ROUGH)
            printing = best.printing
            findings += _told(found, _first_wrong(view))
    elif view.judged < columns.t.values.size:
        findings.append(remark("not_judged", t=float(columns.t.values[view.judged])))
    in_time = list(timing.findings)
    doubt = max([doubt, *(2 * abs(float(each.values["pi"]) - np.pi) for each in in_time if each.name == "rough_pi")])
    if any(each.name == "times_off" for each in in_time) and _is_nearly_in_time(problem, view):
        findings, is_rough = [Finding("single_precision", {}, where=None)], True
    if is_rough:  # its sums of times are inaccurate, too
        in_time = [each for each in in_time if each.name not in ("series_cut", "tau", "tau_off", "uneven_rows", "times_off")]
    findings += in_time
    findings = _misjudged(problem, start, columns, findings)
    findings += of_wrapping(columns.theta.scaled(1 / printing.theta_factor), prediction, printing.form, columns)
    if all(each.name != "regime" for each in findings):
        told = of_sinusoid(problem, start, timing, columns, is_rough, printing.theta_factor, doubt)
        # What explains the period and the sinusoid is told once.
        names = {finding.name for finding in told}
        findings = [each for each in findings if names.isdisjoint(other.name for other in each.alternatives)] + told
    return findings


def _misjudged(problem: Problem, start: Start, columns: Columns, findings: list[Finding]) -> list[Finding]:
    """A period of another regime, and a sinusoid that is there or not as in that regime, are one mistake."""
    regime, has_sine = analysis(start)[0], columns.sine is not None
    periods = ("tau", "tau_off", "series_cut")
    found = next((each for each in findings if each.name in periods or each.name.startswith(("period_", "series_"))), None)
    if found is None or has_sine == (regime == -1):
        return findings
    told = Finding("regime", {"k": problem.regime, **found.values}, where=found.where)
    return [told if each is found else each for each in findings]


def _is_nearly_in_time(problem: Problem, view: View) -> bool:
    """Whether the times are as inaccurate as sums in single precision."""
    t = view.columns.t.values
    return bool(np.all(np.abs(t - view.places * problem.every) <= 1e-3 * np.abs(t)))


def _explained(problem: Problem, view: View) -> list[Explanation] | Finding:
    """The programs that print the states, or what else there is to say of them."""
    columns, where = view.columns, _first_wrong(view)
    rows = columns.t.values.size
    still = np.all(np.abs(wrap(columns.theta.values - columns.theta.values[0])) <= columns.theta.units)
    if rows > 1 and still and np.all(np.abs(columns.omega.values - columns.omega.values[0]) <= columns.omega.units):
        return Finding("nothing_moves", {}, where=where, alternatives=(error("integer_division"),))
    found = explanations(problem, columns, view.places, 1)
    if found:
        return found
    if _are_cells(view):
        return Finding("wrong_cell", {"count": sum(int(each.sum()) for each in view.wrong)}, where=where)
    found = fitted(problem, view.timing, columns, view.places) or explanations(problem, columns, view.places, 2)
    if found:
        return found
    if any(
        in_single_precision(problem, timing, columns)
        for timing in timings(problem, taken(RIGHT, problem), columns.t, view.places)
    ):
        return Finding("single_precision", {}, where=where, alternatives=(error("single_constants"),))
    found = explanations(problem, columns, view.places, 3)
    if found:
        return found
    if _on_a_circle(columns):
        return error("cartesian")
    return Finding("unexplained", _symptoms(problem, view), where=where)


def _on_a_circle(columns: Columns) -> bool:
    """Whether the two columns are x and y of a pendulum, whose length is always the same."""
    x, y = columns.theta.values, columns.omega.values
    squares = x * x + y * y
    return bool(np.ptp(squares) <= 1e-3 * squares.max() and np.ptp(x) > 0.01 * np.sqrt(squares.max()))


def _told(found: Sequence[Explanation], where: Where | None) -> list[Finding]:
    """The mistakes of the first explanation; where others explain as well, their names beside."""
    own = [mistake.name for mistake in found[0].mistakes]
    findings = []
    for i, mistake in enumerate(found[0].mistakes):
        reading = found[0].candidate.reading
        others = {each.name: error(each.name, **each.values) for each in reading.same if mistake in reading.mistakes}
        for other in found[1:]:
            names = [each.name for each in other.mistakes]
            if len(names) == len(own) and names[i] != own[i] and names[:i] + names[i + 1 :] == own[:i] + own[i + 1 :]:
                others[names[i]] = Finding(names[i], dict(other.mistakes[i].values))
        others.pop(mistake.name, None)
        alternatives = tuple(others.values())[:3]
        findings.append(Finding(mistake.name, dict(mistake.values), where=where if i == 0 else None, alternatives=alternatives))
    return findings


def _first_wrong(view: View) -> Where | None:
    """The first state that is not what it should be."""
    rows = [(int(np.argmax(wrong)), i) for i, wrong in enumerate(view.wrong) if wrong.any()]
    if not rows:
        return None
    row, i = min(rows)
    columns = view.columns
    column = (columns.theta, columns.omega, columns.t)[i]
    wanted = (view.wanted.theta, view.wanted.omega, view.timing.clock.t)[i][row]
    word = (WORDS[1], WORDS[2], WORDS[0])[i]
    return Where(int(columns.lines[row]), float(columns.t.values[row]), word, float(column.values[row]), float(wanted))


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


# Distances.


def _deviations(problem: Problem, view: View) -> dict[str, Deviation]:
    """Each column against what is right at its times."""
    columns, wanted = view.columns, view.wanted
    off = (wrap(columns.theta.values - wanted.theta), columns.omega.values - wanted.omega)
    found = {}
    for role, wrong, distance, right in zip(ROLES[1:3], view.wrong[:2], off, wanted[:2], strict=True):
        found[role] = _deviation(wrong, right, distance)
    if problem.regime == -1 and columns.sine is not None:
        start = taken(RIGHT, problem)
        rows = Column(view.timing.clock.t, view.timing.clock.unsure)
        sinusoid = right_sinusoid(start, problem.tau)
        right = sinusoid.at(rows.values)
        fit = fits(sinusoid.at, start, rows, columns.sine)
        found["sine"] = _deviation(~fit, right, columns.sine.values - right)
    return found


def _deviation(wrong: npt.NDArray[np.bool_], wanted: Floats, off: Floats) -> Deviation:
    rows = np.flatnonzero(wrong)
    first = int(rows[0]) if rows.size else None
    with np.errstate(invalid="ignore"):
        return Deviation(int((~wrong).sum()), first, wanted, float(np.nanmax(np.abs(off), initial=0.0)))
