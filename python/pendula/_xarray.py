"""Solutions as xarray's datasets."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
import xarray

from pendula._core import version

if TYPE_CHECKING:
    from pendula._solution import Solution

UNITS = {
    "t": "s",
    "theta": "rad",
    "omega": "rad/s",
    "turns": "1",
    "theta0": "rad",
    "omega0": "rad/s",
    "alpha": "s-2",
    "beta": "s-1",
    "torque": "s-2",
    "drive_amplitude": "s-2",
    "drive_frequency": "rad/s",
    "drive_phase": "rad",
    "dt": "s",
}
LONG_NAMES = {
    "t": "time",
    "theta": "angle",
    "omega": "angular velocity",
    "turns": "whole turns",
    "theta0": "initial angle",
    "omega0": "initial angular velocity",
    "alpha": "stiffness",
    "beta": "damping",
    "torque": "constant torque",
    "drive_amplitude": "drive's amplitude",
    "drive_frequency": "drive's angular frequency",
    "drive_phase": "drive's phase",
    "dt": "longest step",
}


def attributes(name: str) -> dict[str, str]:
    """The units and the name in words of a quantity."""
    return {"units": UNITS[name], "long_name": LONG_NAMES[name]}


def own_axes(value: Any, ndim: int) -> list[int]:
    """The axes of pendulums along which a value runs."""
    shape = np.shape(value)
    return [axis + ndim - len(shape) for axis, length in enumerate(shape) if length != 1]


def dimension_names(quantities: dict[str, Any], ndim: int) -> list[str]:
    """A name for each axis of pendulums: that of the one quantity that runs along it and along no other, else axis_0, …"""
    axes = {name: own_axes(value, ndim) for name, value in quantities.items()}
    names = []
    for axis in range(ndim):
        along = [name for name, its_axes in axes.items() if axis in its_axes]
        names.append(along[0] if len(along) == 1 and len(axes[along[0]]) == 1 else f"axis_{axis}")
    return names


def dataset(solution: Solution) -> xarray.Dataset:
    """theta, omega and turns over the parameters that vary and time; those that do not vary are attributes."""
    ndim = solution.theta.ndim - 1
    parameters = solution.parameters._asdict()
    dims = dimension_names(parameters, ndim)
    shares_times = solution.t.ndim == 1
    time = "t" if shares_times else "row"
    t = (time, solution.t) if shares_times else ((*dims, time), np.broadcast_to(solution.t, solution.theta.shape))

    coordinates: dict[str, Any] = {"t": (*t, attributes("t"))}
    constants: dict[str, Any] = {"method": solution.method, "tolerance": solution.tolerance, "pendula_version": version}
    for name, value in (parameters | {"dt": solution.dt}).items():
        axes = own_axes(value, ndim)
        if axes:
            coordinates[name] = ([dims[axis] for axis in axes], np.squeeze(value), attributes(name))
        else:
            constants[name] = float(np.reshape(value, ()))
    variables = {name: ((*dims, time), getattr(solution, name), attributes(name)) for name in ("theta", "omega", "turns")}
    return xarray.Dataset(variables, coordinates, constants)
