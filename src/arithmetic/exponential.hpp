// exp, log, log1p and asinh.
#pragma once

#include "arithmetic/coefficients.hpp"
#include "arithmetic/pack.hpp"
#include "arithmetic/polynomial.hpp"

namespace pendula::arithmetic::inline PENDULA_ISA {

/// e^x within 0.9 ulp; a denormal result is within 1 ulp. 0 for x < -745.2, infinity for x > 709.8. NaN gives NaN.
template <class T>
inline T exp(T x) {
    const T bounded = select(abs(x) < 800.0, x, copy_sign(splat<T>(800.0), x));
    const T n = (bounded * inverse_ln2[0] + rounder) - rounder;
    const T hi = bounded - n * ln2_parts[0];
    const T lo = n * -ln2_parts[1];
    const T r = hi + lo;
    const T rest = (hi - r) + lo;
    const T result = scale(1.0 + (r + (r * r * polynomial(r, exp_remainder) + (rest + rest * r))), n);
    return select(x == x, result, x);
}

/// log(1 + f) + n ln 2 + correction, where the correction is small and 1 + f, to the nearest double, lies in [sqrt(1/2),
/// sqrt(2)].
template <class T>
inline T log_of_parts(T f, T correction, T n) {
    const T s = f / (2.0 + f);
    const T z = s * s;
    const T half = 0.5 * f * f;
    // log(1 + f) = f - (f^2/2 - s (f^2/2 + R)) with R = z (...), arranged as in fdlibm so that f enters without rounding.
    const T remainder = z * polynomial(z, log_remainder);
    const T tail = s * (half + remainder) + (n * ln2_parts[1] + correction);
    return n * ln2_parts[0] - ((half - tail) - f);
}

/// The decomposition |x| = m 2^n with m in [sqrt(1/2), sqrt(2)).
template <class T>
struct Binade {
    T m;
    T n;
};

template <class T>
inline Binade<T> to_binade(T x) {
    const T a = abs(x);
    const auto is_small = a < 0x1p-1022;
    const auto b = bits(select(is_small, a * 0x1p54, a)) - 0x3fe6a09e667f3bcd;  // sqrt(1/2)
    const T n = from_bits<T>((b >> 52) + bits(splat<T>(rounder))) - rounder;
    return {from_bits<T>((b & 0xfffffffffffff) + 0x3fe6a09e667f3bcd), n - select(is_small, splat<T>(54.0), T{})};
}

/// The natural logarithm, within 0.9 ulp. 0 gives -infinity; a negative number or NaN gives NaN.
template <class T>
inline T log(T x) {
    const auto parts = to_binade(x);
    T result = log_of_parts(parts.m - 1.0, T{}, parts.n);
    result = select(x < __builtin_inf(), result, x);
    result = select(x == 0.0, splat<T>(-__builtin_inf()), result);
    return select(x < 0.0, splat<T>(__builtin_nan("")), result);
}

/// log(1 + x), within 1.2 ulp. -1 gives -infinity; a number below -1 or NaN gives NaN.
template <class T>
inline T log1p(T x) {
    const T u = 1.0 + x;
    const auto parts = to_binade(u);
    const T lost = select(abs(x) < 1.0, x - (u - 1.0), 1.0 - (u - x));
    // If n = 0, f is x itself and not the rounded 1 + x minus 1.
    const T f = select(parts.n == 0.0, x, parts.m - 1.0);
    T result = log_of_parts(f, select(parts.n == 0.0, T{}, lost / u), parts.n);
    result = select(abs(x) < 0x1p-54, x, result);
    result = select(x < __builtin_inf(), result, x);
    result = select(x == -1.0, splat<T>(-__builtin_inf()), result);
    return select(x < -1.0, splat<T>(__builtin_nan("")), result);
}

/// The inverse of sinh, within 1.8 ulp for |x| < 1e150. Odd to the last bit. NaN gives NaN.
template <class T>
inline T asinh(T x) {
    const T a = abs(x);
    const T square = a * a;
    return copy_sign(log1p(a + square / (1.0 + sqrt(1.0 + square))), x);
}

}  // namespace pendula::arithmetic::inline PENDULA_ISA
