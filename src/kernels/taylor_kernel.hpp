// Taylor's method for one pendulum or a pack of them: a step is a polynomial in time, and its end the start of the next.
//
// The length of a step follows from the tolerance as in Jorba & Zou, Experimental Mathematics 14 (2005), 3.2: the radius of
// convergence from the last two coefficients, and the last term kept below the tolerance. Their order, -ln(tolerance)/2 + 1,
// would be the best if a step were nothing but products of series. Sines, time and length cost as much at any order, so that
// a higher one with longer steps is faster: 25 for their 19.
#pragma once

#include "arithmetic/exponential.hpp"
#include "kernels/motion.hpp"
#include "kernels/phase_kernel.hpp"
#include "kernels/taylor_series.hpp"

namespace pendula::kernels::inline PENDULA_ISA {

/// Order and relative length of steps.
struct TaylorReach {
    int order;
    double log2_fraction;  ///< of the radius of convergence that a step goes
};

/// For a tolerance in (0, 1); below 2^-52 the precision of a double is what limits.
inline TaylorReach taylor_reach(double tolerance) {
    const int order = tolerance < 1e-9 ? taylor_order_limit : taylor_low_order;
    const double bounded = tolerance < 0x1p-52 ? 0x1p-52 : tolerance;
    // What the polynomial leaves out is a quarter or so of its last term, which is held to 1/128 of the tolerance: as little
    // as what rounding does, which carried remainders keep far below 1e-16 a step.
    return {order, log(bounded * 0x1p-7) * inverse_ln2[0] / order};
}

/// Added to rates, so that a pendulum which nothing moves takes finite steps.
inline constexpr double slowest_rate = 0x1p-900;

/// A pendulum's parameters and what follows from them.
template <class T>
struct TaylorPendulum {
    T alpha, beta, torque, drive_amplitude, drive_frequency;
    DoubleDouble<T> turn_rate;   ///< of the drive: drive_frequency/(2 pi)
    DoubleDouble<T> turn_start;  ///< drive_phase/(2 pi)
    T rate;                      ///< of change, but for that of the angle [s^-1]
};

template <class T>
inline TaylorPendulum<T> taylor_pendulum(T alpha, T beta, T torque, T drive_amplitude, T drive_frequency, T drive_phase) {
    const DoubleDouble<T> inverse{splat<T>(inverse_two_pi_dd[0]), splat<T>(inverse_two_pi_dd[1])};
    const T of_drive = select(drive_amplitude == 0.0, T{}, drive_frequency);
    return {alpha,
            beta,
            torque,
            drive_amplitude,
            drive_frequency,
            inverse * drive_frequency,
            inverse * drive_phase,
            sqrt(alpha + abs(torque) + abs(drive_amplitude)) + beta + of_drive + slowest_rate};
}

/// A step: theta and omega from its start as polynomials in x = (time since)/unit.
template <class T>
struct TaylorStep {
    Motion<T> start;
    DoubleDouble<T> t;  ///< at the start
    T unit;             ///< a power of two near 1/rate, so that no coefficient overflows [s]
    T length;           ///< [s]
    Series<T> v;        ///< omega unit
    T v1_lo;            ///< what rounding has kept out of v[1]
};

/// sin and cos of hi + lo + (pi/2) quadrant, |hi + lo| <= pi/4, within 2^-56 and with what their rounding leaves.
template <class T>
inline SinCos<DoubleDouble<T>> sincos_with_rest(T hi, T lo, Bits<T> quadrant) {
    const T z = hi * hi, half = 0.5 * z, w = 1.0 - half;
    const auto s = fast_two_sum(hi, hi * z * polynomial(z, sin_quarter) + lo * w);
    const auto c = fast_two_sum(w, ((1.0 - w) - half) + (z * z * polynomial(z, cos_quarter) - hi * lo));
    const auto leading = rotate_quadrants<T>({s.hi, c.hi}, quadrant), rest = rotate_quadrants<T>({s.lo, c.lo}, quadrant);
    return {{leading.sin, rest.sin}, {leading.cos, rest.cos}};
}

/// The same of 2 pi x.
template <class T>
inline SinCos<DoubleDouble<T>> sincos_of_turns(DoubleDouble<T> x) {
    const T shifted = 4.0 * x.hi + rounder;
    const auto rest = two_sum(x.hi - 0.25 * (shifted - rounder), x.lo);
    const auto angle = DoubleDouble<T>{splat<T>(two_pi_dd[0]), splat<T>(two_pi_dd[1])} * rest;
    return sincos_with_rest(angle.hi, angle.lo, bits(shifted));
}

/// 2^-n for a positive number from 2^n to 2^(n+1).
template <class T>
inline T power_below_inverse(T x) {
    return from_bits<T>((std::int64_t{2046} << 52) - (bits(x) & (std::int64_t{2047} << 52)));
}

/// log2 |x| + 1023 by a straight line in each binade: up to 0.09 less. 0 for 0.
template <class T>
inline T log2_by_lines(T x) {
    return (from_bits<T>(((bits(x) & ~sign_bit) >> 20) + bits(splat<T>(rounder))) - rounder) * 0x1p-32;
}

/// 2^x within 0.1 % for |x| < 1000.
template <class T>
inline T exp2_by_cubic(T x) {
    const T n = (x + rounder) - rounder;
    const T f = x - n;
    return scale(1.0 + f * (0.6931 + f * (0.2402 + f * 0.0555)), n);
}

template <class T>
inline T larger(T a, T b) {
    return select(a > b, a, b);
}

template <class T>
inline T smaller(T a, T b) {
    return select(a < b, a, b);
}

/// The length of a step in its unit: at most 8, so that an angle turns little more than once.
template <class T>
inline T taylor_length(TaylorReach reach, T theta, const Series<T>& v) {
    const T size = log2_by_lines(larger(larger(abs(theta), abs(v[0])), larger(abs(v[1]), abs(v[2]))));
    const int p = reach.order;
    const T radius = smaller((size - log2_by_lines(v[p])) * (1.0 / p), (size - log2_by_lines(v[p - 1])) * (1.0 / (p - 1)));
    return exp2_by_cubic(smaller(radius + reach.log2_fraction, splat<T>(3.0)));
}

/// The forces at the start of a step.
template <class T>
inline Forces<T> taylor_forces(const TaylorPendulum<T>& p, DoubleDouble<T> t, T unit) {
    Forces<T> f{p.beta * unit, (p.torque * unit) * unit, {}, T{}, T{}};
    if (any<T>(p.drive_amplitude != 0.0)) {
        const auto turns = (turned(t.hi, p.turn_rate) + t.lo * p.turn_rate.hi) + p.turn_start;
        const auto r = sincos_of_turns(turns);
        const T amplitude = (p.drive_amplitude * unit) * unit, frequency = p.drive_frequency * unit;
        f.drive = r.cos * amplitude;
        f.drive_slope = -(amplitude * frequency * r.sin.hi);
        f.square_frequency = frequency * frequency;
    }
    return f;
}

/// v and C from v[0] and C[0], by the way that each lane's own parameters ask for.
template <int order, class T>
inline void taylor_series(const TaylorPendulum<T>& p, const Forces<T>& f, T sine, Series<T>& v, Series<T>& C) {
    const auto is_driven = p.drive_amplitude != 0.0;
    const auto is_steady = (p.beta != 0.0) | (p.torque != 0.0);
    if (!any<T>(!is_driven)) return driven_series<order>(f, sine, v, C);
    Series<T> driven_v{}, driven_C{};
    if (any<T>(is_driven)) {
        driven_v[0] = v[0];
        driven_v[1] = v[1];
        driven_C[0] = C[0];
        driven_series<order>(f, sine, driven_v, driven_C);
    }
    // Without friction and torque both ways give the same bits, but for signs of zeros that no result shows.
    if (any<T>(is_steady))
        undriven_series<Forcing::steady, order>(f, v, C);
    else
        undriven_series<Forcing::none, order>(f, v, C);
    if (!any<T>(is_driven)) return;
    for (int k = 1; k <= order; ++k) {
        v[k] = select<T>(is_driven, driven_v[k], v[k]);
        C[k] = select<T>(is_driven, driven_C[k], C[k]);
    }
}

/// The polynomials of a step from its start and time; C as in taylor_series.hpp.
template <class T>
inline void expand(const TaylorPendulum<T>& p, TaylorReach reach, TaylorStep<T>& step, Series<T>& C) {
    step.unit = power_below_inverse(abs(step.start.omega) + p.rate);
    const auto forces = taylor_forces(p, step.t, step.unit);
    const auto angle = reduce_to_quarter_turn(step.start.theta);
    const auto r = sincos_with_rest(angle.hi, angle.lo + step.start.theta_lo, angle.quadrant);
    const T pull = (p.alpha * step.unit) * step.unit;
    const auto sine = r.sin * pull;
    C[0] = pull * r.cos.hi;
    step.v[0] = step.start.omega * step.unit;
    // Acceleration and velocity make most of a step's change: rounding of the former would be that of all.
    auto acceleration = -sine;
    if (any<T>((p.beta != 0.0) | (p.torque != 0.0) | (p.drive_amplitude != 0.0)))
        acceleration = ((forces.drive + forces.torque) - two_prod(forces.drag, step.v[0])) - sine;
    step.v[1] = acceleration.hi;
    step.v1_lo = acceleration.lo;
    if (reach.order == taylor_order_limit)
        taylor_series<taylor_order_limit>(p, forces, sine.hi, step.v, C);
    else
        taylor_series<taylor_low_order>(p, forces, sine.hi, step.v, C);
    // A motion that is not finite has no length.
    step.length = taylor_length(reach, step.start.theta, step.v) * step.unit + 0.0 * step.v[reach.order];
}

/// The sum of factor(k) a[k] x^(k - first) for k from `first` on: four chains of dependent operations side by side.
template <int first, class T, class Factor>
inline T tail_of_series(const Series<T>& a, T x, Factor factor) {
    constexpr int last = taylor_order_limit;
    const T square = x * x, fourth = square * square;
    T sum[4];
    for (int i = 0; i < 4; ++i) {
        const int top = last - (last - first - i) % 4;
        sum[i] = factor(a[top], top);
        for (int k = top - 4; k >= first; k -= 4) sum[i] = sum[i] * fourth + factor(a[k], k);
    }
    return (sum[0] + sum[1] * x) + square * (sum[2] + sum[3] * x);
}

/// The motion at a time of the step, given since its start.
template <class T>
inline Motion<T> motion_at(const TaylorStep<T>& step, T since) {
    const T per_unit = 1.0 / step.unit, x = since * per_unit;
    const T change = (x * x) * tail_of_series<2>(step.v, x, [](T a, int) { return a; }) + step.v1_lo * x;
    const T bend = (x * x) * tail_of_series<1>(step.v, x, [](T a, int k) { return a * (1.0 / (k + 1)); });
    const Motion<T>& start = step.start;
    // The first terms are large, so that their rounding is kept too.
    const auto way = two_prod(step.v[0], x), gain = two_prod(step.v[1], x);
    const auto theta = two_sum(start.theta, way.hi), omega = two_sum(start.omega, gain.hi * per_unit);
    Motion<T> m{theta.hi, omega.hi, start.turns, theta.lo + (way.lo + (start.theta_lo + start.omega_lo * since)),
                omega.lo + (start.omega_lo + gain.lo * per_unit)};
    add(m, bend, change * per_unit);
    return m;
}

/// From a step's start to its end, where the next one starts.
template <class T>
inline void go_to_end(TaylorStep<T>& step) {
    step.start = motion_at(step, step.length);
    step.t = step.t + step.length;
}

/// Where the step ends before time t.
template <class T>
inline Mask<T> ends_before(const TaylorStep<T>& step, T t) {
    return (step.t.hi - t) + (step.t.lo + step.length) < 0.0;
}

/// Makes NaN of a motion that more than 2^53 steps of this length would take to time t.
template <class T>
inline void give_up_endless(TaylorStep<T>& step, T t) {
    const auto is_endless = (step.length > 0.0) & (step.length < (t - step.t.hi) * 0x1p-53);
    if (!any<T>(is_endless)) return;
    const T nan = splat<T>(__builtin_nan(""));
    step.length = select(is_endless, nan, step.length);
    step.start.theta = select(is_endless, nan, step.start.theta);
    step.start.omega = select(is_endless, nan, step.start.omega);
}

/// A displacement at a step's start, and its theta as a polynomial in x.
template <class T>
struct TangentStep {
    Tangent<T> start;
    Series<T> u;
};

template <class T>
inline void expand_tangent(const TaylorPendulum<T>& p, int order, T unit, const Series<T>& C, TangentStep<T>& tangent) {
    tangent.u[0] = tangent.start.theta;
    tangent.u[1] = tangent.start.omega * unit;
    if (order == taylor_order_limit)
        tangent_series<taylor_order_limit>(p.beta * unit, C, tangent.u);
    else
        tangent_series<taylor_low_order>(p.beta * unit, C, tangent.u);
}

/// The displacement at a time of the step, given since its start.
template <class T>
inline Tangent<T> tangent_at(const TangentStep<T>& tangent, T unit, T since) {
    const T per_unit = 1.0 / unit, x = since * per_unit;
    return {tangent.start.theta + x * tail_of_series<1>(tangent.u, x, [](T a, int) { return a; }),
            tail_of_series<1>(tangent.u, x, [](T a, int k) { return a * (k + 0.0); }) * per_unit};
}

}  // namespace pendula::kernels::inline PENDULA_ISA
