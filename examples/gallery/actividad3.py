"""The assignment's figures 3.1 to 3.4: actividad3.py DIRECTORY."""

import sys
from pathlib import Path

import pendula
from matplotlib import pyplot

DEGREES_90 = 1.5707963267948966
PROBLEMS = {  # θ0, ω0, factorcout
    "figura_3_1": (DEGREES_90, 0.0, 0.02),
    "figura_3_2": (0.0, 1.999999895801368, 0.005),
    "figura_3_3": (0.0, -2.0, 0.02),
    "figura_3_4": (0.0, 2.01, 0.02),
}

for name, (theta0, omega0, every) in PROBLEMS.items():
    tau = pendula.analyze(theta0, omega0).tau
    solution = pendula.solve(theta0, omega0, every=every * tau)
    figure, (series, portrait) = pyplot.subplots(1, 2, figsize=(10, 3.8), layout="constrained")
    pendula.plot.time_series(solution, ax=series)
    pendula.plot.phase_portrait(solution, ax=portrait)
    figure.savefig(Path(sys.argv[1], f"{name}.svg"))
