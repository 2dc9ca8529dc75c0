"""Makes tests/data/jumps.txt: parameters at which orbits of the pendulum end, from the conditions that define them.

    python tools/make_jumps.py > tests/data/jumps.txt     (needs mpmath and SciPy; minutes)

retrapping: the limit cycle of a pendulum with a torque ends where it meets the saddle pi - asin(torque), alpha = 1. There the
unstable manifold of the saddle is the stable manifold of the saddle a turn later. Both are power series omega(x) near the
saddles, continued by mpmath's Taylor method to the angle pi between them, where they must agree.

fold, doubling: an orbit of period 1 of a driven pendulum ends in a saddle-node, or doubles its period, where a multiplier is 1 or
-1. So Newton's method (SciPy's hybr) solves P(x) - x = 0 and det(DP - m) = 0 for x and the parameter, with DOP853 at a relative
tolerance of 3e-14. The map and its derivative are those of a whole period.
"""

import numpy as np
from mpmath import cos, findroot, mp, mpf, odefun, pi, sin, sqrt, taylor
from scipy.integrate import solve_ivp
from scipy.optimize import root

mp.dps = 25


def manifolds_miss(torque, beta):
    """The difference of the two manifolds in omega at the angle pi from the saddle."""
    curve = sqrt(1 - torque**2)
    terms = 40

    def force(x):
        return torque - torque * cos(x) + curve * sin(x)

    f = taylor(force, 0, terms + 1)

    def manifold(sign, x):
        a = [mpf(0), (-beta + sign * sqrt(beta**2 + 4 * curve)) / 2]  # omega omega' = force - beta omega
        for n in range(2, terms + 1):
            a.append((f[n] - sum(a[j] * (n + 1 - j) * a[n + 1 - j] for j in range(2, n))) / (beta + a[1] * (n + 1)))
        return sum(c * x**k for k, c in enumerate(a))

    def slope(x, omega):
        return force(x) / omega - beta

    start = mpf(1) / 20
    unstable = odefun(lambda x, y: [slope(x, y[0])], start, [manifold(1, start)])
    stable = odefun(lambda s, y: [-slope(2 * pi - s, y[0])], start, [manifold(-1, -start)])
    return unstable(pi)[0] - stable(pi)[0]


def retrapping(beta):
    first = 4 * mpf(beta) / pi
    return findroot(lambda torque: manifolds_miss(torque, mpf(beta)), (first * mpf("0.985"), first), tol=1e-18)


def after_a_period(x, beta, amplitude, frequency):
    """The state and the derivative of the strobe map."""

    def rate(t, y):
        theta, omega, a, b, c, d = y
        k = -np.cos(theta)
        acceleration = -np.sin(theta) - beta * omega + amplitude * np.cos(frequency * t)
        return [omega, acceleration, c, d, k * a - beta * c, k * b - beta * d]

    y = solve_ivp(rate, (0, 2 * np.pi / frequency), [*x, 1, 0, 0, 1], method="DOP853", rtol=3e-14, atol=1e-15).y[:, -1]
    return y[:2], y[2:].reshape(2, 2)


def end_of_branch(guess, problem, multiplier):
    """The parameter at which the orbit near guess[:2] has the multiplier, near guess[2]."""

    def conditions(u):
        point, derivative = after_a_period(u[:2], *problem(u[2]))
        turns = 2 * np.pi * np.round((point[0] - u[0]) / (2 * np.pi))
        return [point[0] - u[0] - turns, point[1] - u[1], np.linalg.det(derivative - multiplier * np.eye(2))]

    found = root(conditions, guess, method="hybr", tol=1e-14)
    if np.abs(found.fun).max() > 1e-13:
        raise SystemExit(f"no root near {guess}")
    return found.x[2]


FOLDS = [(0.05, 0.06, (0.5686, 0.3138, 0.932)), (0.05, 0.06, (0.1637, 1.2173, 0.8877))]
DOUBLINGS = [(0.5, 2 / 3, (-0.2215, 1.9597, 1.0664)), (0.5, 2 / 3, (-0.0717, 0.9786, 1.4249))]

if __name__ == "__main__":
    print("# Made by tools/make_jumps.py, which states the command; do not edit. alpha = 1")
    print("# retrapping beta | torque at which a pendulum that turns comes to rest")
    print("# fold beta drive_amplitude | drive_frequency at which an orbit of period 1 ends, to 1e-12")
    print("# doubling beta drive_frequency | drive_amplitude at which an orbit of period 1 doubles its period, to 1e-12")
    for beta in (0.1, 0.2):
        print("retrapping", beta, float(retrapping(beta)))
    for beta, amplitude, guess in FOLDS:
        print("fold", beta, amplitude, end_of_branch(guess, lambda f, b=beta, a=amplitude: (b, a, f), 1))
    for beta, frequency, guess in DOUBLINGS:
        print("doubling", beta, frequency, end_of_branch(guess, lambda a, b=beta, f=frequency: (b, a, f), -1))
