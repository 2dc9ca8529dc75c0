"""Angle and angular velocity against time."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from pendula.plot._axes import BLUE, GREY, VERMILION, axes, one_by_one
from pendula.plot._breaks import broken

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from pendula import Solution

MOST_MARKS = 250  # beyond, circles and triangles would hide each other


def time_series(solution: Solution, *, ax: Axes | None = None) -> Axes:
    """θ as circles, ω as triangles and, where the pendulum oscillates, the sinusoid (3.4) as a line, against time.

    More than 250 rows are drawn as lines, solid and dashed, without false ones where the angle is wrapped.
    """
    ax = axes(ax)
    conservative = solution.parameters.is_conservative
    sine = solution.sine if conservative else np.full_like(solution.theta, np.nan)
    are_marks = solution.t.shape[-1] <= MOST_MARKS
    for t, theta, omega, turns, sinusoid in one_by_one(
        solution, solution.t, solution.theta, solution.omega, solution.turns, sine
    ):
        if np.isfinite(sinusoid).any():
            ax.plot(t, sinusoid, color=GREY, linewidth=1.2, zorder=1, label=r"$\theta_M\,\sin(2\pi t/\tau+\varphi_0)$")
        if are_marks:
            style: dict[str, Any] = {"linestyle": "none", "markersize": 4.5, "markerfacecolor": "none"}
            ax.plot(t, theta, marker="o", color=BLUE, label=r"$\theta$", **style)
            ax.plot(t, omega, marker="^", color=VERMILION, label=r"$\omega$", **style)
        else:
            angle, time = broken(theta, turns, t)
            ax.plot(time, angle, color=BLUE, label=r"$\theta$")
            ax.plot(t, omega, color=VERMILION, linestyle=(0, (4, 1.5)), label=r"$\omega$")
    ax.margins(x=0.02)
    ax.set_xlabel("$t$ [s]")
    ax.set_ylabel(r"$\theta$ [rad],  $\omega$ [rad/s]")
    _legend_above(ax)
    return ax


def _legend_above(ax: Axes) -> None:
    """One entry a label, outside of where data are."""
    entries = dict(zip(*reversed(ax.get_legend_handles_labels()), strict=True))
    ax.legend(entries.values(), entries.keys(), loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=3, frameon=False)
