"""A table's picture: angle and velocity against time, and phase space, over those of the right table."""

from __future__ import annotations

import io
from typing import TYPE_CHECKING

import numpy as np

from pendula import _core
from pendula._closed_form import exact
from pendula._command import Text, say
from pendula.plot._style import BLUE, GREY, VERMILION, angle_axis, axes

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from pendula.check._seam import Judgement, Problem
    from pendula.check._table import Floats

MOST_MARKS = 250  # beyond, circles would hide each other
MOST_POINTS = 2000  # of a table; more are no finer on a page
POINTS_PER_PERIOD, MOST_PERIODS = 120, 40  # of the right curve; beyond, only its values at the table's rows are drawn
FARTHEST = 100  # times the right values' extent; what is farther off is outside of the picture

TEXTS: dict[str, Text] = {
    "right": ("right", "lo correcto"),
    "table": ("the table", "la tabla"),
    "wrong": ("first wrong row", "primera fila mal"),
    "not judged": ("not judged", "sin juzgar"),
}


def picture(problem: Problem, judgement: Judgement, lang: str) -> str:
    """An SVG; empty where there are no columns to draw."""
    if judgement.columns is None:
        return ""
    import matplotlib as mpl
    from matplotlib.figure import Figure

    columns = judgement.columns
    rows = _shown(len(columns.lines), first := _first_wrong(judgement))
    t, theta, omega = (column.values[rows] for column in columns[:3])
    right = _right(problem, columns.t.values[rows])
    with mpl.rc_context({"svg.hashsalt": "pendula", "axes.grid": True, "grid.color": "0.92", "font.size": 9}):
        figure = Figure(figsize=(9.6, 4.2), layout=None)  # the layouts of matplotlib take as long as the drawing
        above, below = figure.add_axes((0.065, 0.57, 0.46, 0.35)), figure.add_axes((0.065, 0.12, 0.46, 0.35))
        phase = figure.add_axes((0.6, 0.12, 0.385, 0.8))
        for ax, x, y in ((above, 0, 1), (below, 0, 2), (phase, 1, 2)):
            table, wanted = (t, theta, omega), right
            _draw(axes(ax), (wanted[x], wanted[y]), (table[x], table[y]), np.flatnonzero(rows == first), lang)
        _label(above, below, phase, float(np.abs(theta).max()) <= np.pi * 1.001)
        _shade(judgement, above, below, lang)
        # One entry each, above all axes, where no data are.
        entries = dict(zip(*reversed(above.get_legend_handles_labels()), strict=True))
        figure.legend(entries.values(), entries.keys(), loc="upper left", ncols=4, frameon=False, borderaxespad=0.2)
        written = io.StringIO()
        figure.savefig(written, format="svg", metadata={"Date": None})
    return written.getvalue()


def _shown(rows: int, first: int | None) -> Floats:
    """Places of the rows that are drawn: evenly spaced, and the first wrong one."""
    places = np.arange(0, rows, -(-rows // MOST_POINTS))
    return places if first is None else np.union1d(places, first)


def _first_wrong(judgement: Judgement) -> int | None:
    """The first row in which angle or velocity are wrong."""
    wrong = [off.first_wrong for role, off in judgement.deviations.items() if role != "sine" and off.first_wrong is not None]
    return min(wrong, default=None)


def _right(problem: Problem, t: Floats) -> tuple[Floats, Floats, Floats]:
    """Times, angles and velocities of the closed form, with gaps where the angle is wrapped."""
    until = min(problem.until, 2 * float(np.abs(t).max()) or problem.until)
    periods = until / problem.tau
    if periods <= MOST_PERIODS:
        t = np.linspace(0, until, int(np.ceil(periods * POINTS_PER_PERIOD)) + 2)
    t = np.clip(t, 0, problem.until)
    theta, omega = exact(problem.theta0, problem.omega0, t, alpha=problem.alpha)
    theta = _core.wrap(theta)
    return t, np.where(np.abs(np.diff(theta, append=theta[-1])) > np.pi, np.nan, theta), omega


def _draw(ax: Axes, right: tuple[Floats, Floats], table: tuple[Floats, Floats], first: Floats, lang: str) -> None:
    """A table over what is right, and its first wrong row."""
    low, high = np.transpose([_limits(*each) for each in zip(right, table, strict=True)])
    # Values far outside would overflow while they are drawn.
    x, y = (np.clip(each, 2 * a - b, 2 * b - a) for each, a, b in zip(table, low, high, strict=True))
    are_marks = x.size <= MOST_MARKS
    ax.plot(*right, color=GREY, linewidth=1.2, label=say(TEXTS["right"], lang))
    line = {"linestyle": "none", "marker": "o", "markersize": 3.6, "markerfacecolor": "none"} if are_marks else {"linewidth": 0.8}
    ax.plot(x, y, color=BLUE, label=say(TEXTS["table"], lang), **line)
    if first.size:
        ring = {"linestyle": "none", "marker": "o", "markersize": 12, "markerfacecolor": "none", "markeredgewidth": 2}
        ax.plot(x[first], y[first], color=VERMILION, label=say(TEXTS["wrong"], lang), **ring)
    ax.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]))


def _limits(right: Floats, table: Floats) -> tuple[float, float]:
    """What an axis shows: all that is right, and of the table what is not too far off."""
    low, high = float(np.nanmin(right)), float(np.nanmax(right))
    extent = max(high - low, abs(high), 1e-300)
    near = table[(table > low - FARTHEST * extent) & (table < high + FARTHEST * extent)]
    low, high = min(low, float(near.min(initial=low))), max(high, float(near.max(initial=high)))
    margin = 0.05 * ((high - low) or extent)
    return low - margin, high + margin


def _label(above: Axes, below: Axes, phase: Axes, is_wrapped: bool) -> None:
    below.set(xlabel="t [s]", ylabel="ω [rad/s]")
    above.set(ylabel="θ [rad]")
    phase.set(xlabel="θ [rad]", ylabel="ω [rad/s]")
    above.tick_params(labelbottom=False)
    if is_wrapped:
        angle_axis(above, "y")
        angle_axis(phase, "x")


def _shade(judgement: Judgement, above: Axes, below: Axes, lang: str) -> None:
    """The time from which on rounding decides."""
    for finding in judgement.findings:
        if finding.name == "not_judged":
            for ax in (above, below):
                ax.axvspan(float(finding.values["t"]), ax.get_xlim()[1], color="0.9", label=say(TEXTS["not judged"], lang))
