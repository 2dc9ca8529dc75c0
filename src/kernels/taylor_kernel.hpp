// Taylor's method for one pendulum or a pack of them. A step is a polynomial in time; its end is the start of the next step.
#pragma once

#include "kernels/motion.hpp"
#include "kernels/taylor_start.hpp"

namespace pendula::kernels::inline PENDULA_ISA {

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

/// Computes the polynomials and the unit of a step from its start and time. C is the series of taylor_series.hpp.
template <int order, class T, class Step>
inline void expand(const TaylorPendulum<T>& pendulum, Step& step, Series<T>& C) {
    const auto& p = pendulum.parameters;
    step.unit = power_below_inverse(abs(step.start.omega) + pendulum.rate);
    using Real = typename KeptIn<order, T>::type;
    const auto terms = taylor_terms<Real>(pendulum, DoubleDouble<T>{step.t, step.t_lo}, step.unit);
    const auto& k = terms.f.k;
    const auto r = sincos_of_angle<Real>(step.start.theta, step.start.theta_lo);
    Real sine = r.sin * k.pull;
    if (const auto is_shaken = p.pivot_amplitude != 0.0; any<T>(is_shaken))
        sine = choose_kept<T, Real>(is_shaken, r.sin * terms.pull, sine);
    step.series[0] = step.start.omega * step.unit;
    // Most of the change in a step comes from series[0] and series[1]. So series[1] is kept in two doubles at the highest
    // order.
    Real acceleration = -sine;
    if (any<T>((p.beta != 0.0) | (p.torque != 0.0) | (p.drive_amplitude != 0.0)))
        acceleration = ((terms.drive + k.torque) - product<Real>(k.drag, step.series[0])) - sine;
    step.series[1] = high(acceleration);
    step.series_1_lo = low(acceleration);
    taylor_series<order>(p, terms.f, {high(r.sin), high(r.cos)}, high(sine), step.series, C);
}

/// log2 of the length of a step in its unit, as its polynomials allow it.
template <int order, class T, class Step>
inline T log2_length_of(const Step& step, double log2_fraction) {
    return log2_length<order, T>(log2_fraction, step.start.theta, step.series);
}

/// Sets the length of a step; it becomes NaN if the motion is not finite.
template <int order, class T, class Step>
inline void set_length(Step& step, T log2) {
    step.length = length_from_log2(log2) * step.unit + 0.0 * step.series[order];
}

/// The sum of factor(k) a[k] x^(k - first) from k = first to last, as four independent sums of every fourth term, which
/// overlap.
template <int first, int last, class T, class Factor>
inline T tail_of_series(const Series<T>& a, T x, Factor factor) {
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
template <int order, class T, class Step>
inline Motion<T> motion_at(const Step& step, T since) {
    const T per_unit = 1.0 / step.unit, x = since * per_unit;
    const auto same = [](T a, int) { return a; };
    const auto integrated = [](T a, int k) { return a * (1.0 / (k + 1)); };
    const auto& start = step.start;
    if constexpr (order < taylor_order_limit) {
        Motion<T> m{start.theta, start.omega, start.turns, start.theta_lo, start.omega_lo};
        add(m, x * tail_of_series<0, order>(step.series, x, integrated),
            x * tail_of_series<1, order>(step.series, x, same) * per_unit);
        return m;
    }
    const T change = (x * x) * tail_of_series<2, order>(step.series, x, same) + step.series_1_lo * x;
    const T bend = (x * x) * tail_of_series<1, order>(step.series, x, integrated);
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
template <int order, class Step>
inline void move_to_end(Step& step) {
    const auto m = motion_at<order>(step, step.length);
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

template <int order, class T>
inline void expand_tangent(const TaylorPendulum<T>& p, T unit, const Series<T>& C, TangentStep<T>& tangent) {
    tangent.u[0] = tangent.start.theta;
    tangent.u[1] = tangent.start.omega * unit;
    tangent_series<order>(p.parameters.beta * unit, C, tangent.u);
}

/// The displacement at a time within the step, given as the time since the start of the step.
template <int order, class T>
inline Tangent<T> tangent_at(const TangentStep<T>& tangent, T unit, T since) {
    const T per_unit = 1.0 / unit, x = since * per_unit;
    return {tangent.start.theta + x * tail_of_series<1, order>(tangent.u, x, [](T a, int) { return a; }),
            tail_of_series<1, order>(tangent.u, x, [](T a, int k) { return a * (k + 0.0); }) * per_unit};
}

}  // namespace pendula::kernels::inline PENDULA_ISA
