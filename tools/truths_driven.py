"""Long-time truths of driven pendulums on periodic orbits and on curves, for tools/make_truths.py."""

import itertools
import math
from fractions import Fraction

import numpy as np
from true_motions import FREQUENCY, LONG, NAMES, PI, followed, marched, parameters, period_of
from truths_undriven import Truth, ulp


def wrapped(theta):
    return theta - 2 * PI * np.round(LONG(theta) / (2 * PI))


def monodromy(p, state, count):
    """The state after `count` periods of the drive and the matrix of its derivatives, as a product of well scaled factors."""
    period = period_of(p)
    parts = math.ceil(p[1] * float(period) / 4) + 1
    total = np.eye(2, dtype=LONG)
    for part in range(count * parts):
        phase = LONG(p[6]) + 2 * PI * (part % parts) / parts
        state, factor = followed((*p[:6], phase), state, period / parts, with_map=True)
        total = factor @ total
    return state, total


def refined(p, state, count):
    """Newton's method on `count` periods of the drive: the point, the turns and the matrix of a periodic orbit, or None."""
    state = np.array(state, dtype=LONG)
    for _ in range(12):
        after, matrix = monodromy(p, state, count)
        turns = int(np.round((after[0] - state[0]) / (2 * PI)))
        rest = after - state - np.array([2 * PI * turns, 0], dtype=LONG)
        (a, b), (c, d) = matrix - np.eye(2, dtype=LONG)
        determinant = a * d - b * c
        change = np.array([d * rest[0] - b * rest[1], a * rest[1] - c * rest[0]], dtype=LONG) / determinant
        if not np.all(abs(change) < 1):
            return None
        state = state - change
        if max(abs(change)) < 1e-16 * max(1, abs(state[1])):
            return state, turns, matrix
    return None


def multiplier(p, matrix, count):
    """The multiplier of larger modulus if it is real, else 0; the exponent and a bound of its error."""
    time = count * period_of(p)
    trace, determinant = matrix[0, 0] + matrix[1, 1], np.exp(-LONG(p[1]) * time)
    doubt = LONG("3e-16") * (abs(matrix).max() + determinant)

    def of(value):
        discriminant = value**2 - 4 * determinant
        return (value + np.copysign(np.sqrt(discriminant), value)) / 2 if discriminant > 0 else LONG(0)

    values = [of(trace + shift) for shift in (0, doubt, -doubt)]
    exponents = [np.log(abs(x)) / time if x != 0 else -LONG(p[1]) / 2 for x in values]
    error = 2 * max(abs(x - exponents[0]) for x in exponents)
    return float(values[0]), float(exponents[0]), float(error) + ulp(float(exponents[0]))


def orbit_truth(p, start, state, count):
    found = refined(p, state, count)
    if found is None:
        return None
    point, turns, matrix = found
    _, exponent, error = multiplier(p, matrix, count)
    velocity = float(turns * LONG(p[FREQUENCY]) / count)
    rests = p[3] == 0 and p[2] == 0 and abs(point[1]) < 1e-12
    kind = "fixed_point" if rests else "periodic"
    return Truth("locked", start, p, velocity, ulp(velocity) / 2, exponent, error, kind)


def least_period(advance, most=12):
    """The least number of periods after which the motion repeats, or None."""
    tail = advance[-5 * most :]
    return next((q for q in range(1, most + 1) if np.all(abs(tail[q:] - tail[:-q]) < 1e-8)), None)


def grid(starts, phase=0.0, **axes):
    """Every combination of the values of the parameters, each from every start."""
    for values in itertools.product(*axes.values()):
        given = dict(zip(axes.keys(), map(float, values), strict=True))
        for start in starts:
            yield start, parameters(**given, drive_phase=phase)


FAMILIES = {
    "classic": lambda: grid(
        [(0.2, 0.0), (-2.0, 0.5)],
        beta=[0.5],
        drive_amplitude=[0.3, 0.7, 0.9, 1.0, 1.04, 1.07, 1.072, 1.08, 1.1, 1.13, 1.35, 1.36, 1.42, 1.45, 1.46, 1.47],
        drive_frequency=[2 / 3],
    ),
    "doubled": lambda: grid(
        [(0.2, 0.0)], beta=[0.25, 0.375], drive_amplitude=np.round(np.linspace(0.7, 1.6, 25), 4), drive_frequency=[2 / 3]
    ),
    "triple": lambda: grid(
        [(-2.0, 1.0), (1.0, 2.0), (2.5, -2.0)],
        beta=[0.2],
        drive_amplitude=[1.3636363636363635, 1.6],
        drive_frequency=[0.5, 0.6],
    ),
    "Shapiro": lambda: grid(
        [(0.0, 0.0)],
        0.5,
        beta=[0.7, 1.0, 1.5],
        torque=np.round(np.linspace(-0.3, 2.7, 16), 3),
        drive_amplitude=[1.0, 2.5],
        drive_frequency=[0.7, 1.0],
    ),
    "viscous": lambda: grid(
        [(1.0, 0.0)],
        -2.0,
        beta=[8.0, 30.0, 100.0],
        torque=[0.0, 0.5, 0.9, 1.8],
        drive_amplitude=[3.0, 20.0],
        drive_frequency=[0.5, 1.0],
    ),
    "weak": lambda: grid(
        [(0.1, 0.0), (2.0, 0.0), (0.0, 2.5)],
        beta=[0.02],
        drive_amplitude=[0.05, 0.2, 0.4],
        drive_frequency=[0.6, 0.9, 1.1, 2.0],
    ),
    "Kapitza": lambda: grid(
        [(3.0, 0.0), (0.5, 0.1)], beta=[0.1, 0.5], pivot_amplitude=[30.0, 60.0, 120.0], drive_frequency=[20.0]
    ),
    "parametric": lambda: grid(
        [(1.0, 0.5), (0.5, 2.2), (0.1, -2.0)],
        0.25,
        beta=[0.1, 0.3],
        pivot_amplitude=[0.4, 0.8, 1.5, 3.0],
        drive_frequency=[1.5, 2.0, 2.4],
    ),
    "everything": lambda: grid(
        [(0.5, -1.0)],
        0.75,
        alpha=[2.0],
        beta=[0.3, 0.6],
        torque=[0.5, -0.9],
        drive_amplitude=[1.25],
        pivot_amplitude=[-1.5, 0.7],
        drive_frequency=[1.2, 3.0],
    ),
}


def locked(most=9):
    """Periodic orbits with stable multipliers, reached without sensitive motion on the way, a few of each sort."""
    for name, family in FAMILIES.items():
        problems = list(family())
        periods = 320 if name == "viscous" else 1600
        advance, growth, ends = marched([p for _, p in problems], [s for s, _ in problems], periods)
        sorts: dict = {}
        for (start, p), steps, stretch, end in zip(problems, advance, growth, ends, strict=True):
            count = least_period(steps)
            if count is None or np.cumsum(stretch).max() > math.log(1e6):
                continue
            truth = orbit_truth(p, start, end[:2], count)
            if truth is None or truth.exponent > -1e-4:
                continue
            sorts.setdefault((count, truth.velocity, truth.exponent == -p[1] / 2, p[1]), []).append(truth)
        mixed = [sorts[i] for i in sorted(sorts, key=lambda sort: (-sort[0], hash(sort)))]
        ranks = [truth for rank in itertools.zip_longest(*mixed) for truth in rank if truth]
        yield from ranks[:most]
    yield from bordering()


SEEDS = [  # an orbit, the parameter that moves, its step, and the multipliers to come near to
    ({"beta": 0.5, "drive_amplitude": 1.06, "drive_frequency": 2 / 3}, "drive_amplitude", 0.001, (-0.9, -0.99, -0.999)),
    ({"beta": 0.5, "drive_amplitude": 1.07, "drive_frequency": 2 / 3}, "drive_amplitude", 0.0005, (-0.9, -0.99, -0.999)),
    ({"beta": 0.5, "drive_amplitude": 0.9, "drive_frequency": 2 / 3}, "drive_amplitude", 0.002, (0.9, 0.99, 0.999)),
    ({"beta": 1.0, "torque": 0.9, "drive_amplitude": 1.0, "drive_frequency": 0.7}, "torque", 0.002, (0.9, 0.99, 0.999)),
    ({"beta": 1.0, "torque": 0.9, "drive_amplitude": 1.0, "drive_frequency": 0.7}, "torque", -0.002, (0.9, 0.99, 0.999)),
    ({"beta": 10.0, "torque": 0.5, "drive_amplitude": 3.0, "drive_frequency": 0.2}, "torque", 0.002, (0.9, 0.99, 0.999)),
    ({"beta": 0.2, "pivot_amplitude": 1.0, "drive_frequency": 2.0}, "pivot_amplitude", -0.002, (0.9, 0.99, 0.999)),
]


def bordering():
    """Orbits near saddle-nodes, breaks of symmetry and doublings of the period, where transients are long."""
    for given, name, step, targets in SEEDS:
        p = parameters(**given)
        advance, _, ends = marched([p], [(0.2, 0.5)], 3000)
        count = least_period(advance[0])
        if count is None:
            raise ValueError(f"no orbit: {given}")
        for target in targets:
            found = moved_to(p, NAMES.index(name), step, ends[0][:2], count, target)
            if found is None:
                continue
            near, point = found
            start = (float(wrapped(point[0])) + 1e-5, float(point[1]))
            last = marched([near], [start], 3000)[2][0]
            if math.hypot(float(wrapped(last[0] - point[0])), float(last[1] - point[1])) < 5e-6:
                yield orbit_truth(near, start, point, count)


def moved_to(p, index, step, state, count, target):
    """Moves a parameter until the orbit's multiplier is the target: the parameters and the point, or None."""

    def at(value, guess):
        moved = (*p[:index], value, *p[index + 1 :])
        found = refined(moved, guess, count)
        return None if found is None else (found[0], multiplier(moved, found[2], count)[0], moved)

    low, point = p[index], np.array(state, dtype=LONG)
    for _ in range(2000):
        found = at(low + step, point)
        if found is None or abs(found[1]) > 1.5 or max(abs(found[0] - point)) > 0.3:
            step /= 2
            if abs(step) < 1e-12:
                return None
            continue
        beyond = found[1] > target if target > 0 else found[1] < target
        if beyond and abs(found[1] - target) > 1e-7:
            step /= 2
            continue
        low, point = low + step, found[0]
        if abs(found[1] - target) <= 1e-7 or abs(step) < 1e-13:
            return found[2], point
    return None


def birkhoff(values):
    """The mean of a smooth quasi-periodic sequence, which converges faster than any power (Das et al., Nonlinearity 30, 2017)."""
    t = np.arange(1, values.shape[-1]) / values.shape[-1]
    weights = np.exp(-1 / (t * (1 - t)))
    return values[..., 1:] @ weights / weights.sum()


DAMPED = [
    (beta, torque, drive, frequency, pivot)
    for beta in (0.5, 1.0, 2.0, 5.0)
    for torque, drive, frequency, pivot in (
        (beta * 2.2361, 1.0, 0.7, 0.0),
        (beta * -3.1623, 2.5, 1.0, 0.0),
        (1.9 + beta, 0.4, 1.6180339887498949, 0.0),
        (beta * 4.1231, 0.7, 0.9, 0.3),
        (beta * 1.7321 + 1, 3.0, 2.3, 0.0),
        (beta * 5.4772, 0.0, 2.0, 1.5),
        (2.6 * beta, 6.0, 4.3, 0.0),
    )
]
FREE = [
    (start, drive, pivot, frequency)
    for start in ((0.5, 0.0), (1.0, 0.0), (0.0, 3.0), (-1.0, -4.0))
    for drive, pivot, frequency in ((0.01, 0.0, 2.7), (0.05, 0.0, 3.3), (0.0, 0.05, 4.6), (0.1, 0.0, 7.0), (0.02, 0.01, 0.31))
]


def quasi_periodic(periods=8000, transient=1000):
    """Curves, far from ratios of small whole numbers, whose means converge to 9 digits; the errors are differences of runs."""
    damped = [
        ((0.3, 0.0), parameters(beta=b, torque=m, drive_amplitude=g, drive_frequency=w, pivot_amplitude=q))
        for b, m, g, w, q in DAMPED
    ]
    free = [(s, parameters(drive_amplitude=g, pivot_amplitude=q, drive_frequency=w)) for s, g, q, w in FREE]
    problems = damped + free
    rates, growths, advances = rotation(problems, periods, transient)
    for i, (start, p) in enumerate(problems):
        frequency = p[FREQUENCY] / (2 * math.pi)
        velocity, exponent = frequency * rates[-1][i], frequency * growths[-1][i]
        error = 3 * frequency * max(abs(x[i] - rates[-1][i]) for x in rates) + 1e-14 * abs(velocity)
        spread = 3 * frequency * max(abs(x[i] - growths[-1][i]) for x in growths) + abs(exponent)
        ratio = velocity / p[FREQUENCY]
        nearest = float(Fraction(ratio).limit_denominator(40))
        if p[1] == 0 and abs(np.cumsum(advances[i])).max() < 2 * math.pi and abs(velocity) < 1e-9:
            yield Truth("quasi_periodic", start, p, 0.0, 0.0, 0.0, 0.0, "quasi_periodic")
        elif error < 1e-9 and abs(ratio - nearest) > 1e-6 and (p[1] == 0 or spread < 1e-8):
            yield Truth("quasi_periodic", start, p, velocity, error, 0.0, spread if p[1] > 0 else 0.0, "quasi_periodic")


def rotation(problems, periods, transient):
    """Advances and growths in a period, each from runs with two numbers of steps and from halves of them, the best last."""
    ps, rates, growths = [p for _, p in problems], [], []
    for finer in (1.5, 2.0):
        damped, free = [i for i, p in enumerate(ps) if p[1] > 0], [i for i, p in enumerate(ps) if p[1] == 0]
        first = np.array([(*start, 1.0, 0.3) for start, _ in problems])
        first[damped] = marched([ps[i] for i in damped], list(first[damped]), transient, finer)[2]
        advance, growth = np.empty((len(ps), periods)), np.empty((len(ps), periods))
        for part in (damped, free):
            advance[part], growth[part], _ = marched([ps[i] for i in part], list(first[part]), periods, finer)
        rates += [birkhoff(advance[:, : periods // 2]), birkhoff(advance)]
        growths += [birkhoff(growth[:, : periods // 2]), birkhoff(growth)]
    return rates, growths, advance
