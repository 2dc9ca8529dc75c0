"""A table's picture: angle and velocity against time, how far they are from what is right, and phase space.

Where the sinusoid is not right, it is there, too.
"""

from __future__ import annotations

import io
from functools import cache
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from pendula import _core
from pendula._closed_form import exact
from pendula._command import Text, say
from pendula.check._program import RIGHT, taken
from pendula.check._sinusoid import right_sinusoid
from pendula.check._table import WORDS
from pendula.plot._style import BLUE, GREY, ORANGE, VERMILION, angle_axis, axes

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from matplotlib.lines import Line2D

    from pendula.check._judge import Judgement
    from pendula.check._program import Floats, Integers, Problem

MOST_MARKS = 250  # beyond, circles would hide each other
MOST_POINTS = 2000  # of a table; more are no finer on a page
POINTS_PER_PERIOD, MOST_PERIODS = 120, 40  # of the right curve; beyond, it is drawn through the table's times
LATEST = 1e6  # periods; later, the closed form need not know the phase
FARTHEST = 100  # times the right values' extent; what is farther off is outside of the picture
WIDE = np.pi / 2  # angles beyond are shown in the whole turn
# Where phase space is in the picture, and where it leaves room for the sinusoid.
ALL_RIGHT_HAND, UPPER, LOWER = (0.61, 0.1, 0.375, 0.83), (0.61, 0.5, 0.375, 0.43), (0.61, 0.1, 0.375, 0.24)

TEXTS: dict[str, Text] = {
    "right": ("right", "lo correcto"),
    "table": ("the table", "la tabla"),
    "wrong": ("first wrong row", "primera fila mal"),
    "not judged": ("not judged from here on", "sin juzgar desde aquí"),
    "difference": ("table − right", "tabla − correcto"),
}
RC: Any = {"svg.hashsalt": "pendula", "svg.fonttype": "none", "font.size": 9}


class Panel(NamedTuple):
    """Axes with what is right, the table over it and its first wrong row."""

    ax: Axes
    right: Line2D
    table: Line2D
    wrong: Line2D


class Canvas(NamedTuple):
    """All that a picture consists of."""

    figure: Figure
    theta: Panel
    omega: Panel
    phase: Panel
    sine: Panel
    off: Axes
    theta_off: Line2D
    omega_off: Line2D
    limits: tuple[Line2D, ...]
    """From which time on nothing is judged."""


@cache
def _canvas() -> Canvas:
    """Made once and filled anew for each picture: to make axes takes longer than to draw."""
    from matplotlib.figure import Figure
    from matplotlib.ticker import MaxNLocator

    figure = Figure(figsize=(9.6, 4.8))
    places = ((0.08, 0.69, 0.44, 0.24), (0.08, 0.4, 0.44, 0.24), ALL_RIGHT_HAND, LOWER, (0.08, 0.1, 0.44, 0.24))
    theta, omega, phase, sine, off = (axes(figure.add_axes(place)) for place in places)
    theta.tick_params(labelbottom=False)
    omega.tick_params(labelbottom=False)
    theta.set_ylabel("θ [rad]")
    omega.set_ylabel("ω [rad/s]")
    phase.set(xlabel="θ [rad]", ylabel="ω [rad/s]")
    off.set_xlabel("t [s]")
    sine.set(xlabel="t [s]", ylabel="[rad]")
    sine.set_title(WORDS[3], loc="left", fontsize=9)
    for ax, ticks in ((theta, 3), (omega, 3), (off, 3), (sine, 3), (phase, 7)):
        ax.yaxis.set_label_coords(-0.13, 0.5)
        ax.xaxis.set_major_locator(MaxNLocator(6))
        ax.yaxis.set_major_locator(MaxNLocator(ticks))
    off.axhline(0, color=GREY, linewidth=0.8)
    style: dict[str, Any] = {"linestyle": "", "markersize": 2.5}
    (theta_off,) = off.plot([], [], color=BLUE, marker="o", label="θ", **style)
    (omega_off,) = off.plot([], [], color=ORANGE, marker="^", label="ω", **style)
    off.legend(loc="upper right", ncols=2, frameon=False, borderaxespad=0, handlelength=1.2, fontsize=8)
    limits = tuple(ax.axvline(0, color=GREY, linestyle=(0, (4, 2))) for ax in (theta, omega, off))
    return Canvas(figure, _panel(theta), _panel(omega), _panel(phase), _panel(sine), off, theta_off, omega_off, limits)


def _panel(ax: Axes) -> Panel:
    (right,) = ax.plot([], [], color=GREY, linewidth=1.2)
    (table,) = ax.plot([], [], color=BLUE, markersize=3.6, markerfacecolor="none", linewidth=0.8)
    ring: dict[str, Any] = {"marker": "o", "markersize": 11, "markerfacecolor": "none", "markeredgewidth": 2, "clip_on": False}
    (wrong,) = ax.plot([], [], color=VERMILION, linestyle="", **ring)
    return Panel(ax, right, table, wrong)


def picture(problem: Problem, judgement: Judgement, lang: str) -> str:
    """An SVG; empty where there are no columns to draw."""
    if judgement.columns is None:
        return ""
    import matplotlib as mpl

    columns = judgement.columns
    first = _first_wrong(judgement, "theta", "omega")
    rows = _shown(len(columns.lines), first, _first_wrong(judgement, "sine"))
    table = (columns.t.values[rows], columns.theta.values[rows], columns.omega.values[rows])
    right = _right(problem, table[0])
    wrong = np.flatnonzero(rows == first)
    with mpl.rc_context(RC):
        canvas = _canvas()
        for panel, x, y in ((canvas.theta, 0, 1), (canvas.omega, 0, 2), (canvas.phase, 1, 2)):
            _fill(panel, (right[x], right[y]), (table[x], table[y]), wrong)
        largest = max(float(np.nanmax(np.abs(each[1]))) for each in (right, table))
        _fill_sine(canvas, problem, judgement, right[0], rows)
        _set_angle_axes(canvas, is_turn=WIDE < largest <= np.pi * 1.001)
        _fill_off(canvas, judgement, rows, lang)
        _legend(canvas, judgement, lang)
        written = io.StringIO()
        canvas.figure.savefig(written, format="svg", metadata={"Date": None})
    return written.getvalue()


def _set_angle_axes(canvas: Canvas, is_turn: bool) -> None:
    """The whole turn with ticks at its quarters, or what there is of it."""
    from matplotlib.ticker import MaxNLocator, ScalarFormatter

    for axis, ticks in ((canvas.theta.ax.yaxis, 3), (canvas.phase.ax.xaxis, 6)):
        axis.set_major_locator(MaxNLocator(ticks))
        axis.set_major_formatter(ScalarFormatter())
    if is_turn:
        angle_axis(canvas.theta.ax, "y")
        angle_axis(canvas.phase.ax, "x")


def _shown(rows: int, *first: int | None) -> Integers:
    """Places of the rows that are drawn: evenly spaced, and the first wrong ones."""
    places = np.arange(0, rows, -(-rows // MOST_POINTS))
    return np.union1d(places, [row for row in first if row is not None]).astype(int)


def _first_wrong(judgement: Judgement, *roles: str) -> int | None:
    """The first row in which one of these is wrong."""
    firsts = (off.first_wrong for role, off in judgement.deviations.items() if role in roles)
    return min((row for row in firsts if row is not None), default=None)


def _right(problem: Problem, t: Floats) -> tuple[Floats, Floats, Floats]:
    """Times, angles and velocities of the closed form, with gaps where the angle is wrapped."""
    until = min(problem.until, 2 * float(np.abs(t).max()) or problem.until, LATEST * problem.tau)
    periods = until / problem.tau
    if periods <= MOST_PERIODS:
        t = np.linspace(0, until, int(np.ceil(periods * POINTS_PER_PERIOD)) + 2)
    t = np.clip(t, 0, until)
    theta, omega = exact(problem.theta0, problem.omega0, t, alpha=problem.alpha)
    return t, _broken(_core.wrap(theta)), omega


def _broken(theta: Floats) -> Floats:
    """With a gap before each jump."""
    return np.where(np.abs(np.diff(theta, append=theta[-1])) > np.pi, np.nan, theta)


def _fill(panel: Panel, right: tuple[Floats, Floats], table: tuple[Floats, Floats], wrong: Integers) -> None:
    """A table over what is right, and its first wrong row."""
    low, high = np.transpose([_limits(*each) for each in zip(right, table, strict=True)])
    # Values far outside would overflow while they are drawn.
    x, y = (np.clip(each, 2 * a - b, 2 * b - a) for each, a, b in zip(table, low, high, strict=True))
    panel.right.set_data(*right)
    panel.table.set_data(x, y)
    _as_marks(panel.table, x.size, "o")
    panel.wrong.set_data(x[wrong], y[wrong])
    panel.ax.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]))


def _fill_sine(canvas: Canvas, problem: Problem, judgement: Judgement, t: Floats, rows: Integers) -> None:
    """The sinusoid over the right one, where it is not right; else phase space has its place."""
    first = _first_wrong(judgement, "sine")
    canvas.sine.ax.set_visible(first is not None)
    canvas.phase.ax.set_position(ALL_RIGHT_HAND if first is None else UPPER)
    canvas.sine.wrong.set_data(*np.empty((2, 0)))
    if first is None:
        return
    assert judgement.columns is not None
    assert judgement.columns.sine is not None
    right = right_sinusoid(taken(RIGHT, problem), problem.tau).at(t)
    table = (judgement.columns.t.values[rows], judgement.columns.sine.values[rows])
    _fill(canvas.sine, (t, _broken(right)), table, np.flatnonzero(rows == first))


def _as_marks(line: Line2D, rows: int, marker: str) -> None:
    """Marks where there are few rows; else only a line, that jumps where the angle is wrapped."""
    are_marks = rows <= MOST_MARKS
    line.set(marker=marker if are_marks else "", linestyle="" if are_marks else "-")


def _limits(right: Floats, table: Floats) -> tuple[float, float]:
    """What an axis shows: all that is right, and of the table what is not too far off."""
    low, high = float(np.nanmin(right)), float(np.nanmax(right))
    extent = max(high - low, abs(high), 1e-300)
    near = table[(table > low - FARTHEST * extent) & (table < high + FARTHEST * extent)]
    low, high = min(low, float(near.min(initial=low))), max(high, float(near.max(initial=high)))
    margin = 0.05 * ((high - low) or extent)
    return low - margin, high + margin


def _fill_off(canvas: Canvas, judgement: Judgement, rows: Integers, lang: str) -> None:
    """How far angle and velocity are from what is right, on their own scale."""
    assert judgement.columns is not None
    t, theta, omega = (column.values[rows] for column in judgement.columns[:3])
    theta_off = _core.wrap(theta - judgement.deviations["theta"].wanted[rows])
    omega_off = omega - judgement.deviations["omega"].wanted[rows]
    low, high = canvas.theta.ax.get_xlim()
    largest = float(np.abs([theta_off, np.clip(omega_off, -FARTHEST, FARTHEST)]).max()) or 1.0
    for line, off, marker in ((canvas.theta_off, theta_off, "o"), (canvas.omega_off, omega_off, "^")):
        line.set_data(np.clip(t, 2 * low - high, 2 * high - low), np.clip(off, -2 * largest, 2 * largest))
        _as_marks(line, t.size, marker)
    canvas.off.set(xlim=(low, high), ylim=(-1.1 * largest, 1.6 * largest), ylabel=say(TEXTS["difference"], lang))


def _legend(canvas: Canvas, judgement: Judgement, lang: str) -> None:
    """Above all axes, where no data are."""
    panel, entries = canvas.theta, {"right": canvas.theta.right, "table": canvas.theta.table}
    if any(each.wrong.get_xdata().size for each in (panel, canvas.sine)):  # type: ignore[union-attr]
        entries["wrong"] = panel.wrong
    since = next((float(each.values["t"]) for each in judgement.findings if each.name == "not_judged"), None)
    for line in canvas.limits:
        line.set(xdata=[since, since] if since is not None else [], ydata=[0, 1] if since is not None else [])
    if since is not None:
        entries["not judged"] = canvas.limits[0]
    canvas.figure.legends.clear()
    names = [say(TEXTS[name], lang) for name in entries]
    canvas.figure.legend([*entries.values()], names, loc="upper left", ncols=4, frameon=False, borderaxespad=0.2)
