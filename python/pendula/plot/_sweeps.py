"""What `pendula.measure` measures: stroboscopic sections, and quantities over one or two parameters."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from pendula.plot._style import BLUE, COLORS, LABELS, angle_axis, axes, label

if TYPE_CHECKING:
    import numpy.typing as npt
    from matplotlib.axes import Axes


def section(theta: npt.ArrayLike, omega: npt.ArrayLike, *, ax: Axes | None = None, **points: Any) -> Axes:
    """Points of a stroboscopic section: ω against θ in [-π, π). points: passed on to matplotlib's `plot`."""
    ax = axes(ax)
    _dots(ax, theta, omega, points)
    angle_axis(ax, "x")
    ax.set_xlabel(LABELS["theta"])
    ax.set_ylabel(LABELS["omega"])
    return ax


def bifurcation(
    parameter: npt.ArrayLike,
    values: npt.ArrayLike,
    *,
    ax: Axes | None = None,
    names: tuple[str | None, str | None] = (None, None),
    **points: Any,
) -> Axes:
    """Values [..., point] that belong to each of the parameter's [...], as dots: where a pendulum is at each strobe.

    names: of the parameter and the values, as `solve` and `section` have them, for the labels; xarray's know their own.
    points: passed on to matplotlib's `plot`.
    """
    ax = axes(ax)
    x, y = np.broadcast_arrays(np.asarray(parameter, float)[..., np.newaxis], np.asarray(values, float))
    _dots(ax, x, y, points)
    ax.margins(x=0)
    ax.set_xlabel(label(names[0], parameter))
    ax.set_ylabel(label(names[1], values))
    if ax.get_ylabel() == LABELS["theta"]:
        angle_axis(ax, "y")
    return ax


def map(  # noqa: A001, it is called as pendula.plot.map
    x: npt.ArrayLike,
    y: npt.ArrayLike,
    values: npt.ArrayLike,
    *,
    ax: Axes | None = None,
    names: tuple[str | None, str | None, str | None] = (None, None, None),
    **mesh: Any,
) -> Axes:
    """Values [y, x] over two parameters as colours, with their scale; whole numbers, such as labels of attractors, as classes.

    Where values have both signs, 0 lies in the middle of the scale. names: of x, y and the values, as in `bifurcation`.
    mesh: passed on to matplotlib's `pcolormesh`.
    """
    ax = axes(ax)
    grid = np.asarray(values)
    shape = (np.size(y), np.size(x))
    if grid.shape != shape:
        raise ValueError(f"values must have the shape [y, x], here {shape}, got {grid.shape}")
    is_class = np.issubdtype(grid.dtype, np.integer)  # as labels of attractors
    style = _classes(grid) if is_class else _scale(grid)
    image = ax.pcolormesh(np.ravel(x), np.ravel(y), grid, rasterized=True, **style | mesh)
    bar = ax.figure.colorbar(image, ax=ax, label=label(names[2], values))
    bar.outline.set_visible(False)
    if is_class:
        bar.set_ticks([int(number) for number in np.unique(grid)])
    ax.set_xlabel(label(names[0], x))
    ax.set_ylabel(label(names[1], y))
    return ax


def _dots(ax: Axes, x: npt.ArrayLike, y: npt.ArrayLike, points: dict[str, Any]) -> None:
    """Dots, smaller where there are more; as pixels also in vector formats, where a million dots are too many to open."""
    size = float(np.clip(60 / np.sqrt(np.size(y) + 1), 0.4, 4))
    style: dict[str, Any] = {"color": BLUE, "marker": "o", "markersize": size, "markeredgewidth": 0, "linestyle": "none"}
    ax.plot(np.ravel(x), np.ravel(y), rasterized=True, **style | points)


def _scale(grid: npt.NDArray[Any]) -> dict[str, Any]:
    """Colours whose order can be seen in grey and by colour-blind readers."""
    finite = grid[np.isfinite(grid)]
    if finite.size == 0 or finite.min() >= 0 or finite.max() <= 0:
        return {"cmap": "cividis"}
    largest = np.abs(finite).max()
    return {"cmap": "PuOr_r", "vmin": -largest, "vmax": largest}


def _classes(grid: npt.NDArray[Any]) -> dict[str, Any]:
    """A colour for each whole number; 0, which stands for none, is white."""
    from matplotlib.colors import BoundaryNorm, ListedColormap

    first, last = int(grid.min(initial=0)), int(grid.max(initial=0))
    colors = ["white" if number == 0 else COLORS[(number - 1) % len(COLORS)] for number in range(first, last + 1)]
    return {"cmap": ListedColormap(colors), "norm": BoundaryNorm(np.arange(first, last + 2) - 0.5, len(colors))}
