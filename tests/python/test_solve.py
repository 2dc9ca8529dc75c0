"""Rows at the times asked for, with the steps asked for, and motions whose fate is known."""

import numpy as np
import pendula
import pytest
from doubles import same_bits
from pendula import _core


def test_a_pivot_shaken_fast_holds_the_pendulum_on_top():
    """Kapitza: the upright state is stable above P² = 2 α Ω²."""
    for amplitude, is_held in ((40.0, True), (20.0, False)):
        theta = pendula.solve(np.pi - 0.1, 0.0, pivot_amplitude=amplitude, drive_frequency=20.0, every=0.05, until=20).theta
        assert (abs(_core.wrap(theta - np.pi)).max() < 0.5) == is_held


def test_evenly_spaced_times_are_those_of_intervals():
    spaced = pendula.solve(1.0, 0.0, t=np.arange(0, 5, 0.1), dt=0.01)
    rows = pendula.solve(1.0, 0.0, every=0.1, until=4.95, dt=0.01)
    assert same_bits(spaced.t, rows.t)
    assert same_bits(spaced.theta, rows.theta)


def test_times_may_begin_later():
    late = pendula.solve([1.0, 2.0], 0.0, t=np.linspace(7, 9, 21), dt=0.01)
    assert np.all(abs(late.t - np.linspace(7, 9, 21)) <= 2 * np.spacing(9.0))
    assert np.all(abs(late.error) <= 1e-8)  # of order 4: (0.01)^4 for each unit of time


@pytest.mark.parametrize("method", ["rk4", "euler", "verlet"])
def test_rows_of_a_late_start_are_in_steps_as_asked_for(method):
    late = pendula.solve(1.0, 0.0, t=[100.0, 101.0, 102.0], dt=0.3, method=method)
    first = pendula.solve(1.0, 0.0, every=100.0, until=100.0, dt=0.3, method=method)
    assert same_bits(late.theta[0], first.theta[1])
    rest = pendula.solve(late.theta[0], late.omega[0], every=1.0, until=2.0, dt=0.3, method=method)
    # Equal steps, but for what rounding has kept of the first hundred seconds, which grows some tenfold.
    assert np.all(abs(late.unwrapped - rest.unwrapped - late.unwrapped[0] + rest.unwrapped[0]) <= 1e-13)


def test_pendulums_may_have_steps_of_their_own():
    dt = np.array([0.5, 0.01, 0.1])
    together = pendula.solve(1.0, 0.5, t=[3.0, 4.0, 5.0], dt=dt)
    for i, each in enumerate(dt):
        assert same_bits(together.theta[i], pendula.solve(1.0, 0.5, t=[3.0, 4.0, 5.0], dt=each).theta)


def test_the_closed_form_takes_any_times():
    t = [3.0, -1.0, 0.0, 1e6]
    solution = pendula.solve([[0.5], [3.0]], [0.0, 1.0], t=t, method="exact")
    assert same_bits(solution.unwrapped, pendula.exact([[[0.5]], [[3.0]]], [[0.0], [1.0]], t)[0])


@pytest.mark.parametrize("method", ["taylor", "exact"])
def test_methods_without_a_step_have_none(method):
    assert pendula.solve(1.0, 0.0, t=[0.0, 1.0], method=method).dt is None
    assert pendula.solve(1.0, 0.0, every=1, until=2, dt=0.1, method=method).dt is None


def test_a_motion_that_leaves_the_doubles_is_told():
    message = r"^solve: the motion of 1 of 2 pendulums leaves the doubles; results are nan from row 1 on$"
    with pytest.warns(RuntimeWarning, match=message) as told:
        solution = pendula.solve(0.0, [1.0, 1e308], dt=5, every=10, until=30)
    assert told[0].filename == __file__
    assert np.isfinite(solution.theta[0]).all()
    assert np.isnan(solution.theta[1, 1:]).all()
