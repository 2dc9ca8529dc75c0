"""Figures of pendulums. Each takes the axes to draw on, makes its own where there are none, and returns them.

They need matplotlib, the extra `plot`, which is imported only when something is drawn.
"""

from pendula.plot._figures import animate, phase_portrait, time_series
from pendula.plot._sweeps import bifurcation, section
from pendula.plot._sweeps import map as map  # noqa: A004, it is called as pendula.plot.map

# Without `map`, so that `from pendula.plot import *` leaves Python's own in place.
__all__ = ["animate", "bifurcation", "phase_portrait", "section", "time_series"]
