// The closed form at one time or at a pack of times.
#pragma once

#include "arithmetic/arctangent.hpp"
#include "arithmetic/exponential.hpp"
#include "arithmetic/trigonometric.hpp"
#include "kernels/phase_kernel.hpp"
#include "pendula/exact.hpp"

namespace pendula::kernels::inline PENDULA_ISA {

using namespace arithmetic;

/// x where the number of half periods is even, -x where it is odd.
template <class T>
inline T alternate(T x, T whole) {
    return from_bits<T>(bits(x) ^ (bits(whole + rounder) << 63));
}

template <class T>
inline T cubic(T x, T square, const double (&c)[4]) {
    return (c[0] + c[1] * x) + square * (c[2] + c[3] * x);
}

template <class T>
struct Swing {
    T theta;
    T omega;
    T turns;
};

/// Sine and cosine of the fraction of the phase, circular or hyperbolic, and x = s^2 or -s^2.
template <class T>
struct Argument {
    T s;
    T c;
    T x;
};

template <class T>
inline Argument<T> hyperbolic_argument(T zeta) {
    const T e = exp(zeta);
    const T inverse = 1.0 / e;
    const T s = 0.5 * (e - inverse);
    return {s, 0.5 * (e + inverse), -(s * s)};
}

template <class T>
inline Argument<T> circular_argument(T fraction) {
    const auto r = sincos_of_half_turn(fraction);
    return {r.sin, r.cos, r.sin * r.sin};
}

/// Where rounding has carried an angle out of [-pi, pi): into it, or by a turn where it rotates.
template <class T>
inline Swing<T> into_interval(Swing<T> s, bool rotates) {
    const T below = splat<T>(0x1.921fb54442d17p+1);  // the largest double of the interval
    const auto is_above = s.theta >= pi_dd[0];
    if (!rotates) return {select(is_above, below, s.theta), s.omega, s.turns};
    const auto is_under = s.theta < -pi_dd[0];
    const T down = (s.theta - two_pi_dd[0]) - two_pi_dd[1];
    const T lower = select(down < -pi_dd[0], splat<T>(-pi_dd[0]), down);
    const T upper = (s.theta + two_pi_dd[0]) + two_pi_dd[1];
    const T carried = select(is_above, splat<T>(1.0), select(is_under, splat<T>(-1.0), T{}));
    return {select(is_above, lower, select(is_under, select(upper >= pi_dd[0], below, upper), s.theta)), s.omega, s.turns + carried};
}

template <class T>
inline Swing<T> closed_form(const Exact& e, T t) {
    const bool is_separatrix = e.analysis.regime == Regime::separatrix;
    const bool rotates = e.analysis.regime == Regime::rotation;
    Phase<T> p{};
    Argument<T> a;
    if (is_separatrix) {
        // Past 700 the angle is pi to the last bit; e^700 still has a reciprocal.
        const T zeta = e.phase + (t * e.rate_hi + t * e.rate_lo);
        a = hyperbolic_argument(select(abs(zeta) > 700.0, copy_sign(splat<T>(700.0), zeta), zeta));
        a.x = T{};  // the cubics are constants
    } else {
        p = phase_at(t, to_rate<T>({splat<T>(e.rate_hi), splat<T>(e.rate_lo)}), splat<T>(e.phase));
        a = e.stretch == 0 ? circular_argument(p.fraction) : hyperbolic_argument(e.stretch * p.fraction);
    }
    const T square = a.x * a.x;
    T angle_den = cubic(a.x, square, e.angle_den);
    T speed_num = cubic(a.x, square, e.speed_num);
    T speed_den = cubic(a.x, square, e.speed_den);
    if (e.stretch != 0) {
        speed_den = speed_den * a.c;
    } else if (rotates) {
        angle_den = angle_den * a.c;
    } else {
        speed_num = speed_num * a.c;
    }
    const T theta = 2.0 * angle_in_right_half<Care::fast>(a.s * cubic(a.x, square, e.angle_num), angle_den);
    const T omega = speed_num / speed_den;
    if (rotates || is_separatrix) return into_interval<T>({theta, omega, e.turns + p.whole}, rotates);
    return into_interval<T>({alternate(theta, p.whole), alternate(omega, p.whole), splat<T>(e.turns)}, false);
}

}  // namespace pendula::kernels::inline PENDULA_ISA
