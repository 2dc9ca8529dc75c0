"""Makes tests/data/angle.txt: wrapping, turns, degrees and phases.

python tools/make_angle.py > tests/data/angle.txt     (needs python-flint)
"""

import math
import random
from fractions import Fraction

from flint import arb, ctx
from make_elementary import near_quarter_turns, power, uniform
from reference_pendulum import wrap
from reference_table import nearest, pair, text

ctx.prec = 2400
random.seed(20260103)


SEARCHED = [(float.fromhex("-0x1.f9e795dcf9bacp-3"), 1.0)]  # the argument with the largest error of phase among a million


def angles() -> list[float]:
    borders = [math.pi * k for k in (1, -1, 2, -2, 3, -3, 4, 7, -101, 1e5, 1e10, 3e14)]
    borders += [math.nextafter(x, y) for x in borders for y in (math.inf, -math.inf)]
    hard = [4 * near_quarter_turns(e) for e in range(-50, -5, 3)]  # near whole turns, below 1e15
    small = [uniform(-10, 10) for _ in range(60)] + [power(0, 15) for _ in range(150)] + [5e-324, 1e-300, -1e-17]
    return borders + hard + small + [-x for x in hard] + [power(15, 308) for _ in range(40)] + [1.7e308, -1.7e308]


def degrees() -> list[float]:
    return (
        [90.0, 180.0, -180.0, 360.0, 45.0, 30.0, 1.0, 1e-320, 1e300]
        + [uniform(-360, 360) for _ in range(60)]
        + [power(-300, 300) for _ in range(40)]
    )


def phases() -> list[tuple[float, float]]:
    edges = [s * (1 - 2.0**-k) for k in range(1, 54, 4) for s in (-1, 1)] + [1e-300, -1e-17, 0.5]
    inside = [uniform(-1, 1) for _ in range(80)] + edges + [power(-15, 0) for _ in range(20)]
    return [(s, random.choice((1.0, -1.0, 1e-300, -1e300))) for s in inside if abs(s) < 1] + SEARCHED


def phase(s: float, r: float) -> arb:
    right = arb(s).asin()
    return right if r >= 0 else (arb.pi() - right if s > 0 else -arb.pi() - right)


def main():
    print("# Made by tools/make_angle.py, which states the command; do not edit.")
    print("# wrap theta value turns | to_radians degrees value | phase s r value     values are pairs: nearest double and rest")
    for theta in angles():
        value, turns = wrap(arb(theta))
        print("wrap", text(theta), pair(value), turns if abs(turns) < 2**53 else text(nearest(Fraction(turns))))
    for d in degrees():
        print("to_radians", text(d), pair(arb(d) * arb.pi() / 180))
    for s, r in phases():
        print("phase", text(s), text(r), pair(phase(s, r)))


if __name__ == "__main__":
    main()
