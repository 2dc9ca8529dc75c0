"""Long-time truths of undriven pendulums, for tools/make_truths.py: rest, limit cycles, conservative motions."""

import itertools
import math
from dataclasses import dataclass

import numpy as np
from flint import arb, arb_mat, ctx
from mpmath import mp, mpf
from true_motions import LONG, PI, followed, parameters, turned

mp.dps = 40
ctx.prec = 256


@dataclass
class Truth:
    group: str
    start: tuple[float, float]
    pendulum: tuple[float, ...]
    velocity: float  # nan where it is unknown
    velocity_error: float
    exponent: float
    exponent_error: float
    kind: str  # of enum Kind; - where it is not certain


def ulp(x):
    return math.ulp(x) if x else 0.0


def eigenvalue(p):
    """The larger real part of the eigenvalues at rest, rounded once."""
    alpha, beta, torque = map(mpf, p[:3])
    discriminant = beta**2 / 4 - mp.sqrt(alpha**2 - torque**2)
    return float(-beta / 2 + mp.sqrt(max(discriminant, mpf(0))))


def is_trapped(p, state):
    """Whether the energy is below the lower barrier of the well: friction then holds the pendulum there for ever."""
    alpha, torque = p[0], p[2]
    sense = -1 if torque < 0 else 1
    theta, omega, torque = sense * state[0], sense * state[1], sense * torque
    barrier = math.pi - math.asin(torque / alpha)
    theta = float((theta - barrier) % (2 * PI)) + barrier - 2 * math.pi
    if min(theta - barrier + 2 * math.pi, barrier - theta) < 1e-6:
        return False
    return omega**2 / 2 - alpha * math.cos(theta) - torque * theta < -alpha * math.cos(barrier) - torque * barrier - 1e-12


def comes_to_rest(p, start, longest=30000.0):
    state, t = start, 0.0
    while t < longest:
        if is_trapped(p, state):
            return True
        state = followed(p, state, LONG(10))
        t += 10
    return False


def resting(group, start, **given):
    p = parameters(**given)
    if not comes_to_rest(p, start):
        raise ValueError(f"not at rest: {start} {given}")
    exponent = eigenvalue(p)
    return Truth(group, start, p, 0.0, 0.0, exponent, ulp(exponent), "fixed_point")


def limit_cycle(p, section=0.0):
    """The period and omega at the section of the limit cycle with positive velocity, by Newton's method on the return map.

    The derivative of the return map is omega/omega' exp(-beta T), since friction shrinks areas by exp(-beta T). A step that
    falls short of the next turn is halved.
    """
    omega = LONG(max(p[2] / p[1], 2.0) + 0.5 * math.sqrt(p[0]))
    change = LONG(0)
    for _ in range(200):
        found = turned(p, (LONG(section), omega), 2 * PI, 1e3 if p[2] < p[0] else 1e7)
        if found is None:
            change /= 2
            omega -= change
            continue
        period, after = found
        slope = min(omega / after * np.exp(-LONG(p[1]) * period), LONG("0.999999999"))
        change = (after - omega) / (1 - slope)
        omega += change
        if abs(change) < 1e-17 * omega:
            break
    return period, omega


def reaches_cycle(p, start, omega):
    """Whether the returns of the start to theta = 0 come nearer to those of the cycle; the return map is monotonic."""
    state, distance = start, math.inf
    for _ in range(400):
        theta = LONG(state[0])
        angle = np.ceil(theta / (2 * PI) + LONG(1e-9)) * 2 * PI - theta
        found = turned(p, (theta, state[1]), angle, 1e4 if p[2] < p[0] else 1e7)
        if found is None:
            return False
        state = (LONG(0), found[1])
        if abs(found[1] - omega) > distance:
            return False
        distance = abs(found[1] - omega)
        if distance < 1e-3 * omega:
            return True
    return True


def rotating(group, start, **given):
    """A limit cycle by Taylor series, from two sections that need different steps; their difference tells of the error."""
    p = parameters(**given)
    sense = math.copysign(1, p[2])
    mirrored = (*p[:2], abs(p[2]), *p[3:])
    period, omega = limit_cycle(mirrored)
    other, _ = limit_cycle(mirrored, section=1.25)
    if not reaches_cycle(mirrored, (sense * start[0], sense * start[1]), omega):
        raise ValueError(f"does not rotate: {start} {given}")
    velocity = 2 * PI / period
    error = 10 * abs(velocity - 2 * PI / other) + 1e-17 * velocity
    return Truth(group, start, p, sense * float(velocity), float(error) + ulp(float(velocity)), 0.0, 0.0, "rotating")


def collocated(p, modes):
    """The period of an overdamped limit cycle: omega(theta) as a trigonometric polynomial with
    omega omega' = torque - alpha sin(theta) - beta omega at 2 modes + 1 angles, by Newton's method in 256 bits; then the
    integral of 1/omega by Gauss and Legendre's rule on panels that shrink towards the least omega.
    """
    alpha, beta, torque = (arb(x) for x in p[:3])
    count = 2 * modes + 1
    angles = [2 * arb.pi() * j / count for j in range(count)]
    slopes = [arb(0)] + [(-1) ** j / (2 * (arb.pi() * j / count).sin()) for j in range(1, count)]
    derivative = [
        [slopes[j - k] if j > k else (-slopes[k - j] if k > j else arb(0)) for k in range(count)] for j in range(count)
    ]
    force = [torque - alpha * a.sin() for a in angles]
    omega = [f / beta for f in force]
    for _ in range(30):
        slope = [sum((d * w for d, w in zip(row, omega, strict=True)), arb(0)) for row in derivative]
        rest = [w * s + beta * w - f for w, s, f in zip(omega, slope, force, strict=True)]
        matrix = arb_mat(
            [
                [w * d + (s + beta if j == k else 0) for k, d in enumerate(row)]
                for j, (row, w, s) in enumerate(zip(derivative, omega, slope, strict=True))
            ]
        )
        change = matrix.solve(arb_mat([[r] for r in rest]), algorithm="approx")
        omega = [(w - change[j, 0]).mid() for j, w in enumerate(omega)]
        if max(abs(float(change[j, 0])) for j in range(count)) < 1e-45:
            break
    cosines = [
        sum((w * (m * a).cos() for w, a in zip(omega, angles, strict=True)), arb(0)).mid() * 2 / count for m in range(modes + 1)
    ]
    sines = [
        sum((w * (m * a).sin() for w, a in zip(omega, angles, strict=True)), arb(0)).mid() * 2 / count for m in range(modes + 1)
    ]
    cosines[0] /= 2

    def speed(theta):
        c, s = theta.cos(), theta.sin()
        x, y, total = arb(1), arb(0), cosines[0]
        for a, b in zip(cosines[1:], sines[1:], strict=True):
            x, y = (x * c - y * s).mid(), (x * s + y * c).mid()
            total += a * x + b * y
        return total.mid()

    return graded_integral(lambda theta: 1 / speed(theta), arb.pi() / 2, math.sqrt(2 * float(torque - alpha) / float(alpha)))


def graded_integral(f, centre, width, points=40):
    rule = [arb.legendre_p_root(points, k, weight=True) for k in range(points)]
    ends = [arb(width) * 2**k for k in range(-3, 60) if width * 2**k < 3]
    ends = [arb(0), *ends, arb.pi()]
    total = arb(0)
    for low, high in itertools.pairwise(ends):
        for sense in (-1, 1):
            for node, weight in rule:
                x = ((low + high) / 2 + (high - low) / 2 * node).mid()
                total += weight * (high - low) / 2 * f((centre + sense * x).mid())
    return total.mid()


def overdamped(group, start, modes=40, **given):
    """A rotating pendulum with beta > 1.3 sqrt(alpha) by collocation, with two numbers of modes."""
    p = parameters(**given)
    coarse, fine = (2 * arb.pi() / collocated(p, m) for m in (modes, modes + modes // 3))
    velocity = float(fine)
    error = 10 * abs(float(fine - coarse)) + ulp(velocity)
    if not error < 1e-11 * velocity:
        raise ValueError(f"not resolved: {given}, {velocity}, {error}")
    return Truth(group, start, p, velocity, error, 0.0, 0.0, "rotating")


def homoclinic_torque(beta):
    """The torque above which a pendulum with alpha = 1 rotates, by bisection from the saddle's unstable direction."""
    low, high = LONG(0), LONG(1)
    while high - low > 1e-17:
        torque = (low + high) / 2
        barrier = PI - np.arcsin(torque)
        rate = -LONG(beta) / 2 + np.sqrt(LONG(beta) ** 2 / 4 + np.sqrt(1 - torque**2))
        p = parameters(beta=beta)
        p = (*p[:2], torque, *p[3:])
        shift = LONG(1e-9)
        found = turned(p, (barrier - 2 * PI + shift, rate * shift), 2 * PI - 2 * shift, 200.0)
        if found is None:
            low = torque
        else:
            high = torque
        if torque in (low + 0, high + 0) and high - low < 1e-18:
            break
    return float(high)


def conservative(group, start, alpha):
    a, theta, omega = mpf(alpha), mpf(start[0]), mpf(start[1])
    kappa = mp.sin(theta / 2) ** 2 + omega**2 / (4 * a)
    complement = mp.cos(theta / 2) ** 2 - omega**2 / (4 * a)
    velocity, exponent = mpf(0), mpf(0)
    if complement == 0:
        exponent = mp.sqrt(a)
    elif complement < 0:
        velocity = mp.sign(omega) * 2 * mp.sqrt(a) * mp.agm(mp.sqrt(kappa), mp.sqrt(-complement))
    kind = "conservative" if start != (0.0, 0.0) else "-"
    numbers = float(velocity), ulp(float(velocity)), float(exponent), ulp(float(exponent))
    return Truth(group, start, parameters(alpha=alpha), *numbers, kind)


def torqued(group, start, **given):
    """Without friction: bounded in a well, or accelerated for ever."""
    p = parameters(**given)
    if abs(p[2]) < p[0] and is_trapped(p, start):
        return Truth(group, start, p, 0.0, 0.0, 0.0, 0.0, "conservative")
    return Truth(group, start, p, math.nan, math.nan, 0.0, 0.0, "unbounded")
