"""What `solve` returns, and as a dataset of xarray or a table of pandas."""

from __future__ import annotations

from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING

import numpy as np

from . import _core
from ._arguments import along_time
from ._closed_form import analyze
from ._words import attributes

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping

    import numpy.typing as npt
    import pandas
    import xarray
    from matplotlib.axes import Axes

    from ._arguments import Parameters
    from ._closed_form import Analysis
    from ._core import Regime
    from ._labels import Labels
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
    labels: Labels | None = field(default=None, repr=False)
    """Of the axes of pendulums, where the arguments had them."""

    def __repr__(self) -> str:
        return f"<pendula.Solution by {self.method}: {self.t.shape[-1]} times of pendulums of shape {self.theta.shape[:-1]}>"

    def _repr_html_(self) -> str:
        return _html(self)

    def with_labels(self, labels: Labels) -> Solution:
        """The same with labels, which `to_xarray` gives to the axes; the arrays of the solution stay plain."""
        return replace(self, labels=labels)

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
        """theta, omega, turns and energy over the parameters that vary and time, with units.

        Parameters that do not vary are attributes. ImportError without xarray.
        """
        return _dataset(self)

    def to_dataframe(self) -> pandas.DataFrame:
        """One row for each pendulum and time: the parameters that vary, t, theta, omega, turns and energy.

        ImportError without pandas.
        """
        return _table(self)

    def _closed_form(self, name: str) -> tuple[float | Array, float | Array, float | Array]:
        """theta0, omega0 and alpha as they broadcast against times."""
        if not self.parameters.is_conservative:
            raise ValueError(f"{name} needs pendulums without friction and forcing: others have no closed form")
        parameters = self.parameters
        return along_time(parameters.theta0), along_time(parameters.omega0), along_time(parameters.alpha)


@contextmanager
def _needing(function: str, module: str) -> Iterator[None]:
    """Says what to install where an optional module is missing."""
    try:
        yield
    except ImportError as error:
        raise ImportError(f"{function} needs {module}; install it with: pip install 'pendula[{module}]'") from error


def _html(solution: Solution) -> str:
    """The parameters, the method, the shape, and the first and the last rows of the first pendulum."""
    parameters = ", ".join(
        f"{name} = {value:g}" if isinstance(value, float) else f"{name}: {value.shape}"
        for name, value in solution.parameters._asdict().items()
    )
    step = "" if solution.dt is None else f", dt = {solution.dt:g}" if isinstance(solution.dt, float) else ", dt of each"
    step = f", tolerance = {solution.tolerance:g}" if solution.method == "taylor" else step
    pendulums, rows = solution.theta.shape[:-1], solution.theta.shape[-1]
    head = f"pendula.Solution by {solution.method}{step}; {parameters}; {rows} times of pendulums of shape {pendulums}"
    if solution.theta.size == 0:
        return f"<p>{head}</p>"
    names = ("t", "theta", "omega", "turns")
    first = [np.broadcast_to(getattr(solution, name), solution.theta.shape).reshape(-1, rows)[0] for name in names]
    shown = range(rows) if rows <= 6 else [0, 1, 2, None, rows - 3, rows - 2, rows - 1]
    lines = ["".join(f"<td>{'…' if row is None else format(column[row], '.6g')}</td>" for column in first) for row in shown]
    titles = "".join(f"<th>{name}</th>" for name in names)
    table = "".join(f"<tr>{line}</tr>" for line in lines)
    which = f"<p>The pendulum at index {(0,) * len(pendulums)}:</p>" if pendulums else ""
    return f"<p>{head}</p>{which}<table><thead><tr>{titles}</tr></thead><tbody>{table}</tbody></table>"


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
    with _needing("to_xarray", "xarray"):
        import xarray
    ndim = solution.theta.ndim - 1
    parameters: dict[str, float | Array] = solution.parameters._asdict()
    labels = solution.labels
    dims = list(labels.dims) if labels else _dimension_names(parameters, ndim)
    shares_times = solution.t.ndim == 1
    time = "t" if shares_times else "row"
    t = (time, solution.t) if shares_times else ((*dims, time), np.broadcast_to(solution.t, solution.theta.shape))

    words = attributes()
    coordinates: dict[str, object] = {**labels.coords} if labels else {}
    coordinates["t"] = (*t, words["t"])
    constants: dict[str, object] = {
        "method": solution.method,
        "tolerance": solution.tolerance,
        "pendula_version": _core.version,
    }
    for name, value in (parameters if solution.dt is None else parameters | {"dt": solution.dt}).items():
        axes = _own_axes(value, ndim)
        if axes:
            coordinates[name] = ([dims[axis] for axis in axes], np.squeeze(value), words[name])
        else:
            constants[name] = float(np.reshape(value, ()))
    names = ("theta", "omega", "turns", "energy")
    variables = {name: ((*dims, time), getattr(solution, name), words[name]) for name in names}
    return xarray.Dataset(variables, coordinates, constants)


def _table(solution: Solution) -> pandas.DataFrame:
    with _needing("to_dataframe", "pandas"):
        import pandas
    shape = solution.theta.shape
    parameters: dict[str, float | Array] = solution.parameters._asdict()
    columns: dict[str, Array] = {
        name: np.broadcast_to(along_time(value), shape) for name, value in parameters.items() if np.size(value) > 1
    }
    columns["t"] = np.broadcast_to(solution.t, shape)
    columns |= {name: getattr(solution, name) for name in ("theta", "omega", "turns", "energy")}
    return pandas.DataFrame({name: values.reshape(-1) for name, values in columns.items()})
