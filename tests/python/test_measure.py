"""The measures in Python: shapes and bits; that they are right is tested beside the core."""

import re

import numpy as np
import pendula
import pytest
from doubles import same_bits
from pendula import _core, measure

DRIVEN = {"beta": 0.5, "drive_frequency": 2 / 3}
AMPLITUDES = np.array([[0.9, 1.07, 1.15], [1.35, 1.45, 1.5]])
SHORT = {"transient": 20, "periods": 8, "steps_per_period": 200}
MEASURES = {
    "section": measure.section,
    "mean_velocity": lambda *start, **more: [measure.mean_velocity(*start, **more)],
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


def test_one_pendulum_gives_numbers():
    assert isinstance(measure.mean_velocity(0.2, 0.0, **SHORT), np.float64)
    exponent, error, horizon, history = measure.lyapunov(0.2, 0.0, **SHORT)
    assert isinstance(exponent + error + horizon, np.float64)
    assert history.shape == (0,)
    assert isinstance(measure.attractors(0.2, 0.0, **SHORT).label, np.int64)


def test_the_last_estimate_of_the_history_is_the_exponent():
    exponent, *_, history = measure.lyapunov(0.2, 0.0, drive_amplitude=AMPLITUDES, rows=4, **DRIVEN, **SHORT)
    assert same_bits(history[..., -1], exponent)


def test_labels_are_of_each_pendulum_by_itself():
    starts = np.linspace(-3, 3, 7)
    long = {"transient": 300, "periods": 64, "steps_per_period": 200}
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
        ({"steps_per_period": 2}, "steps_per_period must be at least "),
        ({"method": "exact"}, "method must be one of rk4, taylor"),
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
        measure.mean_velocity(1.0, 0.0, drive_frequency=frequencies, transient=2, periods=5)


@pytest.mark.parametrize("name", ["transient", "periods", "steps_per_period", "tolerance"])
def test_a_setting_that_is_no_number_is_a_type_error(name):
    with pytest.raises(TypeError, match=f"^{name} must be a real number, got <U1 '3'$"):
        measure.section(0.2, 0.0, **{name: "3"})


def test_a_history_has_no_more_rows_than_periods():
    with pytest.raises(ValueError, match=r"^rows must be a whole number from 0 to 2, got 6$"):
        measure.lyapunov(0.2, 0.0, periods=2, rows=6)
    history = measure.lyapunov(0.2, 0.0, drive_amplitude=1.5, **DRIVEN, **SHORT, rows=8).history
    assert np.unique(history).size == 8


def test_results_have_the_columns_of_the_core():
    for info in _core.measures:
        if len(info.columns) > 1:
            result = getattr(measure, info.name)(0.2, 0.0, **SHORT)
            assert result._fields == tuple(column.name for column in info.columns)


def test_a_driven_pendulum_has_no_closed_form():
    solution = pendula.solve(0.2, 0.0, drive_amplitude=1.0, **DRIVEN, dt=0.1, every=1, until=2)
    assert solution.analysis is None
    for name in ("sine", "error"):
        with pytest.raises(ValueError, match=f"^{name} needs pendulums without friction and forcing"):
            getattr(solution, name)


def test_no_pendulums_have_no_results_at_once():
    assert pendula.measure.section(np.zeros(0), 0.0, transient=0, periods=2**50, steps_per_period=3).theta.size == 0
