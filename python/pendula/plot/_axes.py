"""What the figures share: axes, labels, colours."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Iterator

    from matplotlib.axes import Axes

    from pendula import Solution

# Okabe & Ito's colours: told apart by colour-blind readers, and of different greys in print.
BLUE, VERMILION, GREEN, PURPLE, ORANGE, SKY = "#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"
COLORS = (BLUE, VERMILION, GREEN, PURPLE, ORANGE, SKY)
GREY = "0.45"

LABELS = {
    "t": "$t$ [s]",
    "theta": r"$\theta$ [rad]",
    "omega": r"$\omega$ [rad/s]",
    "theta0": r"$\theta_0$ [rad]",
    "omega0": r"$\omega_0$ [rad/s]",
    "alpha": r"$\alpha$ [s$^{-2}$]",
    "beta": r"$\beta$ [s$^{-1}$]",
    "torque": r"$\mu$ [s$^{-2}$]",
    "drive_amplitude": r"$\Gamma$ [s$^{-2}$]",
    "drive_frequency": r"$\Omega$ [rad/s]",
    "drive_phase": r"$\varphi$ [rad]",
    "velocity": r"$\langle\omega\rangle$ [rad/s]",
    "lyapunov": r"$\lambda$ [s$^{-1}$]",
}


def pyplot() -> Any:
    """matplotlib.pyplot, or an ImportError that says what to install."""
    try:
        from matplotlib import pyplot
    except ImportError as error:
        raise ImportError("pendula.plot needs matplotlib; install it with: pip install 'pendula[plot]'") from error
    return pyplot


def axes(ax: Axes | None) -> Axes:
    """The axes given, or those of a new figure, without the frame's idle half."""
    if ax is None:
        ax = pyplot().subplots(layout="constrained")[1]
    ax.spines[["top", "right"]].set_visible(False)
    return ax


def label(name: str | None, values: Any = None) -> str:
    """The symbol and unit of the quantity of that name, or of values that carry one, as xarray's do; else the name itself."""
    if name is None:
        name = getattr(values, "name", None) or ""
    return LABELS.get(name, name)


def angle_axis(ax: Axes, which: str) -> None:
    """One turn along x or y, with ticks at the quarters of it."""
    ax.set(**{f"{which}lim": (-np.pi, np.pi)})
    axis: Any = getattr(ax, f"{which}axis")
    axis.set_ticks(np.pi * np.array([-1, -0.5, 0, 0.5, 1]), ["−π", "−π/2", "0", "π/2", "π"])


def one_by_one(solution: Solution, *values: Any) -> Iterator[tuple[Any, ...]]:
    """The rows of each pendulum in turn, of arrays that broadcast to [..., time]."""
    shape = solution.theta.shape
    return zip(*(np.broadcast_to(array, shape).reshape(-1, shape[-1]) for array in values), strict=True)
