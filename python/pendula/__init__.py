"""The pendulum, exactly and step by step, with the same bits everywhere."""

from pendula import measure, plot
from pendula._arguments import Parameters
from pendula._closed_form import Analysis, Regime, analyze, exact
from pendula._core import version as __version__
from pendula._solution import Solution
from pendula._solve import solve

__all__ = ["Analysis", "Parameters", "Regime", "Solution", "__version__", "analyze", "exact", "measure", "plot", "solve"]
