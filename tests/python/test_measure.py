"""The measures in Python: shapes, bits and types, and a right value of each; more of them are tested beside the core."""

import re

import numpy as np
import pendula
import pytest
from doubles import same_bits
from pendula import _core, measure

DRIVEN = {"beta": 0.5, "drive_frequency": 2 / 3}
AMPLITUDES = np.array([[0.9, 1.07, 1.15], [1.35, 1.45, 1.5]])
SHORT = {"transient": 20, "periods": 8, "method": "rk4", "steps_per_period": 200}
MEASURES = {
    "section": measure.section,
    "mean_velocity": measure.mean_velocity,
    "lyapunov": lambda *start, **more: measure.lyapunov(*start, rows=3, **more),
    "attractors": measure.attractors,
}


@pytest.fixture(params=MEASURES.values(), ids=MEASURES.keys())
def measured(request):
    """A measure as a function that returns several results."""
    return lambda **more: request.param(0.2, 0.0, **DRIVEN, **SHORT, **more)


def test_a_pendulum_among_others_has_its_own_bits_on_any_number_of_threads(measured):
    together = measured(drive_amplitude=AMPLITUDES, threads=1)
    for others in (measured(drive_amplitude=AMPLITUDES, threads=3), measured(drive_amplitude=AMPLITUDES.T, threads=2)):
        for one, other in zip(together, others, strict=True):
            back = other if other.shape[:2] == AMPLITUDES.shape else np.moveaxis(other, 0, 1)
            assert same_bits(one, back)
    for index in np.ndindex(AMPLITUDES.shape):
        alone = measured(drive_amplitude=float(AMPLITUDES[index]))
        for one, many in zip(alone, together, strict=True):
            assert same_bits(one, many[index])


def test_rows_come_last():
    assert measure.section(0.2, 0.0, drive_amplitude=AMPLITUDES, **DRIVEN, **SHORT).theta.shape == (2, 3, 8)
    assert measure.lyapunov(0.2, 0.0, drive_amplitude=AMPLITUDES, rows=3, **DRIVEN, **SHORT).history.shape == (2, 3, 3)
    assert measure.section(0.2, 0.0, **SHORT).theta.shape == (8,)
    assert measure.section([], 0.0, **SHORT).theta.shape == (0, 8)


def test_one_pendulum_gives_numbers_and_a_word():
    velocity = measure.mean_velocity(0.2, 0.0, **SHORT)
    assert isinstance(velocity.mean_velocity + velocity.error, np.float64)
    assert velocity.kind is pendula.Kind.conservative
    exponents = measure.lyapunov(0.2, 0.0, **SHORT)
    assert isinstance(exponents.exponent + exponents.horizon, np.float64)
    assert exponents.history.shape == (0,)
    assert isinstance(measure.attractors(0.2, 0.0, **SHORT).label, np.int64)


def test_several_pendulums_give_kinds_as_whole_numbers():
    kind = measure.mean_velocity(0.2, 0.0, beta=[0.5, 0.0], **SHORT).kind
    assert kind.dtype == np.int8
    assert [pendula.Kind(k).name for k in kind] == ["fixed_point", "conservative"]


def test_the_history_of_an_exponent_that_is_known_is_this_exponent():
    found = measure.lyapunov(0.2, 0.0, drive_amplitude=[0.9, 1.5], rows=4, **DRIVEN)
    assert [pendula.Kind(k).name for k in found.kind] == ["periodic", "chaotic"]
    assert np.all(found.history[0] == found.exponent[0])
    assert np.unique(found.history[1]).size == 4


def test_labels_are_of_each_pendulum_by_itself():
    starts = np.linspace(-3, 3, 7)
    long = {"transient": 300, "periods": 64, "method": "rk4", "steps_per_period": 200}
    together = measure.attractors(starts, 0.0, drive_amplitude=[[1.07], [0.9]], **DRIVEN, **long).label
    for row, amplitude in zip(together, (1.07, 0.9), strict=True):
        assert same_bits(row, measure.attractors(starts, 0.0, drive_amplitude=amplitude, **DRIVEN, **long).label)
    assert set(together[1]) == {1}


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"periods": 0}, "periods must be a whole number from 1 to 2^53, got 0"),
        ({"periods": 2.5}, "periods must be a whole number from 1 to 2^53, got 2.5"),
        ({"transient": -1}, "transient must be a whole number from 0 to 2^53, got -1"),
        ({"steps_per_period": 2, "method": "rk4"}, "steps_per_period must be at least "),
        ({"method": "exact"}, "method must be one of taylor, rk4, got 'exact'"),
        ({"method": "rk5"}, "method must be one of taylor, rk4, got 'rk5'; did you mean 'rk4'?"),
        ({"plane": "thta"}, "plane must be one of strobe, theta, omega, got 'thta'; did you mean 'theta'?"),
        ({"direction": "rising"}, "direction is for a section by a plane: it needs plane theta or omega"),
        ({"level": 1.0}, "level is for a section by a plane: it needs plane theta or omega"),
        ({"plane": "theta", "method": "rk4"}, "plane needs method taylor, which finds the crossings between its steps"),
        ({"steps_per_period": 100}, "steps_per_period does not go with method taylor"),
        ({"tolerance": 0.1, "method": "rk4"}, "tolerance does not go with method rk4"),
        ({"plane": "theta", "direction": 3}, "direction must be one of both, rising, falling, got 3"),
        ({"carry": "upp"}, "carry must be one of up, down, both, or None, got 'upp'"),
        ({"threads": -1}, "threads must be a whole number from 1 to 256, got -1"),
        ({"alpha": [1.0, 0.0]}, r"alpha must be positive and finite, got 0 at index (1,)"),
        (
            {"drive_amplitude": 1.0},
            "a drive or a shaken pivot needs a frequency: drive_frequency must be positive and finite, got 0",
        ),
    ],
)
def test_what_cannot_be_measured_is_said(given, message):
    with pytest.raises(ValueError, match=f"^{re.escape(message)}"):
        measure.section(0.2, 0.0, **{"periods": 4} | given)


def test_each_pendulum_is_checked_as_if_it_stood_alone():
    frequencies = np.linspace(0, 1, 1001)  # the strobe's period is 6283 units of time at the second, 6.3 at the first and last
    with pytest.raises(ValueError, match=r"^pendulum at index \(1,\): steps_per_period must be at least 2229, .*method taylor"):
        measure.mean_velocity(1.0, 0.0, drive_frequency=frequencies, transient=2, periods=5, method="rk4")


@pytest.mark.parametrize("name", ["transient", "periods", "steps_per_period", "tolerance"])
def test_a_setting_that_is_no_number_is_a_type_error(name):
    with pytest.raises(TypeError, match=f"^{name} must be a real number, got <U1 '3'$"):
        measure.section(0.2, 0.0, **{name: "3", "method": "taylor" if name == "tolerance" else "rk4"})


def test_a_history_has_no_more_rows_than_periods():
    with pytest.raises(ValueError, match=r"^rows must be a whole number from 0 to 2, got 6$"):
        measure.lyapunov(0.2, 0.0, periods=2, rows=6)


def test_results_have_the_columns_of_the_core():
    for info in _core.measures:
        found = getattr(measure, info.name)(1.5, 0.0, beta=0.5, drive_amplitude=8.0, drive_frequency=2 / 3)
        assert found._fields == tuple(column.name for column in info.columns)


@pytest.mark.parametrize("info", _core.measures, ids=lambda info: info.name)
def test_a_measure_takes_the_settings_that_it_uses_and_no_others(info):
    own = {each.name for each in info.settings}
    others = {each.name for other in _core.measures for each in other.settings} - own
    for name in others:
        with pytest.raises(TypeError, match=rf"^'{name}' is no argument of {info.name}; "):
            getattr(measure, info.name)(0.2, 0.0, **{name: 1})
    with pytest.raises(TypeError, match=r"^plane is no setting of orbit$"):
        _core.measure("orbit", {"plane": "theta"})


def test_sweeps_are_carried_along_the_last_axis_and_both_ways_along_a_new_one():
    torque = np.linspace(0.05, 1.15, 12)
    junctions = {"torque": torque, "beta": [[0.2], [0.3]]}
    both = measure.mean_velocity(0.0, 0.0, carry="both", **junctions)
    assert both.mean_velocity.shape == (2, 2, 12)
    for one, order in zip(both.mean_velocity, ("up", "down"), strict=True):
        assert same_bits(one, measure.mean_velocity(0.0, 0.0, carry=order, **junctions).mean_velocity)
    up, down = both.mean_velocity[:, 0]
    assert same_bits(up > 0.5, torque > 1)  # the fixed point vanishes where the torque is alpha
    assert same_bits(down > 0.5, torque > 4 * 0.2 / np.pi)  # the limit cycle, to first order in beta
    assert measure.section(0.0, 0.0, carry="both", periods=3, **junctions).theta.shape == (2, 2, 12, 3)
    assert measure.attractors(0.0, 0.0, beta=0.2, carry="both").label.tolist() == [1, 1]
    assert measure.mean_velocity(0.0, 0.0, torque=[], carry="up").error.shape == (0,)


def test_a_section_by_a_plane_lies_on_it_at_times_of_the_period():
    period = pendula.analyze(0.2, 0.0).tau
    found = measure.section(0.2, 0.0, plane="theta", level=0.1, direction="rising", transient=0, periods=5)
    assert np.all(abs(found.theta - 0.1) <= 1e-14)
    assert np.all(found.omega > 0)
    assert np.all(abs(np.diff(found.t) - period) <= 1e-12)
    with pytest.warns(RuntimeWarning, match=r"^section: results are nan for 1 of 1 pendulum\. They do not cross the plane"):
        assert np.isnan(measure.section(0.2, 0.0, plane="omega", level=5.0, periods=2).t).all()


def test_the_phase_of_the_strobe_shifts_its_times():
    driven = {"beta": 0.5, "drive_amplitude": 0.9, "drive_frequency": 2.0, "transient": 0, "periods": 2}
    assert np.all(abs(measure.section(0.2, 0.0, strobe_phase=np.pi / 2, **driven).t - [np.pi / 4, 5 * np.pi / 4]) <= 1e-15)


def test_a_jump_is_where_the_fixed_point_vanishes():
    found = measure.jumps(0.0, 0.0, beta=0.2, torque=[0.1, 0.5, 0.9, 1.1], jump_tolerance=1e-9)
    assert np.flatnonzero(~np.isnan(found.value)).tolist() == [3]
    assert found.error[3] <= 1e-9
    assert abs(found.value[3] - 1) <= 1e-6  # early by what the budget leaves unsettled
    assert found.before.tolist() == [-1, -1, -1, pendula.Kind.fixed_point]


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"torque": 0.5}, "just one parameter must vary along the last axis, got none"),
        ({"torque": [0.5, 1.5], "beta": [0.1, 0.2]}, "just one parameter must vary along the last axis, got beta, torque"),
        ({"torque": [0.5, 1.5], "carry": "sideways"}, "carry must be one of up, down, both, or None, got 'sideways'"),
        ({"torque": [0.5, 1.5], "jump_tolerance": 0}, "jump_tolerance must be positive and finite, got 0"),
        ({"drive_phase": [0.5, 1.5]}, "the parameter along the last axis must be one of alpha, beta, torque"),
    ],
)
def test_what_has_no_jumps_is_said(given, message):
    with pytest.raises(ValueError, match=f"^{re.escape(message)}"):
        measure.jumps(0.0, 0.0, **{"jump_tolerance": 1e-6, "beta": 0.2} | given)


def test_an_overdamped_junction_has_the_voltage_of_the_closed_formula():
    """Stewart and McCumber: √(μ² − α²)/β, to a relative order of β⁻⁴."""
    found = measure.mean_velocity(0.0, 0.0, torque=1.5, beta=100)
    assert found.kind is pendula.Kind.rotating
    assert found.error < 1e-9
    assert abs(found.mean_velocity - np.sqrt(1.5**2 - 1) / 100) < 1e-9


def test_a_damped_pendulum_has_the_exponents_of_its_linear_equation():
    found = measure.lyapunov(0.2, 0.0, beta=[0.2, 3.0])
    larger = np.array([-0.1, (-3 + np.sqrt(5)) / 2])
    assert np.all(abs(found.exponent - larger) <= found.error + 4 * np.spacing(1.0))  # the formulas are rounded too
    assert np.all(abs(found.second - ([-0.2, -3.0] - larger)) <= found.error + 8 * np.spacing(1.0))
    assert np.all(found.horizon == np.inf)
    assert found.dimension.tolist() == [0, 0]


def test_floquets_multipliers_have_the_product_that_friction_gives():
    found = measure.orbit(1.5, 0.0, beta=0.5, drive_amplitude=[7.8, 8.0], drive_frequency=2 / 3)
    assert np.all(abs(found.first * found.second / np.exp(-0.5 * 3 * np.pi) - 1) <= 1e-9)  # a difference of large numbers
    assert np.all(found.error < 1e-9)


def test_shares_have_wilsons_errors():
    found = measure.shares([[1, 1, 2, 1], [2, 2, 2, 2]], axis=1)
    assert found.states.tolist() == [[0, 3, 1], [0, 0, 4]]
    assert found.share.tolist() == [[0, 0.75, 0.25], [0, 0, 1]]
    z = 1.96
    # Wilson's interval for 0 of n ends at z²/(n + z²).
    assert np.all(abs(found.error[1] - z**2 / (4 + z**2)) <= 1e-15)
    assert measure.shares([1, 2, 2, 2]).states.tolist() == [0, 1, 3]
    for bad in ([], [0.5], [-1, 2]):
        with pytest.raises(ValueError, match=r"^label must be whole numbers from 0, and not empty$"):
            measure.shares(bad)


def test_a_driven_pendulum_has_no_closed_form():
    solution = pendula.solve(0.2, 0.0, drive_amplitude=1.0, **DRIVEN, dt=0.1, every=1, until=2)
    assert solution.analysis is None
    for name in ("sine", "error"):
        with pytest.raises(ValueError, match=f"^{name} needs pendulums without friction and forcing"):
            getattr(solution, name)


def test_no_pendulums_have_no_results_at_once():
    assert pendula.measure.section(np.zeros(0), 0.0, transient=0, periods=2**50).theta.size == 0
