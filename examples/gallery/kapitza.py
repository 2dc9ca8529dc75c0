"""Kapitza's pendulum let go beside the top, with its pivot shaken too little and enough: kapitza.py DIRECTORY."""

import sys
from pathlib import Path

import numpy as np
import pendula
from matplotlib import pyplot

frequency = 20.0
lowest = np.sqrt(2) * frequency  # the amplitude that holds it up, for alpha = 1 and a fast pivot
figure, ax = pyplot.subplots(figsize=(7, 4), layout="constrained")
for amplitude, colour in ((0.0, "#009e73"), (0.95 * lowest, "#d55e00"), (1.15 * lowest, "#0072b2")):
    run = pendula.solve(
        np.pi - 0.1,
        0.0,
        beta=0.05,
        pivot_amplitude=amplitude,
        drive_frequency=frequency,
        method="taylor",
        every=0.01,
        until=40.0,
    )
    ax.plot(run.t, run.unwrapped, color=colour, linewidth=1.2, label=f"$P$ = {amplitude:.3g} s⁻²")
ax.axhline(np.pi, color="0.6", linestyle=":", zorder=0)
ax.spines[["top", "right"]].set_visible(False)
ax.set_yticks(np.pi * np.array([-1, -0.5, 0, 0.5, 1]), ["−π", "−π/2", "0", "π/2", "π"])
ax.set(xlabel="$t$ [s]", ylabel="$θ$ [rad]", xlim=(0, 40), ylim=(-np.pi, 1.15 * np.pi))
ax.legend(frameon=False, loc="upper center", bbox_to_anchor=(0.5, 1.12), ncols=3)
figure.savefig(Path(sys.argv[1], "kapitza.svg"))
