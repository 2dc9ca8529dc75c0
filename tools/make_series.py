"""Makes tests/data/series.txt: the right-hand side of the assignment's cut (3.9).

python tools/make_series.py > tests/data/series.txt     (needs python-flint)
"""

import random

from flint import arb
from make_closed_form import NAMED, near, oscillation, rotation, small
from reference_pendulum import OSCILLATION, SEPARATRIX, complement, energy_ratio, motion
from reference_table import pair, text

random.seed(20260104)


def cut(alpha: float, theta: float, omega: float, epsilon: float) -> arb:
    """log(epsilon (1 - r^2)) / (2 log r)."""
    kappa, kappa1 = energy_ratio(alpha, theta, omega), complement(alpha, theta, omega) / arb(alpha)
    is_oscillation = motion(alpha, theta, omega).regime == OSCILLATION
    r2, rest = (kappa, kappa1) if is_oscillation else (1 / kappa, -kappa1 / kappa)
    return (arb(epsilon) * rest).log() / r2.log()


def main():
    print("# Made by tools/make_series.py, which states the command; do not edit.")
    print("# alpha theta omega epsilon value     the least N is the value rounded up; a pair: nearest double and rest")
    cases = NAMED + [make() for make in (oscillation, small, rotation, near) for _ in range(25)]
    for case in cases:
        alpha, theta, omega = case
        if theta == omega == 0 or omega != omega or motion(*case).regime == SEPARATRIX:
            continue
        for epsilon in (1e-7, 1e-15):
            print(*map(text, case), text(epsilon), pair(cut(alpha, theta, omega, epsilon)))


if __name__ == "__main__":
    main()
