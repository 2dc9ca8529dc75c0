"""What `solve` returns."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from pendula import _core
from pendula._arguments import Array, Parameters, along_time
from pendula._closed_form import Analysis, analyze

if TYPE_CHECKING:
    import xarray
    from matplotlib.axes import Axes


@dataclass(frozen=True, eq=False)
class Solution:
    """Trajectories of pendulums: arrays [..., time]."""

    t: Array
    """Times [s]; the last axis, and the only one where all pendulums share their times."""
    theta: Array
    """Angle in [-π, π) [rad]."""
    omega: Array
    """Angular velocity [rad/s]."""
    turns: Array
    """Whole turns: the unwrapped angle is theta + 2π turns."""
    parameters: Parameters
    method: str
    dt: Any
    """The longest step that was asked for [s]."""
    tolerance: float

    def __repr__(self) -> str:
        return f"<pendula.Solution by {self.method}: {self.t.shape[-1]} times of pendulums of shape {self.theta.shape[:-1]}>"

    @property
    def unwrapped(self) -> Array:
        """The angle with its turns [rad]."""
        angle: Array = _core.unwrap(self.theta, self.turns)
        return angle

    @property
    def analysis(self) -> Analysis | None:
        """What the pendulums do by themselves; None with friction or forcing."""
        if not self.parameters.is_conservative:
            return None
        return analyze(self.parameters.theta0, self.parameters.omega0, alpha=self.parameters.alpha)

    @property
    def energy(self) -> Array:
        """Energy per m l² [s⁻²]: ω²/2 + α(1 − cos θ)."""
        values: Array = _core.energy(self.theta, self.omega, along_time(self.parameters.alpha))
        return values

    @property
    def sine(self) -> Array:
        """The sinusoid (3.4) of the same amplitude, period and phase [rad], in [-π, π); NaN unless it oscillates.

        ValueError with friction or forcing.
        """
        values: Array = _core.sine(**self._closed_form("sine"), t=self.t)
        return values

    @property
    def error(self) -> Array:
        """The angle less the closed form's [rad], in [-π, π). ValueError with friction or forcing."""
        theta, _, _ = _core.states(**self._closed_form("error"), t=self.t)
        difference: Array = _core.wrap(np.subtract(self.theta, theta))
        return difference

    def plot(self, *, ax: Axes | None = None) -> Axes:
        """Angle and angular velocity against time: `pendula.plot.time_series`."""
        from pendula.plot import time_series

        return time_series(self, ax=ax)

    def to_xarray(self) -> xarray.Dataset:
        """The solution with named dimensions, coordinates, units and parameters."""
        from pendula._xarray import dataset

        return dataset(self)

    def _closed_form(self, name: str) -> dict[str, Any]:
        """The arguments of the closed form, as they broadcast against times."""
        if not self.parameters.is_conservative:
            raise ValueError(f"{name} needs beta, torque and drive_amplitude to be 0: there is no closed form")
        return self.parameters.closed_form()
