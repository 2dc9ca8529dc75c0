"""The pendulum, exactly and step by step, with the same bits everywhere."""

from . import measure, plot
from ._arguments import Parameters
from ._closed_form import Analysis, Regime, amplitude, analyze, exact, to_radians
from ._core import Kind
from ._core import version as __version__
from ._solution import Solution
from ._solve import solve

__all__ = [
    "Analysis",
    "Kind",
    "Parameters",
    "Regime",
    "Solution",
    "__version__",
    "amplitude",
    "analyze",
    "exact",
    "measure",
    "plot",
    "solve",
    "to_radians",
]
