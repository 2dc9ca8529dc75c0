"""Arrays of every kind: what is legal is taken as it is, all else is named."""

import re

import numpy as np
import pendula
import pytest
from doubles import same_bits

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
    assert all(type(value) is np.float64 for value in pendula.exact(1, 0.5, np.array(2.0)))
    assert isinstance(pendula.analyze(1, 0).regime, pendula.Regime)
    assert pendula.exact([1], 0.5, 2)[0].shape == (1,)
    assert pendula.exact(np.empty((0, 3)), 0.5, 2)[0].shape == (0, 3)


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


BAD_VALUES = {
    "theta0": ([np.nan, np.inf, -np.inf], "finite"),
    "omega0": ([np.nan, np.inf], "finite"),
    "alpha": ([0.0, -1.0, np.nan, np.inf], "positive and finite"),
    "beta": ([-1.0, np.nan], "finite and not negative"),
    "torque": ([np.inf], "finite"),
    "drive_amplitude": ([np.nan], "finite"),
    "drive_frequency": ([-1.0, np.inf], "finite and not negative"),
    "drive_phase": ([np.nan], "finite"),
    "dt": ([0.0, -1.0, np.nan], "positive and finite"),
    "every": ([0.0, np.inf], "positive and finite"),
    "until": ([-1.0], "positive and finite"),
}
EACH_BAD = [(name, value, legal) for name, (values, legal) in BAD_VALUES.items() for value in values]


@pytest.mark.parametrize(("name", "value", "legal"), EACH_BAD)
def test_a_value_outside_is_named_with_its_interval_and_its_place(name, value, legal):
    given = {"theta0": 1.0, "omega0": 0.0}
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


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"method": "rk5"}, "method must be one of rk4, euler, verlet, taylor, exact, got 'rk5'"),
        ({"method": "exact", "beta": 0.1}, "method exact needs beta, torque and drive_amplitude to be 0"),
        ({"method": "verlet", "beta": [0, 0.1]}, "method verlet needs beta to be 0, got 0.1"),
        ({"drive_amplitude": 1}, "drive_frequency must be positive and finite, got 0"),
        ({"tolerance": 1.0}, "tolerance must be between 0 and 1, both excluded, got 1"),
        ({"threads": 0}, "threads must be at least 1, got 0"),
        ({"t": [0, 1], "until": 1}, "t cannot be given together with until or every"),
        ({"t": [[0, 1]]}, "t must have one axis, got shape (1, 2)"),
        ({"t": [0, 1, 3]}, "t must begin at 0 or later and grow by even steps"),
        ({"t": [-1, 0, 1]}, "t must begin at 0 or later and grow by even steps"),
        ({"until": [1, 2], "every": 0.1, "dt": 0.1}, "until/every must give all pendulums as many rows, got from 11 to 21"),
        ({"until": 1e30}, "a run must have at most 2^53 rows and steps, got "),
        ({"theta0": [1, 2], "alpha": [1, 2, 3]}, "arguments cannot be broadcast together: their shapes are (2,)"),
    ],
)
def test_what_makes_no_run_says_why(given, message):
    with pytest.raises(ValueError, match=f"^{re.escape(message)}"):
        pendula.solve(**{"theta0": 1.0, "omega0": 0.0} | given)


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


def test_evenly_spaced_times_are_those_of_intervals():
    spaced = pendula.solve(1.0, 0.0, t=np.arange(0, 5, 0.1), dt=0.01)
    rows = pendula.solve(1.0, 0.0, every=0.1, until=4.95, dt=0.01)
    assert same_bits(spaced.t, rows.t)
    assert same_bits(spaced.theta, rows.theta)


def test_times_may_begin_later():
    late = pendula.solve([1.0, 2.0], 0.0, t=np.linspace(7, 9, 21), dt=0.01)
    assert np.all(abs(late.t - np.linspace(7, 9, 21)) <= 2 * np.spacing(9.0))
    assert np.all(abs(late.error) <= 1e-8)  # of order 4: (0.01)^4 for each unit of time


def test_the_closed_form_takes_any_times():
    t = [3.0, -1.0, 0.0, 1e6]
    solution = pendula.solve([[0.5], [3.0]], [0.0, 1.0], t=t, method="exact")
    assert same_bits(solution.unwrapped, pendula.exact([[[0.5]], [[3.0]]], [[0.0], [1.0]], t)[0])
