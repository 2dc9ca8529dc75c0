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

/// Beyond this argument of sinh and cosh, which only the separatrix reaches, theta is the last double below pi.
inline constexpr double far_argument = 100;

/// An argument beyond `far_argument` is taken as that one, so that sinh stays finite.
template <class T>
inline Argument<T> hyperbolic_argument(T zeta) {
    const T e = exp(select(abs(zeta) > far_argument, copy_sign(splat<T>(far_argument), zeta), zeta));
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

/// The state at |t| <= ordinary_time(e).
template <class T>
inline Swing<T> closed_form(const Exact& e, T t) {
    const auto p = phase_of(e, t);
    return state_of(e, p.whole, half_tangent(e, p.fraction));
}

/// Up to so many tau `phase_at` is right to 2^-58, and no latest time is earlier.
inline constexpr double ordinary_periods = 0x1p20;

/// The largest |t| [s] that `closed_form` serves; later times, which are rare, are left to `late_closed_form`.
inline double ordinary_time(const Exact& e) {
    if (e.analysis.regime == Regime::separatrix) return (far_argument - abs(e.phase)) / abs(e.rate_hi);
    return ordinary_periods * e.analysis.tau;
}

/// The phase of an oscillation or a rotation; NaN beyond the latest time.
inline Phase<double> late_phase(const Exact& e, double start, double t) {
    const auto p = late_phase_at<double>(t, {e.rate_hi, e.rate_lo}, start);
    // Turns count all whole numbers; the sign of an oscillation asks only for even or odd.
    const double whole = e.analysis.regime == Regime::rotation ? p.fours + p.whole : p.whole;
    return {whole, abs(t) <= e.latest ? p.fraction : __builtin_nan("")};
}

/// The state far along the separatrix; NaN at infinite times.
inline Swing<double> far_along_separatrix(const Exact& e, double t) {
    if (!(abs(t) <= e.latest)) return {__builtin_nan(""), __builtin_nan(""), e.turns};
    const double leading = t * e.rate_hi;
    // From 2^20 on t rate_lo changes nothing that counts, and it may overflow.
    const double zeta = e.phase + (abs(leading) < 0x1p20 ? leading + t * e.rate_lo : leading);
    auto half = half_tangent(e, zeta);
    if (abs(zeta) > far_argument) {
        // 1/cosh(zeta) is 2 exp(-|zeta|) to the last bit. The root of that is a normal number wherever omega is not 0.
        const double root = exp(-0.5 * abs(zeta));
        half.omega = (2 * e.speed_num[0] * root) * root;
    }
    return state_of(e, 0.0, half);
}

/// The state at a time beyond `ordinary_time`; NaN beyond the latest.
inline Swing<double> late_closed_form(const Exact& e, double t) {
    if (e.analysis.regime == Regime::separatrix) return far_along_separatrix(e, t);
    const auto p = late_phase(e, e.phase, t);
    return state_of(e, p.whole, half_tangent(e, p.fraction));
}

}  // namespace pendula::kernels::inline PENDULA_ISA
