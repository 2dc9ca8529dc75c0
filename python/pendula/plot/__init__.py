"""Figures of pendulums. Each takes the axes to draw on, makes its own where there are none, and returns them.

They need matplotlib, the extra `plot`, which is imported only when something is drawn.
"""

from pendula.plot._animation import animate
from pendula.plot._portrait import phase_portrait
from pendula.plot._series import time_series
from pendula.plot._sweeps import bifurcation, map, section  # noqa: A004, as its name there

__all__ = ["animate", "bifurcation", "map", "phase_portrait", "section", "time_series"]
