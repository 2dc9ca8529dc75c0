// The equation of motion in any unit of time u, for one pendulum or a pack of them: the only place of the physics.
//     v' = torque + drive cos(phase) - (pull + pivot cos(phase)) sin(theta) - drag v,    v = omega u
// Runge-Kutta's method counts time in its step, Taylor's in a power of two: both scale alike.
#pragma once

#include "arithmetic/trigonometric.hpp"
#include "kernels/chunk.hpp"

namespace pendula::kernels::inline PENDULA_ISA {

using namespace arithmetic;

/// What acts beside gravity; each kind includes those before it. A lane's kind follows from its own parameters, and a lane that is
/// computed as a later kind keeps its bits: what it lacks is 0.
enum class Forcing {
    none,
    steady,  ///< friction or a constant torque
    driven,  ///< a drive
    shaken,  ///< a shaken pivot
};

/// The terms of the equation in a unit of time.
template <class T>
struct Terms {
    T pull;    ///< alpha u^2
    T drag;    ///< beta u
    T torque;  ///< torque u^2
    T drive;   ///< drive_amplitude u^2
    T pivot;   ///< pivot_amplitude u^2
};

template <class T>
inline Terms<T> terms(const Parameters<T>& p, T unit) {
    return {p.alpha * unit * unit, p.beta * unit, p.torque * unit * unit, p.drive_amplitude * unit * unit,
            p.pivot_amplitude * unit * unit};
}

/// Whether the terms depend on time.
template <class T>
inline auto is_driven(const Parameters<T>& p) {
    return (p.drive_amplitude != 0.0) | (p.pivot_amplitude != 0.0);
}

/// Whether nothing acts but gravity.
template <class T>
inline auto is_free(const Terms<T>& k) {
    return (k.drag == 0.0) & (k.torque == 0.0) & (k.drive == 0.0) & (k.pivot == 0.0);
}

/// The terms at one time.
template <class T>
struct Acting {
    T force;  ///< does not depend on the state
    T pull;   ///< times -sin(theta)
};

/// `cosine`: of the drive's phase.
template <Forcing forcing, class T>
inline Acting<T> acting(const Terms<T>& k, T cosine) {
    if constexpr (forcing < Forcing::driven) return {k.torque, k.pull};
    const T force = k.torque + k.drive * cosine;
    if constexpr (forcing == Forcing::driven) return {force, k.pull};
    return {force, k.pull + k.pivot * cosine};
}

template <class T>
inline T acceleration(const Terms<T>& k, const Acting<T>& now, T sine, T v) {
    return now.force - now.pull * sine - k.drag * v;
}

/// Of a small displacement, by the linearised equation.
template <class T>
inline T tangent_acceleration(const Terms<T>& k, const Acting<T>& now, T cosine, const Tangent<T>& d) {
    return -(now.pull * cosine) * d.theta - k.drag * d.omega;
}

/// A bound on |theta(stage) - theta(start of its step)| in each of so many steps of RK4 of length 1, for drag <= 1/8.
///
/// In n steps |v| grows by at most n a, a = pull + |torque| + |drive| + |pivot|. A stage's velocity is at most
/// |v| (1 + drag + drag^2/2 + drag^3/4) + a (1 + drag/2 + drag^2/4) <= 1.14 (|v| + a). The rest of 1.25 is for rounding.
template <class T>
inline T largest_change(const Terms<T>& k, T v, int steps) {
    return 1.25 * (abs(v) + (steps + 1.0) * (k.pull + abs(k.torque) + abs(k.drive) + abs(k.pivot)));
}

/// Added to rates, so that a pendulum which nothing moves takes finite steps.
inline constexpr double slowest_rate = 0x1p-900;

/// How fast the motion changes, but for the angle's own velocity [s^-1].
template <class T>
inline T rate_of_change(const Parameters<T>& p) {
    const T of_drive = select(is_driven(p), p.drive_frequency, T{});
    return sqrt(p.alpha + abs(p.torque) + abs(p.drive_amplitude) + abs(p.pivot_amplitude)) + p.beta + of_drive + slowest_rate;
}

}  // namespace pendula::kernels::inline PENDULA_ISA
