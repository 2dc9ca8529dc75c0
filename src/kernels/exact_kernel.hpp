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

/// Up to so many tau `phase_at` is right to 2^-58, and no latest time is earlier.
inline constexpr double ordinary_periods = 0x1p20;

/// The times that `ordinary_phase` does not serve.
template <class T>
inline Mask<T> is_late(const Exact& e, T t) {
    return abs(t) > ordinary_periods * e.analysis.tau;
}

/// start + rate t of an oscillation or a rotation.
template <class T>
inline Phase<T> ordinary_phase(const Exact& e, T start, T t) {
    return phase_at(t, to_rate<T>({splat<T>(e.rate_hi), splat<T>(e.rate_lo)}), start);
}

/// The same at any time; NaN beyond the latest. Not inlined, so that it takes no registers from ordinary times.
template <class T>
[[gnu::noinline]] Phase<T> late_phase(const Exact& e, const T& start, const T& t) {
    const auto ordinary = ordinary_phase(e, start, t);
    const auto late = late_phase_at<T>(t, {splat<T>(e.rate_hi), splat<T>(e.rate_lo)}, start);
    // Turns count all whole numbers; the sign of an oscillation asks only for even or odd.
    const T whole = e.analysis.regime == Regime::rotation ? late.fours + late.whole : late.whole;
    const T fraction = select(abs(t) <= e.latest, late.fraction, splat<T>(__builtin_nan("")));
    return {select(is_late(e, t), whole, ordinary.whole), select(is_late(e, t), fraction, ordinary.fraction)};
}

/// The argument of sinh and cosh on the separatrix; NaN at infinite times.
template <class T>
inline T separatrix_argument(const Exact& e, T t) {
    const T leading = t * e.rate_hi;
    // From 2^20 on, where t rate_lo changes nothing, it may overflow.
    const T zeta = e.phase + select(abs(leading) < 0x1p20, leading + t * e.rate_lo, leading);
    return select(abs(t) <= e.latest, zeta, splat<T>(__builtin_nan("")));
}

template <class T>
inline Phase<T> phase_of(const Exact& e, T t) {
    if (e.analysis.regime == Regime::separatrix) return {T{}, separatrix_argument(e, t)};
    const T start = splat<T>(e.phase);
    return any<T>(is_late(e, t)) ? late_phase(e, start, t) : ordinary_phase(e, start, t);
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

/// Beyond `far_argument` 1/cosh(zeta) is 2 exp(-|zeta|) to the last bit. The root of the exponential is a normal number wherever
/// omega is not 0. By itself and lane by lane, so that it takes no room from what comes before.
template <class T>
[[gnu::noinline]] void set_omega_of_tail(const Exact& e, const T& zeta, T& omega) {
    for (int i = 0; i < lanes<T>; ++i) {
        if (!(abs(lane(zeta, i)) > far_argument)) continue;
        const double root = exp(-0.5 * abs(lane(zeta, i)));
        lane(omega, i) = (2 * e.speed_num[0] * root) * root;
    }
}

template <class T>
inline Swing<T> closed_form(const Exact& e, T t) {
    const auto p = phase_of(e, t);
    auto half = half_tangent(e, p.fraction);
    if (e.analysis.regime == Regime::separatrix && any<T>(abs(p.fraction) > far_argument))
        set_omega_of_tail(e, p.fraction, half.omega);
    return state_of(e, p.whole, half);
}

}  // namespace pendula::kernels::inline PENDULA_ISA
