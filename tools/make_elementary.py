"""Makes tests/data/elementary.txt: elementary functions on random and on hard arguments.

python tools/make_elementary.py > tests/data/elementary.txt     (needs python-flint; 2,400 bits)
"""

import math
import random
from fractions import Fraction

from flint import acb, arb, ctx
from reference_table import exact, nearest, pair, text

ctx.prec = 2400  # reducing a huge argument of sin takes 1,024 bits, and up to 60 more where the result is small
random.seed(20260102)
uniform = random.uniform
TINY, HUGE = 5e-324, math.nextafter(math.inf, 0)


def power(low: float, high: float) -> float:
    return random.choice((-1, 1)) * 10 ** uniform(low, high)


def near_quarter_turns(exponent: int) -> float:
    """The double m 2^exponent, m < 2^53, with the smallest relative distance to a multiple of pi/2, by continued fractions."""
    x = exact(arb(2) ** exponent * 2 / arb.pi())
    before, last = 0, 1  # denominators of two successive convergents of x
    while last < 2**53:
        best, x = last, 1 / (x - x.numerator // x.denominator)
        before, last = last, x.numerator // x.denominator * last + before
    return math.ldexp(float(best), exponent)


def quarter_turn_distance(x: float) -> Fraction:
    q = arb(x) * 2 / arb.pi()
    return abs(exact(q - (q + arb(0.5)).floor().unique_fmpz()))


def angles() -> list[float]:
    hard = sorted({near_quarter_turns(e) for e in range(-52, 971)}, key=quarter_turn_distance)
    xs = [
        6381956970095103.0 * 2.0**797,
        TINY,
        2.2e-308,
        2.0**-27,
        math.nextafter(2.0**-27, 0),
        2.0**-26,
        2.0**20,
        math.nextafter(2.0**20, 3e6),
        HUGE,
    ]
    xs += [math.pi / 4 * k for k in range(1, 17)] + hard[:40] + hard[60::18]
    return xs + [uniform(-4, 4) for _ in range(100)] + [power(0, 6.5) for _ in range(60)] + [power(-9, 308) for _ in range(100)]


def exponents() -> list[float]:
    edges = [
        709.782712893384,
        709.7827128933841,
        -745.1332191019411,
        -745.1332191019412,
        -708.3964185322641,
        -708.3964185322642,
        -744.4400719213812,
        -710.5,
        -740.25,
        1e-300,
        -TINY,
        1e-17,
        -1e-17,
        2.0**-53,
        2.0**-54,
    ]
    halves = [math.log(2) * (k + 0.5) for k in range(-12, 12)]
    return edges + halves + [uniform(-1, 1) for _ in range(80)] + [uniform(-745, 709.7) for _ in range(120)]


def positives() -> list[float]:
    ones = [1 + s * 2.0**-k for k in range(1, 53, 3) for s in (-1, 1)]
    roots = [math.sqrt(0.5) * (1 + k * 2.0**-51) for k in range(-3, 4)] + [
        math.sqrt(2) * (1 + k * 2.0**-51) for k in range(-3, 4)
    ]
    return (
        ones
        + roots
        + [TINY, 2e-310, 2.0**-1022, HUGE, 1e15]
        + [uniform(0.4, 2.2) for _ in range(80)]
        + [abs(power(-308, 308)) for _ in range(60)]
    )


def above_minus_one() -> list[float]:
    edges = [-1 + 2.0**-k for k in range(2, 54, 3)] + [
        2.0**-54,
        -(2.0**-54),
        2.0**-53,
        -(2.0**-53),
        2.0**53,
        2.0**54,
        TINY,
        HUGE,
        1e-300,
    ]
    roots = [math.sqrt(0.5) - 1 + k * 2.0**-53 for k in range(-3, 4)] + [math.sqrt(2) - 1 + k * 2.0**-53 for k in range(-3, 4)]
    return (
        edges
        + roots
        + [uniform(-0.9999, 2) for _ in range(100)]
        + [power(-20, -0.01) for _ in range(50)]
        + [abs(power(0, 300)) for _ in range(40)]
    )


def any_size(limit: float) -> list[float]:
    edges = [TINY, 1e-300, 2.0**-27, 2.0**-28, 1.0, -1.0, math.tan(math.pi / 8), 0.41421356237309503, 2.414213562373095, 1e8]
    return (
        edges
        + [uniform(-3, 3) for _ in range(100)]
        + [power(-limit, limit) for _ in range(50)]
        + [power(-8, 8) for _ in range(60)]
    )


def directions() -> list[tuple[float, float]]:
    edges = [
        (1e-320, 3e-320),
        (TINY, TINY),
        (TINY, -TINY),
        (HUGE, HUGE),
        (HUGE, -1.0),
        (1.0, HUGE),
        (-HUGE, 1e300),
        (1e300, -1e-300),
    ]
    wide = [(power(-300, 300), power(-300, 300)) for _ in range(50)]
    close = [(s, s * uniform(0.98, 1.02) * random.choice((-1, 1))) for s in (power(-307, 307) for _ in range(50))]
    return edges + wide + close + [(uniform(-1, 1), uniform(-1, 1)) for _ in range(120)]


def halves() -> list[float]:
    edges = [0.5, -0.5, 0.25, -0.25, math.nextafter(0.25, 1), math.nextafter(0.5, 0), 1e-300, 1e-20]
    return (
        edges
        + [uniform(-0.5, 0.5) for _ in range(100)]
        + [power(-15, -1) for _ in range(20)]
        + [0.5 - power(-15, -1) ** 2 for _ in range(20)]
    )


# The arguments with the largest errors among a million random ones, found by comparison with 113-bit arithmetic.
SEARCHED = {
    "sincos": ["0x1.f08fe82d23e4p+1", "0x1.f243e4b13b533p+1", "-0x1.2b3846de3795ep+41", "-0x1.fb502b924669dp+1"],
    "exp": ["-0x1.b68e7a9c3eb9bp+0", "0x1.24865fe17307p+6"],
    "log": ["0x1.67699c51bdd71p+0", "0x1.3df5a19bd1471p-1"],
    "log1p": ["0x1.a23e9c3e117c4p-2", "-0x1.7c79241fabbb2p-2", "0x1.b71fde98d0dcbp+0"],
    "asinh": ["0x1.085ca66fc2ep-1", "0x1.f61ab8f68a61ap-3", "-0x1.1ade0f644801fp+4"],
    "atan": ["-0x1.9626cfbc9e7b8p-2", "0x1.b64ec25850b0dp-2"],
    "sincos_of_half_turn": ["-0x1.54a42e81c5668p-3", "-0x1.58b9c822a73b6p-2", "-0x1.46452aa31246p-3", "-0x1.56062a09f7068p-2"],
}
SEARCHED_ATAN2 = [("-0x1.6158f0f5b9764p-1", "-0x1.2d41c01b81fep-2")]
SEARCHED_RF = [
    ("0", "0x1.fa010bcd2781dp-88"),
    ("0x1.eabd359094297p-94", "0x1.f3090ff2eb4e3p-85"),
    ("0x1.069813d0d07cp-78", "0x1.83df19651a7cep-42"),
]


def searched(name: str) -> list[float]:
    return [float.fromhex(x) for x in SEARCHED[name]]


def triples() -> list[tuple[float, float, float]]:
    """Arguments of R_F as they occur in the closed form: the last is 1."""
    some = [(abs(power(-32, 0)), abs(power(-32, 0)), 1.0) for _ in range(60)] + [
        (0.0, abs(power(-32, 0)), 1.0) for _ in range(40)
    ]
    return (
        some
        + [(x, 1 - x * uniform(0, 1), 1.0) for x in (uniform(0, 1) for _ in range(60))]
        + [(float.fromhex(x), float.fromhex(y), 1.0) for x, y in SEARCHED_RF]
    )


def full(x: arb) -> str:
    """The value as a sum of two full doubles."""
    hi = nearest(exact(x))
    return f"{text(hi)} {text(nearest(exact(x) - Fraction(hi)))}"


def cos_of_half_turn(f: float) -> arb:
    return arb(0) if abs(f) == 0.5 else arb(f).cos_pi()


def main():
    print("# Made by tools/make_elementary.py, which states the command; do not edit.")
    print("# FUNCTION argument... value...     values are pairs: the nearest double and the rest to 9 bits")
    xs = angles() + searched("sincos")
    for x in xs:
        print("sincos", text(x), pair(arb(x).sin()), pair(arb(x).cos()))
    for x in xs[::4]:
        print("sincos_double_double", text(x), full(arb(x).sin()), full(arb(x).cos()))
    for f in halves() + searched("sincos_of_half_turn"):
        print("sincos_of_half_turn", text(f), pair(arb(f).sin_pi()), pair(cos_of_half_turn(f)))
    for name, xs, f in (
        ("exp", exponents(), arb.exp),
        ("log", positives(), arb.log),
        ("log1p", above_minus_one(), arb.log1p),
        ("asinh", any_size(150), arb.asinh),
        ("atan", any_size(300), arb.atan),
    ):
        for x in xs + searched(name):
            if f is not arb.log or x != 1:
                print(name, text(x), pair(f(arb(x))))
    for y, x in directions() + [tuple(map(float.fromhex, t)) for t in SEARCHED_ATAN2]:
        print("atan2", text(y), text(x), pair(arb.atan2(arb(y), arb(x))))
    for t in triples():
        print("carlson_rf", *map(text, t), pair(acb.elliptic_rf(*map(arb, t)).real))


if __name__ == "__main__":
    main()
