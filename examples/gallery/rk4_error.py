"""The error of each method against its step, after one period from 90°: rk4_error.py DIRECTORY."""

import sys
from pathlib import Path

import numpy as np
import pendula
from matplotlib import pyplot

theta0 = np.pi / 2
tau = pendula.analyze(theta0, 0.0).tau
steps = 2 ** np.arange(5, 18)  # a period
figure, ax = pyplot.subplots(figsize=(7, 4.5), layout="constrained")
for method, order, marker, colour in (("euler", 1, "^", "#d55e00"), ("verlet", 2, "s", "#009e73"), ("rk4", 4, "o", "#0072b2")):
    runs = [pendula.solve(theta0, 0.0, every=tau / 32, until=tau, dt=tau / n, method=method) for n in steps]
    error = [np.abs(run.error).max() for run in runs]
    ax.loglog(1 / steps, error, marker, color=colour, fillstyle="none", label=f"{method}, order {order}")
    ax.loglog(1 / steps, error[3] * (steps[3] / steps) ** order, color=colour, linewidth=0.8, zorder=0)
ax.axvline(1e-4, color="0.6", linestyle=":", zorder=0)
ax.annotate(
    "assignment", (1e-4, 1e-9), xytext=(-4, 0), textcoords="offset points", color="0.4", rotation=90, ha="right", va="top"
)
ax.spines[["top", "right"]].set_visible(False)
ax.set(xlabel=r"$\Delta t/\tau$", ylabel=r"largest error of $\theta$ [rad]", ylim=(1e-16, 10))
ax.legend(frameon=False, loc="lower right")
figure.savefig(Path(sys.argv[1], "rk4_error.svg"))
