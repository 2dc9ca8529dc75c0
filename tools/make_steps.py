"""Makes tests/data/steps.txt and pivot_steps.txt: steps of the methods of Euler, Verlet and Runge-Kutta (3.10) in 57 digits.

python tools/make_steps.py free > tests/data/steps.txt     (needs python-flint; some minutes)
python tools/make_steps.py pivot > tests/data/pivot_steps.txt
python tools/make_steps.py pivot 256                       (gives the same text: the precision is sufficient)
"""

import math
import sys

from flint import arb, ctx
from reference_table import pair, text

ctx.prec = int(sys.argv[2]) if len(sys.argv) > 2 else 192


def euler(a, x, w, h):
    return x + w * h, w - a * x.sin() * h


def verlet(a, x, w, h):
    """Velocity form: half a step of the velocity, a step of the angle, half a step of the velocity."""
    half = w - a * x.sin() * h / 2
    x = x + half * h
    return x, half - a * x.sin() * h / 2


def rk4(a, x, w, h):
    xa, wa = w * h, -a * x.sin() * h
    xb, wb = (w + wa / 2) * h, -a * (x + xa / 2).sin() * h
    xc, wc = (w + wb / 2) * h, -a * (x + xb / 2).sin() * h
    xd, wd = (w + wc) * h, -a * (x + xc).sin() * h
    return x + (xa + 2 * xb + 2 * xc + xd) / 6, w + (wa + 2 * wb + 2 * wc + wd) / 6


# alpha, theta, omega, h. One pendulum turns by 100 rad in a step.
PROBLEMS = [
    (1.0, math.pi / 2, 0.0, 0.000741629870920549),
    (1.0, 1.0, 0.5, 0.01),
    (9.81, 2.5, -1.0, 0.001),
    (1.0, 0.0, 2.01, 0.003),
    (4.0, 3.0, 2.0, 0.01),
    (1.0, 1e-9, 0.0, 0.006),
    (1.0, 0.0, 1e-200, 0.006),
    (1.0, 0.3, 0.0, 0.5),
    (2.0, -1.0, 0.2, 1.1),
    (1.0, 1.0, 1000.0, 0.1),
    (1e6, 1.0, 3.0, 1e-5),
    (1e-8, 2.0, -1e-4, 31.0),
]
# For rounding errors: 100 periods or turns with steps of tau/10,000, then runs with longer steps.
LONG = [
    (1.0, math.pi / 2, 0.0, 0.000741629870920549),
    (1.0, 0.0, 2.5, 0.0002894),
    (9.81, 1.0, 0.0, 0.00021391),
    (1.0, 2.0, 0.0, 0.00315),
    (1.0, 1.2, 0.4, 0.007),
    (1.0, -2.5, 0.0, 0.05),
]


def table(name, method, problem, checkpoints):
    print("problem", name, *map(text, problem))
    a, x, w, h = map(arb, problem)
    for step in range(1, checkpoints[-1] + 1):
        x, w = (v.mid() for v in method(a, x, w, h))  # the radii are dropped: the run with 256 bits checks the error
        if step in checkpoints:
            print("after", step, pair(x), pair(w))


def free():
    print("# problem METHOD alpha theta omega h | after steps theta omega     theta unwrapped; pairs: nearest double and rest")
    for problem in PROBLEMS:
        for name, method in (("euler", euler), ("verlet", verlet), ("rk4", rk4)):
            is_long_step = problem[3] ** 2 * problem[0] > 0.1 or abs(problem[2]) * problem[3] > 1  # may be chaotic
            table(name, method, problem, [1, 2, 10] if is_long_step else [1, 2, 10, 1000])
    for problem in LONG:
        table("rk4", rk4, problem, [10_000, 100_000, 250_000, 500_000, 750_000, 1_000_000])


class Forced:
    """The equation with all terms. Each method makes one step from time t; verlet is valid only without friction."""

    def __init__(self, alpha, beta, torque, drive, pivot, frequency, phase):
        self.alpha, self.beta, self.torque, self.drive = alpha, beta, torque, drive
        self.pivot, self.frequency, self.phase = pivot, frequency, phase

    def acceleration(self, t, x, w):
        wave = (self.frequency * t + self.phase).cos()
        return -(self.alpha + self.pivot * wave) * x.sin() - self.beta * w + self.torque + self.drive * wave

    def euler(self, t, x, w, h):
        return x + w * h, w + self.acceleration(t, x, w) * h

    def verlet(self, t, x, w, h):
        half = w + self.acceleration(t, x, w) * h / 2
        x = x + half * h
        return x, half + self.acceleration(t + h, x, half) * h / 2

    def rk4(self, t, x, w, h):
        xa, wa = w * h, self.acceleration(t, x, w) * h
        xb, wb = (w + wa / 2) * h, self.acceleration(t + h / 2, x + xa / 2, w + wa / 2) * h
        xc, wc = (w + wb / 2) * h, self.acceleration(t + h / 2, x + xb / 2, w + wb / 2) * h
        xd, wd = (w + wc) * h, self.acceleration(t + h, x + xc, w + wc) * h
        return x + (xa + 2 * xb + 2 * xc + xd) / 6, w + (wa + 2 * wb + 2 * wc + wd) / 6


# alpha, beta, torque, drive_amplitude, pivot_amplitude, drive_frequency, drive_phase, theta, omega, t, h. In a step the angle
# changes by less than 1/48 rad in some cases, and by several radians in others.
SHAKEN = [
    (1.0, 0.0, 0.0, 0.0, 30.0, 20.0, 0.0, 3.0, 0.0, 0.0, 0.001),
    (1.0, 0.0, 0.0, 0.0, -30.0, 20.0, 0.0, 0.5, 1.0, 0.0, 0.01),
    (1.0, 0.0, 0.0, 0.0, 600.0, 60.0, 0.75, 2.0, -1.0, 3.5, 0.0005),
    (1.0, 0.0, 0.0, 0.0, 0.5, 2.0, 0.0, 1e-9, 0.0, 0.25, 0.01),
    (1.0, 0.0, 0.0, 0.0, 0.5, 0.3, 0.0, 2.5, 0.25, 20.0, 0.05),
    (9.81, 0.0, 0.5, 1.25, -6.0, 6.25, 1.5, -1.0, 3.0, 1.0, 0.002),
    (2.0, 0.5, 0.5, 1.25, -1.5, 3.0, 0.75, 0.5, -1.0, 2.0, 0.01),
    (1.0, 0.25, 0.0, 0.0, 3.0, 2.5, -2.0, 1.5, 40.0, 0.0, 0.01),
    (1.0, 0.0, 0.0, 0.0, 40.0, 1.0, 0.0, 1.0, 0.5, 0.5, 0.1),
    (1.0, 4.0, 0.0, 2.0, 5.0, 3.0, 0.0, 1.0, 0.5, 0.0, 0.1),
    (1.0, 0.0, 0.0, 0.0, 2.0, 5.0, 0.5, 1.0, 1000.0, 0.0, 0.125),
]


def pivot():
    print(
        "# METHOD alpha beta torque drive_amplitude pivot_amplitude drive_frequency drive_phase theta omega t h | theta omega"
    )
    print("#     after one step from t to t + h, theta unwrapped; pairs: nearest double and rest")
    for problem in SHAKEN:
        *parameters, x, w, t, h = map(arb, problem)
        forced = Forced(*parameters)
        methods = [("euler", forced.euler), ("rk4", forced.rk4)] + ([] if problem[1] else [("verlet", forced.verlet)])
        for name, method in methods:
            print(name, *map(text, problem), *map(pair, method(t, x, w, h)))


if __name__ == "__main__":
    print("# Made by tools/make_steps.py, which states the command; do not edit.")
    {"free": free, "pivot": pivot}[sys.argv[1]]()
