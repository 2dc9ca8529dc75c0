// sin, cos and sincos for every double, and sincos in double-double.
#pragma once

#include "arithmetic/coefficients.hpp"
#include "arithmetic/double_double.hpp"
#include "arithmetic/polynomial.hpp"
#include "arithmetic/reduce_huge.hpp"

namespace pendula::arithmetic::inline PENDULA_ISA {

template <class T>
struct SinCos {
    T sin;
    T cos;
};

/// An angle reduced by quarter turns: x = hi + lo + (pi/2) quadrant, of which only quadrant mod 4 is used.
template <class T>
struct Reduction {
    T hi;
    T lo;
    Bits<T> quadrant;
};

/// The reduction of x, with |hi + lo| <= pi/4 (1 + 2^-20) and an error below 2^-130 (1 + |x|). An infinite x or NaN gives NaN.
template <class T>
inline Reduction<T> reduce_to_quarter_turn(T x) {
    constexpr double limit = 0x1p20;  // x 2/pi is below 2^20, so that the products with n are exact
    const T shifted = x * two_over_pi[0] + rounder;
    const T n = shifted - rounder;
    const auto a = two_sum(x - n * pi_over_2_parts[0], -(n * pi_over_2_parts[1]));
    const auto b = two_sum(a.hi, -(n * pi_over_2_parts[2]));
    const auto r = two_sum(b.hi, (a.lo + b.lo) - n * pi_over_2_parts[3]);
    Reduction<T> result{r.hi, r.lo, bits(shifted)};
    if (any<T>(abs(x) > limit)) {
        for (int i = 0; i < lanes<T>; ++i) {
            if (!(abs(lane(x, i)) > limit)) continue;
            const auto huge = reduce_huge(lane(x, i));
            lane(result.hi, i) = huge.hi;
            lane(result.lo, i) = huge.lo;
            reinterpret_cast<std::int64_t*>(&result.quadrant)[i] = huge.quadrant;
        }
    }
    return result;
}

/// sin and cos of hi + lo, for |hi + lo| <= pi/4.
template <class T>
inline SinCos<T> sincos_quarter(T hi, T lo) {
    const T z = hi * hi;
    const T half = 0.5 * z;
    const T w = 1.0 - half;
    return {hi + (hi * z * polynomial(z, sin_quarter) + lo * w),
            w + (((1.0 - w) - half) + (z * z * polynomial(z, cos_quarter) - hi * lo))};
}

/// sin and cos of an angle, from those of the reduced angle and the quadrant.
template <class T>
inline SinCos<T> rotate_quadrants(SinCos<T> r, Bits<T> quadrant) {
    const auto is_odd = (quadrant & 1) != 0;
    const T s = select(is_odd, r.cos, r.sin);
    const T c = select(is_odd, r.sin, r.cos);
    return {from_bits<T>(bits(s) ^ (quadrant & 2) << 62), from_bits<T>(bits(c) ^ ((quadrant + 1) & 2) << 62)};
}

/// sin x and cos x, within 0.95 ulp for every finite x. sin is odd and cos is even to the last bit. An infinite x or NaN gives
/// NaN.
template <class T>
inline SinCos<T> sincos(T x) {
    const auto r = reduce_to_quarter_turn(x);
    auto result = rotate_quadrants(sincos_quarter(r.hi, r.lo), r.quadrant);
    result.sin = select(abs(x) < 0x1p-27, x, result.sin);  // keeps -0 and denormal numbers
    return result;
}

template <class T>
inline T sin(T x) {
    return sincos(x).sin;
}

template <class T>
inline T cos(T x) {
    return sincos(x).cos;
}

/// sin(pi f) and cos(pi f) for |f| <= 1/2 (1 + 2^-50), within 3 ulp. Exactly +-1 and 0 for f = +-1/2.
template <class T>
inline SinCos<T> sincos_of_half_turn(T f) {
    const T a = abs(f);
    const auto is_steep = a > 0.25;
    const T g = select(is_steep, 0.5 - a, a);
    const T u = g * g;
    const T s = g * polynomial(u, sin_turn);
    const T c = 1.0 + u * polynomial(u, cos_turn);
    return {copy_sign(select(is_steep, c, s), f), select(is_steep, s, c)};
}

/// sin x and cos x in double-double for |x| <= 2^1023, by the Taylor series up to power 28 on |x| <= pi/4. The absolute error
/// is below 2^-103. The relative error is below 2^-100, except near the zeros for huge arguments. It is used for scalars only.
template <class T>
inline SinCos<DoubleDouble<T>> sincos_double_double(T x) {
    const auto r = reduce_to_quarter_turn(x);
    const DoubleDouble<T> angle{r.hi, r.lo};
    const auto square = angle * angle;
    DoubleDouble<T> even{};
    DoubleDouble<T> odd{};
    const auto inverse_factorial = [](int n) {
        return DoubleDouble<T>{splat<T>(inverse_factorial_hi[n - 2]), splat<T>(inverse_factorial_lo[n - 2])};
    };
    for (int n = 28; n >= 2; n -= 2) {
        even = inverse_factorial(n) - even * square;
        odd = inverse_factorial(n + 1) - odd * square;
    }
    const auto s = angle - angle * square * odd;
    const auto c = -(square * even) + splat<T>(1.0);
    const auto hi = rotate_quadrants<T>({s.hi, c.hi}, r.quadrant);
    const auto lo = rotate_quadrants<T>({s.lo, c.lo}, r.quadrant);
    return {{hi.sin, lo.sin}, {hi.cos, lo.cos}};
}

}  // namespace pendula::arithmetic::inline PENDULA_ISA
