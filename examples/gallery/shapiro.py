"""The current-voltage curve of a Josephson junction in microwaves, with Shapiro steps: shapiro.py DIRECTORY.

The torque is the bias current, the mean velocity the voltage: it locks to whole multiples of the drive's frequency.
"""

import sys
from pathlib import Path

import numpy as np
import pendula
from matplotlib import pyplot

current = np.linspace(0, 2.5, 800)
figure, ax = pyplot.subplots(figsize=(7, 4.5), layout="constrained")
for step in range(1, 4):
    ax.axhline(step, color="0.85", linewidth=0.8, zorder=0)
for amplitude, colour, dashes in ((0.0, "0.45", "--"), (1.0, "#0072b2", "-")):
    found = pendula.measure.mean_velocity(0.0, 0.0, beta=1.0, torque=current, drive_amplitude=amplitude, drive_frequency=0.7)
    ax.plot(
        current,
        found.mean_velocity / 0.7,
        color=colour,
        linestyle=dashes,
        label=rf"$\Gamma = {amplitude:g}\,\mathrm{{s}}^{{-2}}$",
    )
ax.spines[["top", "right"]].set_visible(False)
ax.set(xlabel=r"$\mu$ [s$^{-2}$]", ylabel=r"$\langle\omega\rangle/\Omega$", xlim=(0, 2.5), ylim=(0, None))
ax.legend(frameon=False)
figure.savefig(Path(sys.argv[1], "shapiro.svg"))
