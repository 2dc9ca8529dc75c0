"""Marks a table: which hypothesis about the program that made it explains its numbers."""

from __future__ import annotations

from itertools import product
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from pendula import _core, analyze
from pendula.check._columns import ROLES, WORDS
from pendula.check._findings import ERROR, Finding, error, remark
from pendula.check._layout import columns_at, header_findings, placements
from pendula.check._sines import SINUSOIDS
from pendula.check._states import Column, Columns, Deviation, Reading, deviations, explain, is_right, sine_fits
from pendula.check._times import judge_times

if TYPE_CHECKING:
    from pendula.check._asked import Asked, Start
    from pendula.check._reading import Table

FEW_DIGITS = 5

# Mistakes after which the sinusoid has that period, too.
OWN_PERIODS = ("period doubled", "period halved", "series not begun", "series cut", "tau")


class Judgement(NamedTuple):
    """A table's mark."""

    findings: list[Finding]
    deviations: dict[str, Deviation]

    @property
    def is_right(self) -> bool:
        """Whether there are no mistakes; remarks are none."""
        return all(finding.severity != ERROR for finding in self.findings)


def judge(problem: Asked, table: Table) -> Judgement:
    """Compares every column with the truth and, where they differ, finds the mistake that explains it."""
    findings = header_findings(problem, table)
    found = ((name, columns_at(table, places)) for name, places in placements(problem, table))
    candidates = [(name, columns) for name, columns in found if columns is not None]
    if not candidates:
        return Judgement([*findings, error("columns", found=table.values.shape[1])], {})
    # As the header says or, where only that makes the states right, in another order.
    name, columns = next((each for each in candidates if is_right(problem, each[1])), candidates[0])
    if name:
        findings.append(error(name, header=" ".join(table.header)))
    lost = np.setdiff1d(table.lines, columns.lines)
    findings += _judge_rows(table, columns, lost)
    reading = explain(problem, columns)
    off = deviations(problem, columns)
    findings += _judge_states(columns, reading, off)
    taken = reading.explanation.start(problem.start) if reading else problem.start
    times = reading.times if reading else columns.t
    in_time = [] if lost.size else judge_times(problem, taken, times.values, times.units, columns.sine is not None)
    is_single = reading is not None and reading.explanation.name == "single precision"
    if is_single:  # its sums of times are off, too
        in_time = [finding for finding in in_time if finding.name not in (*OWN_PERIODS, "uneven rows")]
    findings += in_time
    times = _in_own_periods(taken, times, in_time)
    if all(finding.name != "regime" for finding in findings):
        findings += _judge_sine(problem, taken, columns, times, is_single)
    return Judgement(findings, off)


def _judge_rows(table: Table, columns: Columns, lost: Any) -> list[Finding]:
    """Rows that are none, and numbers that say little."""
    findings = []
    if table.ragged:
        findings.append(error("ragged", line=table.ragged[0], count=len(table.ragged)))
    lost = np.setdiff1d(lost, table.ragged)
    if lost.size:
        findings.append(error("not numbers", line=int(lost[0]), count=int(lost.size)))
    if columns.digits < FEW_DIGITS and np.ptp(columns.theta.values) > 0:
        findings.append(remark("few digits", digits=columns.digits))
    return findings


def _judge_states(columns: Columns, reading: Reading | None, off: dict[str, Deviation]) -> list[Finding]:
    """What is wrong with angle and velocity, for a table that a hypothesis explains or none."""
    name = reading.explanation.name if reading else "unexplained"
    findings = [error(name, **_first_wrong(columns, off))] if name else []
    return findings + (_presentation(columns, reading) if reading else [])


def _first_wrong(columns: Columns, off: dict[str, Deviation]) -> dict[str, Any]:
    """The first state that is not what it should be."""
    wrong = [(each.first_wrong, role) for role, each in off.items() if role != "sine" and each.first_wrong is not None]
    row, role = min(wrong)
    got = {"theta": columns.theta, "omega": columns.omega}[role].values[row]
    return {
        "line": int(columns.lines[row]),
        "t": float(columns.t.values[row]),
        "column": WORDS[ROLES.index(role)],
        "value": float(got),
        "wanted": float(off[role].wanted[row]),
    }


def _presentation(columns: Columns, reading: Reading) -> list[Finding]:
    """Right states that are not printed as they should be."""
    findings = []
    if reading.angle_unit != 1 and np.any(columns.theta.values):
        findings.append(error("angle in degrees"))
    if reading.velocity_unit != 1 and np.any(columns.omega.values):
        findings.append(error("velocity in degrees"))
    theta = columns.theta.values * reading.angle_unit
    outside = np.flatnonzero(np.abs(theta) > np.pi + columns.theta.units * reading.angle_unit)
    if outside.size:
        row = outside[0]
        wanted = float(_core.wrap(theta[row]))
        line, value = int(columns.lines[row]), float(columns.theta.values[row])
        findings.append(error("not normalised", line=line, value=value, wanted=wanted, count=int(outside.size)))
    return findings


def _in_own_periods(taken: Start, t: Column, findings: list[Finding]) -> Column:
    """Times at which the right sinusoid has the values of one with the period that a program has got."""
    got = next((finding.values["got"] for finding in findings if finding.name in OWN_PERIODS), None)
    if got is None:
        return t
    # The period is known no better than the last of the times that it was found from.
    doubt = t.units + np.abs(t.values) * (t.units.max() / np.abs(t.values).max())
    return Column(t.values * (taken.tau / got), doubt * (taken.tau / got))


def _judge_sine(problem: Asked, taken: Start, columns: Columns, t: Column, is_single: bool) -> list[Finding]:
    """The fourth column, which is there where the pendulum oscillates and only there."""
    sine = columns.sine
    if taken != problem.start and (sine is not None) == (analyze(*taken[:2], alpha=taken.alpha).regime == -1):
        return []  # it follows from what the program took the pendulum for
    if problem.regime != -1:
        return [error("sine too many")] if sine is not None else []
    if sine is None:
        return [error("sine missing")]
    if not np.all(np.isfinite(sine.values)):
        return [error("sine not numbers", line=int(columns.lines[~np.isfinite(sine.values)][0]))]
    for hypothesis, times in product(SINUSOIDS, (t, columns.t)):
        if np.all(sine_fits(hypothesis.column, problem.start, times, sine)):
            return [error(hypothesis.name)] if hypothesis.name else []
    if is_single:
        return []  # as inexact as the states
    right = SINUSOIDS[0].column
    row = int(np.argmax(~sine_fits(right, problem.start, t, sine)))
    wanted = right(problem.start, t.values)[row]
    return [error("sine unexplained", line=int(columns.lines[row]), value=float(sine.values[row]), wanted=float(wanted))]
