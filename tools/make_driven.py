"""Makes tests/data/driven.txt and pivot.txt: the forced pendulum by its Taylor series in 75 digits.

pivot.txt also has a shaken pivot, and the growth of a small displacement.

    python tools/make_driven.py driven > tests/data/driven.txt     (needs python-flint; minutes)
    python tools/make_driven.py pivot > tests/data/pivot.txt
    python tools/make_driven.py pivot check     (half the step, order 80 instead of 60, 90 digits: gives the same text)

Numbers are fixed-point integers in units of 2^-BITS.
"""

import math
import sys
from operator import mul

from flint import arb, ctx
from reference_table import pair, text

CHECK = sys.argv[2:] == ["check"]
BITS = 300 if CHECK else 250
ORDER = 80 if CHECK else 60
STEPS_PER_UNIT = 4 if CHECK else 2  # steps in a time of 1/rate; the radius of convergence is larger than 1/rate
ctx.prec = BITS + 64

# Problems of driven.txt: alpha, beta, torque, drive_amplitude, drive_frequency, drive_phase, theta, omega.
BAKER = [(1.0, 0.5, 0.0, g, 2 / 3, 0.0, 0.2, 0.0) for g in (0.9, 1.07, 1.15, 1.35, 1.45, 1.47, 1.5)]
REGULAR = [
    (1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.5, 0.0),  # the pendulum of the assignment
    (1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1e-9, 0.0),
    (9.81, 0.0, 0.0, 0.0, 0.0, 0.0, -2.0, 8.0),
    (1.0, 0.25, 0.0, 0.0, 0.0, 0.0, 3.0, 0.5),
    (1.0, 0.1, 1.2, 0.0, 0.0, 0.0, 0.0, 0.0),  # accelerates until friction balances the torque
    (1.0, 0.0, 0.3, 0.0, 0.0, 0.0, -1.0, 0.25),
    (2.0, 0.5, 0.5, 1.25, 3.0, 0.75, 0.5, -1.0),
    (0.25, 3.0, 0.1, 0.5, 1.0, -2.0, 0.1, 0.0),  # overdamped
    (1.0, 0.2, 0.0, 20.0, 12.0, 1.0, 0.0, 1.0),  # driven fast
    (1.0, 0.0, 0.0, 1e-6, 0.5, 0.0, 0.0, 0.0),  # starts at rest, with a weak drive
]
CHAOTIC = [
    (1.0, 0.25, 0.0, 1.5, 2 / 3, 0.5, 1.0, 0.0),
    (1.0, 0.0, 0.0, 1.0, 1.25, 0.0, 2.0, 0.1),  # without friction
    (1.0, 0.1, 0.05, 1.0, 0.7, 0.0, -1.0, 2.0),
]
TIMES = [0.125, 1.0, 7.5, 20.0, 35.0, 50.0]

# Problems of pivot.txt: alpha, beta, torque, drive_amplitude, pivot_amplitude, drive_frequency, drive_phase, theta, omega.
PIVOT_CASES = [
    (1.0, 0.0, 0.0, 0.0, 30.0, 20.0, 0.0, 3.0, 0.0),  # near the upright state, which is stable for pivot_amplitude > 28.3
    (1.0, 0.1, 0.0, 0.0, 40.0, 20.0, 0.5, 2.5, 0.0),
    (1.0, 0.0, 0.0, 0.0, -30.0, 20.0, 0.0, 3.1, 0.05),
    (1.0, 0.2, 0.0, 0.0, 170.0, 20.0, 1.0, 3.0, 0.0),
    (9.81, 0.05, 0.0, 0.0, 2000.0, 188.0, 0.0, 3.0, 0.1),
    (1.0, 0.0, 0.0, 0.0, 600.0, 60.0, 0.0, 2.0, 0.0),
    (1.0, 0.0, 0.0, 0.0, 30.0, 20.0, 0.0, 0.5, 0.0),  # near the bottom
    (1.0, 0.2, 0.0, 0.0, 25.0, 15.0, -2.0, 10.0, 0.0),  # theta not wrapped
    (1.0, 0.0, 0.0, 0.0, 0.5, 0.3, 0.0, 1.0, 0.0),  # slow
    (1.0, 0.3, 0.0, 0.0, 5.0, 0.3, 0.0, 1.0, 0.0),  # slow; the effective gravity changes its sign
    (1.0, 0.05, 0.0, 0.0, 0.5, 2.0, 0.0, 0.01, 0.0),  # in the first tongue of Mathieu's equation
    (1.0, 0.0, 0.0, 0.0, 0.2, 1.5, 0.25, 1e-9, 0.0),  # outside that tongue
    (1.0, 0.0, 0.0, 0.0, 0.5, 2.0, 0.0, 0.0, 0.0),  # at rest: only the displacement grows
    (9.81, 0.02, 0.0, 0.0, -2.0, 6.26, 0.0, 0.2, 0.0),
    (1.0, 0.0, 0.0, 0.0, 1e-6, 2.0, 0.0, 1.0, 0.0),  # a very small amplitude
    (1.0, 0.3, 0.5, 0.0, 0.8, 1.7, 0.3, -1.0, 0.0),  # with a torque
    (2.0, 0.5, 0.5, 1.25, -1.5, 3.0, 0.75, 0.5, -1.0),  # all terms of the equation
    (0.25, 3.0, 0.1, 0.5, 2.0, 1.0, -2.0, 0.1, 0.0),  # overdamped
    (1.0, 0.1, 0.0, 0.0, 3.0, 2.5, 0.0, -7.5, 3.0),  # rotates in step with the pivot
    (1.0, 0.0, 0.0, 0.0, 5.0, 0.7, 0.0, 0.0, 30.0),  # rotates fast
    (1.0, 0.0, 0.0, 0.0, 0.5, 1.25, 0.0, 2.0, 0.1),  # this and the following are chaotic
    (1.0, 0.1, 0.05, 0.0, -1.2, 0.7, 0.0, -1.0, 2.0),
    (1.0, 0.2, 0.1, 0.0, 1.4, 1.8, 0.0, 1.0, 0.0),
    (1.0, 0.2, 0.0, 0.0, 1.6, 2.0, 0.5, 1.0, 0.0),
    (1.0, 0.1, 0.0, 0.0, 2.0, 2.0, 0.0, 1.0, 0.0),
]
PIVOT_TIMES = [0.5, 5.0, 20.0, 50.0]


def fixed(x: arb) -> int:
    return int((x * arb(2) ** BITS).mid().floor().unique_fmpz())


def real(x: int) -> arb:
    return arb(x) / arb(2) ** BITS


def product(x, y):
    """The last coefficient of the product of two series of equal length n: the one of order n - 1."""
    return sum(map(mul, x, reversed(y))) >> BITS


def coefficients(p, state, t):
    """The Taylor coefficients of theta, omega and the displacement about t, as lists."""
    alpha, beta, torque, amplitude, pivot, frequency, phase = p
    theta, omega, d_theta, d_omega = state
    angle = real(frequency) * t + real(phase)
    wave = [fixed(f) for f in (angle.cos(), -angle.sin(), -angle.cos(), angle.sin())]
    x, v, s, c = [theta], [omega], [fixed(real(theta).sin())], [fixed(real(theta).cos())]
    dx, dv = [d_theta], [d_omega]
    stiffness, slope = [], []  # series of alpha + pivot cos(phase), and of its product with cos(theta)
    power = 1 << BITS  # frequency^n/n!
    for n in range(ORDER):
        drive = power * wave[n % 4] >> BITS  # coefficient n of cos(phase)
        stiffness.append((pivot * drive >> BITS) + (alpha if n == 0 else 0))
        slope.append(product(stiffness, c))
        force = (amplitude * drive - beta * v[n] >> BITS) + (torque if n == 0 else 0)
        x.append(v[n] // (n + 1))
        dx.append(dv[n] // (n + 1))
        dv.append((-product(slope, dx[:-1]) - (beta * dv[n] >> BITS)) // (n + 1))
        acceleration = force - product(stiffness, s)
        s.append(product(v, c) // (n + 1))
        c.append(-product(v, s[:-1]) // (n + 1))
        v.append(acceleration // (n + 1))
        power = (power * frequency >> BITS) // (n + 1)
    return x, v, dx, dv


def horner(x, h):
    total = 0
    for a in reversed(x):
        total = (total * h >> BITS) + a
    return total


def solve(pendulum, theta, omega, times):
    """Yields (t, theta, omega, d_theta, d_omega) at the times; the displacement (d_theta, d_omega) is (1, 0) at t = 0.

    The error is estimated by the check; there is no proven bound.
    """
    p, state = [fixed(arb(v)) for v in pendulum], [fixed(arb(v)) for v in (theta, omega, 1, 0)]
    alpha, beta, torque, amplitude, pivot, frequency, _ = pendulum
    t = 0
    for end in times:
        end = fixed(arb(end))
        while t < end:
            rate = abs(float(real(state[1]))) + math.sqrt(alpha + abs(torque) + abs(amplitude) + abs(pivot)) + beta + frequency
            h = min((1 << BITS + math.floor(-math.log2(rate))) // STEPS_PER_UNIT, end - t)
            state = [horner(series, h) for series in coefficients(p, state, real(t))]
            t += h
        yield float(real(end)), *map(real, state)


def driven():
    print("# problem KIND alpha beta torque drive_amplitude drive_frequency drive_phase theta omega")
    print("# at t theta omega     theta unwrapped; pairs: nearest double and rest")
    for kind, problems in (("regular", REGULAR + BAKER[:2]), ("chaotic", CHAOTIC + BAKER[2:])):
        for problem in problems:
            print("problem", kind, *map(text, problem))
            for t, theta, omega, *_ in solve((*problem[:4], 0.0, *problem[4:6]), *problem[6:], TIMES):
                print("at", text(t), pair(theta), pair(omega))


def pivot():
    print("# problem alpha beta torque drive_amplitude pivot_amplitude drive_frequency drive_phase theta omega")
    print("# at t theta omega d_theta d_omega     theta unwrapped; pairs: nearest double and rest")
    print("#     (d_theta, d_omega) was (1, 0) at t = 0 and follows the linearised equation")
    for problem in PIVOT_CASES:
        print("problem", *map(text, problem))
        for t, *values in solve(problem[:7], *problem[7:], PIVOT_TIMES):
            print("at", text(t), *map(pair, values))


if __name__ == "__main__":
    print("# Made by tools/make_driven.py, which states the command; do not edit.")
    {"driven": driven, "pivot": pivot}[sys.argv[1]]()
