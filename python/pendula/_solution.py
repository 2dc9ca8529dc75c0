"""What `solve` returns, and as a dataset of xarray."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from . import _core
from ._arguments import along_time
from ._closed_form import analyze

if TYPE_CHECKING:
    from collections.abc import Mapping

    import numpy.typing as npt
    import xarray
    from matplotlib.axes import Axes

    from ._arguments import Parameters
    from ._closed_form import Analysis
    from ._core import Regime
    from ._tables import Array


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
    dt: float | Array | None
    """The longest step that was asked for [s]; None by methods that have no step of a chosen length."""
    tolerance: float

    def __repr__(self) -> str:
        return f"<pendula.Solution by {self.method}: {self.t.shape[-1]} times of pendulums of shape {self.theta.shape[:-1]}>"

    @property
    def unwrapped(self) -> Array:
        """The angle with its turns [rad], rounded once."""
        return _core.unwrap(self.theta, self.turns)

    @property
    def analysis(self) -> Analysis[Regime, np.float64] | Analysis[npt.NDArray[np.int8], Array] | None:
        """What the pendulums do by themselves; None with friction or forcing."""
        if not self.parameters.is_conservative:
            return None
        return analyze(self.parameters.theta0, self.parameters.omega0, alpha=self.parameters.alpha)

    @property
    def energy(self) -> Array:
        """Energy per m l² [s⁻²]: ω²/2 + α(1 − cos θ)."""
        return _core.energy(self.theta, self.omega, along_time(self.parameters.alpha))

    @property
    def sine(self) -> Array:
        """The sinusoid (3.4) of the same amplitude, period and phase [rad], in [-π, π); NaN unless it oscillates.

        ValueError with friction or forcing.
        """
        return _core.sine(*self._closed_form("sine"), self.t)

    @property
    def error(self) -> Array:
        """The angle less the closed form's [rad], in [-π, π). ValueError with friction or forcing."""
        theta, _, _ = _core.states(*self._closed_form("error"), self.t)
        return _core.wrap(np.subtract(self.theta, theta))

    def plot(self, *, ax: Axes | None = None) -> Axes:
        """Angle and angular velocity against time: `pendula.plot.time_series`."""
        from .plot import time_series

        return time_series(self, ax=ax)

    def to_xarray(self) -> xarray.Dataset:
        """theta, omega and turns over the parameters that vary and time, with units; those that do not vary are attributes."""
        return _dataset(self)

    def _closed_form(self, name: str) -> tuple[float | Array, float | Array, float | Array]:
        """theta0, omega0 and alpha as they broadcast against times."""
        if not self.parameters.is_conservative:
            raise ValueError(f"{name} needs pendulums without friction and forcing: others have no closed form")
        parameters = self.parameters
        return along_time(parameters.theta0), along_time(parameters.omega0), along_time(parameters.alpha)


def _attributes() -> dict[str, dict[str, str]]:
    """The units and the names in words of all quantities, from the core's tables."""
    (states,) = (each.columns for each in _core.measures if each.name == "section")
    as_ascii = str.maketrans("⁻⁰¹²³", "-0123")
    rows = [("t", "s", "time"), ("dt", "s", "longest step")]
    rows += [(each.name, each.unit, each.meaning) for each in _core.parameters]
    rows += [(each.name, each.unit, each.meaning) for each in states]
    return {name: {"units": unit.translate(as_ascii), "long_name": meaning} for name, unit, meaning in rows}


def _own_axes(value: npt.ArrayLike, ndim: int) -> list[int]:
    """The axes of pendulums along which a value runs."""
    shape = np.shape(value)
    return [axis + ndim - len(shape) for axis, length in enumerate(shape) if length != 1]


def _dimension_names(quantities: Mapping[str, npt.ArrayLike], ndim: int) -> list[str]:
    """A name for each axis of pendulums: that of the one quantity that runs along it and along no other, else axis_0, …"""
    axes = {name: _own_axes(value, ndim) for name, value in quantities.items()}
    names = []
    for axis in range(ndim):
        along = [name for name, its_axes in axes.items() if axis in its_axes]
        names.append(along[0] if len(along) == 1 and len(axes[along[0]]) == 1 else f"axis_{axis}")
    return names


def _dataset(solution: Solution) -> xarray.Dataset:
    import xarray

    ndim = solution.theta.ndim - 1
    parameters: dict[str, float | Array] = solution.parameters._asdict()
    dims = _dimension_names(parameters, ndim)
    shares_times = solution.t.ndim == 1
    time = "t" if shares_times else "row"
    t = (time, solution.t) if shares_times else ((*dims, time), np.broadcast_to(solution.t, solution.theta.shape))

    attributes = _attributes()
    coordinates: dict[str, object] = {"t": (*t, attributes["t"])}
    constants: dict[str, object] = {
        "method": solution.method,
        "tolerance": solution.tolerance,
        "pendula_version": _core.version,
    }
    for name, value in (parameters if solution.dt is None else parameters | {"dt": solution.dt}).items():
        axes = _own_axes(value, ndim)
        if axes:
            coordinates[name] = ([dims[axis] for axis in axes], np.squeeze(value), attributes[name])
        else:
            constants[name] = float(np.reshape(value, ()))
    variables = {name: ((*dims, time), getattr(solution, name), attributes[name]) for name in ("theta", "omega", "turns")}
    return xarray.Dataset(variables, coordinates, constants)
