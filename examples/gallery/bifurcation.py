"""A driven pendulum's way to chaos by doubling its period, with its branches in both directions: bifurcation.py DIRECTORY.

The pendulum of Baker & Gollub, Chaotic dynamics (Cambridge, 2nd edition, 1996), chapter 3, with their q = 2 and 2/3 of the
natural frequency. Each amplitude starts from where its neighbour ended; where the two colours differ there is hysteresis.
"""

import sys
from pathlib import Path

import numpy as np
import pendula
from matplotlib import pyplot

amplitude = np.linspace(1.0, 1.5, 1200)
up, down = pendula.measure.section(
    0.2, 0.0, beta=0.5, drive_amplitude=amplitude, drive_frequency=2 / 3, transient=200, periods=64, carry="both"
).omega
figure, ax = pyplot.subplots(figsize=(8, 4.5), layout="constrained")
for omega, colour, name in ((up, "#d55e00", "up"), (down, "#0072b2", "down")):
    pendula.plot.bifurcation(
        amplitude,
        omega,
        ax=ax,
        names=("drive_amplitude", "omega"),
        markersize=0.6,
        color=colour,
        zorder=2 if name == "up" else 1,
    )
    ax.plot([], [], ".", color=colour, label=f"amplitude going {name}")
ax.legend(frameon=False, loc="lower right", fontsize="small")
ax.set_title(r"$\beta = 0.5\,\mathrm{s}^{-1}$, $\Omega = 2/3\,\mathrm{rad/s}$, once a period of the drive", fontsize="medium")
figure.savefig(Path(sys.argv[1], "bifurcation.png"), dpi=150)
