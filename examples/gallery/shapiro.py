"""The current-voltage curve of a Josephson junction in microwaves, with Shapiro steps and hysteresis: shapiro.py DIRECTORY.

The model is the resistively and capacitively shunted junction: Kautz, Rep. Prog. Phys. 59 (1996), 935. The torque is the bias
current, the mean velocity the voltage. Each current starts from the state at its neighbour, up and down.
"""

import sys
from pathlib import Path

import numpy as np
import pendula
from matplotlib import pyplot

current = np.linspace(0, 1, 401)
figure, ax = pyplot.subplots(figsize=(7, 4.5), layout="constrained")
for step in range(1, 4):
    ax.axhline(step, color="0.85", linewidth=0.8, zorder=0)
for amplitude, dashes in ((0.0, (0, (2, 1.5))), (1.5, "-")):
    branches = pendula.measure.mean_velocity(
        0.0, 0.0, beta=0.2, torque=current, drive_amplitude=amplitude, drive_frequency=1.5, carry="both"
    ).mean_velocity
    for voltage, colour, name in zip(branches, ("#d55e00", "#0072b2"), ("up", "down"), strict=True):
        label = rf"$\Gamma = {amplitude:g}\,\mathrm{{s}}^{{-2}}$, {name}"
        ax.plot(current, voltage / 1.5, color=colour, linestyle=dashes, linewidth=1.2, label=label)
ax.spines[["top", "right"]].set_visible(False)
ax.set(xlabel=r"$\mu$ [s$^{-2}$]", ylabel=r"$\langle\omega\rangle/\Omega$", xlim=(0, 1), ylim=(0, None))
ax.legend(frameon=False)
figure.savefig(Path(sys.argv[1], "shapiro.svg"))
