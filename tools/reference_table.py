"""The format of numbers in reference tables: C99 hex floats; a true value is the nearest double and the remainder."""

import math
from fractions import Fraction

from flint import arb

REST_BITS = 9  # of the remainder, so that errors can be measured to 2^-10 ulp


def exact(x: arb) -> Fraction:
    """The midpoint of a ball, as a fraction. The ball must have many more good digits than the table keeps."""
    if not x.is_exact() and not x.is_zero() and x.rel_accuracy_bits() < 100:
        raise ValueError(f"too few good digits: {x}")
    mantissa, exponent = x.mid().man_exp()
    mantissa, exponent = int(mantissa), int(exponent)
    return Fraction(mantissa << exponent) if exponent >= 0 else Fraction(mantissa, 1 << -exponent)


def nearest(x: Fraction) -> float:
    """The nearest double, or infinity on overflow."""
    try:
        return x.numerator / x.denominator
    except OverflowError:
        return math.inf if x > 0 else -math.inf


def text(x: float) -> str:
    if math.isnan(x):
        return "nan"
    if math.isinf(x):
        return "inf" if x > 0 else "-inf"
    mantissa, exponent = x.hex().split("p")
    if "." in mantissa:
        mantissa = mantissa.rstrip("0").rstrip(".")
    return f"{mantissa}p{exponent}" if x else ("0" if math.copysign(1, x) > 0 else "-0")


def pair(x: arb | Fraction | int | float) -> str:
    """`hi lo`, where hi is the nearest double and lo the remainder rounded to REST_BITS bits."""
    if isinstance(x, float) and not math.isfinite(x):
        return f"{text(x)} 0"
    value = exact(x) if isinstance(x, arb) else Fraction(x)
    hi = nearest(value)
    if not math.isfinite(hi):
        return f"{text(hi)} 0"
    rest = nearest(value - Fraction(hi))
    if abs(rest) < math.ulp(hi) * 2.0**-60:
        return f"{text(hi)} 0"
    mantissa, exponent = math.frexp(rest)
    return f"{text(hi)} {text(math.ldexp(round(math.ldexp(mantissa, REST_BITS)), exponent - REST_BITS))}"
