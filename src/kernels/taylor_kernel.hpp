// Taylor's method for one pendulum or a pack of them. A step is a polynomial in time; its end is the start of the next step.
//
// The length of a step follows from the tolerance as in Jorba & Zou, Experimental Mathematics 14 (2005), 3.2: the last two
// coefficients give the radius of convergence, and the last term is kept below the tolerance. Their order, -ln(tolerance)/2 +
// 1, is the best one if products of series are the only cost of a step. Here the sines, the time and the length of a step cost
// the same for every order, so that a higher order with longer steps is faster: 25 instead of 19 for a tolerance of 1e-15.
#pragma once

#include "arithmetic/exponential.hpp"
#include "kernels/equation.hpp"
#include "kernels/motion.hpp"
#include "kernels/phase_kernel.hpp"
#include "kernels/taylor_series.hpp"

namespace pendula::kernels::inline PENDULA_ISA {

/// The order and the relative length of the steps.
struct StepControl {
    int order;
    double log2_fraction;  ///< log2 of the step length divided by the radius of convergence
};

/// The order and length for a tolerance in (0, 1). A tolerance below 2^-52, the precision of a double, gives those of 2^-52.
inline StepControl step_control(double tolerance) {
    const int order = tolerance < 1e-9 ? taylor_order_limit : taylor_low_order;
    const double bounded = tolerance < 0x1p-52 ? 0x1p-52 : tolerance;
    // The truncation error is about a quarter of the last term, and that term is kept below 1/128 of the tolerance. At the
    // smallest tolerance the truncation error is then as small as the rounding error, which compensated summation keeps far
    // below 1e-16 for each step.
    return {order, log(bounded * 0x1p-7) * inverse_ln2[0] / order};
}

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

/// sin and cos of hi + lo + (pi/2) quadrant as sums of two doubles, for |hi + lo| <= pi/4. The errors are below 2^-56.
template <class T>
inline SinCos<DoubleDouble<T>> sincos_with_rest(T hi, T lo, Bits<T> quadrant) {
    const T z = hi * hi, half = 0.5 * z, w = 1.0 - half;
    const auto s = fast_two_sum(hi, hi * z * polynomial(z, sin_quarter) + lo * w);
    const auto c = fast_two_sum(w, ((1.0 - w) - half) + (z * z * polynomial(z, cos_quarter) - hi * lo));
    const auto leading = rotate_quadrants<T>({s.hi, c.hi}, quadrant), rest = rotate_quadrants<T>({s.lo, c.lo}, quadrant);
    return {{leading.sin, rest.sin}, {leading.cos, rest.cos}};
}

/// sin and cos of 2 pi x, in the same form.
template <class T>
inline SinCos<DoubleDouble<T>> sincos_of_turns(DoubleDouble<T> x) {
    const T shifted = 4.0 * x.hi + rounder;
    const auto rest = two_sum(x.hi - 0.25 * (shifted - rounder), x.lo);
    const auto angle = DoubleDouble<T>{splat<T>(two_pi_dd[0]), splat<T>(two_pi_dd[1])} * rest;
    return sincos_with_rest(angle.hi, angle.lo, bits(shifted));
}

/// 2^-n for x in [2^n, 2^(n+1)).
template <class T>
inline T power_below_inverse(T x) {
    return from_bits<T>((std::int64_t{2046} << 52) - (bits(x) & (std::int64_t{2047} << 52)));
}

/// An approximation of log2 |x| + 1023, linear between powers of two, which is at most 0.09 too small. 0 for x = 0.
template <class T>
inline T log2_by_lines(T x) {
    return (from_bits<T>(((bits(x) & ~sign_bit) >> 20) + bits(splat<T>(rounder))) - rounder) * 0x1p-32;
}

/// 2^x with a relative error below 0.1 % for |x| < 1000.
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

/// The length of a step in its unit. At most 8: as |omega| unit < 2, the initial velocity turns the angle by less than 16 rad.
template <class T>
inline T taylor_length(StepControl control, T theta, const Series<T>& v) {
    const T size = log2_by_lines(larger(larger(abs(theta), abs(v[0])), larger(abs(v[1]), abs(v[2]))));
    const int p = control.order;
    const T radius = smaller((size - log2_by_lines(v[p])) * (1.0 / p), (size - log2_by_lines(v[p - 1])) * (1.0 / (p - 1)));
    return exp2_by_cubic(smaller(radius + control.log2_fraction, splat<T>(3.0)));
}

/// The terms of the equation during a step that starts at time t [s].
template <class T>
inline TaylorTerms<T> taylor_terms(const TaylorPendulum<T>& p, DoubleDouble<T> t, T unit) {
    const auto k = terms(p.parameters, unit);
    TaylorTerms<T> f{k, {}, T{}, {k.pull, T{}}, T{}, T{}, T{}};
    if (any<T>(is_driven(p.parameters))) {
        const auto turns = (turned(t.hi, p.turn_rate) + t.lo * p.turn_rate.hi) + p.turn_start;
        const auto r = sincos_of_turns(turns);
        const T frequency = p.parameters.drive_frequency * unit;
        f.drive = r.cos * k.drive;
        f.drive_slope = -(k.drive * frequency * r.sin.hi);
        f.square_frequency = frequency * frequency;
        if (!any<T>(p.parameters.pivot_amplitude != 0.0)) return f;
        const auto pivot = r.cos * k.pivot;
        f.pull = pivot + k.pull;
        f.pivot = pivot.hi;
        f.pull_slope = -(k.pivot * frequency * r.sin.hi);
    }
    return f;
}

/// The series v and C from v[0], v[1] and the angle. Each lane uses the recurrence that its own parameters need, so that its
/// bits do not depend on the other lanes. `sine` is pull sin(theta), where pull includes the term of a shaken pivot.
template <int order, class T>
inline void taylor_series(const Parameters<T>& p, const TaylorTerms<T>& f, SinCos<T> angle, T sine, Series<T>& v,
                          Series<T>& C) {
    const auto is_shaken = p.pivot_amplitude != 0.0;
    const auto has_drive = (p.drive_amplitude != 0.0) & !is_shaken;
    C[0] = f.k.pull * angle.cos;
    if (!any<T>(!has_drive)) return driven_series<order>(f, sine, v, C);
    if (!any<T>(!is_shaken)) return shaken_series<order>(f, angle, v, C);
    // Without friction and torque both recurrences give the same bits, except for signs of zeros, which do not affect any
    // result.
    if (any<T>((p.beta != 0.0) | (p.torque != 0.0)))
        undriven_series<Forcing::steady, order>(f, v, C);
    else
        undriven_series<Forcing::none, order>(f, v, C);
    const auto put = [&](const Mask<T>& mask, const auto& expand_into) {
        if (!any<T>(mask)) return;
        Series<T> its_v{}, its_C{};
        its_v[0] = v[0];
        its_v[1] = v[1];
        its_C[0] = C[0];
        expand_into(its_v, its_C);
        for (int k = 0; k <= order; ++k) {
            v[k] = select<T>(mask, its_v[k], v[k]);
            C[k] = select<T>(mask, its_C[k], C[k]);
        }
    };
    put(has_drive, [&](Series<T>& its_v, Series<T>& its_C) { driven_series<order>(f, sine, its_v, its_C); });
    put(is_shaken, [&](Series<T>& its_v, Series<T>& its_C) { shaken_series<order>(f, angle, its_v, its_C); });
}

// In the functions below Step is TaylorStep or, for one pendulum, the public TaylorPolynomial, which is used in place: a copy
// would take a quarter of the time of a step.

/// Computes the polynomials, the unit and the length of a step from its start and time. C is the series of taylor_series.hpp.
template <class T, class Step>
inline void expand(const TaylorPendulum<T>& pendulum, StepControl control, Step& step, Series<T>& C) {
    const auto& p = pendulum.parameters;
    step.unit = power_below_inverse(abs(step.start.omega) + pendulum.rate);
    const auto f = taylor_terms(pendulum, {step.t, step.t_lo}, step.unit);
    const auto angle = reduce_to_quarter_turn(step.start.theta);
    const auto r = sincos_with_rest(angle.hi, angle.lo + step.start.theta_lo, angle.quadrant);
    auto sine = r.sin * f.k.pull;
    if (const auto is_shaken = p.pivot_amplitude != 0.0; any<T>(is_shaken)) {
        const auto shaken = r.sin * f.pull;
        sine = {select<T>(is_shaken, shaken.hi, sine.hi), select<T>(is_shaken, shaken.lo, sine.lo)};
    }
    step.series[0] = step.start.omega * step.unit;
    // Most of the change in a step comes from series[0] and series[1]. So series[1] is kept in two doubles: its rounding would
    // dominate the error.
    auto acceleration = -sine;
    if (any<T>((p.beta != 0.0) | (p.torque != 0.0) | (p.drive_amplitude != 0.0)))
        acceleration = ((f.drive + f.k.torque) - two_prod(f.k.drag, step.series[0])) - sine;
    step.series[1] = acceleration.hi;
    step.series_1_lo = acceleration.lo;
    const SinCos<T> rounded{r.sin.hi, r.cos.hi};
    if (control.order == taylor_order_limit)
        taylor_series<taylor_order_limit>(p, f, rounded, sine.hi, step.series, C);
    else
        taylor_series<taylor_low_order>(p, f, rounded, sine.hi, step.series, C);
    // The last addend makes the length NaN if the motion is not finite.
    step.length = taylor_length(control, step.start.theta, step.series) * step.unit + 0.0 * step.series[control.order];
}

/// The sum of factor(k) a[k] x^(k - first) for k >= first, as four independent sums of every fourth term, which overlap.
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

/// The motion at a time within the step, given as the time since the start of the step.
template <class T, class Step>
inline Motion<T> motion_at(const Step& step, T since) {
    const T per_unit = 1.0 / step.unit, x = since * per_unit;
    const T change = (x * x) * tail_of_series<2>(step.series, x, [](T a, int) { return a; }) + step.series_1_lo * x;
    const T bend = (x * x) * tail_of_series<1>(step.series, x, [](T a, int k) { return a * (1.0 / (k + 1)); });
    const auto& start = step.start;
    // The terms of series[0] and series[1] are large. Their rounding errors are kept.
    const auto from_v0 = two_prod(step.series[0], x), from_v1 = two_prod(step.series[1], x);
    const auto theta = two_sum(start.theta, from_v0.hi), omega = two_sum(start.omega, from_v1.hi * per_unit);
    Motion<T> m{theta.hi, omega.hi, start.turns, theta.lo + (from_v0.lo + (start.theta_lo + start.omega_lo * since)),
                omega.lo + (start.omega_lo + from_v1.lo * per_unit)};
    add(m, bend, change * per_unit);
    return m;
}

/// The time at which a step ends, as the sum of two doubles.
template <class T>
inline DoubleDouble<T> end_of(const T& t, const T& t_lo, const T& length) {
    return DoubleDouble<T>{t, t_lo} + length;
}

/// Replaces the start of the step by its end, where the next step starts.
template <class Step>
inline void move_to_end(Step& step) {
    const auto m = motion_at(step, step.length);
    const auto t = end_of(step.t, step.t_lo, step.length);
    step.start = {m.theta, m.omega, m.turns, m.theta_lo, m.omega_lo};
    step.t = t.hi;
    step.t_lo = t.lo;
}

/// True for lanes in which the step ends before time t.
template <class T, class Step>
inline Mask<T> ends_before(const Step& step, T t) {
    return (step.t - t) + (step.t_lo + step.length) < 0.0;
}

/// Makes a motion NaN if more than 2^53 steps of this length would be needed to reach time t.
template <class T, class Step>
inline void stop_endless(Step& step, T t) {
    const auto is_endless = (step.length > 0.0) & (step.length < (t - step.t) * 0x1p-53);
    if (!any<T>(is_endless)) return;
    const T nan = splat<T>(__builtin_nan(""));
    step.length = select(is_endless, nan, step.length);
    step.start.theta = select(is_endless, nan, step.start.theta);
    step.start.omega = select(is_endless, nan, step.start.omega);
}

template <class T>
inline void expand_tangent(const TaylorPendulum<T>& p, int order, T unit, const Series<T>& C, TangentStep<T>& tangent) {
    tangent.u[0] = tangent.start.theta;
    tangent.u[1] = tangent.start.omega * unit;
    if (order == taylor_order_limit)
        tangent_series<taylor_order_limit>(p.parameters.beta * unit, C, tangent.u);
    else
        tangent_series<taylor_low_order>(p.parameters.beta * unit, C, tangent.u);
}

/// The displacement at a time within the step, given as the time since the start of the step.
template <class T>
inline Tangent<T> tangent_at(const TangentStep<T>& tangent, T unit, T since) {
    const T per_unit = 1.0 / unit, x = since * per_unit;
    return {tangent.start.theta + x * tail_of_series<1>(tangent.u, x, [](T a, int) { return a; }),
            tail_of_series<1>(tangent.u, x, [](T a, int k) { return a * (k + 0.0); }) * per_unit};
}

}  // namespace pendula::kernels::inline PENDULA_ISA
