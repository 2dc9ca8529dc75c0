"""Makes tests/data/late.txt: states of frictionless pendulums at very late times, and far along the separatrix.

python tools/make_late.py > tests/data/late.txt     (needs python-flint; 512 bits)
"""

import math
import random

from flint import arb
from reference_pendulum import Solution, complement
from reference_table import exact, nearest, pair, text

random.seed(20260301)
uniform = random.uniform
MOST = 2.0**52


def sign() -> int:
    return random.choice((-1, 1))


def velocity(alpha: float, theta: float, kappa1: float) -> float:
    """The velocity for which cos^2(theta/2) - omega^2/(4 alpha) = kappa1, of either sign, or nan if there is none."""
    square = arb(alpha) * ((arb(theta) / 2).cos() ** 2 - arb(kappa1))
    return sign() * 2 * nearest(exact(square.sqrt())) if square > 0 else math.nan


def stiffness() -> float:
    return random.choice((1.0, 9.8, 10 ** uniform(-6, 6)))


def clear():
    """A case in which kappa' does not suffer from cancellation: at rest, rotating, or well below the top."""
    alpha, theta = stiffness(), uniform(-math.pi, math.pi)
    kind = random.choice(("rest", "upright", "small", "rotation", "oscillation"))
    if kind == "rest":
        return alpha, theta, 0.0
    if kind == "upright":
        return alpha, sign() * (math.pi - 10 ** uniform(-12, -1)), 0.0
    if kind == "small":
        return alpha, theta * 10 ** uniform(-20, -2), 0.0
    if kind == "rotation":
        return alpha, theta, velocity(alpha, theta, -(10 ** uniform(-0.9, 3)))
    return alpha, theta, velocity(alpha, theta, uniform(0.1, 0.9))


def near():
    alpha, theta = stiffness(), random.choice((0.0, uniform(-3.1, 3.1)))
    return alpha, theta, velocity(alpha, theta, sign() * 10 ** uniform(-15.2, -1))


def latest(case, tau: arb) -> float:
    """The latest time in units of tau, from 2^20 to 2^52: an error of 2^-102 (1 + x) per period has then grown to 2^-41."""
    alpha, theta, omega = case
    gap = abs(complement(alpha, theta, omega))
    x = 2 * arb(alpha).sqrt() * (arb(theta) / 2).cos() ** 2 / (tau * gap)
    return min(MOST, max(2.0**20, 2.0**61 / (1 + float(x))))


def late_times(case, tau: arb) -> list[float]:
    most = latest(case, tau) * (1 - 1e-9)
    factors = [most, 2 ** uniform(20, math.log2(most)), 2 ** uniform(20, math.log2(most))]
    return [sign() * f * float(tau) for f in factors]


def separatrix():
    alpha = stiffness()
    theta = random.choice((0.0, uniform(-3.1, 3.1), sign() * (math.pi - 10 ** uniform(-8, -1))))
    return alpha, theta, velocity(alpha, theta, 0)


def tail_times(case) -> list[float]:
    """Times chosen by the argument of sinh: near the bottom, on the way up, and where the velocity is denormal or 0."""
    alpha, theta, omega = case
    root, start = math.sqrt(alpha), math.asinh(math.tan(theta / 2))
    arguments = [uniform(-2, 2), uniform(-100, 100), *(sign() * uniform(99, 700) for _ in range(3)), sign() * uniform(700, 770)]
    return [(z - start) / root * math.copysign(1, omega) for z in arguments]


NAMED = {
    "clear": [(1.0, 1.0, 0.0), (1.0, 0.0, 3.0), (9.8, 3.1, 0.0), (1.0, 0.0, -1e6)],
    "near": [(1.0, 0.0, 1.999999895801368), (1.0, 0.0, 2 - 1e-14), (1.0, 0.0, 2 + 1e-14), (1.0, 2.0, 1.0806)],
    "separatrix": [(1.0, 0.0, 2.0), (1.0, 0.0, -2.0), (2.0**-500, 0.0, 2.0**-249), (2.0**600, 0.0, 2.0**301)],
}
GROUPS = {"clear": (clear, 150), "near": (near, 150), "separatrix": (separatrix, 60)}
NAMED_TIMES = {(1.0, 1.0, 0.0): [8e15, 1e16], (1.0, 0.0, 2.0): [50.0, 100.0, 150.0, 200.0, -200.0]}


def is_of(group: str, solution: Solution) -> bool:
    nearness = solution.motion.nearness
    return nearness < 0.4 if group == "separatrix" else nearness > 2


def table():
    print("# Made by tools/make_late.py, which states the command; do not edit.")
    print("# The rows are those of closed_form.txt.")
    for group, (make, count) in GROUPS.items():
        cases = list(NAMED[group])
        while len(cases) < count:
            case = make()
            if all(map(math.isfinite, case)) and is_of(group, Solution(*case)):
                cases.append(case)
        for case in cases:
            solution = Solution(*case)
            m = solution.motion
            print("case", group, *map(text, case), m.regime, pair(m.theta_max), pair(m.tau))
            times = tail_times(case) if group == "separatrix" else late_times(case, m.tau)
            for t in times + NAMED_TIMES.get(case, []):
                theta, omega, n = solution.at(t)
                print("at", text(t), pair(theta), pair(omega), n)


if __name__ == "__main__":
    table()
