"""What a solution holds, and what becomes of it in xarray."""

import sys
from xml.etree import ElementTree

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


def test_a_dataset_has_the_energies():
    solution = pendula.solve([0.1, 0.2], 0.5, **TIMES)
    assert same_bits(solution.to_xarray().energy, solution.energy)


def test_a_table_has_a_row_for_each_pendulum_and_time():
    solution = pendula.solve([0.1, 0.2], 0.5, alpha=[[1.0], [2.0]], **TIMES)
    table = solution.to_dataframe()
    assert list(table) == ["theta0", "alpha", "t", "theta", "omega", "turns", "energy"]
    one = table[(table.theta0 == 0.2) & (table.alpha == 2.0)]
    assert same_bits(one.theta, solution.theta[1, 1])
    assert same_bits(one.t, solution.t)
    assert same_bits(pendula.solve(0.1, 0.0, **TIMES).to_dataframe().energy, pendula.solve(0.1, 0.0, **TIMES).energy)


@pytest.mark.parametrize(("module", "convert"), [("xarray", "to_xarray"), ("pandas", "to_dataframe")])
def test_a_missing_module_is_told_with_what_to_install(monkeypatch, module, convert):
    monkeypatch.setitem(sys.modules, module, None)
    with pytest.raises(ImportError, match=rf"^{convert} needs {module}; install it with: pip install 'pendula\[{module}\]'$"):
        getattr(pendula.solve(0.1, 0.0, **TIMES), convert)()


def test_a_notebook_shows_the_parameters_and_some_rows():
    shown = pendula.solve([0.5, 3.0], 0.0, alpha=2.0, **TIMES)._repr_html_()
    assert "by rk4, dt = 0.01; theta0: (2,), omega0 = 0, alpha = 2" in shown
    assert "11 times of pendulums of shape (2,)" in shown
    rows = ElementTree.fromstring(f"<div>{shown}</div>").findall(".//tbody/tr")
    assert [row[0].text for row in rows] == ["0", "0.5", "1", "…", "4", "4.5", "5"]
    assert rows[0][1].text == "0.5"
    assert "<table>" not in pendula.solve([], 0.0, **TIMES)._repr_html_()


def test_everything_has_units_and_a_run_can_be_repeated_from_its_attributes():
    data = pendula.solve([0.1, 0.2], 0.5, alpha=2.0, **TIMES).to_xarray()
    units = {name: data[name].attrs["units"] for name in data.variables}
    assert {data[name].attrs["long_name"] for name in ("t", "theta0")} == {"time", "initial angle"}
    assert units == {"theta": "rad", "omega": "rad/s", "turns": "1", "energy": "s-2", "t": "s", "theta0": "rad"}
    assert data.attrs["pendula_version"] == pendula.__version__
    parameters = {name: data.attrs[name] for name in pendula.Parameters._fields if name in data.attrs}
    again = pendula.solve(theta0=data.theta0, **parameters, t=data.t, method=data.attrs["method"], dt=data.attrs["dt"])
    assert same_bits(again.theta, data.theta)
