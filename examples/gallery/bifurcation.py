"""A driven pendulum's way to chaos by doubling its period, and back: bifurcation.py DIRECTORY."""

import sys
from pathlib import Path

import numpy as np
import pendula
from matplotlib import pyplot

amplitude = np.linspace(1.0, 1.5, 1000)
# Several starts for each amplitude find all of its attractors.
states = pendula.measure.section(
    np.linspace(-2.5, 2.5, 6),
    0.0,
    beta=0.5,
    drive_amplitude=amplitude[:, np.newaxis],
    drive_frequency=2 / 3,
    transient=300,
    periods=32,
)
figure, ax = pyplot.subplots(figsize=(8, 4.5), layout="constrained")
pendula.plot.bifurcation(amplitude[:, np.newaxis], states.omega, ax=ax, names=("drive_amplitude", "omega"), markersize=0.6)
ax.set_title(r"$\beta = 0.5\,\mathrm{s}^{-1}$, $\Omega = 2/3\,\mathrm{rad/s}$, once a period of the drive", fontsize="medium")
figure.savefig(Path(sys.argv[1], "bifurcation.png"), dpi=150)
