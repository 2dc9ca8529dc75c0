// Runge-Kutta's method of order 4 (3.10) for one pendulum or a pack of them, in blocks of steps.
//
// The sines of a step lie close to sin(theta): sin(theta + d) = sin + (sin (cos d - 1) + cos sin d) with short polynomials in
// d costs less than a new sine. Within a block sine and cosine of theta are carried along in the same way; a block starts
// with new ones. Angle and velocity carry the rounding of their sums from block to block (Kahan), and within a block only
// their small changes are summed, so that rounding hardly grows with the number of steps.
#pragma once

#include "arithmetic/polynomial.hpp"
#include "arithmetic/trigonometric.hpp"
#include "kernels/phase_kernel.hpp"

namespace pendula::kernels::inline PENDULA_ISA {

using namespace arithmetic;

/// Steps of a block, counted from the last row: rounding moves the carried sine and cosine by some 10 ulp at most.
inline constexpr int block_steps = 32;

template <class T>
struct Motion {
    T theta;  ///< in [-pi, pi)
    T omega;
    T turns;
    T theta_lo;  ///< what rounding has kept out of theta and omega
    T omega_lo;
};

/// A step's constants. Velocities are counted in angle per step, v = omega h, and accelerations likewise, times h^2.
template <class T>
struct Rk4Step {
    T h;
    T pull;                  ///< alpha h^2
    T drag;                  ///< beta h
    T torque;                ///< torque h^2
    T drive;                 ///< drive_amplitude h^2
    DoubleDouble<T> rate;    ///< drive_frequency/(2 pi)
    T start;                 ///< drive_phase/(2 pi)
    SinCos<T> half_step;     ///< of drive_frequency h/2
};

/// The drive's phase, carried through a block.
template <class T>
struct Drive {
    T s;
    T c;

    void rotate(const SinCos<T>& by) {
        const T next = s * by.cos + c * by.sin;
        c = c * by.cos - s * by.sin;
        s = next;
    }
};

/// sin d and cos d - 1 for small d; the coefficients' largest errors stand with them.
template <int terms, class T>
inline SinCos<T> small_increments(T d, const double (&sine)[terms], const double (&cosine)[terms]) {
    const T q = d * d;
    return {d + d * (q * polynomial(q, sine)), q * (-0.5 + q * polynomial(q, cosine))};
}

/// Angles up to 1/768 a step: the assignment's 10^-4 of a period and finer.
struct Tiny {
    static constexpr double limit = 1.0 / 768;
    template <class T>
    static SinCos<T> increments(T d) { return small_increments(d, sin_tiny, cos_tiny); }
};

/// Angles up to 1/48 a step.
struct Short {
    static constexpr double limit = 1.0 / 48;
    template <class T>
    static SinCos<T> increments(T d) { return small_increments(d, sin_short, cos_short); }
};

/// What a step adds to angle and velocity [per step].
template <class T>
struct Increment {
    T theta;
    T v;
};

/// (3.10) with sine(d) = sin(theta + d), s = sine(0), where the accelerations are -pull times these sines.
template <class T, class Sine>
inline Increment<T> free_increment(T pull, T v, T s, Sine sine) {
    const T half = 0.5 * v;
    const T sb = sine(half);
    const T sc = sine(half - (0.25 * pull) * s);
    const T sd = sine(v - (0.5 * pull) * sb);
    const T sixth = pull * (-1.0 / 6.0);
    const T middle = sb + sc;
    return {v + sixth * (s + middle), sixth * ((s + sd) + (middle + middle))};
}

/// (3.10) with friction, torque and drive; `drive` goes from the beginning of the step to its end.
template <class T, class Sine>
inline Increment<T> forced_increment(const Rk4Step<T>& k, Drive<T>& drive, T v, T s, Sine sine) {
    const T ka = (k.torque + k.drive * drive.c) - k.pull * s - k.drag * v;
    drive.rotate(k.half_step);
    const T force = k.torque + k.drive * drive.c;
    drive.rotate(k.half_step);
    const T vb = v + 0.5 * ka;
    const T kb = force - k.pull * sine(0.5 * v) - k.drag * vb;
    const T vc = v + 0.5 * kb;
    const T kc = force - k.pull * sine(0.5 * vb) - k.drag * vc;
    const T vd = v + kc;
    const T kd = (k.torque + k.drive * drive.c) - k.pull * sine(vc) - k.drag * vd;
    const T middle = kb + kc;
    return {v + (ka + middle) * (1.0 / 6.0), ((ka + kd) + (middle + middle)) * (1.0 / 6.0)};
}

template <bool is_free, class T, class Sine>
inline Increment<T> rk4_increment(const Rk4Step<T>& k, Drive<T>& drive, T v, T s, Sine sine) {
    if constexpr (is_free)
        return free_increment(k.pull, v, s, sine);
    else
        return forced_increment(k, drive, v, s, sine);
}

/// Adds to angle and velocity, and takes the angle back into [-pi, pi), 2 pi in two parts.
template <class T>
inline void add(Motion<T>& x, T d_theta, T d_omega) {
    const auto omega = two_sum(x.omega, d_omega + x.omega_lo);
    x.omega = omega.hi;
    x.omega_lo = omega.lo;
    const auto theta = two_sum(x.theta, d_theta + x.theta_lo);
    const auto is_outside = (theta.hi >= pi_dd[0]) | (theta.hi < -pi_dd[0]);
    const T turn = select(is_outside, round_even(theta.hi * inverse_two_pi_dd[0]), T{});
    x.turns = x.turns + turn;
    // turn * 2 pi rounds where it is large, and then the step was hopeless anyway
    const auto back = two_prod(turn, splat<T>(-two_pi_dd[0]));
    const auto wrapped = two_sum(theta.hi, back.hi);
    x.theta = wrapped.hi;
    x.theta_lo = wrapped.lo + (theta.lo + (back.lo - turn * two_pi_dd[1]));
}

/// Steps so short that sines follow each other by small increments.
template <bool is_free, class Size, class T>
inline void small_steps(const Rk4Step<T>& k, Drive<T> drive, Motion<T>& x, int steps) {
    const auto r = sincos(x.theta);
    T s = r.sin + r.cos * x.theta_lo;
    T c = r.cos - r.sin * x.theta_lo;
    const T start = x.omega * k.h;
    T change{}, way{}, v = start;
    for (int i = 0; i < steps; ++i) {
        const auto d = rk4_increment<is_free>(k, drive, v, s, [s, c](T e) {
            const auto small = Size::increments(e);
            return s + (s * small.cos + c * small.sin);
        });
        const auto small = Size::increments(d.theta);
        const T next = s + (s * small.cos + c * small.sin);
        c = c + (c * small.cos - s * small.sin);
        s = next;
        way = way + d.theta;
        change = change + d.v;
        v = start + change;
    }
    add(x, way, change / k.h);
}

/// Steps of any length: every sine anew.
template <bool is_free, class T>
inline void large_steps(const Rk4Step<T>& k, Drive<T> drive, Motion<T>& x, int steps) {
    for (int i = 0; i < steps; ++i) {
        const T theta = x.theta;
        const auto d = rk4_increment<is_free>(k, drive, x.omega * k.h, sin(theta), [theta](T e) { return sin(theta + e); });
        add(x, d.theta, d.v / k.h);
    }
}

/// Where the mask holds, y; elsewhere x.
template <class T>
inline Motion<T> choose(Mask<T> mask, const Motion<T>& y, const Motion<T>& x) {
    return {select<T>(mask, y.theta, x.theta), select<T>(mask, y.omega, x.omega), select<T>(mask, y.turns, x.turns),
            select<T>(mask, y.theta_lo, x.theta_lo), select<T>(mask, y.omega_lo, x.omega_lo)};
}

/// Up to `block_steps` steps from time t (double-double); each lane by the way that its own angles allow.
template <bool is_free, class T>
inline void rk4_block(const Rk4Step<T>& k, DoubleDouble<T> t, Motion<T>& x, int steps) {
    T force = k.pull;
    Drive<T> drive{};
    if constexpr (!is_free) {
        force = force + abs(k.torque) + abs(k.drive);
        const auto p = to_phase(turned(t.hi, k.rate) + t.lo * k.rate.hi, k.start);
        const auto r = sincos(two_pi_dd[0] * p.fraction);
        drive = {r.sin, r.cos};
    }
    // No angle of the block exceeds this: a step adds at most `force` to v, and friction up to 1/8 a step a tenth to a stage.
    const T reach = 1.25 * (abs(x.omega * k.h) + (steps + 1.0) * force);
    const auto is_small = (reach <= Short::limit) & (k.drag <= 0.125);
    const auto is_tiny = is_small & (reach <= Tiny::limit);
    const auto is_short = is_small & !is_tiny;
    Motion<T> tiny = x, small = x, large = x;
    if (any<T>(is_tiny)) small_steps<is_free, Tiny>(k, drive, tiny, steps);
    if (any<T>(is_short)) small_steps<is_free, Short>(k, drive, small, steps);
    if (any<T>(!is_small)) large_steps<is_free>(k, drive, large, steps);
    x = choose<T>(is_tiny, tiny, choose<T>(is_small, small, large));
}

/// The constants of a step h.
template <class T>
inline Rk4Step<T> rk4_step(T alpha, T beta, T torque, T drive_amplitude, T drive_frequency, T drive_phase, T h) {
    const DoubleDouble<T> inverse{splat<T>(inverse_two_pi_dd[0]), splat<T>(inverse_two_pi_dd[1])};
    return {h,
            alpha * h * h,
            beta * h,
            torque * h * h,
            drive_amplitude * h * h,
            inverse * drive_frequency,
            inverse.hi * drive_phase,
            sincos(0.5 * drive_frequency * h)};
}

}  // namespace pendula::kernels::inline PENDULA_ISA
