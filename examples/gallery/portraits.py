"""Phase space through the separatrix: portraits.py DIRECTORY."""

import sys
from pathlib import Path

import numpy as np
import pendula
from matplotlib import pyplot
from pendula.plot import phase_portrait

figure, ax = pyplot.subplots(figsize=(7, 5), layout="constrained")
# Started at the bottom: up to 2 rad/s a pendulum of α = 1 oscillates, beyond it turns over.
oscillating = np.linspace(0.25, 1.95, 8)
rotating = np.array([2.05, 2.3, 2.6, 2.95])
rotating = np.concatenate([rotating, -rotating])
for speeds, colour, kind in ((oscillating, "#0072b2", "oscillation"), (rotating, "#d55e00", "rotation")):
    tau = pendula.analyze(0.0, speeds).tau
    orbits = pendula.solve(0.0, speeds, every=tau / 400, until=tau, method="exact")
    phase_portrait(orbits, ax=ax, separatrix=False, color=colour, linewidth=1.3)
    ax.lines[-1].set_label(kind)
phase_portrait(pendula.solve(0.0, 0.0), ax=ax, flow=True, color="#0072b2", marker="o", markersize=3)
ax.lines[-1].set_label("separatrix")
ax.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=3, frameon=False)
figure.savefig(Path(sys.argv[1], "portraits.svg"))
