"""The pendulum swinging beside its phase plane."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pendula.plot._axes import BLUE, GREY, VERMILION, pyplot
from pendula.plot._portrait import phase_portrait

if TYPE_CHECKING:
    from matplotlib.animation import FuncAnimation
    from matplotlib.artist import Artist
    from matplotlib.figure import Figure

    from pendula import Solution

FASTEST = 20  # ms a frame; browsers slow GIFs down that ask for less
TRAIL = 12  # rows


def animate(solution: Solution, *, figure: Figure | None = None, speed: float = 1.0) -> FuncAnimation:
    """An animation of a single pendulum, a frame a row: to be kept by `.save("pendulum.gif", writer="pillow")`, or as
    `.mp4` where ffmpeg is there.

    speed: seconds of the pendulum in one of the spectator's, as far as 50 frames a second allow; positive. ValueError for
    a solution of several pendulums, or of one row.
    """
    if solution.theta.ndim != 1 or solution.t.size < 2:
        raise ValueError(f"animate takes one pendulum at two times or more, got an array of shape {solution.theta.shape}")
    if not speed > 0:
        raise ValueError(f"speed must be positive, got {speed}")
    plt = pyplot()
    from matplotlib.animation import FuncAnimation

    if figure is None:
        figure = plt.figure(figsize=(8, 4), layout="constrained")
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
    figure.set_layout_engine("none")  # which would lay out every frame anew

    def draw(row: int) -> tuple[Artist, ...]:
        past = slice(max(0, row - TRAIL), row + 1)
        trail.set_data(x[past], y[past])
        rod.set_data([0, x[row]], [0, y[row]])
        bob.set_data([x[row]], [y[row]])
        state.set_data([solution.theta[row]], [solution.omega[row]])
        clock.set_text(f"$t$ = {solution.t[row]:.2f} s")
        return trail, rod, bob, state, clock

    interval = max(FASTEST, 1000 * float(solution.t[1] - solution.t[0]) / speed)
    return FuncAnimation(figure, draw, frames=solution.t.size, interval=interval, blit=True)
