"""A strange attractor at four phases of the drive, stretched and folded from one to the next: phases.py DIRECTORY.

The pendulum of Baker & Gollub, Chaotic dynamics (Cambridge, 2nd edition, 1996), chapter 3, with their q = 4 and g = 1.5.
"""

import sys
from pathlib import Path

import numpy as np
import pendula
from matplotlib import pyplot

figure, axes = pyplot.subplots(2, 2, figsize=(8, 6), sharex=True, sharey=True, layout="constrained")
for quarter, ax in enumerate(axes.flat):
    states = pendula.measure.section(
        np.linspace(-1, 1, 64),
        0.0,
        beta=0.25,
        drive_amplitude=1.5,
        drive_frequency=2 / 3,
        strobe_phase=quarter * np.pi / 2,
        transient=100,
        periods=400,
    )
    pendula.plot.section(states.theta, states.omega, ax=ax, markersize=0.6)
    ax.set_title(rf"$\Omega t = {('0', 'π/2', 'π', '3π/2')[quarter]}$", fontsize="medium")
    ax.label_outer()
figure.savefig(Path(sys.argv[1], "phases.png"), dpi=150)
