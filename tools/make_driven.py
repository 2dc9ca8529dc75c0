"""Makes tests/data/driven.txt: the pendulum with friction, torque and drive, by its Taylor series in 75 digits.

    python tools/make_driven.py > tests/data/driven.txt     (needs python-flint; minutes)
    python tools/make_driven.py check                       (every step halved, order 80 for 60, 90 digits: the same text)

Numbers are fixed-point integers in units of 2^-BITS.
"""

import math
import sys
from operator import mul

from flint import arb, ctx

from reference_table import pair, text

CHECK = sys.argv[1:] == ["check"]
BITS = 300 if CHECK else 250
ORDER = 80 if CHECK else 60
STEPS_PER_UNIT = 4 if CHECK else 2  # of 1/rate; the series converges some way beyond that
ctx.prec = BITS + 64

# alpha, beta, torque, drive_amplitude, drive_frequency, drive_phase, theta, omega
BAKER = [(1.0, 0.5, 0.0, g, 2 / 3, 0.0, 0.2, 0.0) for g in (0.9, 1.07, 1.15, 1.35, 1.45, 1.47, 1.5)]
REGULAR = [
    (1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.5, 0.0),       # the pendulum of the assignment
    (1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1e-9, 0.0),
    (9.81, 0.0, 0.0, 0.0, 0.0, 0.0, -2.0, 8.0),
    (1.0, 0.25, 0.0, 0.0, 0.0, 0.0, 3.0, 0.5),
    (1.0, 0.1, 1.2, 0.0, 0.0, 0.0, 0.0, 0.0),       # runs away until friction holds it
    (1.0, 0.0, 0.3, 0.0, 0.0, 0.0, -1.0, 0.25),
    (2.0, 0.5, 0.5, 1.25, 3.0, 0.75, 0.5, -1.0),
    (0.25, 3.0, 0.1, 0.5, 1.0, -2.0, 0.1, 0.0),     # overdamped
    (1.0, 0.2, 0.0, 20.0, 12.0, 1.0, 0.0, 1.0),     # driven fast
    (1.0, 0.0, 0.0, 1e-6, 0.5, 0.0, 0.0, 0.0),      # from rest by a weak drive
]
CHAOTIC = [
    (1.0, 0.25, 0.0, 1.5, 2 / 3, 0.5, 1.0, 0.0),
    (1.0, 0.0, 0.0, 1.0, 1.25, 0.0, 2.0, 0.1),      # without friction
    (1.0, 0.1, 0.05, 1.0, 0.7, 0.0, -1.0, 2.0),
]
TIMES = [0.125, 1.0, 7.5, 20.0, 35.0, 50.0]


def fixed(x: arb) -> int:
    return int((x * arb(2) ** BITS).mid().floor().unique_fmpz())


def real(x: int) -> arb:
    return arb(x) / arb(2) ** BITS


def product(x, y):
    """The last coefficient of the product of two series of equal length."""
    return sum(map(mul, x, reversed(y))) >> BITS


def coefficients(p, theta, omega, t):
    """theta(t + h) = sum of x[n] h^n; v, s and c are the series of velocity, sine and cosine."""
    alpha, beta, torque, amplitude, frequency, phase = p
    angle = real(frequency) * t + real(phase)
    drive = [fixed(f) for f in (angle.cos(), -angle.sin(), -angle.cos(), angle.sin())]
    x, v, s, c = [theta], [omega], [fixed(real(theta).sin())], [fixed(real(theta).cos())]
    power = amplitude  # amplitude frequency^n/n!
    for n in range(ORDER):
        force = power * drive[n % 4] - alpha * s[n] - beta * v[n] >> BITS
        x.append(v[n] // (n + 1))
        s.append(product(v, c) // (n + 1))
        c.append(-product(v, s[:-1]) // (n + 1))
        v.append((force + torque if n == 0 else force) // (n + 1))
        power = (power * frequency >> BITS) // (n + 1)
    return x, v


def horner(x, h):
    total = 0
    for a in reversed(x):
        total = (total * h >> BITS) + a
    return total


def solve(problem):
    """(theta, omega) at TIMES; the check, not a bound, tells the error."""
    p, theta, omega = [fixed(arb(v)) for v in problem[:6]], fixed(arb(problem[6])), fixed(arb(problem[7]))
    t = 0
    for end in TIMES:
        end = fixed(arb(end))
        while t < end:
            rate = abs(float(real(omega))) + math.sqrt(problem[0] + abs(problem[2]) + abs(problem[3])) + problem[1] + problem[4]
            h = min((1 << BITS + math.floor(-math.log2(rate))) // STEPS_PER_UNIT, end - t)
            x, v = coefficients(p, theta, omega, real(t))
            theta, omega, t = horner(x, h), horner(v, h), t + h
        yield float(real(end)), real(theta), real(omega)


def main():
    print("# Made by tools/make_driven.py, with the command that stands there; do not edit.")
    print("# problem KIND alpha beta torque drive_amplitude drive_frequency drive_phase theta omega")
    print("# at t theta omega     theta unwrapped; pairs: nearest double and rest")
    for kind, problems in (("regular", REGULAR + BAKER[:2]), ("chaotic", CHAOTIC + BAKER[2:])):
        for problem in problems:
            print("problem", kind, *map(text, problem))
            for t, theta, omega in solve(problem):
                print("at", text(t), pair(theta), pair(omega))


if __name__ == "__main__":
    main()
