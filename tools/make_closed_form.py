"""Makes tests/data/closed_form.txt: regime, amplitude, characteristic time and states of frictionless pendulums.

python tools/make_closed_form.py > tests/data/closed_form.txt     (needs python-flint; 512 bits)
python tools/make_closed_form.py --verify                         (needs mpmath: against Taylor series in time)
"""

import math
import random
import sys

from flint import arb
from reference_pendulum import SEPARATRIX, Solution, motion
from reference_table import exact, nearest, pair, text

SEED = 20260101
TOP = math.pi
random.seed(SEED)
uniform = random.uniform


def power(low: float, high: float) -> float:
    return 10 ** uniform(low, high)


def sign() -> int:
    return random.choice((-1, 1))


def stiffness() -> float:
    return 1.0 if random.random() < 0.4 else power(-6, 6)


def with_complement(alpha: float, theta: float, kappa1: float) -> float:
    """The velocity for which cos^2(theta/2) - omega^2/(4 alpha) = kappa1, of either sign, or nan if there is none."""
    square = arb(alpha) * ((arb(theta) / 2).cos() ** 2 - arb(kappa1))
    return sign() * 2 * nearest(exact(square.sqrt())) if square > 0 else math.nan


def oscillation():
    alpha, kappa1 = stiffness(), uniform(0.01, 0.99)
    theta = uniform(-1, 1) * 2 * math.acos(math.sqrt(kappa1))
    return alpha, theta, 0.0 if random.random() < 0.15 else with_complement(alpha, theta, kappa1)


def small():
    alpha, size = stiffness(), power(-12, -3) if random.random() < 0.8 else power(-150, -12)
    theta, omega = (random.choice((0.0, 1.0)) if random.random() < 0.4 else uniform(-1, 1) for _ in "ab")
    return alpha, theta * size, omega * size * math.sqrt(alpha)


def rotation():
    alpha, theta = stiffness(), uniform(-TOP, TOP)
    return alpha, theta, with_complement(alpha, theta, -power(-2, 4))


def near():
    alpha, theta = stiffness(), uniform(-TOP, TOP)
    return alpha, 0.0 if random.random() < 0.2 else theta, with_complement(alpha, theta, sign() * power(-12, -2))


def beyond():
    alpha, theta = stiffness(), sign() * (TOP - power(-7, -1.5))
    return alpha, theta, with_complement(alpha, theta, sign() * power(-15.2, -12.5))


def upright():
    alpha, theta = stiffness(), sign() * (TOP - power(-14, -3))
    return alpha, theta, 0.0 if random.random() < 0.5 else with_complement(alpha, theta, sign() * power(-27, -10))


def separatrix():
    alpha, theta = stiffness(), uniform(-TOP, TOP) if random.random() < 0.8 else sign() * (TOP - power(-9, -1))
    return alpha, theta, with_complement(alpha, theta, 0)


def turns():
    alpha, theta, omega = random.choice((oscillation, rotation, near))()
    many = round(sign() * (power(0, 6) if random.random() < 0.85 else power(6, 14)))
    return alpha, nearest(exact(arb(theta) + 2 * arb.pi() * many)), omega


def extreme():
    alpha, theta, omega = random.choice((oscillation, rotation, near))()
    scale = 2.0 ** round(uniform(-450, 450))
    return alpha * scale * scale, theta, omega * scale


def fast():
    alpha = stiffness()
    return alpha, uniform(-TOP, TOP), sign() * math.sqrt(alpha) * power(2, 100)


NAMED = [
    (1.0, 0.0, 0.0),
    (1.0, 0.001, 0.0),
    (1.0, 0.5, 0.0),
    (1.0, 1.0, 0.0),
    (1.0, 1.5, 0.0),
    (1.0, 2.0, 0.0),
    (1.0, 2.5, 0.0),
    (1.0, 3.0, 0.0),
    (1.0, 0.0, 2.0),
    (1.0, 0.0, -2.0),
    (1.0, 0.001, 2.0),
    (1.0, 0.01, 2.0),
    (1.0, 0.1, 2.0),
    (1.0, 1.0, 2.0),
    (1.0, TOP / 2, 0.0),
    (1.0, 0.0, 1.999999895801368),
    (1.0, 0.0, 2.01),
    (1.0, 0.0, 2 + 1e-14),
    (1.0, 0.0, 2 - 1e-14),
    (1.0, TOP, 0.0),
    (1.0, -TOP, 0.0),
    (9.8, TOP, 0.0),
    (1.0, 3 * TOP, 0.0),
    (1.0, -101 * TOP, 0.0),
    (1e-3, TOP, 0.0),
    (1.0, TOP / 2, math.sqrt(2)),
    (1.0, -TOP / 2, math.sqrt(2)),
    (1.0, TOP / 2, -math.sqrt(2)),
    (1.0, 3.14159, 0.0),
    (1.0, 3.1415926535, 0.0),
    (1.0, 2 * TOP, 0.0),
    (1.0, 0.0, 1e-300),
    (1.0, 1e-300, 0.0),
    (4.0, 0.0, 4.0),
    (0.25, 0.0, -1.0),
    (1.0, 3.14, 2 * math.cos(1.57)),
    (1.0, 3.14, -2 * math.cos(1.57)),
    (1.0, TOP, 1e-3),
    (1.0, TOP, -1e-3),
    (1.0, -TOP, 1e-3),
    (2.0**-1060, 1.0, 0.0),
    (2.0**1023, 1.0, 0.0),
    (2.0**-1022, 2.0, 0.0),
    (2.0**1000, 0.0, 2.0**501),
    (1.0, 1.0, 2.0**511),
]

# Kinds of cases, and how many of each.
GROUPS = [
    (oscillation, 300),
    (small, 200),
    (rotation, 260),
    (near, 420),
    (beyond, 160),
    (upright, 150),
    (separatrix, 170),
    (turns, 200),
    (extreme, 80),
    (fast, 40),
]


def is_clear(m, name: str) -> bool:
    """Whether the regime is certain: well inside, or well outside, the one ulp by which the separatrix is defined."""
    return m.nearness < 0.4 if name == "separatrix" else m.nearness > 4


def cases():
    for case in NAMED:
        yield "named", case
    for make, count in GROUPS:
        done = 0
        while done < count:
            case = make()
            if all(map(math.isfinite, case)) and case[0] > 0 and is_clear(motion(*case), make.__name__):
                done += 1
                yield make.__name__, case


def short(t: float) -> float:
    """t rounded to 20 bits, which makes the table shorter."""
    mantissa, exponent = math.frexp(t)
    return math.ldexp(round(math.ldexp(mantissa, 20)), exponent - 20)


def times(name: str, number: int, tau: float) -> list[float]:
    factors = (
        [uniform(-30, 30)] + ([uniform(-2, 2)] if number % 3 == 0 else []) + ([sign() * power(2, 6)] if number % 6 == 0 else [])
    )
    if name == "named" or number % 25 == 0:
        factors += [0, 0.25, 0.5, 1, -1 / 3, 30]
    limit = 2**1000
    return [t for t in (short(f * tau) for f in factors) if abs(t) < limit]


def header():
    print("# Made by tools/make_closed_form.py, which states the command; do not edit.")
    print("# case GROUP alpha theta omega k theta_max tau      numbers after k are pairs: the nearest double and the rest")
    print("# at t theta omega turns                            theta in [-pi, pi); theta and omega are pairs")


def table():
    header()
    for number, (name, case) in enumerate(cases()):
        solution = Solution(*case)
        m = solution.motion
        print("case", name, *map(text, case), m.regime, pair(m.theta_max), pair(m.tau))
        for t in times(name, number, nearest(exact(m.tau))):
            theta, omega, n = solution.at(t)
            print("at", text(t), pair(theta), pair(omega), n)


def verify():
    """Compares every 50th case with Taylor series of order 40 in time, over a few units of 1/sqrt(alpha), in 70 digits."""
    from mpmath import mp, mpf
    from taylor_check import integrate

    def as_mp(x):
        return mpf(exact(x).numerator) / exact(x).denominator

    mp.dps, worst, count = 70, mpf(0), 0
    for number, (name, case) in enumerate(cases()):
        solution = Solution(*case)
        if (number % 50 and name != "named") or solution.motion.regime == SEPARATRIX:
            continue
        t = 7.0 / max(math.sqrt(case[0]), abs(case[2]))
        theta, omega, n = solution.at(t)
        want = as_mp(theta) + 2 * mp.pi * n
        got, speed = integrate(*map(mpf, (*case, t)))
        size = max(abs(as_mp(solution.motion.theta_max)), mpf(0))
        error = max(
            abs(got - want) / (size or 1), abs(speed - as_mp(omega)) / (2 * mp.sqrt(case[0]) * size + abs(case[2]) or 1)
        )
        worst, count = max(worst, error), count + 1
    print(f"{count} cases, largest relative difference {mp.nstr(worst, 3)}")


if __name__ == "__main__":
    verify() if "--verify" in sys.argv else table()
