"""Figures of a solution: time series, phase portrait, animation."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from pendula import _core
from pendula._solve import solve
from pendula.plot._style import BLUE, GREY, LABELS, VERMILION, angle_axis, axes, broken, new_figure, one_by_one

if TYPE_CHECKING:
    import numpy.typing as npt
    from matplotlib.animation import FuncAnimation
    from matplotlib.artist import Artist
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from pendula._solution import Solution
    from pendula.plot._style import Floats

MOST_MARKS = 250  # beyond, circles and triangles would hide each other
ARROWS = (17, 13)  # of the flow, along θ and along ω
FASTEST, SLOWEST = 20, 60_000  # ms a frame; browsers slow GIFs down that ask for less
TRAIL = 12  # rows of an animation


def time_series(solution: Solution, *, ax: Axes | None = None) -> Axes:
    """θ as circles, ω as triangles and, where the pendulum oscillates, the sinusoid (3.4) as a line, against time.

    More than 250 rows are drawn as lines, solid and dashed, which are broken where the angle is wrapped.
    """
    ax = axes(ax)
    sine = solution.sine if solution.parameters.is_conservative else np.full_like(solution.theta, np.nan)
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


def phase_portrait(
    solution: Solution, *, ax: Axes | None = None, separatrix: bool = True, flow: bool = False, **line: Any
) -> Axes:
    """ω against θ, a line for each pendulum, which is broken where the angle is wrapped.

    separatrix: also the curve between oscillation and rotation, which there is without friction and forcing only. flow: also
    arrows from a grid of states to where they are a moment later, at the drive's phase at t = 0. Both are those of the first
    pendulum. line: passed on to matplotlib's `plot`.
    """
    ax = axes(ax)
    # A line without a colour of its own takes the next of the axes' cycle.
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


def _first(values: npt.ArrayLike) -> float:
    return float(np.ravel(values)[0])


def _draw_separatrix(ax: Axes, alpha: float) -> None:
    """The states that have the energy of rest on top, which is quadratic in ω."""
    theta = np.linspace(-np.pi, np.pi, 401)
    kinetic = _core.energy(np.pi, 0.0, alpha) - _core.energy(theta, 0.0, alpha)
    omega: Floats = np.sqrt(kinetic / _core.energy(0.0, 1.0, alpha))
    for branch in (omega, -omega):
        ax.plot(theta, branch, color=GREY, linestyle="dashed", linewidth=1.2, zorder=1, label="_separatrix")


def _draw_flow(ax: Axes, parameters: dict[str, float]) -> None:
    """Arrows, the longest of them nearly as long as a cell of the grid is wide."""
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


def animate(solution: Solution, *, figure: Figure | None = None, speed: float = 1.0) -> FuncAnimation:
    """An animation of a single pendulum, a frame a row. `.save("pendulum.gif", writer="pillow")` keeps it, as `.mp4` does
    where ffmpeg is there.

    speed: seconds of the pendulum in one of the spectator's, as far as 50 frames a second allow; positive. ValueError for a
    solution of several pendulums, or of one row, and where a frame would last longer than a minute.
    """
    if solution.theta.ndim != 1 or solution.t.size < 2:
        raise ValueError(f"animate takes one pendulum at two times or more, got an array of shape {solution.theta.shape}")
    if not speed > 0:
        raise ValueError(f"speed must be positive, got {speed}")
    interval = max(FASTEST, 1000 * float(solution.t[1] - solution.t[0]) / speed)
    if interval > SLOWEST:
        raise ValueError(f"a frame must not last longer than 60 s, got {interval / 1000:.6g} at speed {speed}")
    if figure is None:
        figure = new_figure((8, 4))
    from matplotlib.animation import FuncAnimation

    swing, plane = figure.subplots(1, 2)
    phase_portrait(solution, ax=plane, color=BLUE, alpha=0.35)
    (state,) = plane.plot([], [], "o", color=VERMILION, markersize=9)

    x, y = np.sin(solution.theta), -np.cos(solution.theta)  # of the bob, on a rod of length 1
    swing.set(xlim=(-1.2, 1.2), ylim=(-1.2, 1.2), aspect="equal")
    swing.set_axis_off()
    swing.plot(0, 0, "o", color=GREY, markersize=5)
    (trail,) = swing.plot([], [], color=BLUE, alpha=0.35)
    (rod,) = swing.plot([], [], color=GREY, linewidth=2)
    (bob,) = swing.plot([], [], "o", color=VERMILION, markersize=16)
    clock = swing.text(0.02, 0.98, "", transform=swing.transAxes, va="top")

    figure.draw_without_rendering()
    figure.set_layout_engine("none")  # it would lay out every frame anew

    def draw(row: int) -> tuple[Artist, ...]:
        past = slice(max(0, row - TRAIL), row + 1)
        trail.set_data(x[past], y[past])
        rod.set_data([0, x[row]], [0, y[row]])
        bob.set_data([x[row]], [y[row]])
        state.set_data([solution.theta[row]], [solution.omega[row]])
        clock.set_text(f"$t$ = {solution.t[row]:.2f} s")
        return trail, rod, bob, state, clock

    return FuncAnimation(figure, draw, frames=solution.t.size, interval=interval, blit=True)
