"""What the figures share: axes, labels, colours, and lines that are broken where the angle is wrapped."""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal, TypeAlias

import numpy as np
import numpy.typing as npt

from pendula import _core

if TYPE_CHECKING:
    from collections.abc import Iterator

    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from pendula._solution import Solution

Floats: TypeAlias = npt.NDArray[np.float64]

# Okabe and Ito's colours: colour-blind readers can tell them apart, and in print they are different greys.
BLUE, VERMILION, GREEN, PURPLE, ORANGE, SKY = "#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"
COLORS = (BLUE, VERMILION, GREEN, PURPLE, ORANGE, SKY)
GREY = "0.45"


def _with_unit(symbol: str, unit: str) -> str:
    """A label: $θ_0$ [rad] of θ0 and rad."""
    return f"${symbol.replace('0', '_0')}$ [{unit}]"


LABELS = {
    "t": "$t$ [s]",
    **{each.name: _with_unit(each.symbol, each.unit) for each in _core.parameters},
    **{each.name: _with_unit(each.symbol, each.unit) for m in _core.measures for each in m.columns if each.symbol},
}


def new_figure(size: tuple[float, float] | None = None) -> Figure:
    """One of pyplot's figures, of a size in inches; an ImportError says what to install."""
    try:
        from matplotlib import pyplot
    except ImportError as error:
        raise ImportError("pendula.plot needs matplotlib; install it with: pip install 'pendula[plot]'") from error
    return pyplot.figure(figsize=size, layout="constrained")


def axes(ax: Axes | None) -> Axes:
    """The axes given, or those of a new figure, framed at the left and below only."""
    if ax is None:
        ax = new_figure().subplots()
    ax.spines[["top", "right"]].set_visible(False)
    return ax


def label(name: str | None, values: npt.ArrayLike) -> str:
    """The symbol and unit of a quantity by its name, else by that which the values carry, as xarray's do; else the name."""
    if name is None:
        name = getattr(values, "name", None) or ""
    return LABELS.get(name, name)


def angle_axis(ax: Axes, which: Literal["x", "y"]) -> None:
    """One turn along x or y, with ticks at the quarters of it."""
    ax.set(**{f"{which}lim": (-np.pi, np.pi)})
    axis = ax.xaxis if which == "x" else ax.yaxis
    axis.set_ticks(np.pi * np.array([-1, -0.5, 0, 0.5, 1]), ["−π", "−π/2", "0", "π/2", "π"])


def one_by_one(solution: Solution, *values: Floats) -> Iterator[tuple[Floats, ...]]:
    """The rows of each pendulum in turn, of arrays that broadcast to [..., time]."""
    shape = solution.theta.shape
    return zip(*(np.broadcast_to(array, shape).reshape(-1, shape[-1]) for array in values), strict=True)


def broken(theta: Floats, turns: Floats, *others: Floats) -> tuple[Floats, ...]:
    """The angle and what goes with it, with three more points wherever the angle is wrapped: the edge, a NaN, the other edge.

    theta: in [-π, π). turns: its whole turns, of which a fast pendulum may pass several between two rows; then all three points
    are NaN. others: what goes with the angle, and is interpolated at the edge. All have one axis.
    """
    passed = np.diff(turns)
    places = np.flatnonzero(passed)
    if places.size == 0:
        return (theta, *others)
    edge = np.where(np.abs(passed[places]) == 1, np.pi * passed[places], np.nan)
    step = np.diff(theta)[places] + 2 * np.pi * passed[places]
    fraction = (edge - theta[places]) / step
    gap = np.full(places.size, np.nan)

    def inserted(values: Floats, at_edge: Floats, behind: Floats) -> Floats:
        return np.insert(values, np.repeat(places + 1, 3), np.stack([at_edge, gap, behind], axis=1).reshape(-1))

    found = [inserted(theta, edge, -edge)]
    for values in others:
        between = values[places] + fraction * np.diff(values)[places]
        found.append(inserted(values, between, between))
    return tuple(found)
