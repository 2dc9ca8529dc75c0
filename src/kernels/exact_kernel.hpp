// The closed form at one time or at a pack of times.
#pragma once

#include "arithmetic/arctangent.hpp"
#include "arithmetic/exponential.hpp"
#include "arithmetic/trigonometric.hpp"
#include "kernels/phase_kernel.hpp"
#include "pendula/angle.hpp"
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

/// Past 100, on the separatrix only, the angle is pi to the last bit and the velocity below 1e-43; the powers stay finite.
template <class T>
inline Argument<T> hyperbolic_argument(T zeta) {
    const T e = exp(select(abs(zeta) > 100.0, copy_sign(splat<T>(100.0), zeta), zeta));
    const T inverse = 1.0 / e;
    const T s = 0.5 * (e - inverse);
    return {s, 0.5 * (e + inverse), -(s * s)};
}

template <class T>
inline Argument<T> circular_argument(T fraction) {
    const auto r = sincos_of_half_turn(fraction);
    return {r.sin, r.cos, r.sin * r.sin};
}

/// tan(theta/2) as a fraction, and the velocity, but for the sign that the whole part of the phase gives an oscillation.
template <class T>
struct HalfTangent {
    T numerator;
    T denominator;
    T omega;
};

template <class T>
inline Phase<T> phase_of(const Exact& e, T t) {
    if (e.analysis.regime == Regime::separatrix) return {T{}, e.phase + (t * e.rate_hi + t * e.rate_lo)};
    return phase_at(t, to_rate<T>({splat<T>(e.rate_hi), splat<T>(e.rate_lo)}), splat<T>(e.phase));
}

template <class T>
inline HalfTangent<T> half_tangent(const Exact& e, T fraction) {
    const bool is_hyperbolic = e.stretch != 0;
    const auto a = is_hyperbolic ? hyperbolic_argument(e.stretch * fraction) : circular_argument(fraction);
    const T square = a.x * a.x;
    const T numerator = a.s * cubic(a.x, square, e.angle_num);
    const T denominator = cubic(a.x, square, e.angle_den);
    const T speed_num = cubic(a.x, square, e.speed_num);
    const T speed_den = cubic(a.x, square, e.speed_den);
    if (is_hyperbolic) return {numerator, denominator, speed_num / (speed_den * a.c)};
    if (e.analysis.regime == Regime::rotation) return {numerator, denominator * a.c, speed_num / speed_den};
    return {numerator, denominator, (speed_num * a.c) / speed_den};
}

/// The state of a rotation, whose angle may round out of [-pi, pi): into it by a turn.
template <class T>
inline Swing<T> rotating(T theta, T omega, T turns) {
    const T last = splat<T>(last_below_pi);
    const auto is_above = theta >= pi_dd[0];
    const auto is_under = theta < -pi_dd[0];
    const T down = (theta - two_pi_dd[0]) - two_pi_dd[1];
    const T up = (theta + two_pi_dd[0]) + two_pi_dd[1];
    const T lower = select(down < -pi_dd[0], splat<T>(-pi_dd[0]), down);
    const T upper = select(up >= pi_dd[0], last, up);
    const T carried = select(is_above, splat<T>(1.0), select(is_under, splat<T>(-1.0), T{}));
    return {select(is_above, lower, select(is_under, upper, theta)), omega, turns + carried};
}

/// The state of an oscillation or on the separatrix, whose angle stays below pi: where it rounds to pi, the last double below.
template <class T>
inline Swing<T> swinging(T theta, T omega, T turns) {
    return {select(theta >= pi_dd[0], splat<T>(last_below_pi), theta), omega, turns};
}

template <class T>
inline Swing<T> state_of(const Exact& e, T whole, const HalfTangent<T>& h) {
    const T theta = 2.0 * angle_in_right_half<Care::fast>(h.numerator, h.denominator);
    if (e.analysis.regime == Regime::rotation) return rotating<T>(theta, h.omega, e.turns + whole);
    return swinging<T>(alternate(theta, whole), alternate(h.omega, whole), splat<T>(e.turns));
}

template <class T>
inline Swing<T> closed_form(const Exact& e, T t) {
    const auto p = phase_of(e, t);
    return state_of(e, p.whole, half_tangent(e, p.fraction));
}

}  // namespace pendula::kernels::inline PENDULA_ISA
