"""Angles that were not put into [-π, π), and by what rule."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pendula.check._finding import Finding, Where, error, remark
from pendula.check._predict import Prediction, are_cells, without_digits, wrap
from pendula.check._table import WORDS, Column, Columns

if TYPE_CHECKING:
    from pendula.check._program import Floats

CLOSED = 1e-9  # rad: angles nearer to −π are meant to be that


def of_wrapping(theta: Column, prediction: Prediction, form: str, columns: Columns) -> list[Finding]:
    """Angles that stand outside [-π, π), and by what rule they got there."""
    if form == "absolute":
        return []
    # A few wrong cells are told as such.
    wrong = ~(np.abs(wrap(theta.values - prediction.theta)) <= theta.units + prediction.theta_slack) | without_digits(
        theta.units
    )
    judged = ~wrong if are_cells(int(wrong.sum()), wrong.size) else np.ones_like(wrong)
    outside = np.flatnonzero(judged & ((theta.values > np.pi + theta.units) | (theta.values < -np.pi - theta.units)))
    if outside.size == 0:
        at_top = np.abs(np.abs(prediction.theta) - np.pi) <= CLOSED
        closed = np.any(at_top & (theta.values > 0) & (prediction.theta_slack < CLOSED))
        return [remark("wraps_closed_above")] if closed else []
    row = int(outside[0])
    wanted = float(wrap(theta.values[row]))
    where = Where(int(columns.lines[row]), float(columns.t.values[row]), WORDS[1], float(columns.theta.values[row]), wanted)
    printed, turning = theta.values[judged], prediction.turning[judged]
    slack = (theta.units + prediction.theta_slack + 1e-9)[judged]
    named = list(dict.fromkeys(name for name, rule in WRAPPINGS if _follows(printed, rule(turning), slack)))
    alternatives = tuple(error(name) for name in named[1:4])
    return [Finding(named[0] if named else "not_normalised", {}, where=where, alternatives=alternatives)]


def _follows(theta: Floats, wanted: Floats, slack: Floats) -> bool:
    """Whether angles follow a rule, except where rounding decides at a multiple of π."""
    off = np.abs(theta - wanted)
    at_edge = np.abs(np.sin(wanted)) <= slack
    whole_turn = np.abs(off - 2 * np.pi) <= slack
    return bool(np.all((off <= slack) | (at_edge & whole_turn)))


def _one_side(theta: Floats, sign: float) -> Floats:
    return np.where(sign * theta > np.pi, wrap(theta), theta)


WRAPPINGS = (
    ("not_normalised", lambda theta: theta),
    ("wraps_one_side", lambda theta: _one_side(theta, 1.0)),
    ("wraps_one_side", lambda theta: _one_side(theta, -1.0)),
    ("wraps_one_side", lambda theta: np.where(theta > np.pi, theta - 2 * np.pi, theta)),
    ("wraps_one_side", lambda theta: np.where(theta < -np.pi, theta + 2 * np.pi, theta)),
    ("wraps_one_side", lambda theta: theta - 2 * np.pi * (theta > np.pi) + 2 * np.pi * (theta < -np.pi)),
    ("wraps_zero_to_two_pi", lambda theta: np.mod(theta, 2 * np.pi)),
    ("wraps_fmod", lambda theta: np.fmod(theta, 2 * np.pi)),
    ("wraps_fmod", lambda theta: np.fmod(theta + np.pi, 2 * np.pi) - np.pi),
)
