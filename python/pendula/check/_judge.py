"""Marks a table: what is wrong with its layout, times, states, their printing and the sinusoid, each mistake told once."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from pendula.check._explain import Explanation, Search
from pendula.check._finding import ERROR, REMARK, Finding, Value, error, remark
from pendula.check._predict import AS_ASKED
from pendula.check._program import RIGHT, Problem, Start, analysis, taken
from pendula.check._sinusoid import UNKNOWN, of_sinusoid
from pendula.check._states import explained, told
from pendula.check._table import STATE, WORDS, Columns, columns_at, placements, roles_of
from pendula.check._view import Deviation, View, deviations, first_wrong, has_same_states, view_of
from pendula.check._wrapping import of_wrapping

if TYPE_CHECKING:
    from collections.abc import Sequence

    from pendula.check._table import Table

FEW_DIGITS = 5
ROUGH = 2e-3  # relative: what 3.14 for π does to a sinusoid
MOST_PLACEMENTS = 12
MOST_WRONG = 4  # placements that a wrong table's columns are tried in


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
        return Judgement(findings if is_told else [*findings, _without_states(table)], {})
    # As the header says or, where only that makes the states right, in another order.
    is_twice = len(table.values) > 1 and np.array_equal(table.values[0], table.values[1])
    if is_twice:
        table = _without_first(table)
        found = [(name, _without_first_row(columns)) for name, columns in found if columns.lines.size > 1]
    views = [(name, view_of(problem, table, columns)) for name, columns in found]
    name, view, of_states = _best(problem, views)
    if name:
        findings.append(error(name, header=" ".join(table.header)))
    if is_twice:
        findings.append(error("first_row_twice"))
    findings += _of_rows(table, view.columns)
    findings += of_states
    off = deviations(problem, view)
    if any(finding.name == "cartesian" for finding in findings):
        findings = [finding for finding in findings if finding.name not in ("sine_missing", "sine_unexplained")]
    findings = list({finding.name: finding for finding in reversed(findings)}.values())[::-1]
    return Judgement(findings, off, view.columns, max(view.columns.digits, 3))


def _best(problem: Problem, views: Sequence[tuple[str, View]]) -> tuple[str, View, list[Finding]]:
    """The columns that there is least to say of: those with right states, else those whose states one mistake explains."""
    right = [each for each in views if each[1].is_right and each[1].judged > 0]
    view, search = (right[0][1], None) if right else _likeliest(problem, views)
    found = explained(problem, view, search) if search else None
    # Where nothing tells which column is the sinusoid, it is the one that fits.
    same = [each for each in right or views if has_same_states(each[1], view)]
    best, least = None, np.inf
    for each_name, each in same:
        findings = _of_states(problem, each, found)
        weight = sum(3 if finding.name == "sine_unexplained" else 1 for finding in findings if finding.severity == ERROR)
        if weight + 0.5 * bool(each_name) < least:
            best, least = (each_name, each, findings), weight + 0.5 * bool(each_name)
        if least == 0:
            break
    assert best is not None
    return best


def _likeliest(problem: Problem, views: Sequence[tuple[str, View]]) -> tuple[View, Search]:
    """Of columns with wrong states, those with few wrong cells; else those that one mistake explains; else the first."""
    tried: list[tuple[View, Search]] = []
    for _, each in views:
        if len(tried) < MOST_WRONG and not any(has_same_states(each, view) for view, _ in tried):
            search = Search(problem, each.columns, each.places)
            tried.append((each, search))
            if each.are_cells or search.explanations(1):
                return each, search
    return tried[0]


def _without_first(table: Table) -> Table:
    return table._replace(values=table.values[1:], units=table.units[1:], lines=table.lines[1:])


def _without_first_row(columns: Columns) -> Columns:
    rest = slice(1, None)
    sine = None if columns.sine is None else columns.sine.at(rest)
    t, theta, omega = (each.at(rest) for each in columns[:3])
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


def _without_states(table: Table) -> Finding:
    """What there is to say of a table in which no row has a time and a state."""
    whole = np.setdiff1d(table.lines, table.ragged)
    if table.values.shape[1] < len(STATE) or not whole.size:
        return error("columns", found=table.values.shape[1])
    return error("not_numbers", line=int(whole[0]), count=int(whole.size))


# States.


def _of_states(problem: Problem, view: View, found: list[Explanation] | Finding | None) -> list[Finding]:
    """What is wrong with times, angle, velocity and sinusoid. found: what explains states that are wrong."""
    columns = view.columns
    start, timing, prediction = taken(RIGHT, problem), view.timing, view.wanted
    findings: list[Finding] = []
    printing = AS_ASKED
    doubt = UNKNOWN
    is_rough = False
    if not view.is_right:
        if isinstance(found, Finding):
            if found.name == "other_start":
                return [found]  # its times and its sinusoid are those of that start
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
            findings += told(found, first_wrong(view))
    elif view.judged < columns.t.values.size:
        findings.append(remark("not_judged", t=float(columns.t.values[view.judged])))
    in_time = list(timing.findings)
    doubt = max([doubt, *(2 * abs(float(each.values["pi"]) - np.pi) for each in in_time if each.name == "rough_pi")])
    if is_rough:  # its sums of times are inaccurate, too
        in_time = [each for each in in_time if each.name not in ("series_cut", "tau", "tau_off", "uneven_rows", "times_off")]
    findings += in_time
    findings = _misjudged(problem, start, columns, findings)
    if all(each.name != "rough_pi" for each in findings):  # the wrapping has the same π
        findings += of_wrapping(columns.theta.scaled(1 / printing.theta_factor), prediction, printing.form, columns)
    if all(each.name != "regime" for each in findings):
        of_sine = of_sinusoid(problem, start, timing, columns, is_rough, printing.theta_factor, doubt)
        # What explains the period and the sinusoid is told once.
        names = {finding.name for finding in of_sine}
        findings = [each for each in findings if names.isdisjoint(other.name for other in each.alternatives)] + of_sine
    return findings


def _misjudged(problem: Problem, start: Start, columns: Columns, findings: list[Finding]) -> list[Finding]:
    """A period of another regime, and a sinusoid that is there or not as in that regime, are one mistake."""
    regime, has_sine = analysis(start)[0], columns.sine is not None
    periods = ("tau", "tau_off", "series_cut")
    found = next((each for each in findings if each.name in periods or each.name.startswith(("period_", "series_"))), None)
    if found is None or has_sine == (regime == -1):
        return findings
    misjudged = Finding("regime", {"k": problem.regime, **found.values}, where=found.where)
    return [misjudged if each is found else each for each in findings]
