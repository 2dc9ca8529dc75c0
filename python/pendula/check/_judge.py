"""Marks a table: what is wrong with its layout, states, times and sinusoid, each mistake told once."""

from __future__ import annotations

from itertools import product
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from pendula.check._findings import ERROR, Finding, Value, error, remark
from pendula.check._mistakes import SINUSOIDS, Reading, explain
from pendula.check._problem import (
    PERIOD,
    Asked,
    Deviation,
    Start,
    deviations,
    fits,
    right_at_times,
    right_sine,
    sine_fits,
    wrap,
)
from pendula.check._table import ROLES, WORDS, Column, Columns, columns_at, placements, roles_of

if TYPE_CHECKING:
    from collections.abc import Iterator

    from pendula.check._table import Floats, Integers, Table

FEW_DIGITS = 5

# Mistakes after which the sinusoid has the wrong period, too.
OWN_PERIODS = ("period doubled", "period halved", "series not begun", "series cut", "tau")


class Judgement(NamedTuple):
    """What there is to say of a table."""

    findings: list[Finding]
    deviations: dict[str, Deviation]
    """By the columns' roles."""

    @property
    def is_right(self) -> bool:
        """Whether there are no mistakes; remarks are none."""
        return all(finding.severity != ERROR for finding in self.findings)


def judge(problem: Asked, table: Table) -> Judgement:
    """Compares every column with the truth and, where they differ, finds the mistake that explains it."""
    findings = _judge_header(problem, table)
    found = ((name, columns_at(table, places)) for name, places in placements(table, problem.regime == -1))
    candidates = [(name, columns) for name, columns in found if columns is not None]
    if not candidates:
        return Judgement([*findings, error("columns", found=table.values.shape[1])], {})
    # As the header says or, where only that makes the states right, in another order.
    name, columns = next((each for each in candidates if _is_right(problem, each[1])), candidates[0])
    if name:
        findings.append(error(name.replace("_", " "), header=" ".join(table.header)))
    lost = np.setdiff1d(table.lines, columns.lines)
    findings += _judge_rows(table, columns, lost)
    reading = explain(problem, columns)
    off = deviations(problem, columns)
    findings += _judge_states(columns, reading, off)
    taken = reading.explanation.start(problem.start) if reading else problem.start
    times = reading.times if reading else columns.t
    in_time = [] if lost.size else judge_times(problem, taken, times, columns.sine is not None)
    is_single = reading is not None and reading.explanation.name == "single precision"
    if is_single:  # its sums of times are inaccurate, too
        in_time = [finding for finding in in_time if finding.name not in (*OWN_PERIODS, "uneven rows")]
    findings += in_time
    times = _in_own_periods(taken, times, in_time)
    if all(finding.name != "regime" for finding in findings):
        findings += _judge_sine(problem, taken, columns, times, is_single)
    return Judgement(findings, off)


# Layout.


def _judge_header(problem: Asked, table: Table) -> list[Finding]:
    """Remarks on the header; nothing is wrong with a table that lacks one."""
    has_sine = "sine" in roles_of(table.header) if table.header else problem.regime == -1
    words = WORDS if has_sine else WORDS[:3]
    if not table.header:
        return [remark("no header", words=" ".join(words))]
    if table.header[: len(words)] != words:
        return [remark("other header", header=" ".join(table.header), words=" ".join(words))]
    return []


def _is_right(problem: Asked, columns: Columns) -> bool:
    return all(map(np.all, fits(right_at_times(problem, columns.t), columns.theta, columns.omega)))


def _judge_rows(table: Table, columns: Columns, lost: Integers) -> list[Finding]:
    """Rows that lack numbers, and numbers of few digits."""
    findings = []
    if table.ragged:
        findings.append(error("ragged", line=table.ragged[0], count=len(table.ragged)))
    lost = np.setdiff1d(lost, table.ragged)
    if lost.size:
        findings.append(error("not numbers", line=int(lost[0]), count=int(lost.size)))
    if columns.digits < FEW_DIGITS and np.ptp(columns.theta.values) > 0:
        findings.append(remark("few digits", digits=columns.digits))
    return findings


# States.


def _judge_states(columns: Columns, reading: Reading | None, off: dict[str, Deviation]) -> list[Finding]:
    """What is wrong with angle and velocity, whether a hypothesis explains them or none does."""
    name = reading.explanation.name if reading else "unexplained"
    findings = [error(name, **_first_wrong(columns, off))] if name else []
    return findings + (_judge_units(columns, reading) if reading else [])


def _first_wrong(columns: Columns, off: dict[str, Deviation]) -> dict[str, Value]:
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


def _judge_units(columns: Columns, reading: Reading) -> list[Finding]:
    """Right states in degrees, and angles outside [-π, π)."""
    findings = []
    if reading.angle_unit != 1 and np.any(columns.theta.values):
        findings.append(error("angle in degrees"))
    if reading.velocity_unit != 1 and np.any(columns.omega.values):
        findings.append(error("velocity in degrees"))
    theta = columns.theta.scaled(reading.angle_unit)
    outside = np.flatnonzero(np.abs(theta.values) > np.pi + theta.units)
    if outside.size:
        row = outside[0]
        wanted = float(wrap(theta.values[row]))
        line, value = int(columns.lines[row]), float(columns.theta.values[row])
        findings.append(error("not normalised", line=line, value=value, wanted=wanted, count=int(outside.size)))
    return findings


# Times.


class Grid(NamedTuple):
    """Times first + j every, as far as their digits tell."""

    first: float
    every: float
    rows: int
    unit: float
    """Of the last digit of the last time."""

    @property
    def values(self) -> Floats:
        """The times."""
        return self.first + self.every * np.arange(float(self.rows))


def judge_times(problem: Asked, taken: Start, times: Column, has_sine: bool) -> list[Finding]:
    """What is wrong with the times of a program that took the pendulum for `taken`."""
    t = times.values
    if t.size < 2:
        return [error("one row", expected=problem.rows)] if problem.rows > 1 else []
    have = Grid(float(t[0]), float((t[-1] - t[0]) / (t.size - 1)), int(t.size), float(times.units.max()))
    slack = 1.01 * problem.dt + have.unit  # a program may print a row at the end of the step that reaches its time
    off = np.abs(t - have.values)
    if off.max() > slack:
        return [error("uneven rows", row=int(np.argmax(off > slack)) + 1, every=problem.every)]
    findings = [error("late start", first=have.first)] if abs(have.first) > slack else []
    # Rows that are not at the ends of steps show the period to the last digit.
    drift = 2 * have.unit if off.max() <= 2 * have.unit else slack
    as_taken = problem.every * taken.tau / problem.tau
    expected = min((problem.every, as_taken), key=lambda every: abs(every - have.every))
    if abs(have.every - expected) * (have.rows - 1) <= drift + PERIOD * expected * have.rows:
        return findings + _judge_length(problem, have, slack)
    return [*findings, _judge_spacing(problem, taken, have, has_sine)]


def _judge_length(problem: Asked, have: Grid, slack: float) -> list[Finding]:
    """Rows that are missing or too many; whether there is a row at the very end may depend on rounding."""
    more = have.rows + round(have.first / problem.every) - problem.rows
    last = have.first + have.every * (have.rows - 1)
    counts: dict[str, Value] = {"rows": have.rows, "expected": problem.rows, "last": last, "until": problem.until}
    if more == 0:
        return []
    if abs(more) == 1 and abs(problem.until - round(problem.until / problem.every) * problem.every) <= slack:
        return [remark("last row lost" if more < 0 else "last row won", **counts)]
    return [error("early end" if more < 0 else "late end", **counts)]


def _judge_spacing(problem: Asked, taken: Start, have: Grid, has_sine: bool) -> Finding:
    """The first mistake that gives the time between rows that there is."""
    factor = problem.every / problem.tau
    got = have.every / factor
    uncertainty = have.unit / (have.rows - 1) + PERIOD * have.every
    values: dict[str, Value] = {"tau": taken.tau, "got": got, "k": problem.regime}
    values |= {"every": problem.every, "spacing": have.every}
    for name, every, slack in _spacings(problem, taken, factor):
        if abs(every - have.every) <= uncertainty + slack:
            return error(name, **values)
    if problem.regime == 0 or (problem.regime == -1 and not has_sine):
        return error("regime", **values)
    if taken.first_term < got < taken.tau:
        return error("series cut", relative=1 - got / taken.tau, **values)
    return error("tau", **values)


def _spacings(problem: Asked, taken: Start, factor: float) -> Iterator[tuple[str, float, float]]:
    """Mistakes, the times between rows that they give, and how far these may be off."""
    yield "period doubled", 2 * taken.tau * factor, 0
    yield "period halved", taken.tau / 2 * factor, 0
    if problem.regime != 0:
        yield "series not begun", taken.first_term * factor, 0
        yield "regime", taken.on_separatrix().tau * factor, 0
    yield "seconds", factor, problem.dt  # no whole number of steps
    yield "every step", problem.dt, 0


# The sinusoid.


def _in_own_periods(taken: Start, t: Column, findings: list[Finding]) -> Column:
    """Times at which the right sinusoid has the values of one with the wrong period that the program has found."""
    got = next((float(finding.values["got"]) for finding in findings if finding.name in OWN_PERIODS), None)
    if got is None:
        return t
    # The last time gave the period, which is therefore as inexact as that.
    doubt = t.units + np.abs(t.values) * (t.units.max() / np.abs(t.values).max())
    return Column(t.values * (taken.tau / got), doubt * (taken.tau / got))


def _judge_sine(problem: Asked, taken: Start, columns: Columns, t: Column, is_single: bool) -> list[Finding]:
    """The fourth column, which is there where the pendulum oscillates and only there."""
    sine = columns.sine
    if taken != problem.start and (sine is not None) == (taken.regime == -1):
        return []  # right for the pendulum that the program took for the problem's
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
    row = int(np.argmax(~sine_fits(right_sine, problem.start, t, sine)))
    wanted = float(right_sine(problem.start, t.values)[row])
    return [error("sine unexplained", line=int(columns.lines[row]), value=float(sine.values[row]), wanted=wanted)]
