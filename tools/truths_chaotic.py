"""Long-time truths of chaotic pendulums, for tools/make_truths.py: means over many long motions on the same attractor."""

import math

import numpy as np
from true_motions import FREQUENCY, marched, parameters
from truths_undriven import Truth

STARTS, PERIODS, TRANSIENT, BLOCK = 64, 4000, 400, 250

CLASSIC = [
    {"beta": 0.5, "drive_amplitude": g, "drive_frequency": 2 / 3}
    for g in (1.15, 1.16, 1.17, 1.18, 1.19, 1.2, 1.21, 1.22, 1.23, 1.24, 1.48, 1.49, 1.495, 1.5, 1.52)
]
WEAKER = [
    {"beta": b, "drive_amplitude": g, "drive_frequency": 2 / 3}
    for b in (0.2, 0.25, 0.3)
    for g in (1.2, 1.3, 1.35, 1.4, 1.5, 1.55, 1.6, 1.65)
]
GREBOGI = [
    {"beta": b, "drive_amplitude": g, "drive_frequency": 1.0}
    for b, g in ((0.1, 2.0), (0.1, 2.2), (0.22, 2.7), (0.1, 1.8), (0.15, 2.4))
]
JUNCTIONS = [  # in units of the plasma frequency: Kautz & Monaco, J. Appl. Phys. 57 (1985), and near
    {"beta": b, "torque": m, "drive_amplitude": g, "drive_frequency": w}
    for b, g, w in ((0.2, 1.0, 0.6), (0.25, 1.2, 0.65), (0.4, 1.1, 0.6), (0.3, 1.5, 0.5), (0.5, 1.5, 0.6))
    for m in (0.03, 0.1, -0.25, 0.4, 0.55)
]
SHAKEN = [
    {"beta": b, "pivot_amplitude": q, "drive_frequency": w, "torque": m}
    for b, q, w, m in (
        (0.1, 1.5, 1.8, 0.0),
        (0.1, 2.0, 2.0, 0.0),
        (0.2, 1.4, 1.8, 0.1),
        (0.1, 1.2, 0.7, 0.05),
        (0.15, 2.5, 2.0, 0.0),
        (0.05, 1.0, 1.6, 0.0),
    )
]


def chaotic():
    """Problems all of whose motions that are still chaotic are on one attractor; the errors are four standard errors."""
    for given in CLASSIC + WEAKER + GREBOGI + JUNCTIONS + SHAKEN:
        truth = sampled(parameters(**given))
        if truth is not None:
            yield truth


def sampled(p):
    generator = np.random.default_rng(1)
    starts = np.column_stack([generator.uniform(-math.pi, math.pi, STARTS), generator.uniform(-2, 2, STARTS)])
    states = marched([p] * STARTS, list(starts), TRANSIENT, 0.5)[2]
    advance, growth, ends = marched([p] * STARTS, list(states), PERIODS, 0.5)
    rate = p[FREQUENCY] / (2 * math.pi)
    exponents, velocities = ((rate * x).reshape(STARTS, -1, BLOCK).mean(axis=2) for x in (growth, advance))
    wild = exponents.mean(axis=1) > 0.01
    if wild.sum() < STARTS // 2 or (exponents[wild][:, -2:].mean(axis=1) < 0.3 * exponents[wild].mean()).any():
        return None
    if not (is_one(exponents[wild]) and is_one(velocities[wild])):
        return None
    (exponent, exponent_error), (velocity, velocity_error) = mean(exponents[wild]), mean(velocities[wild])
    if p[2] == 0:  # theta -> -theta half a period later is a symmetry, also of this attractor
        if abs(velocity) > velocity_error:
            return None
        velocity = velocity_error = 0.0
    start = ends[wild][0][:2]
    return Truth(
        "chaotic", (float(start[0]), float(start[1])), p, velocity, velocity_error, exponent, exponent_error, "chaotic"
    )


def is_one(means):
    """Whether the means of the motions differ no more than blocks of each one tell: there is one attractor, without drifts."""
    expected = means.std(axis=1, ddof=1).mean() / math.sqrt(means.shape[1])
    return means.mean(axis=1).std(ddof=1) < 2.5 * expected + 1e-12


def mean(means):
    each = means.mean(axis=1)
    return float(each.mean()), float(4 * each.std(ddof=1) / math.sqrt(len(each)))
