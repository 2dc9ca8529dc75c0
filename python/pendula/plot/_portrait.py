"""Phase space."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from pendula import _core
from pendula._solve import solve
from pendula.plot._axes import GREY, LABELS, angle_axis, axes, one_by_one
from pendula.plot._breaks import broken

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from pendula import Solution

ARROWS = (17, 13)  # along θ and along ω


def phase_portrait(
    solution: Solution, *, ax: Axes | None = None, separatrix: bool = True, flow: bool = False, **line: Any
) -> Axes:
    """ω against θ, a line for each pendulum, without false ones where the angle is wrapped.

    separatrix: also the curve between oscillation and rotation, where neither friction nor forcing blurs it. flow: also arrows
    from a grid of states to where they are a moment later, at the drive's phase at t = 0. Both are those of the first
    pendulum. line: passed on to matplotlib's `plot`.
    """
    ax = axes(ax)
    # A line that is not handed a colour takes the next of the axes' cycle.
    for theta, omega, turns in one_by_one(solution, solution.theta, solution.omega, solution.turns):
        ax.plot(*broken(theta, turns, omega), **line)
    angle_axis(ax, "x")
    ax.margins(y=0.08)
    if separatrix and solution.parameters.is_conservative:
        _draw_separatrix(ax, _first(solution.parameters.alpha))
    if flow:
        _draw_flow(ax, {name: _first(value) for name, value in solution.parameters._asdict().items()})
    ax.set_xlabel(LABELS["theta"])
    ax.set_ylabel(LABELS["omega"])
    return ax


def _first(values: Any) -> float:
    return float(np.ravel(values)[0])


def _draw_separatrix(ax: Axes, alpha: float) -> None:
    """The states of the energy of rest on top, which is quadratic in ω."""
    theta = np.linspace(-np.pi, np.pi, 401)
    kinetic = _core.energy(np.pi, 0.0, alpha) - _core.energy(theta, 0.0, alpha)
    omega = np.sqrt(kinetic / _core.energy(0.0, 1.0, alpha))
    for branch in (omega, -omega):
        ax.plot(theta, branch, color=GREY, linestyle="dashed", linewidth=1.2, zorder=1, label="_separatrix")


def _draw_flow(ax: Axes, parameters: dict[str, float]) -> None:
    """Arrows as long as the longest may be without reaching into the next one's cell."""
    low, high = ax.get_ylim()
    columns, rows = ARROWS
    width, height = 2 * np.pi / columns, (high - low) / rows
    theta = -np.pi + width * (0.5 + np.arange(columns))
    omega = (low + height * (0.5 + np.arange(rows)))[:, np.newaxis]
    moment = 0.9 * width / max(-low, high)
    starts: dict[str, Any] = parameters | {"theta0": theta, "omega0": omega}
    moved = solve(**starts, until=moment, every=moment, method="taylor")
    d_theta, d_omega = moved.unwrapped[..., 1] - theta, moved.omega[..., 1] - omega
    ax.quiver(
        *np.broadcast_arrays(theta, omega),
        d_theta,
        d_omega,
        angles="xy",
        scale_units="xy",
        scale=1,
        pivot="mid",
        color="0.75",
        width=0.003,
        zorder=0,
    )
    ax.set_ylim(low, high)
