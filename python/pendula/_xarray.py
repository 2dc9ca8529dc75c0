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
}


def attributes(name: str) -> dict[str, str]:
    """The units and the name in words of a quantity."""
    return {"units": UNITS[name], "long_name": LONG_NAMES[name]}


def dimension_names(parameters: Any, ndim: int) -> list[str]:
    """A name for each axis of pendulums: that of the one parameter that runs along it and along no other, else axis_0, …"""
    runs = {
        name: [axis + ndim - np.ndim(value) for axis in range(np.ndim(value)) if np.shape(value)[axis] > 1]
        for name, value in parameters._asdict().items()
    }
    names = []
    for axis in range(ndim):
        along = [name for name, axes in runs.items() if axis in axes]
        names.append(along[0] if len(along) == 1 and len(runs[along[0]]) == 1 else f"axis_{axis}")
    return names


def dataset(solution: Solution) -> xarray.Dataset:
    """theta, omega and turns over the parameters that vary and time; those that do not vary are attributes."""
    ndim = solution.theta.ndim - 1
    dims = dimension_names(solution.parameters, ndim)
    time = "t" if solution.t.ndim == 1 else "row"
    variables = {name: ((*dims, time), getattr(solution, name), attributes(name)) for name in ("theta", "omega", "turns")}
    t_dims = (*dims[ndim - (solution.t.ndim - 1) :], time)
    coordinates: dict[str, Any] = {"t": (t_dims, solution.t, attributes("t"))}
    constants: dict[str, Any] = {}
    for name, value in solution.parameters._asdict().items():
        if np.size(value) == 1:
            constants[name] = float(np.reshape(value, ()))
        else:
            own = dims[ndim - np.ndim(value) :]
            kept = [axis for axis in range(np.ndim(value)) if np.shape(value)[axis] > 1]
            coordinates[name] = ([own[axis] for axis in kept], np.squeeze(value), attributes(name))
    settings = {"method": solution.method, "tolerance": solution.tolerance, "pendula_version": version}
    return xarray.Dataset(variables, coordinates, constants | settings)
