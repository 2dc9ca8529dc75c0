// The Runge-Kutta method of order 4 (3.10), for one pendulum or a pack of them, in blocks of steps.
//
// In a short step the angles of the four stages are close to theta. Then
//     sin(theta + d) = sin(theta) + (sin(theta) (cos(d) - 1) + cos(theta) sin(d)),
// with short polynomials in d, costs less than a new sine. Within a block sine and cosine of theta are updated from step to
// step in the same way; each block starts with newly computed ones. Within a block only the changes of angle and velocity are
// summed. At its end they are added by compensated summation. So the rounding error hardly grows with the number of steps.
#pragma once

#include "arithmetic/polynomial.hpp"
#include "kernels/equation.hpp"
#include "kernels/motion.hpp"
#include "kernels/phase_kernel.hpp"

namespace pendula::kernels::inline PENDULA_ISA {

/// The number of steps of a block; blocks are counted from the last row. In so many steps the rounding errors of the updated
/// sine and cosine stay below about 10 ulp.
inline constexpr int block_steps = 32;

/// The constants of a step. The unit of time is the step: v = omega h is the angle per step.
template <class T>
struct Rk4Step {
    T h;
    T per_step;  ///< 1/h; 0 if h is 0, when a step changes nothing
    Terms<T> terms;
    Rate<T> rate;         ///< drive_frequency/(2 pi)
    T start;              ///< drive_phase/(2 pi)
    SinCos<T> half_step;  ///< sine and cosine of drive_frequency h/2
};

template <class T>
inline Rk4Step<T> rk4_constants(const Parameters<T>& p, T h) {
    const DoubleDouble<T> inverse{splat<T>(inverse_two_pi_dd[0]), splat<T>(inverse_two_pi_dd[1])};
    return {h,
            select(h == 0.0, T{}, 1.0 / h),
            terms(p, h),
            to_rate(inverse * p.drive_frequency),
            inverse.hi * p.drive_phase,
            sincos(0.5 * p.drive_frequency * h)};
}

/// sin d and cos d - 1 for |d| <= short_limit, with an absolute error below 5e-17.
inline constexpr double short_limit = 1.0 / 48;
template <class T>
inline SinCos<T> short_increments(T d) {
    const T q = d * d;
    return {d + d * (q * polynomial(q, sin_short)), q * (-0.5 + q * polynomial(q, cos_short))};
}

/// sin d and cos d - 1 for |d| <= medium_limit, with an absolute error below 2e-16.
inline constexpr double medium_limit = 0.75;
template <class T>
inline SinCos<T> medium_increments(T d) {
    const T q = d * d;
    return {d + d * (q * polynomial(q, sin_quarter)), q * (-0.5 + q * polynomial(q, cos_quarter))};
}

/// sin(x + d) and cos(x + d), from sin x and cos x and from d.sin = sin d and d.cos = cos d - 1.
template <class T>
inline SinCos<T> turned_by(SinCos<T> x, SinCos<T> d) {
    return {x.sin + (x.sin * d.cos + x.cos * d.sin), x.cos + (x.cos * d.cos - x.sin * d.sin)};
}

/// The state within a block of short steps: sine and cosine of the angle, the velocity, and the sums of the changes of angle
/// and velocity.
template <class T>
struct Carried {
    SinCos<T> angle;
    T v;
    T start;     ///< v at the start of the block
    T change{};  ///< of v, since the start of the block
    T angle_change{};

    Carried(const Motion<T>& x, T h) : v(x.omega * h), start(v) {
        const auto r = sincos(x.theta);
        angle = {r.sin + r.cos * x.theta_lo, r.cos - r.sin * x.theta_lo};
    }

    void step(T d_theta, T d_v) {
        angle_change = angle_change + d_theta;
        change = change + d_v;
        v = start + change;
    }
};

/// Steps of a free pendulum with |v| <= near_limit and p = alpha h^2 <= near_pull, expanded about the middle of the step.
///
/// The middle is B = theta + eta with eta = v/2. The sine of the third stage is expanded about B:
///     sin C = sin B - a cos B - a^2/2 sin B,  a = (p/4) sin A.
/// That of the fourth stage is expanded in the same way about theta + v. With
///     s = (p/6) sin B,  c = (p/6) cos B,  m = s (2 + cos(eta)),  t = c sin(eta)
/// (3.10) becomes
///     theta' - theta = v + bend,  bend = t - m + 3/2 c (s - t)
///     eta' - eta     = s (3 c cos(eta) + 27/8 s^2) - p^2/24 sin(eta) - m
/// with truncated terms below 1e-17. Of the angle only s and c are needed. For the next step they are rotated by B' - B: first
/// by v, then by the small remainder bend + eta' - eta.
inline constexpr double near_limit = 1.0 / 256;
inline constexpr double near_pull = 4e-6;
template <class T>
inline void near_steps(const Rk4Step<T>& k, Motion<T>& x, int steps) {
    const T pull = k.terms.pull;
    const T unit = pull * (1.0 / 6.0), squared = pull * pull * (1.0 / 24.0);
    const T start = 0.5 * (x.omega * k.h);
    auto middle = turned_by(sincos(x.theta), short_increments(start + x.theta_lo));
    middle = {unit * middle.sin, unit * middle.cos};
    T eta = start, change{}, angle_change{};
    for (int i = 0; i < steps; ++i) {
        const T q = eta * eta;
        const T sine = eta + eta * (q * (-1.0 / 6.0));
        const T cosine = 1.0 + q * (-0.5 + q * (1.0 / 24.0));
        const T twice = sine + sine;
        const auto end = turned_by(middle, SinCos<T>{twice * cosine, -(twice * sine)});
        const T m = middle.sin * (2.0 + cosine);
        const T t = middle.cos * sine;
        const T bend = (t - m) + (1.5 * middle.cos) * (middle.sin - t);
        const T d_eta = (middle.sin * ((3.0 * middle.cos) * cosine + 3.375 * (middle.sin * middle.sin)) - squared * sine) - m;
        const T rest = bend + d_eta;
        const T half_square = (0.5 * rest) * rest;
        middle = {end.sin + (rest * end.cos - half_square * end.sin), end.cos - (rest * end.sin + half_square * end.cos)};
        angle_change = angle_change + ((eta + eta) + bend);
        change = change + d_eta;
        eta = start + change;
    }
    add(x, angle_change, (change + change) * k.per_step);
}

/// The four stages of a step for the motion and, if requested, for a displacement.
template <Forcing forcing, bool has_tangent, class T>
struct Stages {
    const Rk4Step<T>& k;
    SinCos<T> drive;  ///< sine and cosine of the phase of the drive, at the current stage
    Tangent<T> tangent;

    Acting<T> now() const { return acting<forcing>(k.terms, drive.cos); }

    void advance_drive() {
        if constexpr (forcing < Forcing::driven) return;
        drive = {drive.sin * k.half_step.cos + drive.cos * k.half_step.sin,
                 drive.cos * k.half_step.cos - drive.sin * k.half_step.sin};
    }

    /// The increments of angle and v in one step of (3.10). a = (sin, cos)(theta) and angle_at(d) = (sin, cos)(theta + d). Also
    /// advances the phase of the drive, and the displacement, by one step.
    template <class AngleAt>
    Tangent<T> step(T v, SinCos<T> a, AngleAt angle_at) {
        const auto start = now();
        const T ka = acceleration(k.terms, start, a.sin, v);
        advance_drive();
        const auto middle = now();
        const auto b = angle_at(0.5 * v);
        const T vb = v + 0.5 * ka;
        const T kb = acceleration(k.terms, middle, b.sin, vb);
        const auto c = angle_at(0.5 * vb);
        const T vc = v + 0.5 * kb;
        const T kc = acceleration(k.terms, middle, c.sin, vc);
        advance_drive();
        const auto end = now();
        const auto d = angle_at(vc);
        const T kd = acceleration(k.terms, end, d.sin, v + kc);
        if constexpr (has_tangent) {
            const auto at = tangent;
            const T ta = tangent_acceleration(k.terms, start, a.cos, at);
            const Tangent<T> at_b{at.theta + 0.5 * at.omega, at.omega + 0.5 * ta};
            const T tb = tangent_acceleration(k.terms, middle, b.cos, at_b);
            const Tangent<T> at_c{at.theta + 0.5 * at_b.omega, at.omega + 0.5 * tb};
            const T tc = tangent_acceleration(k.terms, middle, c.cos, at_c);
            const T td = tangent_acceleration(k.terms, end, d.cos, {at.theta + at_c.omega, at.omega + tc});
            const auto bend = weighted(ta, tb, tc, td);
            tangent = {at.theta + at.omega + bend.theta, at.omega + bend.omega};
        }
        const auto bend = weighted(ka, kb, kc, kd);
        return {v + bend.theta, bend.omega};
    }

    /// The increments of angle (without v) and velocity, from the accelerations of the four stages.
    static Tangent<T> weighted(T a, T b, T c, T d) {
        const T inner = b + c;
        return {(a + inner) * (1.0 / 6.0), ((a + d) + (inner + inner)) * (1.0 / 6.0)};
    }
};

/// Steps in which the angle changes by at most short_limit: all sines by short polynomials, from the sine and cosine of the
/// step before.
template <class Stages, class T>
inline void short_steps(Stages& stages, Motion<T>& x, int steps) {
    Carried<T> at(x, stages.k.h);
    for (int i = 0; i < steps; ++i) {
        const auto angle = at.angle;
        const auto d = stages.step(at.v, angle, [angle](T e) { return turned_by(angle, short_increments(e)); });
        at.angle = turned_by(angle, short_increments(d.theta));
        at.step(d.theta, d.omega);
    }
    add(x, at.angle_change, at.change * stages.k.per_step);
}

/// Steps in which the angle changes by at most medium_limit: one new sine and cosine for each step, and the other three by
/// longer polynomials.
template <class Stages, class T>
inline void medium_steps(Stages& stages, Motion<T>& x, int steps) {
    for (int i = 0; i < steps; ++i) {
        const auto angle = sincos(x.theta);
        const auto d =
            stages.step(x.omega * stages.k.h, angle, [angle](T e) { return turned_by(angle, medium_increments(e)); });
        add(x, d.theta, d.omega * stages.k.per_step);
    }
}

/// Steps of any length: four new sines.
template <class Stages, class T>
inline void large_steps(Stages& stages, Motion<T>& x, int steps) {
    for (int i = 0; i < steps; ++i) {
        const T theta = x.theta;
        const auto d = stages.step(x.omega * stages.k.h, sincos(theta), [theta](T e) { return sincos(theta + e); });
        add(x, d.theta, d.omega * stages.k.per_step);
    }
}

/// A block of steps that `near_steps` does not cover. `largest` bounds the change of the angle within a step.
template <Forcing forcing, bool has_tangent, class T>
inline void forced_block(const Rk4Step<T>& k, DoubleDouble<T> t, Motion<T>& x, Tangent<T>& tangent, T largest, int steps) {
    SinCos<T> drive{};
    if constexpr (forcing >= Forcing::driven)
        drive = sincos(two_pi_dd[0] * phase_at(t.hi, k.rate, k.start + t.lo * k.rate.whole).fraction);
    const auto is_bounded = abs(k.terms.drag) <= 0.125;  // as `largest_change` requires
    const auto is_short = is_bounded & (largest <= short_limit);
    const auto is_medium = is_bounded & (largest <= medium_limit);
    Stages<forcing, has_tangent, T> by_short{k, drive, {tangent.theta, tangent.omega * k.h}};
    auto by_medium = by_short, by_large = by_short;
    Motion<T> after_short = x, after_medium = x, after_large = x;
    if (any<T>(is_short)) short_steps(by_short, after_short, steps);
    if (any<T>(is_medium & !is_short)) medium_steps(by_medium, after_medium, steps);
    if (any<T>(!is_medium)) large_steps(by_large, after_large, steps);
    x = choose<T>(is_short, after_short, choose<T>(is_medium, after_medium, after_large));
    const auto moved = choose<T>(is_short, by_short.tangent, choose<T>(is_medium, by_medium.tangent, by_large.tangent));
    tangent = {moved.theta, moved.omega * k.per_step};
}

/// Makes up to block_steps steps from time t. Each lane uses the method that its own constants and angles allow, so that its
/// bits do not depend on the other lanes. The displacement follows if has_tangent is true.
template <bool has_tangent, class T>
inline void rk4_block(const Rk4Step<T>& k, DoubleDouble<T> t, Motion<T>& x, Tangent<T>& tangent, int steps) {
    const T largest = largest_change(k.terms, x.omega * k.h, steps);
    const auto is_near = (largest <= near_limit) & is_free(k.terms) &
                         (k.terms.pull <= (has_tangent ? -1.0 : near_pull));  // near_steps has no displacements

    Motion<T> near = x, forced = x;
    if (any<T>(is_near)) near_steps(k, near, steps);
    if (any<T>(!is_near)) {
        if (any<T>(k.terms.pivot != 0.0))
            forced_block<Forcing::shaken, has_tangent>(k, t, forced, tangent, largest, steps);
        else if (any<T>(k.terms.drive != 0.0))
            forced_block<Forcing::driven, has_tangent>(k, t, forced, tangent, largest, steps);
        else
            forced_block<Forcing::steady, has_tangent>(k, t, forced, tangent, largest, steps);
    }
    x = choose<T>(is_near, near, forced);
}

}  // namespace pendula::kernels::inline PENDULA_ISA
