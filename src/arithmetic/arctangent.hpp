// atan and atan2.
#pragma once

#include "arithmetic/coefficients.hpp"
#include "arithmetic/double_double.hpp"
#include "arithmetic/polynomial.hpp"

namespace pendula::arithmetic::inline PENDULA_ISA {

enum class Care { fast, full };

/// The angle of (x, y) with x >= 0, in [-pi/2, pi/2]. x and y must not both be zero or both be infinite. Care::fast takes one
/// division and is within 3 ulp. Care::full takes two divisions and is within 0.9 ulp if |x| and |y| lie between 1e-270 and
/// 1e270.
template <Care care, class T>
inline T angle_in_right_half(T y, T x) {
    const T a = abs(y);
    const auto is_steep = a > x;
    const T low = select(is_steep, x, a);
    const T high = select(is_steep, a, x);
    // For a quotient above tan(pi/8) the angle is measured from pi/4.
    const auto is_far = low > high * 0.41421356237309503;
    const auto sum = two_sum(low, high);
    const auto difference = two_sum(low, -high);
    const T divisor = select(is_far, sum.hi, high);
    const T t = select(is_far, difference.hi, low) / divisor;
    const T z = t * t;
    T tail = t * z * polynomial(z, atan_remainder);
    if constexpr (care == Care::full) {
        const auto product = two_prod(t, divisor);
        const T rest = (select(is_far, difference.hi, low) - product.hi) - product.lo;
        const T rounding = select(is_far, difference.lo - t * sum.lo, T{});
        tail = tail + (rest + rounding) / (divisor * (1.0 + z));
    }
    // The angle is start +- (t + tail). start is 0, or it is pi/4 or pi/2 and larger than t, as fast_two_sum requires.
    const T start = select(is_far, splat<T>(pi_over_2_dd[0] * 0.5), select(is_steep, splat<T>(pi_over_2_dd[0]), T{}));
    const T sign = select(is_steep, splat<T>(-1.0), splat<T>(1.0));
    if constexpr (care == Care::fast) return copy_sign(start + sign * (t + tail), y);
    const auto leading = fast_two_sum(start, sign * t);
    return copy_sign(leading.hi + (leading.lo + (sign * tail + start * (pi_over_2_dd[1] / pi_over_2_dd[0]))), y);
}

/// The angle of (x, y) in [-pi, pi], within 1 ulp. Signs of zeros and infinite arguments are treated as by atan2 of C. NaN
/// gives NaN.
template <class T>
inline T atan2(T y, T x) {
    T a = abs(x);
    T b = abs(y);
    const auto is_unbounded = (a == __builtin_inf()) | (b == __builtin_inf());
    const T one = splat<T>(1.0);
    const T a_limit = select(a == __builtin_inf(), one, T{});
    const T b_limit = select(b == __builtin_inf(), one, T{});
    a = select(is_unbounded, a_limit, select((b == 0.0) & (a == 0.0), one, a));
    b = select(is_unbounded, b_limit, b);
    // Without this scaling the exact products in the division would overflow, or underflow and lose bits.
    const T power = select((a > 0x1p900) | (b > 0x1p900), splat<T>(0x1p-200),
                           select((a < 0x1p-700) & (b < 0x1p-700), splat<T>(0x1p300), splat<T>(1.0)));
    const T right = angle_in_right_half<Care::full>(b * power, a * power);
    const T left = pi_dd[0] - (right - pi_dd[1]);
    const auto is_left = (bits(x) < 0) & ((x != 0.0) | (y == 0.0));  // for x = -0 and y != 0 the angle is +-pi/2 on either side
    const T angle = select(is_left, left, right);
    return select((x == x) & (y == y), copy_sign(angle, y), x + y);
}

/// The arc tangent, in [-pi/2, pi/2], within 0.9 ulp. Odd to the last bit. NaN gives NaN.
template <class T>
inline T atan(T x) {
    return atan2(x, splat<T>(1.0));
}

}  // namespace pendula::arithmetic::inline PENDULA_ISA
