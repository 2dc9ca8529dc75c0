"""What a solution holds, and what becomes of it in xarray."""

import numpy as np
import pendula
import pytest
from doubles import same_bits

xarray = pytest.importorskip("xarray")

TIMES = {"dt": 0.01, "every": 0.5, "until": 5}


def test_a_solution_knows_its_pendulums():
    solution = pendula.solve([0.5, 3.0], 0.0, alpha=2.0, method="verlet", **TIMES)
    assert same_bits(solution.analysis.tau, pendula.analyze([0.5, 3.0], 0.0, alpha=2.0).tau)
    assert solution.parameters.alpha == 2.0
    assert (solution.method, solution.dt) == ("verlet", 0.01)
    assert repr(solution) == "<pendula.Solution by verlet: 11 times of pendulums of shape (2,)>"


def test_the_unwrapped_angle_counts_turns():
    solution = pendula.solve(0.0, [3.0, -3.0], method="exact", **TIMES)
    assert same_bits(solution.unwrapped, pendula.exact(0.0, [[3.0], [-3.0]], solution.t)[0])
    assert np.all(np.diff(solution.unwrapped) * [[1], [-1]] > 0)


def test_axes_bear_the_names_of_the_parameters_that_run_along_them():
    alpha, theta0 = np.array([[1.0], [2.0]]), np.array([0.1, 0.2, 0.3])
    data = pendula.solve(theta0, 0.0, alpha=alpha, **TIMES).to_xarray()
    assert data.theta.dims == ("alpha", "theta0", "t")
    assert same_bits(data.sel(alpha=2.0, theta0=0.3).theta, pendula.solve(0.3, 0.0, alpha=2.0, **TIMES).theta)


def test_an_axis_of_several_parameters_bears_a_number():
    data = pendula.solve([0.1, 0.2], [0.0, 1.0], **TIMES).to_xarray()
    assert data.theta.dims == ("axis_0", "t")
    assert same_bits(data.theta0, [0.1, 0.2])
    assert same_bits(data.omega0, [0.0, 1.0])


def test_pendulums_with_times_of_their_own_have_rows():
    data = pendula.solve([0.1, 3.0], 0.0, dt=0.01).to_xarray()
    assert data.t.dims == ("theta0", "row")
    assert data.theta.dims == ("theta0", "row")


def test_everything_has_units_and_a_run_can_be_repeated_from_its_attributes():
    data = pendula.solve([0.1, 0.2], 0.5, alpha=2.0, **TIMES).to_xarray()
    units = {name: data[name].attrs["units"] for name in data.variables}
    assert {data[name].attrs["long_name"] for name in ("t", "theta0")} == {"time", "initial angle"}
    assert units == {"theta": "rad", "omega": "rad/s", "turns": "1", "t": "s", "theta0": "rad"}
    assert data.attrs["pendula_version"] == pendula.__version__
    parameters = {name: data.attrs[name] for name in pendula.Parameters._fields if name in data.attrs}
    again = pendula.solve(theta0=data.theta0, **parameters, t=data.t, method=data.attrs["method"], dt=data.attrs["dt"])
    assert same_bits(again.theta, data.theta)
