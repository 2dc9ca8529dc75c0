"""States at a table's rows as programs predict them, how far a table may be from them, and which of its rows are farther."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from pendula import _core
from pendula._closed_form import exact
from pendula.check._methods import Mistake
from pendula.check._mistakes import PRINTINGS
from pendula.check._program import RIGHT, Clock, Motion, Program, Start, closed_form, replay

if TYPE_CHECKING:
    from collections.abc import Sequence

    import numpy.typing as npt

    from pendula.check._program import Floats
    from pendula.check._table import Column, Columns

ROUNDING = 1e-11  # relative: what the roundings of ten thousand steps may be worth
TINY = 1e-300  # rad, rad/s: what is smaller has few digits or none, for doubles end there
MOST_WORK = 1 << 22  # steps of a program that is replayed; more are taken by the closed form
ENERGY = 4e-16  # of 2α: what the rounding of a step adds to the energy; those of many steps add up at random
LOSSES = 30  # of the energy that Runge-Kutta loses up to a row: in a fall it loses more than near the top
FAR = 1e6  # rad, and of ω/√α: no digits tell a state from such a one
FEW_CELLS = 0.05  # of the rows
DECIDES = 0.1  # rad: beyond this, what rounding may be worth leaves nothing to judge


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


class Run(NamedTuple):
    """A program with its rows and with what it takes for the pendulum."""

    program: Program
    clock: Clock
    start: Start


def predictions(runs: Sequence[Run]) -> list[Prediction]:
    """What the programs print, each with the spread of what is legitimately unknown: roundings, and the period."""
    three: list[Run] = []
    for program, clock, start in runs:
        moved = _moved(start, float(clock.steps.max(initial=0)))
        slower = clock._replace(dt=clock.dt * (1 + clock.doubt))
        three += [Run(program, clock, start), Run(program, clock, moved), Run(program, slower, start)]
    programs, clocks, starts = zip(*three, strict=True) if three else ((), (), ())
    theta, omega = replay(programs, clocks, starts)
    return [
        _prediction(Motion(theta[i : i + 3], omega[i : i + 3]), three[i].clock.unsure, three[i].start.alpha)
        for i in range(0, len(three), 3)
    ]


def _prediction(spread: Motion, unsure: Floats, alpha: float) -> Prediction:
    with np.errstate(invalid="ignore", over="ignore"):
        slacks = [np.abs(each[1] - each[0]) + np.abs(each[2] - each[0]) for each in spread]
        # Roundings of a small motion are small; near the top they are those of an angle of π.
        sizes = [min(largest, float(np.nanmax(np.abs(each[0]), initial=0.0))) for largest, each in _largest(spread, alpha)]
        floors = [ROUNDING * (size + np.abs(each[0])) + TINY for size, each in zip(sizes, spread, strict=True)]
        late = (np.abs(spread.omega[0]) * unsure, alpha * unsure)
        theta_slack, omega_slack = (
            np.maximum.accumulate(np.nan_to_num(slack, nan=0.0, posinf=1e300) + floor) + open_time
            for slack, floor, open_time in zip(slacks, floors, late, strict=True)
        )
    return Prediction(wrap(spread.theta[0]), spread.omega[0], theta_slack, omega_slack, spread.theta[0])


def _largest(spread: Motion, alpha: float) -> tuple[tuple[float, Floats], ...]:
    return (1.0, spread.theta), (float(np.sqrt(alpha)), spread.omega)


def _moved(start: Start, steps: float) -> Start:
    """The initial state farther on by what roundings may be worth: in itself, and in its energy, which decides near the top."""
    theta0, omega0, alpha = start
    slope = np.array([alpha * np.sin(theta0), omega0 * np.sqrt(alpha)])  # of the energy, in θ and ω/√α
    size = float(slope @ slope)
    gain = ENERGY * min(alpha, float(_core.energy(*start))) * np.sqrt(1.0 + steps)
    kick = gain * slope / size if gain < size else np.zeros(2)
    return Start(
        theta0 * (1 + ROUNDING) + float(kick[0]), omega0 * (1 + ROUNDING) + float(kick[1]) * float(np.sqrt(alpha)), alpha
    )


def right_prediction(clock: Clock, start: Start) -> Prediction:
    """The closed form, within twice Runge-Kutta's error at the problem's step and what is legitimately unknown.

    A better method than was asked for is right.
    """
    t = clock.t
    theta, omega = closed_form(start, t)
    if clock.steps.max(initial=0) <= MOST_WORK:
        by_rk4 = predictions([Run(RIGHT, clock, start)])[0]
    else:
        by_rk4 = by_closed_form(start, clock)
    theta_error, omega_error = np.abs(wrap(by_rk4.theta - theta)), np.abs(by_rk4.omega - omega)
    twice = 2 * clock.coarser**4  # Runge-Kutta's error goes as the fourth power of the step
    errors = (np.maximum.accumulate(twice * np.nan_to_num(error, nan=np.inf)) for error in (theta_error, omega_error))
    theta_slack, omega_slack = (a + b for a, b in zip(errors, by_rk4[2:4], strict=True))
    return Prediction(wrap(theta), omega, theta_slack, omega_slack, theta)


def by_closed_form(start: Start, clock: Clock) -> Prediction:
    """The closed form with the spread that Runge-Kutta would have, where its steps are too many to be taken."""
    t = clock.t
    moved = _moved(start, float(clock.steps.max(initial=0)))
    three = ((start, t), (moved, t), (start, t * (1 + clock.doubt)))
    motions = [closed_form(each, times) for each, times in three]
    theta, omega = (np.array([motion[i] for motion in motions]) for i in (0, 1))
    return _prediction(Motion(theta, omega), clock.unsure, start.alpha)


def not_judged_from(prediction: Prediction) -> int:
    """The first row in which roundings may be worth so much that nothing can be said of it; where there is none, how many rows.

    Near the separatrix a right program falls to either side.
    """
    open_rows = np.flatnonzero(~(prediction.theta_slack <= DECIDES))
    return int(open_rows[0]) if open_rows.size else prediction.theta.size


def wrong_locally(start: Start, clock: Clock, columns: Columns) -> tuple[npt.NDArray[np.bool_], ...]:
    """Rows, but the first, that do not follow from the row before, as far as its digits and Runge-Kutta's error tell."""
    between = np.maximum(np.diff(clock.steps), 0)
    wrong = tuple(np.zeros(columns.t.values.size, bool) for _ in range(2))
    if between.max(initial=0) > MOST_WORK // 64 or between.size == 0:
        return wrong
    rate = float(np.sqrt(start.alpha))
    speed = rate + np.minimum(np.abs(columns.omega.values[:-1]), FAR * rate)
    units = [columns.theta.units[:-1] + ROUNDING, columns.omega.units[:-1] + ROUNDING * speed]
    units = [np.minimum(unit, FAR * scale) for unit, scale in zip(units, (1.0, rate), strict=True)]
    theta, omega = columns.theta.values[:-1], columns.omega.values[:-1]
    finite = (np.abs(theta) < FAR) & (np.abs(omega) < FAR * rate)
    finite &= np.abs(omega) * between * np.float64(clock.dt) < FAR  # beyond, no digits tell the angle
    theta, omega = np.where(finite, theta, 0), np.where(finite, omega, 0)
    t = between * np.float64(clock.dt)
    # As printed, and one unit to either side: near the top they part.
    sides = ((0, 0), (1, 0), (-1, 0), (0, 1), (0, -1))
    states = [(theta + a * units[0], omega + b * units[1]) for a, b in sides]
    after = [exact(*state, t, alpha=start.alpha) for state in states]
    after.append(exact(theta, omega, t * (1 + clock.doubt), alpha=start.alpha))
    starts = [Start(float(a), float(b), start.alpha) for a, b in zip(theta, omega, strict=True)]
    clocks = [clock._replace(steps=between[i : i + 1]) for i in range(between.size)]
    by_rk4 = replay([RIGHT] * len(starts), clocks, starts)
    is_open = np.max([np.abs(np.asarray(motion[0]) - after[0][0]) for motion in after[1:]], axis=0) > DECIDES
    open_time = clock.unsure[1:] + clock.unsure[:-1]
    for i, (each, column) in enumerate(zip(wrong, (columns.theta, columns.omega), strict=True)):
        there = np.asarray(after[0][i])
        spread = sum(np.abs(np.asarray(motion[i]) - there) for motion in after[1:])
        error = np.abs(by_rk4[i][:, 0] - there)
        off = column.values[1:] - there
        slack = (
            2 * (spread + error + column.units[1:]) + ROUNDING * (1.0, speed)[i] + open_time * (np.abs(omega), start.alpha)[i]
        )
        each[1:] = ~(np.abs(wrap(off) if i == 0 else off) <= slack) & ~is_open | ~finite
    return wrong


def wrong_in_energy(clock: Clock, start: Start, columns: Columns) -> npt.NDArray[np.bool_]:
    """Rows whose energy is not that of the start, as far as their digits tell and Runge-Kutta keeps it."""
    theta, omega, alpha = columns.theta, columns.omega, start.alpha
    by_rk4 = replay([RIGHT], [clock], [start])
    with np.errstate(all="ignore"):
        right = float(_core.energy(*start))
        lost = float(np.nanmax(np.abs(_core.energy(by_rk4.theta[0], by_rk4.omega[0], alpha) - right), initial=0.0))
        slope = alpha * np.abs(np.sin(theta.values)) * theta.units + np.abs(omega.values) * omega.units
        curve = alpha * theta.units**2 + omega.units**2
        off = np.abs(_core.energy(theta.values, omega.values, alpha) - right)
        wrong: npt.NDArray[np.bool_] = ~(off <= 2 * (slope + curve) + LOSSES * lost + 1e-9 * alpha)
    return wrong


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
WRONGLY = (*(_printing((mistake,)) for mistake in PRINTINGS), _printing(PRINTINGS[:2]))  # both in degrees is as good as one


def misfits(prediction: Prediction, printing: Printing, theta: Column, omega: Column) -> tuple[npt.NDArray[np.bool_], ...]:
    """Rows in which the angle, but for whole turns, and the velocity are not those predicted."""
    n = prediction.theta.shape[-1]
    angle, velocity = theta.scaled(1 / printing.theta_factor), omega.scaled(1 / printing.omega_factor)
    wanted_theta = np.abs(prediction.theta) if printing.form == "absolute" else prediction.theta
    wanted_omega = wrap(prediction.omega) if printing.form == "normalised" else prediction.omega
    with np.errstate(invalid="ignore"):
        theta_off = np.abs(wrap(angle.values[:n] - wanted_theta))
        omega_off = np.abs(velocity.values[:n] - wanted_omega)
        return (
            ~(theta_off <= np.abs(angle.units[:n]) + prediction.theta_slack) | without_digits(theta.units)[:n],
            ~(omega_off <= np.abs(velocity.units[:n]) + prediction.omega_slack),
        )


def without_digits(units: Floats) -> npt.NDArray[np.bool_]:
    """Rows with an angle that is known to whole turns alone. Few such are wrong cells; many are angles that only grow."""
    rows = np.abs(units) > np.pi
    return rows if are_cells(int(rows.sum()), rows.size) else np.zeros_like(rows)


def matters(printing: Printing, prediction: Prediction) -> bool:
    """Whether a form changes any number."""
    if printing.form == "absolute":
        return bool(np.any(prediction.theta < -prediction.theta_slack))
    return printing.form != "normalised" or bool(np.any(np.abs(prediction.omega) > np.pi + prediction.omega_slack))


def fits(prediction: Prediction, printing: Printing, columns: Columns) -> bool:
    """Whether all rows are as predicted."""
    return not any(wrong.any() for wrong in misfits(prediction, printing, columns.theta, columns.omega))


def few_of(rows: int) -> int:
    """How many wrong ones of so many rows are cells, and no mistake of the program."""
    return max(1, int(FEW_CELLS * rows)) if rows > 3 else 0


def are_cells(wrong: int, rows: int) -> bool:
    """Whether so few of the rows are wrong that they are no mistake of the program."""
    return wrong <= few_of(rows)
