"""Arrays of every kind: what is legal is taken as it is, all else is named."""

import inspect
import math
import pydoc
import re
from dataclasses import replace
from fractions import Fraction

import numpy as np
import pendula
import pytest
from doubles import same_bits
from pendula import _core, measure

PI_LOW = Fraction(12246467991473532, 10**32)  # what the double of pi lacks
THETA = np.linspace(-3, 3, 12).reshape(3, 4)
PLAIN = pendula.exact(THETA, 0.5, 2.0)


def unaligned(values):
    raw = np.zeros(values.nbytes + 1, np.uint8)[1:].view(float).reshape(values.shape)
    raw[...] = values
    assert not raw.flags.aligned
    return raw


def read_only(values):
    copy = values.copy()
    copy.flags.writeable = False
    return copy


SAME_VALUES = {
    "Fortran's order": np.asfortranarray(THETA),
    "every other of a larger array": np.repeat(THETA, 2, axis=1)[:, ::2],
    "reversed twice": THETA[::-1, ::-1].copy()[::-1, ::-1],
    "the other byte order": THETA.astype(">f8"),
    "unaligned": unaligned(THETA),
    "read-only": read_only(THETA),
    "lists": THETA.tolist(),
    "long double": THETA.astype(np.longdouble),
}


@pytest.mark.parametrize("array", SAME_VALUES.values(), ids=SAME_VALUES.keys())
def test_values_count_and_not_how_they_are_stored(array):
    assert same_bits(pendula.exact(array, 0.5, 2.0), PLAIN)
    assert same_bits(pendula.analyze(array, 0.5).tau, pendula.analyze(THETA, 0.5).tau)
    solution = pendula.solve(array, 0.5, dt=0.1, every=1, until=2)
    assert same_bits(solution.theta, pendula.solve(THETA, 0.5, dt=0.1, every=1, until=2).theta)


@pytest.mark.parametrize("dtype", [np.float16, np.float32, np.int8, np.int64, np.uint64, np.bool_])
def test_other_real_numbers_become_float64(dtype):
    values = np.array([0, 1], dtype)
    theta, omega = pendula.exact(values, values, values)
    assert theta.dtype == omega.dtype == np.float64
    assert same_bits((theta, omega), pendula.exact([0.0, 1.0], [0.0, 1.0], [0.0, 1.0]))


def test_scalars_give_scalars_and_arrays_arrays():
    assert all(isinstance(value, np.float64) for value in pendula.exact(1, 0.5, np.array(2.0)))
    assert isinstance(pendula.analyze(1, 0).regime, pendula.Regime)
    assert pendula.exact([1], 0.5, 2)[0].shape == (1,)
    assert pendula.exact(np.empty((0, 3)), 0.5, 2)[0].shape == (0, 3)


@pytest.mark.parametrize("method", ["rk4", "taylor", "exact"])
@pytest.mark.parametrize("dt", [{}, {"dt": 0.1}, {"dt": []}], ids=["no dt", "one dt", "dt of each"])
def test_no_pendulums_have_the_rows_of_any(method, dt):
    solution = pendula.solve([], 0.0, every=0.5, until=5, method=method, **dt)
    assert solution.theta.shape == (0, 11)
    assert solution.t.shape == (11,)
    assert pendula.solve([], 0.0, t=[0.0, 1.0], method=method, **dt).theta.shape == (0, 2)


def test_arguments_are_not_written_to():
    times = np.linspace(0, 9, 10)
    before = times.copy()
    pendula.exact(THETA[..., None], 0.5, times)
    pendula.solve(THETA, 0.5, t=times, dt=0.1)
    assert same_bits(times, before)


@pytest.mark.parametrize(
    "value",
    ["1", b"1", None, 1j, [1, None], np.datetime64("2000"), 10**400, object(), {}, [THETA, "x"]],
    ids=lambda v: type(v).__name__,
)
def test_what_is_no_real_number_is_a_type_error_that_names_the_argument(value):
    if isinstance(value, list) and isinstance(value[0], np.ndarray):
        value = np.array(value, dtype=object)
    for call in (lambda: pendula.exact(1, value, 2), lambda: pendula.solve(1, value), lambda: pendula.analyze(1, value)):
        with pytest.raises(TypeError, match=r"^omega0 must be real numbers, got "):
            call()


def test_masks_are_refused_and_not_ignored():
    masked = np.ma.array([1.0, 2.0], mask=[False, True])
    with pytest.raises(TypeError, match=r"^omega0 must be real numbers, got a masked array, whose masks would be ignored; "):
        pendula.analyze(1, [masked, (masked, masked)])
    for call in (lambda: pendula.exact(1, masked, 2), lambda: pendula.solve(1, masked), lambda: measure.section(1, masked)):
        with pytest.raises(
            TypeError, match=r"numpy\.ma\.filled puts values in their places, and compressed\(\) leaves them out$"
        ):
            call()


@pytest.mark.parametrize("value", [b"abc", "x", None, np.array(["2000"], dtype="M8"), {}])
def test_the_extension_itself_refuses_what_is_no_real_number(value):
    with pytest.raises(TypeError, match=r"^theta must be real numbers, got "):
        _core.wrap(value)


def test_the_extension_itself_converts_other_formats():
    solution = pendula.solve([1.0, -2.0], [0.5, 3.0], dt=0.1, every=1, until=5)
    single = replace(solution, theta=solution.theta.astype("f4"))
    assert same_bits(single.unwrapped, replace(solution, theta=single.theta.astype(float)).unwrapped)


def test_a_name_that_is_no_argument_is_told_with_the_nearest_or_with_all():
    near, far = {"betta": 1.0}, {"xyz": 1.0}
    for call in (pendula.solve, measure.section, measure.lyapunov, pendula.Parameters):
        with pytest.raises(TypeError, match=rf"^'betta' is no argument of {call.__name__}; did you mean 'beta'\?$"):
            call(0.2, 0.0, **near)
        with pytest.raises(
            TypeError, match=rf"^'xyz' is no argument of {call.__name__}; its arguments are theta0, omega0, alpha"
        ):
            call(0.2, 0.0, **far)


FUNCTIONS = [pendula.solve, *(getattr(measure, info.name) for info in _core.measures), measure.jumps]


@pytest.mark.parametrize("function", FUNCTIONS, ids=lambda function: function.__name__)
def test_signatures_and_docs_name_every_argument_with_its_default(function):
    shown = inspect.signature(function).parameters
    for each in _core.parameters:
        assert shown[each.name].default == (inspect.Parameter.empty if each.is_initial else each.default)
        line = f"{each.name}: {each.symbol}, {each.meaning} [{each.unit}]"
        assert re.search(rf"^    {re.escape(line)}", function.__doc__, re.MULTILINE)
    assert not any(each.kind == each.VAR_KEYWORD for each in shown.values())
    for name in shown:
        assert re.search(rf"\b{name}\b", function.__doc__), name


def test_measures_show_the_cores_defaults():
    for info in _core.measures:
        shown = inspect.signature(getattr(measure, info.name)).parameters
        assert {each.name: shown[each.name].default for each in info.settings} == {s.name: s.default for s in info.settings}
        assert shown["method"].default == "taylor"


def test_help_begins_with_the_call_and_has_no_types_in_it():
    first = pydoc.plain(pydoc.TextDoc().document(pendula.solve)).splitlines()[0]
    assert first.startswith("solve(theta0, omega0, *, alpha=1.0, gravity=None, length=None, beta=0.0, torque=0.0, ")
    assert "[" not in first


def test_gravity_and_length_give_alpha():
    length = np.array([0.5, 1.0])
    tau = pendula.analyze(1, 0, alpha=9.81 / length).tau
    assert same_bits(pendula.analyze(1, 0, gravity=9.81, length=length).tau, tau)
    assert same_bits(pendula.Parameters(1, 0, gravity=9.81, length=length).alpha, 9.81 / length)
    assert pendula.solve(1, 0, gravity=9.81, length=2).parameters.alpha == 9.81 / 2
    assert pendula.exact(1, 0, 1, gravity=8, length=2) == pendula.exact(1, 0, 1, alpha=4)
    assert same_bits(measure.section(1, 0, gravity=8, length=2).theta, measure.section(1, 0, alpha=4).theta)


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"gravity": 9.81}, "gravity and length go together: alpha is gravity/length"),
        ({"length": 1}, "gravity and length go together: alpha is gravity/length"),
        ({"gravity": 9.81, "length": 1, "alpha": 1}, "alpha cannot be given together with gravity and length"),
        ({"gravity": [1, 0], "length": 1}, "gravity must be positive and finite, got 0 at index (1,)"),
        ({"gravity": 1, "length": -1}, "length must be positive and finite, got -1"),
    ],
)
def test_gravity_and_length_are_checked_by_their_names(given, message):
    for call in (pendula.analyze, pendula.solve, measure.section, pendula.Parameters):
        with pytest.raises(ValueError, match=f"^{re.escape(message)}$"):
            call(1, 0, **given)


def test_the_amplitude_of_a_period_is_that_of_the_elliptic_integral():
    """K(1/√2) = Γ(1/4)²/(4√π) is a quarter of the period of the amplitude π/2."""
    tau = math.gamma(0.25) ** 2 / math.sqrt(math.pi)
    assert abs(pendula.amplitude(tau) - math.pi / 2) <= 4e-15  # math.gamma is right to some ulp
    assert same_bits(pendula.amplitude([tau, 2 * tau], alpha=[1, 0.25]), [pendula.amplitude(tau)] * 2)
    assert pendula.amplitude(tau / 2, gravity=8, length=2) == pendula.amplitude(tau)
    assert pendula.amplitude(2 * math.pi) == 0
    assert pendula.amplitude([]).shape == (0,)


@pytest.mark.parametrize(
    ("tau", "message"),
    [
        (6.0, "tau must be at least 2 pi/sqrt(alpha), the period of small swings, got 6.0"),
        ([[7.0, 6.25]], "tau must be at least 2 pi/sqrt(alpha), the period of small swings, got 6.25 at index (0, 1)"),
        (-1, "tau must be positive and finite, got -1"),
    ],
)
def test_a_period_that_no_pendulum_has_is_refused(tau, message):
    with pytest.raises(ValueError, match=f"^{re.escape(message)}$"):
        pendula.amplitude(tau)


def test_degrees_become_the_nearest_radians():
    degrees = np.array([90, -180, 30, 1e-3, 57.29577951308232, 1e17])
    exact = [float(Fraction(d) * Fraction(np.pi) / 180 + Fraction(d) * PI_LOW / 180) for d in degrees]
    assert pendula.to_radians(degrees).tolist() == exact
    with pytest.raises(TypeError, match=r"^degrees must be real numbers, got <U2 '90'$"):
        pendula.to_radians("90")


BAD_VALUES = {
    "theta0": ([np.nan, np.inf, -np.inf], "finite"),
    "omega0": ([np.nan, np.inf], "finite"),
    "alpha": ([0.0, -1.0, np.nan, np.inf], "positive and finite"),
    "beta": ([-1.0, np.nan], "finite and not negative"),
    "torque": ([np.inf], "finite"),
    "drive_amplitude": ([np.nan], "finite"),
    "pivot_amplitude": ([-np.inf], "finite"),
    "drive_frequency": ([-1.0, np.inf], "finite and not negative"),
    "drive_phase": ([np.nan], "finite"),
    "dt": ([0.0, -1.0, np.nan], "positive and finite"),
    "every": ([0.0, np.inf], "positive and finite"),
    "until": ([-1.0], "positive and finite"),
}
EACH_BAD = [(name, value, legal) for name, (values, legal) in BAD_VALUES.items() for value in values]


@pytest.mark.parametrize(("name", "value", "legal"), EACH_BAD)
def test_a_value_outside_is_named_with_its_interval_and_its_place(name, value, legal):
    given = {"theta0": 1.0, "omega0": 0.0, "drive_frequency": 1.0}
    message = f"{name} must be {legal}, got {value:g}"
    with pytest.raises(ValueError, match=f"^{re.escape(message)}$"):
        pendula.solve(**given | {name: value})
    with pytest.raises(ValueError, match=f"^{re.escape(message)} at index \\(1, 2\\)$"):
        array = np.ones((2, 3))
        array[1, 2] = value
        pendula.solve(**given | {name: array})


def test_times_of_the_closed_form_must_be_finite():
    with pytest.raises(ValueError, match=r"^t must be finite, got nan at index \(2,\)$"):
        pendula.exact(1, 0, [0, 1, np.nan])
    with pytest.raises(ValueError, match=r"^alpha must be positive and finite, got 0$"):
        pendula.exact(1, 0, 1, alpha=0)


@pytest.mark.parametrize("t", [1e100, -1e100, 1e18])
def test_times_to_which_the_closed_form_is_not_carried_are_refused(t):
    message = rf"^the closed form is right up to t = \d+ s, not at {re.escape(f'{t:g}')} s$"
    for call in (lambda: pendula.exact(1, 0, [0, t]), lambda: pendula.solve(1, 0, t=[0, t], method="exact")):
        with pytest.raises(ValueError, match=message):
            call()


def test_late_times_that_the_closed_form_is_carried_to_are_right():
    assert abs(pendula.exact(1, 0, 8e15)[0] - 0.99612) <= 5e-6
    assert abs(pendula.exact(1, 0, 1e16)[0] - 0.11484) <= 5e-6  # the digits that are known


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"method": "rk5"}, "method must be one of rk4, euler, verlet, taylor, exact, got 'rk5'"),
        ({"method": 99}, "method must be one of rk4, euler, verlet, taylor, exact, got 99"),
        ({"method": "exact", "beta": 0.1}, "method exact needs a pendulum without friction, torque, drive and shaken pivot"),
        (
            {"method": "exact", "pivot_amplitude": [0, 1.0], "drive_frequency": 1},
            "pendulum at index (1,): method exact needs a pendulum without friction, torque, drive and shaken pivot",
        ),
        ({"method": "verlet", "beta": [0, 0.1]}, "pendulum at index (1,): method verlet needs a pendulum without friction"),
        (
            {"drive_amplitude": 1},
            "a drive or a shaken pivot needs a frequency: drive_frequency must be positive and finite, got 0",
        ),
        (
            {"pivot_amplitude": 1},
            "a drive or a shaken pivot needs a frequency: drive_frequency must be positive and finite, got 0",
        ),
        (
            {"drive_amplitude": [[0], [1]], "alpha": [1, 2, 3]},
            "pendulum at index (1, 0): a drive or a shaken pivot needs a frequency: drive_frequency must be positive and finite, got 0",
        ),
        (
            {"drive_amplitude": [[0], [1]], "drive_frequency": [3, 2, 0]},
            "a drive or a shaken pivot needs a frequency: drive_frequency must be positive and finite, got 0 at index (2,)",
        ),
        ({"tolerance": 1.0}, "tolerance must be between 0 and 1, both excluded, got 1"),
        ({"threads": 0}, "threads must be a whole number from 1 to 256, got 0"),
        ({"threads": 1.5}, "threads must be a whole number from 1 to 256, got 1.5"),
        ({"threads": 257}, "threads must be a whole number from 1 to 256, got 257"),
        ({"threads": 10**30}, "threads must be a whole number from 1 to 256, got 1e+30"),
        ({"dt": -5, "method": "taylor"}, "dt must be positive and finite, got -5"),
        ({"dt": -5, "method": "exact"}, "dt must be positive and finite, got -5"),
        ({"t": [0, 1], "until": 1}, "t cannot be given together with until or every"),
        ({"t": [[0, 1]]}, "t must have one axis, got shape (1, 2)"),
        ({"t": [0, 3, 1]}, "t must not decrease, got 1 after 3 at index (2,)"),
        ({"t": [-1, 0, 1]}, "t must be finite and not negative, got -1 at index (0,)"),
        ({"until": [1, 2], "every": 0.1, "dt": 0.1}, "until/every must give all pendulums as many rows, got from 11 to 21"),
        ({"until": 1e30}, "there would be 7.4"),
        (
            {"theta0": [1, 2], "alpha": [1, 2, 3]},
            "arguments cannot be broadcast together: theta0 has shape (2,), alpha has shape (3,)",
        ),
        ({"beta": 1e6, "dt": 0.1, "every": 1}, "every/dt must be at least 359713, or the method is unstable, got 10"),
        (
            {"beta": [0, 1e6], "t": [1.0, 2.0], "dt": 0.1},
            "pendulum at index (1,): t[0]/dt must be at least 359713, or the method is unstable, got 10; or use method taylor",
        ),
    ],
)
def test_what_makes_no_run_says_why(given, message):
    with pytest.raises(ValueError, match=f"^{re.escape(message)}"):
        pendula.solve(**{"theta0": 1.0, "omega0": 0.0} | given)


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"tolerance": [1e-3]}, "tolerance must be a real number, got an array of shape (1,)"),
        ({"tolerance": "1e-3"}, "tolerance must be a real number, got <U4 '1e-3'"),
        ({"threads": "2"}, "threads must be a real number, got <U1 '2'"),
        ({"dt": "2"}, "dt must be real numbers, got <U1 '2'"),
    ],
)
def test_a_setting_that_is_no_number_is_a_type_error(given, message):
    with pytest.raises(TypeError, match=f"^{re.escape(message)}$"):
        pendula.solve(1.0, 0.0, **given)


def test_parameters_are_kept_as_floats_and_float64():
    parameters = pendula.Parameters([1, 2], 0)
    assert parameters.shape == (2,)
    assert (parameters.theta0.dtype, parameters.alpha) == (np.float64, 1.0)
    kept = pendula.solve(1, 0, beta=[[1], [2]], method="taylor", every=1, until=1).parameters
    assert (kept.shape, type(kept.theta0)) == ((2, 1), float)
    assert not kept.is_conservative
    assert pendula.Parameters([1, 2], 0, 3).is_conservative
    with pytest.raises(TypeError, match=r"^beta must be real numbers"):
        pendula.Parameters(1, 0, beta="x")


UNBOUNDED = "2 of 3 pendulums. 2 unbounded: Without friction: a torque accelerates the motion for ever."
REASONS = {
    "section": "1 of 3 pendulums. The motion leaves the range of doubles.",
    "mean_velocity": UNBOUNDED,
    "attractors": UNBOUNDED,
}


@pytest.mark.parametrize(("name", "reason"), REASONS.items())
def test_measures_that_cannot_be_had_are_told_with_the_reason(name, reason):
    with pytest.warns(RuntimeWarning, match=f"^{name}: results are nan for {re.escape(reason)}$") as told:
        getattr(measure, name)(0.1, 0.0, torque=[0.0, 1.5, 1e308], periods=5, transient=0)
    assert told[0].filename == __file__


def test_orbits_that_are_not_found_are_told():
    message = (
        r"^orbit: results are nan for 1 of 1 pendulum\. Newton's method finds no periodic orbit from their initial states\.$"
    )
    with pytest.warns(RuntimeWarning, match=message) as told:
        measure.orbit(0.2, 0.0, torque=1.5)  # without friction it turns ever faster
    assert told[0].filename == __file__


@pytest.mark.parametrize("theta0", [1.0, -1e299])
@pytest.mark.parametrize("omega0", [0.0, 1.0, np.finfo(float).max])
@pytest.mark.parametrize("alpha", [5e-324, 1.0, np.finfo(float).max])
def test_numbers_of_any_size_give_numbers(theta0, omega0, alpha):
    analysis = pendula.analyze(theta0, omega0, alpha=alpha)
    assert np.all(np.isfinite(analysis))
    assert np.all(np.isfinite(pendula.exact(theta0, omega0, analysis.tau * np.array([-1e6, 0.1, 1e6]), alpha=alpha)))


def test_more_results_than_there_is_memory_for_is_a_memory_error():
    with pytest.raises(MemoryError):
        pendula.exact(np.broadcast_to(1.0, 10**14), 0.0, 1.0)
    with pytest.raises(MemoryError):
        pendula.solve(1.0, 0.0, every=1e-12, until=100, dt=1)
