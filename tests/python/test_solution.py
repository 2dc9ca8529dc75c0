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


# Thirty pictures a second, to a thousandth of a second, some of them twice, and a late one.
MEASURED = np.concatenate([np.repeat(np.round(np.arange(0, 3, 1 / 30), 3), 2)[1:], [6.0]])
# Of the states at those times by steps of 0.001, of orders 4, 1 and 2.
BOUNDS = {"rk4": 1e-11, "euler": 0.05, "verlet": 1e-5, "taylor": 1e-13, "exact": 1e-14}


@pytest.mark.parametrize("method", BOUNDS)
def test_measured_times_have_the_states_of_the_closed_form(method):
    solution = pendula.solve([[0.5], [2.0]], [0.0, 1.0], t=MEASURED, method=method, dt=0.001)
    assert same_bits(solution.t, MEASURED)
    assert abs(solution.error).max() <= BOUNDS[method]
    assert same_bits(solution.theta[..., 1], solution.theta[..., 2])  # the same time, the same state


@pytest.mark.parametrize("method", ["rk4", "taylor"])
def test_a_driven_pendulum_at_measured_times_is_that_at_each_time_alone(method):
    given = {"beta": 0.3, "drive_amplitude": 1.2, "drive_frequency": 0.7, "method": method, "dt": 0.001}
    times = [0.5, 0.501, 2.0, 2.0, 7.25]
    together = pendula.solve([0.1, 2.0], 0.0, t=times, **given)
    for j, t in enumerate(times):
        alone = pendula.solve([0.1, 2.0], 0.0, t=[t], **given)
        # Steps of rk4 begin anew at each time: its error is 1e-13 there.
        assert abs(together.theta[:, j] - alone.theta[:, 0]).max() <= (1e-12 if method == "rk4" else 0)


@pytest.mark.parametrize("method", BOUNDS)
@pytest.mark.parametrize(
    "t", [np.arange(0, 3, 1 / 30, dtype=np.float32), [0, 1, 1, 5], [2.5, 2.5], (0.1, 7), np.float32([1, 4])]
)
def test_times_of_any_type_are_taken_as_they_are(method, t):
    solution = pendula.solve(1.0, 0.0, t=t, method=method, dt=0.01)
    assert solution.t.dtype == np.float64
    assert np.all(abs(solution.t - np.asarray(t, float)) <= np.spacing(7.0))
    assert abs(solution.error).max() <= 10 * BOUNDS[method] * {"euler": 1, "verlet": 1e2, "rk4": 1e4}.get(method, 1)


def test_steps_between_given_times_are_at_most_dt():
    """Two equal steps lead over a gap of 0.15 where dt is 0.1, by one of 0.1 to a row and over a repeated time by none."""
    h, theta = 0.075, [1.0]
    omega = 0.0
    for step in (0.1, h, h):
        theta.append(theta[-1] + omega * step)
        omega -= np.sin(theta[-2]) * step
    solution = pendula.solve(1.0, 0.0, t=[0.0, 0.1, 0.1, 0.25], dt=0.1, method="euler")
    assert np.all(abs(solution.theta - [theta[0], theta[1], theta[1], theta[3]]) <= 1e-15)


def test_pendulums_may_have_steps_of_their_own_between_given_times():
    dt, t = np.array([0.5, 0.01, 0.1]), [0.3, 0.31, 4.0]
    together = pendula.solve(1.0, 0.5, t=t, dt=dt)
    for i, each in enumerate(dt):
        assert same_bits(together.theta[i], pendula.solve(1.0, 0.5, t=t, dt=each).theta)


@pytest.mark.parametrize("method", ["rk4", "euler", "verlet", "taylor"])
@pytest.mark.parametrize(
    ("t", "message"),
    [
        ([0.0, 2.0, 1.0], r"t must not decrease, got 1 after 2 at index \(2,\)"),
        ([-0.5, 2.0, 3.0], r"t must be finite and not negative, got -0.5 at index \(0,\)"),
        ([0.0, np.nan], r"t must be finite, got nan at index \(1,\)"),
        ([[0.0, 1.0]], r"t must have one axis, got shape \(1, 2\)"),
        (1.0, r"t must have one axis, got shape \(\)"),
    ],
)
def test_bad_times_are_refused_with_index_and_value(method, t, message):
    with pytest.raises(ValueError, match=f"^{message}$"):
        pendula.solve([1.0, 2.0], 0.0, t=t, method=method)


def test_steps_between_given_times_must_be_stable():
    with pytest.raises(ValueError, match=r"^every/dt must be at least 2, or the method is unstable, got 1"):
        pendula.solve(1.0, 0.0, t=[0.0, 1.0, 4.5], dt=5.0, beta=1.0)
