"""Makes tests/data/truths.txt: the long-time mean velocity, Lyapunov exponent and kind of motion of many pendulums.

    python tools/make_truths.py > tests/data/truths.txt     (needs python-flint, mpmath, SciPy and gcc; 4.5 minutes on one core)

Closed formulas where there are some; otherwise integrators with no code of pendula's (true_motions.py). One of them is a Taylor
series, as pendula's is, but in 80 bits. Errors are the differences of two computations, with a margin; for the chaotic motions
they are four standard errors. The searches for driven orbits can find others on another
processor, since they follow sensitive motions.
"""

import math
import sys

import truths_chaotic
import truths_driven
from true_motions import parameters
from truths_undriven import Truth, conservative, homoclinic_torque, overdamped, resting, rotating, torqued

HEAD = """\
# theta0 omega0 alpha beta torque drive_amplitude pivot_amplitude drive_frequency drive_phase: shortest decimals of the doubles
# group, these nine, then: mean velocity, bound of its error, largest Lyapunov exponent, bound of its error, kind of motion
#     nan: not known; kind -: not certain"""


def fixed_points():
    for alpha, beta in (
        *(
            (1, b)
            for b in (
                0.01,
                0.05,
                0.1,
                0.2,
                0.5,
                1,
                1.9,
                1.999999,
                2 - 1e-9,
                2,
                2 + 1e-12,
                2.000001,
                2.5,
                5,
                10,
                30,
                100,
                300,
                1000,
            )
        ),
        *((0.25, b) for b in (0.02, 0.3, 1, 4)),
        *((9.81, b) for b in (0.05, 0.5, 6, 40)),
    ):
        yield resting("fixed_point", (0.5 + beta % 1.7, -0.25), alpha=alpha, beta=beta)
    yield resting("fixed_point", (3.14159, 0.0), beta=0.2)
    yield resting("fixed_point", (0.0, 20.0), beta=0.05)
    yield resting("fixed_point", (0.0, -100.0), beta=0.5)
    yield resting("fixed_point", (1e-9, 0.0), beta=0.5)
    yield resting("fixed_point", (0.0, 0.0), beta=0.5)
    for torque, beta in (
        (0.1, 0.01),
        (0.5, 0.1),
        (-0.5, 0.5),
        (0.9, 0.7),
        (0.99, 1.5),
        (-0.9, 2),
        (0.7, 5),
        (0.999, 20),
        (0.3, 100),
    ):
        yield resting("fixed_point", (0.3, 0.0), beta=beta, torque=torque)
    yield resting("fixed_point", (0.0, 30.0), beta=0.9, torque=0.6)
    yield resting("fixed_point", (0.0, -8.0), beta=1.4, torque=0.8)
    yield resting("fixed_point", (7.0, 1.0), alpha=4, beta=1.5, torque=-3)


def rotations():
    for beta in (0.001, 0.01, 0.1, 0.3, 0.7, 1, 1.5, 2, 3):
        for torque in (1.1, -2.5) if beta > 0.01 else (1.1, 0.05):
            yield rotating("rotating", (0.0, math.copysign(max(3.0, abs(torque) / beta), torque)), beta=beta, torque=torque)
    for beta, torque in (
        (0.02, 0.1),
        (0.05, 0.2),
        (0.1, 0.15),
        (0.1, 0.5),
        (0.2, 0.3),
        (0.3, 0.5),
        (-0.5, 0.7),
        (0.7, 0.85),
        (0.9, 0.97),
    ):
        sense = math.copysign(1.0, beta)  # here of the torque
        yield rotating("rotating", (0.5, sense * 6.0), beta=abs(beta), torque=sense * torque)
    for beta, torque in (
        (5, 1.05),
        (10, 1.5),
        (10, -20),
        (30, 2),
        (100, 1.01),
        (100, 50),
        (300, 1.2),
        (1000, 1.5),
        (1000, 30),
        (1000, 1.001),
    ):
        yield overdamped_either((0.2, 0.0), beta, torque)
    for alpha, beta, torque in ((9.81, 0.5, 12), (0.25, 0.1, 0.3), (9.81, 2, 11), (1e-3, 0.2, 0.5), (100, 3, 150)):
        yield rotating("rotating", (-1.0, torque / beta), alpha=alpha, beta=beta, torque=torque)


def overdamped_either(start, beta, torque):
    truth = overdamped("rotating", start, beta=beta, torque=abs(torque))
    truth.pendulum = (*truth.pendulum[:2], torque, *truth.pendulum[3:])
    truth.velocity = math.copysign(truth.velocity, torque)
    return truth


def conservatives():
    for alpha in (1.0, 9.81, 0.25):
        for theta, omega in (
            (0.0, 2.5),
            (0.3, -3.0),
            (1.0, 10.0),
            (3.0, 0.5),
            (0.5, 0.0),
            (2.0, 0.3),
            (3.14159, 0.0),
            (1e-6, 0.0),
        ):
            yield conservative("conservative", (theta, omega * math.sqrt(alpha)), alpha)
    for sign in (1, -1):
        for change in (1e-4, 1e-8, 1e-12, -1e-4, -1e-8, -1e-12):
            yield conservative("conservative", (0.0, sign * 2.0 * (1 + change)), 1.0)
    for alpha, omega in ((1.0, 2.0), (4.0, -4.0), (0.25, 1.0), (2.25, 3.0)):
        yield conservative("conservative", (0.0, omega), alpha)
    yield conservative("conservative", (0.0, 0.0), 1.0)
    for torque, theta in ((0.1, 0.5), (0.5, 0.6), (0.9, 1.2), (-0.3, 0.0), (0.0001, 2.0), (-0.7, -0.5)):
        yield torqued("conservative", (theta, 0.0), torque=torque)
    for torque, omega in ((0.1, 3.0), (1.5, 0.0), (-2.0, 1.0), (0.5, -3.0), (1.01, -6.0), (-0.2, 0.0)):
        yield torqued("conservative", (0.0, omega), torque=torque)


def near_saddle_nodes():
    for beta in (1.5, 2, 3):
        for power in (4, 5, 6, 7, 8):
            truth = rotating("near_saddle_node", (0.0, 1.0), beta=beta, torque=1 + 10.0**-power)
            truth.velocity_error += 1e-12 * truth.velocity
            yield truth
    for beta, power in ((10, 4), (10, 8), (30, 6), (100, 5), (100, 8), (1000, 4), (1000, 6)):
        yield overdamped("near_saddle_node", (0.0, 1.0), modes=30, beta=beta, torque=1 + 10.0**-power)
    for beta in (0.1, 0.3, 0.5, 0.8, 1):
        edge = homoclinic_torque(beta)
        for power in (4, 7, 10):
            yield rotating("near_saddle_node", (0.0, 4.0), beta=beta, torque=edge + 10.0**-power)
        yield resting("near_saddle_node", (0.0, 4.0), beta=beta, torque=edge - 1e-6)
    for beta in (2, 5):  # torque = alpha: theta creeps up to pi/2, below the line omega = beta/2 (pi/2 - theta)
        yield Truth("near_saddle_node", (1.0, 0.0), parameters(beta=beta, torque=1), 0.0, 0.0, 0.0, 0.0, "fixed_point")
    for beta, power in ((0.5, 4), (0.5, 8), (1.5, 4), (1.5, 6), (3, 8), (10, 4), (30, 4)):
        yield resting("near_saddle_node", (1.5, 0.0), beta=beta, torque=1 - 10.0**-power)


GROUPS = {
    "fixed_point": fixed_points,
    "rotating": rotations,
    "conservative": conservatives,
    "near_saddle_node": near_saddle_nodes,
    "locked": truths_driven.locked,
    "quasi_periodic": truths_driven.quasi_periodic,
    "chaotic": truths_chaotic.chaotic,
}


def line(truth):
    if not all(map(math.isfinite, (*truth.start, *truth.pendulum))):
        raise ValueError(truth)
    numbers = (*truth.start, *truth.pendulum, truth.velocity, truth.velocity_error, truth.exponent, truth.exponent_error)
    return " ".join((truth.group, *(repr(float(x)).removesuffix(".0") for x in numbers), truth.kind))


if __name__ == "__main__":
    print("# Made by tools/make_truths.py, which states the command; do not edit.", HEAD, sep="\n")
    for group in sys.argv[1:] or GROUPS:
        for truth in GROUPS[group]():
            print(line(truth), flush=True)
