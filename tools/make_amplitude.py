"""Makes tests/data/amplitude.txt: amplitudes of the frictionless pendulum with given periods.

python tools/make_amplitude.py > tests/data/amplitude.txt     (needs mpmath and python-flint)
"""

import math
import random
from fractions import Fraction

import mpmath
from mpmath import mpf
from reference_table import pair, text

random.seed(20261125)
mpmath.mp.dps = 120  # the worst case loses 32 digits in 1 - k^2


def amplitude(alpha: float, tau: float) -> mpf:
    """2 asin(k), where K(k) = tau sqrt(alpha)/4: Newton's method in ln(1 - k^2), in which K is nearly linear."""
    integral = mpf(tau) * mpmath.sqrt(mpf(alpha)) / 4
    if integral <= mpmath.pi / 2:
        return mpf(0)
    square = min(4 * (integral - mpmath.pi / 2), 1 - 16 * mpmath.exp(-2 * integral))  # k^2 close to 0, and to 1
    if square > mpf("0.9") and integral < 2.5:
        square = mpf("0.6")
    for _ in range(80):
        rest = 1 - square
        excess = mpmath.ellipk(square) - integral
        slope = (mpmath.ellipe(square) - rest * mpmath.ellipk(square)) / (2 * square * rest)
        change = 1 - rest * mpmath.exp(excess / (rest * slope)) - square
        square += change
        if abs(change) < mpf(10) ** -70 * min(square, 1 - square):
            assert abs(mpmath.ellipk(square) - integral) < mpf(10) ** -50
            return (
                2 * mpmath.asin(mpmath.sqrt(square)) if square < 0.5 else mpmath.pi - 2 * mpmath.asin(mpmath.sqrt(1 - square))
            )
    raise ArithmeticError(f"no amplitude for {alpha}, {tau}")


def fraction(x: mpf) -> Fraction:
    mantissa, exponent = mpmath.frexp(x)
    return Fraction(int(mpmath.ldexp(mantissa, 400))) * Fraction(2) ** (int(exponent) - 400)


def cases():
    """Periods from that of small swings on: by ulps, by factors close to 1, and up to where the amplitude rounds to pi."""
    shortest = 2 * math.pi
    for _ in range(4):
        shortest = math.nextafter(shortest, 7)
        yield 1.0, shortest
    for _ in range(200):
        alpha = random.choice([1.0, math.exp(random.uniform(-30, 30))])
        factor = random.choice([1 + 10 ** random.uniform(-15, 0), random.uniform(1, 3), random.uniform(1, 24)])
        yield alpha, 2 * math.pi / math.sqrt(alpha) * factor
    for alpha in (1e-300, 1e-310, 1e300):
        for factor in (1.0001, 1.5, 10, 23):
            yield alpha, 2 * math.pi / math.sqrt(alpha) * factor


def main():
    print("# Made by tools/make_amplitude.py, which states the command; do not edit.")
    print("# alpha tau amplitude     a pair: nearest double and rest")
    for alpha, tau in cases():
        print(text(alpha), text(tau), pair(fraction(amplitude(alpha, tau))))


if __name__ == "__main__":
    main()
