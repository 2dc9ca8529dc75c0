"""A strange attractor, where a driven pendulum is once a period of the drive: attractor.py DIRECTORY."""

import sys
from pathlib import Path

import numpy as np
import pendula
from matplotlib import pyplot

states = pendula.measure.section(
    np.linspace(-1, 1, 128),
    0.0,
    beta=0.25,
    drive_amplitude=1.5,
    drive_frequency=2 / 3,
    transient=100,
    periods=800,
)
figure, ax = pyplot.subplots(figsize=(7, 5), layout="constrained")
pendula.plot.section(states.theta, states.omega, ax=ax, markersize=0.6)
ax.set_title(
    r"$\beta = 0.25\,\mathrm{s}^{-1}$, $\Gamma = 1.5\,\mathrm{s}^{-2}$, $\Omega = 2/3\,\mathrm{rad/s}$", fontsize="medium"
)
figure.savefig(Path(sys.argv[1], "attractor.png"), dpi=150)
