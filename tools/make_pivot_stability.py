"""Makes tests/data/pivot_stability.txt: limits of stability of a pendulum with a shaken pivot, by Floquet theory.

    python tools/make_pivot_stability.py > tests/data/pivot_stability.txt     (needs python-flint; two minutes)
    python tools/make_pivot_stability.py check                                (needs mpmath too; minutes; prints differences)

A small displacement x from the hanging state obeys x'' + beta x' + (alpha + P cos(Omega t)) x = 0. A displacement from the
upright state obeys the same equation with -alpha and -P; the sign of P is a shift of time by half a period. With
x = e^(-beta t/2) y this becomes Mathieu's equation y'' + (a + P cos(Omega t)) y = 0 with a = +-alpha - beta^2/4. The product of
the two multipliers of y over a period T is 1, and their sum is the trace of the map over T. So x grows if
|trace| > 2 cosh(beta T/2). Because cos(Omega t) is even about t = 0 and about t = T/2, the trace follows from the even and the
odd solution at T/2, which are power series that converge everywhere. The check integrates the equation of x over a whole period
instead, by mpmath's Taylor method.
"""

import sys

from flint import arb, ctx
from reference_table import pair, text

ctx.prec = 256
TERMS = 128  # of a power series; the truncated terms are below (T/2 sqrt(|a| + |P|))^128/128!


def half_period(a: arb, pivot: arb, frequency: arb):
    """The even and the odd solution and their derivatives by s, at s = 1; the time is t = s T/2."""
    scale = (arb.pi() / frequency) ** 2
    cosine = [(-1) ** k * arb.pi() ** (2 * k) / arb.fac_ui(2 * k) for k in range(TERMS)]
    rate = [scale * ((a if k == 0 else 0) + pivot * c) for k, c in enumerate(cosine)]  # powers of s^2
    values = []
    for first in (0, 1):  # the series has the powers first, first + 2, ... of s
        y = [arb(1)]
        for n in range(TERMS - 1):
            power = 2 * n + first
            y.append(-sum(rate[k] * y[n - k] for k in range(n + 1)) / ((power + 1) * (power + 2)))
        values.append((sum(y), sum((2 * n + first) * c for n, c in enumerate(y))))
    return values


def trace(a: arb, pivot: arb, frequency: arb) -> arb:
    (even, _), (_, odd_slope) = half_period(a, pivot, frequency)
    return 2 * (2 * even * odd_slope - 1)


def excess(alpha, beta, pivot, frequency, sign) -> arb:
    """sign trace - 2 cosh(beta T/2), which is zero if a multiplier of x is equal to sign. alpha < 0 for the upright state."""
    alpha, beta, pivot, frequency = map(arb, (alpha, beta, pivot, frequency))
    return sign * trace(alpha - beta**2 / 4, pivot, frequency) - 2 * (beta * arb.pi() / frequency).cosh()


def exponent(alpha, beta, pivot, frequency) -> arb:
    """The largest growth rate of x."""
    alpha, beta, pivot, frequency = map(arb, (alpha, beta, pivot, frequency))
    half_trace = abs(trace(alpha - beta**2 / 4, pivot, frequency)) / 2
    growth = half_trace.acosh() * frequency / (2 * arb.pi()) if half_trace > 1 else arb(0)
    return growth - beta / 2


def root(f, low, high) -> arb:
    """The zero of f between two arguments at which f has different signs, by bisection."""
    low, high = arb(low), arb(high)
    is_positive = f(low) > 0
    if is_positive == (f(high) > 0):
        raise ValueError(f"no change of sign between {low} and {high}")
    for _ in range(140):
        middle = ((low + high) / 2).mid()
        low, high = (middle, high) if (f(middle) > 0) == is_positive else (low, middle)
    return middle


def upright_limits(alpha, beta, frequency):
    """The amplitudes between which the upright state is stable."""
    start = 1.41421356 * alpha**0.5 * frequency
    low = root(lambda p: excess(-alpha, beta, p, frequency, 1), 0.8 * start, 1.3 * start)
    high = root(lambda p: excess(-alpha, beta, p, frequency, -1), 0.4 * frequency**2, 0.7 * frequency**2)
    return low, high


def tongue(alpha, beta, pivot, middle):
    """The frequencies between which the hanging state is unstable; it is unstable at the frequency `middle`."""

    def f(frequency):
        return excess(alpha, beta, pivot, frequency, -1)

    return root(f, 0.8 * middle, middle), root(f, middle, 1.25 * middle)


def threshold(alpha, beta):
    """The smallest amplitude at which the tongue near 2 sqrt(alpha) exists, and its frequency, by golden-section search."""

    def boundary(frequency):
        return root(lambda p: excess(alpha, beta, p, frequency, -1), 0, 8 * beta)

    low, high = arb(1.9), arb(2.1)  # times sqrt(alpha)
    ratio = (arb(5).sqrt() - 1) / 2
    root_alpha = arb(alpha).sqrt()
    while high - low > 1e-16:
        a, b = (high - ratio * (high - low)).mid(), (low + ratio * (high - low)).mid()
        low, high = (low, b) if boundary(a * root_alpha) < boundary(b * root_alpha) else (a, high)
    frequency = (a * root_alpha).mid()
    return boundary(frequency), frequency


UPRIGHT = [(1.0, beta, frequency) for beta in (0.0, 0.05) for frequency in (10.0, 20.0, 40.0, 80.0)] + [(9.81, 0.1, 60.0)]
TONGUES = [(1.0, beta, pivot) for beta in (0.0, 0.05) for pivot in (0.2, 0.5)] + [(4.0, 0.1, 1.5)]
THRESHOLDS = [(1.0, 0.05)]
FREQUENCIES = (1.5, 1.99, 2.0, 2.03, 2.5)
HANGING = [(1.0, beta, pivot, frequency) for beta in (0.0, 0.05) for pivot in (0.2, 0.5) for frequency in FREQUENCIES]
HANGING += [(1.0, 0.05, 1.0, 1.0), (1.0, 0.0, -3.0, 2.0), (4.0, 0.2, 5.0, 4.0)]
TOP = [(1.0, 0.0, 20.0, 20.0), (1.0, 0.05, 28.0, 20.0), (1.0, 0.0, 30.0, 20.0), (1.0, 0.05, 200.0, 20.0)]


def table():
    print("# Made by tools/make_pivot_stability.py, which states the command; do not edit.")
    print("# upright alpha beta frequency | lowest and highest pivot_amplitude at which the upright state is stable")
    print("# tongue alpha beta pivot_amplitude | frequencies near 2 sqrt(alpha) between which the hanging state is unstable")
    print("# threshold alpha beta | lowest pivot_amplitude of that tongue, and its frequency to 16 digits")
    print("# hanging, top: alpha beta pivot_amplitude frequency | largest Floquet exponent at rest there")
    print("#     pairs: nearest double and rest")
    for problem in UPRIGHT:
        print("upright", *map(text, problem), *map(pair, upright_limits(*problem)))
    for problem in TONGUES:
        print("tongue", *map(text, problem), *map(pair, tongue(*problem, 2 * problem[0] ** 0.5)))
    for problem in THRESHOLDS:
        print("threshold", *map(text, problem), *map(pair, threshold(*problem)))
    for problem in HANGING:
        print("hanging", *map(text, problem), pair(exponent(*problem).mid()))
    for problem in TOP:
        print("top", *map(text, problem), pair(exponent(-problem[0], *problem[1:]).mid()))


def check():
    """Computes every number again, from the equation of x with friction over a whole period, by mpmath's Taylor method."""
    from mpmath import mp, mpf

    mp.dps = 35

    def multiplier(alpha, beta, pivot, frequency):
        """The larger modulus of the two multipliers of x."""
        alpha, beta, pivot, frequency = (mpf(str(arb(v).str(45, radius=False))) for v in (alpha, beta, pivot, frequency))
        period = 2 * mp.pi / frequency
        columns = []
        for start in ([1, 0], [0, 1]):
            f = mp.odefun(lambda t, y: [y[1], -beta * y[1] - (alpha + pivot * mp.cos(frequency * t)) * y[0]], 0, start)
            columns.append(f(period))
        (x1, v1), (x2, v2) = columns
        half, product = (x1 + v2) / 2, x1 * v2 - x2 * v1
        inner = mp.sqrt(mp.mpc(half**2 - product))
        return max(abs(half + inner), abs(half - inner)), period

    def report(name, problem, departure):
        print(name, *problem, mp.nstr(departure, 3))
        if abs(departure) > 1e-14:  # half of the digits are lost where the two multipliers are equal
            raise SystemExit("the check disagrees")

    for alpha, beta, frequency in UPRIGHT:
        for pivot in upright_limits(alpha, beta, frequency):
            report("upright", (alpha, beta, frequency), multiplier(-alpha, beta, pivot, frequency)[0] - 1)
    for alpha, beta, pivot in TONGUES:
        for frequency in tongue(alpha, beta, pivot, 2 * alpha**0.5):
            report("tongue", (alpha, beta, pivot), multiplier(alpha, beta, pivot, frequency)[0] - 1)
    for problem in THRESHOLDS:
        report("threshold", problem, multiplier(*problem, *threshold(*problem))[0] - 1)
    for sign, name, problems in ((1, "hanging", HANGING), (-1, "top", TOP)):
        for problem in problems:
            largest, period = multiplier(sign * problem[0], *problem[1:])
            own = exponent(sign * problem[0], *problem[1:]).mid().str(35, radius=False)
            report(name, problem, mp.log(largest) / period - mpf(own))


if __name__ == "__main__":
    check() if sys.argv[1:] == ["check"] else table()
