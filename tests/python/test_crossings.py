"""Crossings and periods: against mpmath, the closed form, and one pendulum against many."""

import numpy as np
import pendula
import pytest
from doubles import same_bits

# x'' = -x'/2 - sin x + 1.1 sin(t/2) from (0.1, 0), by mpmath's odefun with 30 digits: times and velocities at x = 1 (mod 2 pi),
# times and angles at x' = -1/2.
DRIVEN = {"beta": 0.5, "drive_amplitude": 1.1, "drive_frequency": 0.5, "drive_phase": -np.pi / 2}
TIMES_AT_1 = [3.00145830343787147, 7.02998526817545997, 12.5613760770088316, 16.0839625020287408, 20.7667784065545546]
VELOCITIES_AT_1 = [0.580012753442882812, -1.11055334221460191, -1.64271487934530043, 1.1448461620844497, -1.73550966107071607]
TIMES_AT_MINUS_HALF = [6.20745852260645351, 13.8417210899430537, 19.5290118405499549]
ANGLES_AT_MINUS_HALF = [1.66259616594553057, -6.87073374385786671, -3.91836768949550799]
ERROR = 3e-13  # Taylor's method is within 1e-13 there; the smallest rate of change is 0.58


def test_crossings_of_an_angle_are_those_of_mpmath():
    found = pendula.crossings(0.1, 0.0, at=1.0, until=21.0, **DRIVEN)
    assert np.all(abs(found.t - TIMES_AT_1) <= ERROR)
    assert np.all(abs(found.omega - VELOCITIES_AT_1) <= ERROR)
    assert np.all(abs(found.theta - 1) <= 1e-15)
    assert found.is_rising.tolist() == [True, False, False, True, False]


def test_crossings_of_a_velocity_are_those_of_mpmath():
    found = pendula.crossings(0.1, 0.0, of="omega", at=-0.5, until=20.0, **DRIVEN)
    assert np.all(abs(found.t - TIMES_AT_MINUS_HALF) <= ERROR)
    turned = (found.theta - ANGLES_AT_MINUS_HALF) / (2 * np.pi)  # theta is wrapped
    assert np.all(abs(turned - np.round(turned)) <= ERROR)
    assert np.all(abs(found.theta) <= np.pi)
    assert found.is_rising.tolist() == [False, True, False]


@pytest.mark.parametrize(("direction", "part"), [("rising", slice(1, None, 2)), ("falling", slice(0, None, 2))])
def test_a_direction_leaves_the_other_crossings_out(direction, part):
    both = pendula.crossings(2.0, 0.0, at=0.5, until=50.0)
    one = pendula.crossings(2.0, 0.0, at=0.5, until=50.0, direction=direction)
    assert same_bits(one.t, both.t[part])
    assert np.all(one.is_rising == (direction == "rising"))


def test_turning_points_come_each_half_period_at_the_amplitude():
    tau = pendula.analyze(2.0, 0.0).tau
    found = pendula.crossings(2.0, 0.0, of="omega", until=10.2 * tau)
    assert np.all(abs(found.t - tau / 2 * np.arange(1, 21)) <= 1e-12)
    assert np.all(abs(abs(found.theta) - 2.0) <= 1e-14)


def test_many_pendulums_are_each_alone_with_nan_behind_the_last_crossing():
    theta0, omega0, at = np.array([[0.5], [2.0], [np.pi]]), np.array([0.0, 3.0]), np.array([0.2, -0.4])
    many = pendula.crossings(theta0, omega0, at=at, until=[20.0, 10.0], beta=0.1, threads=2)
    counts = np.isfinite(many.t).sum(axis=-1)
    assert many.t.shape == (3, 2, counts.max())
    for i, j in np.ndindex(3, 2):
        one = pendula.crossings(theta0[i, 0], omega0[j], at=at[j], until=[20.0, 10.0][j], beta=0.1)
        count = counts[i, j]
        assert one.t.shape == (count,)
        for column, own in zip(many, one, strict=True):
            assert same_bits(column[i, j, :count], own)
        assert np.isnan(many.theta[i, j, count:]).all()
        assert not many.is_rising[i, j, count:].any()
    assert counts[2, 0] == 0  # at rest on top


def test_no_pendulums_have_no_crossings():
    assert pendula.crossings(np.empty((0, 2)), 0.0, until=5.0).t.shape == (0, 2, 0)
    assert pendula.measured_period(np.empty(0), 0.0, until=5.0).shape == (0,)


def test_the_measured_period_is_that_of_the_closed_form():
    theta0, omega0 = np.array([1e-6, 1.0, 3.0, 0.0]), np.array([0.0, 0.0, 0.0, 2.5])
    tau = pendula.analyze(theta0, omega0).tau
    periods = pendula.measured_period(theta0, omega0, until=50 * tau)
    # Rounding moves the energy, and the period with it: most at 3 rad, by the square of the distance from the top.
    assert np.all(abs(periods / tau - 1) <= [1e-14, 1e-14, 1e-12, 1e-14])
    assert isinstance(pendula.measured_period(1.0, 0.0, until=50.0), float)


def test_the_period_of_too_few_crossings_is_nan():
    assert np.isnan(pendula.measured_period(1.0, 0.0, until=3.0))
    assert np.isnan(pendula.measured_period(np.pi, 0.0, until=1e4))


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"of": "phi"}, "of must be one of theta, omega, got 'phi'"),
        ({"direction": "up"}, "direction must be one of both, rising, falling, got 'up'"),
        ({"until": -1.0}, "until must be finite and not negative, got -1"),
        ({"at": [0.0, np.nan]}, r"at must be finite, got nan at index \(1,\)"),
        ({"tolerance": 1.0}, "tolerance must be between 0 and 1, both excluded, got 1"),
        ({"beta": -2.0}, "beta must be finite and not negative, got -2"),
    ],
)
def test_what_is_not_legal_is_refused_by_name(given, message):
    with pytest.raises(ValueError, match=f"^{message}$"):
        pendula.crossings(1.0, 0.0, **{"until": 1.0} | given)


def test_until_of_a_period_must_be_legal():
    with pytest.raises(ValueError, match=r"^until must be finite and not negative, got inf$"):
        pendula.measured_period(1.0, 0.0, until=np.inf)
    with pytest.raises(TypeError, match=r"^until must be real numbers"):
        pendula.measured_period(1.0, 0.0, until="long")


def test_a_motion_that_leaves_the_doubles_is_told():
    message = r"^crossings: the motion of 1 of 2 pendulums leaves the doubles; results are nan$"
    with pytest.warns(RuntimeWarning, match=message) as told:
        found = pendula.crossings(1.0, 0.0, torque=[0.0, 1e308], until=30.0)
    assert told[0].filename == __file__
    assert same_bits(found.t[0][np.isfinite(found.t[0])], pendula.crossings(1.0, 0.0, until=30.0).t)
