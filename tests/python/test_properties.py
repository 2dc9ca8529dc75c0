"""What is true of every pendulum."""

import numpy as np
import pendula
from doubles import same_bits
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import mutually_broadcastable_shapes

# Angles short of the top, where the half-open interval [-π, π) breaks the symmetry.
angles = st.floats(-3.1, 3.1)
speeds = st.floats(-10, 10)
stiffnesses = st.floats(0.1, 10)

ANGLE = 1e-14  # the closed form's stated error [rad], and of omega in its maximum, for |t| <= 30 tau


def largest_speed(theta0, omega0, alpha):
    return np.hypot(omega0, 2 * np.sqrt(alpha) * np.sin(theta0 / 2))


def is_clear_of_the_separatrix(theta0, omega0, alpha):
    """Nearer, one rounding of the state that a motion is taken up from moves its period by more than these bounds allow."""
    return abs(omega0**2 / (4 * alpha) + np.sin(theta0 / 2) ** 2 - 1) > 1e-2


@given(angles, speeds, stiffnesses, st.floats(-30, 30))
def test_energy_is_conserved(theta0, omega0, alpha, periods):
    t = periods * pendula.analyze(theta0, omega0, alpha=alpha).tau
    theta, omega = pendula.exact(theta0, omega0, t, alpha=alpha)

    def energy(angle, speed):
        return speed**2 / 2 + 2 * alpha * np.sin(angle / 2) ** 2

    fastest = largest_speed(theta0, omega0, alpha)
    # dE = omega d omega + alpha sin(theta) d theta, and a few roundings of E itself; unwrapped, theta adds its own.
    allowed = ANGLE * fastest**2 + alpha * (ANGLE + np.spacing(abs(theta))) + 8 * np.spacing(fastest**2)
    assert abs(energy(theta, omega) - energy(theta0, omega0)) <= allowed


@given(angles, speeds, stiffnesses, st.floats(-30, 30))
def test_the_mirror_image_moves_as_the_mirror_says(theta0, omega0, alpha, periods):
    t = periods * pendula.analyze(theta0, omega0, alpha=alpha).tau
    theta, omega = pendula.exact(theta0, omega0, t, alpha=alpha)
    mirrored = pendula.exact(-theta0, -omega0, t, alpha=alpha)
    assert abs(theta + mirrored[0]) <= 2 * ANGLE + np.spacing(abs(theta))
    assert abs(omega + mirrored[1]) <= 2 * ANGLE * largest_speed(theta0, omega0, alpha)


@given(angles, speeds.filter(bool), stiffnesses, st.floats(0, 30))
def test_backwards_is_forwards_with_the_speed_reversed(theta0, omega0, alpha, periods):
    t = periods * pendula.analyze(theta0, omega0, alpha=alpha).tau
    back = pendula.exact(theta0, omega0, -t, alpha=alpha)
    reversed_ = pendula.exact(theta0, -omega0, t, alpha=alpha)
    assert abs(back[0] - reversed_[0]) <= 2 * ANGLE + np.spacing(abs(back[0]))
    assert abs(back[1] + reversed_[1]) <= 2 * ANGLE * largest_speed(theta0, omega0, alpha)


@given(angles, speeds, stiffnesses, st.floats(0, 10), st.integers(1, 20))
def test_a_motion_repeats_after_tau(theta0, omega0, alpha, t, periods):
    regime, _, tau = pendula.analyze(theta0, omega0, alpha=alpha)
    if regime == pendula.Regime.separatrix or t > 9 * tau:
        return
    now = pendula.exact(theta0, omega0, t, alpha=alpha)
    later = pendula.exact(theta0, omega0, t + periods * tau, alpha=alpha)
    turns = 2 * np.pi * periods * np.sign(omega0) if regime == pendula.Regime.rotation else 0.0
    fastest = largest_speed(theta0, omega0, alpha)
    # Both errors, tau's 4 ulp times the periods, and the roundings of the later time and of its angle.
    delay = 4 * periods * np.spacing(tau) + np.spacing(t + periods * tau)
    assert abs(later[0] - now[0] - turns) <= 2 * ANGLE + fastest * delay + 2 * np.spacing(abs(later[0]))
    assert abs(later[1] - now[1]) <= 2 * ANGLE * fastest + alpha * delay


@given(angles, speeds, stiffnesses, st.floats(0, 5), st.floats(0, 5))
def test_a_motion_can_be_taken_up_from_any_of_its_states(theta0, omega0, alpha, first, second):
    if not is_clear_of_the_separatrix(theta0, omega0, alpha):
        return
    whole = pendula.exact(theta0, omega0, first + second, alpha=alpha)
    between = pendula.exact(theta0, omega0, first, alpha=alpha)
    parts = pendula.exact(*between, second, alpha=alpha)
    # An error of the state in between moves the period too, by at most a hundred times as much this far from the separatrix.
    assert abs(parts[0] - whole[0]) <= 1e-11
    assert abs(parts[1] - whole[1]) <= 1e-11 * np.sqrt(alpha)


@given(angles, speeds, stiffnesses)
@settings(max_examples=25)
def test_steps_have_the_mirror_image_too(theta0, omega0, alpha):
    for method in ("rk4", "euler", "verlet", "taylor"):
        times = {"alpha": alpha, "method": method, "dt": 0.01, "every": 0.5, "until": 5}
        one, other = pendula.solve(theta0, omega0, **times), pendula.solve(-theta0, -omega0, **times)
        inside = one.theta != -np.pi  # which has no mirror image in [-π, π)
        assert same_bits(abs(one.theta[inside]), abs(other.theta[inside]))
        assert np.all(one.omega == -other.omega)


@given(mutually_broadcastable_shapes(num_shapes=4, max_dims=4, max_side=4, min_side=0), st.integers(0, 2**32 - 1))
def test_arguments_broadcast_as_numpys_do(shapes, seed):
    random = np.random.default_rng(seed)
    theta0, omega0, t, alpha = (random.uniform(0.1, 3, shape) for shape in shapes.input_shapes)
    theta, omega = pendula.exact(theta0, omega0, t, alpha=alpha)
    analysis = pendula.analyze(theta0, omega0, alpha=alpha)
    assert theta.shape == omega.shape == shapes.result_shape
    assert {np.shape(field) for field in analysis} == {np.broadcast_shapes(theta0.shape, omega0.shape, alpha.shape)}
    for index, *each in zip(
        np.ndindex(theta.shape), *(x.flat for x in np.broadcast_arrays(theta0, omega0, t, alpha)), strict=True
    ):
        assert (theta[index], omega[index]) == pendula.exact(*each[:3], alpha=each[3])


@given(mutually_broadcastable_shapes(num_shapes=3, max_dims=3, max_side=3, min_side=0))
@settings(max_examples=25)
def test_solutions_have_time_last(shapes):
    theta0, omega0, alpha = (np.full(shape, 1.0) for shape in shapes.input_shapes)
    solution = pendula.solve(theta0, omega0, alpha=alpha, dt=0.1, every=0.5, until=1)
    assert solution.t.shape == (3,)
    assert solution.theta.shape == solution.omega.shape == solution.turns.shape == (*shapes.result_shape, 3)
    assert same_bits(solution.theta, pendula.solve(1.0, 1.0, dt=0.1, every=0.5, until=1).theta)
