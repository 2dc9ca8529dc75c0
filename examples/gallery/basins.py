"""Which of a driven pendulum's two orbits each initial state ends on: basins.py DIRECTORY.

Both have period 3. The parameters are those of scripts/pendulum_basins.jl in github.com/awage/BasinsCollection, which finds the
basins with Attractors.jl (Datseris & Wagemakers, Chaos 32 (2022), 023104).
"""

import sys
from pathlib import Path

import numpy as np
import pendula
from matplotlib import pyplot

AMPLITUDE = 1.3636363636363635
theta, omega = np.linspace(-np.pi, np.pi, 160), np.linspace(-4, 4, 160)
found = pendula.measure.attractors(theta, omega[:, np.newaxis], beta=0.2, drive_amplitude=AMPLITUDE, drive_frequency=0.5)
figure, ax = pyplot.subplots(figsize=(7, 5.5), layout="constrained")
pendula.plot.map(theta, omega, found.label, ax=ax, names=("theta", "omega", "label"))
for label in np.unique(found.label[found.label > 0]):
    first = tuple(np.argwhere(found.label == label)[0])
    orbit = pendula.measure.section(
        found.theta[first], found.omega[first], beta=0.2, drive_amplitude=AMPLITUDE, drive_frequency=0.5, transient=0, periods=3
    )
    ax.plot(orbit.theta, orbit.omega, "o", markersize=5, markeredgecolor="white", color="black")
ax.set_title(
    r"$\beta = 0.2\,\mathrm{s}^{-1}$, $\Gamma = 1.36\ldots\,\mathrm{s}^{-2}$, $\Omega = 0.5\,\mathrm{rad/s}$", fontsize="medium"
)
figure.savefig(Path(sys.argv[1], "basins.png"), dpi=150)
