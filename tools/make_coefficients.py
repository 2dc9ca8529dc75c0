"""Makes src/arithmetic/coefficients.hpp: polynomials and constants of the elementary functions.

    python tools/make_coefficients.py > src/arithmetic/coefficients.hpp     (needs mpmath)

A polynomial is a Chebyshev expansion, whose error is within a factor 2 of that of the best polynomial. The comment before it
names the smooth function that it approximates, the interval of the reduced argument (a small margin is added), and the
largest error, relative to the elementary function of which the polynomial is a part.
"""

from mpmath import atan, chebyfit, cos, exp, factorial, log, mp, mpf, pi, polyval, sin, sqrt

mp.dps = 60


def double(x):
    return float(x)  # mpmath rounds to nearest


def parts(x, bits):
    """x as a sum of doubles with the given numbers of bits, largest first. The last one is a full double."""
    out = []
    for b in bits:
        scale = mpf(2) ** (b - 1 - int(mp.floor(mp.log(abs(x), 2))))
        part = mp.floor(x * scale) / scale
        out.append(double(part))
        x -= part
    return [*out, double(x)]


def array(name, values, comment):
    print(f"// {comment}")
    print(f"inline constexpr double {name}[{len(values)}] = {{")
    for v in values:
        print(f"    {v.hex()},")
    print("};\n")


def polynomial(name, what, f, interval, terms, weight=lambda _: 1):
    """Prints the coefficients of f, constant first, and the error of the polynomial with rounded coefficients, times weight."""
    coefficients = [double(c) for c in reversed(chebyfit(f, interval, terms))]
    a, b = interval
    points = [a + (b - a) * mpf(i) / 400 for i in range(1, 400)]
    error = max(abs((polyval(coefficients[::-1], u) - f(u)) * weight(u)) for u in points)
    array(name, coefficients, f"{what}: largest error {mp.nstr(error, 2)} = 2^{mp.nstr(mp.log(error, 2), 3)}.")


def around_zero(f, series):
    """The function f, by its Taylor series near zero, where the formula of f suffers from cancellation."""
    return lambda u: series(u) if abs(u) < mpf("1e-6") else f(u)


def power_series(coefficient, terms=12):
    return lambda u: sum(coefficient(n) * u**n for n in range(terms))


def trigonometric(suffix, bound, sin_terms, cos_terms, comment):
    interval = [0, mpf(bound) ** 2]
    polynomial(
        f"sin_{suffix}",
        f"(sin x - x)/x^3 in x^2, |x| <= {comment}, relative to sin x",
        around_zero(
            lambda u: (sin(sqrt(u)) - sqrt(u)) / sqrt(u) ** 3, power_series(lambda n: (-1) ** (n + 1) / factorial(2 * n + 3))
        ),
        interval,
        sin_terms,
        lambda u: u,
    )
    polynomial(
        f"cos_{suffix}",
        f"(cos x - 1 + x^2/2)/x^4 in x^2, |x| <= {comment}, absolute",
        around_zero(lambda u: (cos(sqrt(u)) - 1 + u / 2) / u**2, power_series(lambda n: (-1) ** n / factorial(2 * n + 4))),
        interval,
        cos_terms,
        lambda u: u**2,
    )


print("""// Made by tools/make_coefficients.py, which states the command; do not edit.
#pragma once

namespace pendula::arithmetic {
""")
array(
    "pi_over_2_parts",
    parts(pi / 2, [33, 33, 33]),
    "pi/2 in 33 + 33 + 33 + 53 bits: products by a whole number below 2^20 are exact.",
)
array("two_over_pi", [double(2 / pi)], "2/pi.")
doubles = {
    "pi_dd": pi,
    "two_pi_dd": 2 * pi,
    "pi_over_2_dd": pi / 2,
    "pi_over_180_dd": pi / 180,
    "ln2_dd": log(2),
    "inverse_two_pi_dd": 1 / (2 * pi),
}
for name, x in doubles.items():
    array(name, [double(x), double(x - mpf(double(x)))], f"{name[:-3]} in two doubles.")
array(
    "two_pi_parts",
    parts(2 * pi, [26, 26, 53]),
    "2 pi in 26 + 26 + 53 + 53 bits: products by a whole number of up to 27 bits are exact in the first two.",
)
array("ln2_parts", parts(log(2), [32]), "ln 2 in 32 + 53 bits: products by a binary exponent are exact in the first.")
array("inverse_ln2", [double(1 / log(2))], "1/ln 2.")
for name, x in {"mark_sine_dd": sin(mpf("0.999") * pi / 2), "mark_cosine_dd": cos(mpf("0.999") * pi / 2)}.items():
    array(
        name,
        [double(x), double(x - mpf(double(x)))],
        f"{name[5:-3]} of 0.999 pi/2, half the angle at which the time on the separatrix ends (3.5), in two doubles.",
    )

trigonometric("quarter", pi / 4 * mpf("1.0001"), 6, 6, "pi/4")
trigonometric("short", mpf(1) / 48, 2, 2, "1/48")
polynomial(
    "sin_turn",
    "sin(pi f)/f in f^2, |f| <= 1/4, relative to sin(pi f)",
    around_zero(
        lambda u: sin(pi * sqrt(u)) / sqrt(u), power_series(lambda n: (-1) ** n * pi ** (2 * n + 1) / factorial(2 * n + 1))
    ),
    [0, mpf(1) / 16 * mpf("1.0001")],
    7,
    lambda _: 1 / pi,
)
polynomial(
    "cos_turn",
    "(cos(pi f) - 1)/f^2 in f^2, |f| <= 1/4, absolute",
    around_zero(
        lambda u: (cos(pi * sqrt(u)) - 1) / u,
        power_series(lambda n: (-1) ** (n + 1) * pi ** (2 * n + 2) / factorial(2 * n + 2)),
    ),
    [0, mpf(1) / 16 * mpf("1.0001")],
    7,
    lambda u: u,
)
polynomial(
    "exp_remainder",
    "(exp x - 1 - x)/x^2, |x| <= ln(2)/2, relative to exp x",
    around_zero(lambda x: (exp(x) - 1 - x) / x**2, power_series(lambda n: 1 / factorial(n + 2))),
    [-log(2) / 2 * mpf("1.0001"), log(2) / 2 * mpf("1.0001")],
    11,
    lambda x: x**2 / exp(x),
)
polynomial(
    "log_remainder",
    "(log((1 + s)/(1 - s)) - 2 s)/s^3 in s^2, s <= (sqrt 2 - 1)/(sqrt 2 + 1), relative to the logarithm",
    around_zero(
        lambda u: (log((1 + sqrt(u)) / (1 - sqrt(u))) - 2 * sqrt(u)) / sqrt(u) ** 3,
        power_series(lambda n: mpf(2) / (2 * n + 3)),
    ),
    [0, ((sqrt(2) - 1) / (sqrt(2) + 1)) ** 2 * mpf("1.0001")],
    7,
    lambda u: u / 2,
)
polynomial(
    "atan_remainder",
    "(atan x - x)/x^3 in x^2, |x| <= tan(pi/8), relative to atan x",
    around_zero(lambda u: (atan(sqrt(u)) - sqrt(u)) / sqrt(u) ** 3, power_series(lambda n: mpf(-1) ** (n + 1) / (2 * n + 3))),
    [0, (sqrt(2) - 1) ** 2 * mpf("1.0001")],
    11,
    lambda u: u,
)

inverse_factorials = [1 / factorial(n) for n in range(2, 30)]
array("inverse_factorial_hi", [double(x) for x in inverse_factorials], "1/n! for n = 2, 3, …: leading doubles.")
array("inverse_factorial_lo", [double(x - mpf(double(x))) for x in inverse_factorials], "1/n!: the remainders.")

words = []
fraction = 2 / pi
mp.prec = 1400
fraction = 2 / pi
for _ in range(40):
    fraction *= 2**32
    word = int(mp.floor(fraction))
    fraction -= word
    words.append(word)
print("// 2/pi after the binary point, 32 bits a word: enough for the largest double and 100 bits beyond.")
print(f"inline constexpr unsigned two_over_pi_words[{len(words)}] = {{")
for i in range(0, len(words), 8):
    print("    " + " ".join(f"0x{w:08x}u," for w in words[i : i + 8]))
print("};\n")
print("}  // namespace pendula::arithmetic")
