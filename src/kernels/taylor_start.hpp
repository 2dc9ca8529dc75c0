// The start of a step of Taylor's method: the sines of the angle and of the drive's phase, and the terms of the equation.
#pragma once

#include "kernels/equation.hpp"
#include "kernels/phase_kernel.hpp"
#include "kernels/taylor_length.hpp"

namespace pendula::kernels::inline PENDULA_ISA {

/// The parameters of a pendulum, and quantities that follow from them.
template <class T>
struct TaylorPendulum {
    Parameters<T> parameters;
    DoubleDouble<T> turn_rate;   ///< drive_frequency/(2 pi), turns of the phase of the drive in a second
    DoubleDouble<T> turn_start;  ///< drive_phase/(2 pi)
    T rate;                      ///< see `rate_of_change` [s^-1]
};

template <class T>
inline TaylorPendulum<T> taylor_pendulum(const Parameters<T>& p) {
    const DoubleDouble<T> inverse{splat<T>(inverse_two_pi_dd[0]), splat<T>(inverse_two_pi_dd[1])};
    return {p, inverse * p.drive_frequency, inverse * p.drive_phase, rate_of_change(p)};
}

/// What the sines and forces at the start of a step are kept in: at the highest order in two doubles, because their rounding
/// would dominate the error, and in one double at the others, which saves a tenth of the time.
template <int order, class T>
struct KeptIn {
    using type = T;
};
template <class T>
struct KeptIn<taylor_order_limit, T> {
    using type = DoubleDouble<T>;
};

/// Whether a number is kept in two doubles.
template <class Real>
inline constexpr bool has_rest = false;
template <class T>
inline constexpr bool has_rest<DoubleDouble<T>> = true;

template <class T>
inline T high(T x) {
    return x;
}
template <class T>
inline T high(DoubleDouble<T> x) {
    return x.hi;
}
template <class T>
inline T low(T) {
    return T{};
}
template <class T>
inline T low(DoubleDouble<T> x) {
    return x.lo;
}

/// a in the lanes where the mask is true, b in the others.
template <class T, class Real>
inline Real choose_kept(const Mask<T>& mask, Real a, Real b) {
    if constexpr (has_rest<Real>)
        return {select<T>(mask, a.hi, b.hi), select<T>(mask, a.lo, b.lo)};
    else
        return select<T>(mask, a, b);
}

/// a b, exactly if it is kept in two doubles.
template <class Real, class T>
inline Real product(T a, T b) {
    if constexpr (has_rest<Real>)
        return two_prod(a, b);
    else
        return a * b;
}

/// sin and cos of hi + lo + (pi/2) quadrant as sums of two doubles, for |hi + lo| <= pi/4. The errors are below 2^-56.
template <class T>
inline SinCos<DoubleDouble<T>> sincos_with_rest(T hi, T lo, Bits<T> quadrant) {
    const T z = hi * hi, half = 0.5 * z, w = 1.0 - half;
    const auto s = fast_two_sum(hi, hi * z * polynomial(z, sin_quarter) + lo * w);
    const auto c = fast_two_sum(w, ((1.0 - w) - half) + (z * z * polynomial(z, cos_quarter) - hi * lo));
    const auto leading = rotate_quadrants<T>({s.hi, c.hi}, quadrant), rest = rotate_quadrants<T>({s.lo, c.lo}, quadrant);
    return {{leading.sin, rest.sin}, {leading.cos, rest.cos}};
}

/// sin and cos of theta + theta_lo, for theta in [-pi, pi).
template <class Real, class T>
inline SinCos<Real> sincos_of_angle(T theta, T theta_lo) {
    if constexpr (has_rest<Real>) {
        const auto angle = reduce_to_quarter_turn(theta);
        return sincos_with_rest(angle.hi, angle.lo + theta_lo, angle.quadrant);
    } else {
        const T shifted = theta * two_over_pi[0] + rounder, n = shifted - rounder;
        const T angle = ((theta - n * pi_over_2_parts[0]) - n * pi_over_2_parts[1]) - n * pi_over_2_parts[2];
        return rotate_quadrants(sincos_quarter(angle, theta_lo), bits(shifted));
    }
}

/// sin and cos of 2 pi x.
template <class Real, class T>
inline SinCos<Real> sincos_of_turns(DoubleDouble<T> x) {
    const T shifted = 4.0 * x.hi + rounder;
    const T fraction = x.hi - 0.25 * (shifted - rounder);
    if constexpr (has_rest<Real>) {
        const auto angle = DoubleDouble<T>{splat<T>(two_pi_dd[0]), splat<T>(two_pi_dd[1])} * two_sum(fraction, x.lo);
        return sincos_with_rest(angle.hi, angle.lo, bits(shifted));
    } else {
        return rotate_quadrants(sincos_quarter(two_pi_dd[0] * fraction, two_pi_dd[0] * x.lo), bits(shifted));
    }
}

/// 2^-n for x in [2^n, 2^(n+1)).
template <class T>
inline T power_below_inverse(T x) {
    return from_bits<T>((std::int64_t{2046} << 52) - (bits(x) & (std::int64_t{2047} << 52)));
}

/// The drive and the pull at the start of a step, and the terms of its series.
template <class T, class Real>
struct StartTerms {
    TaylorTerms<T> f;
    Real drive;  ///< drive cos(phase)
    Real pull;   ///< pull + pivot cos(phase)
};

/// The terms of the equation during a step that starts at time t [s].
template <class Real, class T>
inline StartTerms<T, Real> taylor_terms(const TaylorPendulum<T>& p, DoubleDouble<T> t, T unit) {
    const auto k = terms(p.parameters, unit);
    StartTerms<T, Real> start{{k, T{}, T{}, k.pull, T{}, T{}, T{}}, {}, {k.pull}};
    auto& f = start.f;
    if (any<T>(is_driven(p.parameters))) {
        const auto turns = (turned(t.hi, p.turn_rate) + t.lo * p.turn_rate.hi) + p.turn_start;
        const auto r = sincos_of_turns<Real>(turns);
        const T frequency = p.parameters.drive_frequency * unit;
        start.drive = r.cos * k.drive;
        f.drive = high(start.drive);
        f.drive_slope = -(k.drive * frequency * high(r.sin));
        f.square_frequency = frequency * frequency;
        if (!any<T>(p.parameters.pivot_amplitude != 0.0)) return start;
        const auto pivot = r.cos * k.pivot;
        start.pull = pivot + k.pull;
        f.pull = high(start.pull);
        f.pivot = high(pivot);
        f.pull_slope = -(k.pivot * frequency * high(r.sin));
    }
    return start;
}

}  // namespace pendula::kernels::inline PENDULA_ISA
