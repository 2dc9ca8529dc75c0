"""The pendulum, exactly and step by step, with the same bits everywhere."""

from pendula._closed_form import Analysis, Regime, analyze, exact
from pendula._core import version as __version__

__all__ = ["Analysis", "Regime", "__version__", "analyze", "exact"]
