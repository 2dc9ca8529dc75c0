"""The pendulum, exactly and step by step, with the same bits everywhere."""

from . import measure, plot
from ._arguments import Parameters
from ._closed_form import Analysis, Regime, amplitude, analyze, exact, to_radians
from ._core import Kind
from ._core import version as __version__
from ._crossings import Crossings, crossings, measured_period
from ._solution import Solution
from ._solve import solve

__all__ = [
    "Analysis",
    "Crossings",
    "Kind",
    "Parameters",
    "Regime",
    "Solution",
    "__version__",
    "amplitude",
    "analyze",
    "crossings",
    "exact",
    "measure",
    "measured_period",
    "plot",
    "solve",
    "to_radians",
]
