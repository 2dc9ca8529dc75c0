// The equation of motion, for one pendulum or a pack of them. All physics of the kernels is here. Time is measured in a unit u,
// and v = omega u:
//     v' = torque + drive cos(phase) - (pull + pivot cos(phase)) sin(theta) - drag v.
// The Runge-Kutta method uses its step as the unit, Taylor's method a power of two.
#pragma once

#include "arithmetic/trigonometric.hpp"
#include "kernels/chunk.hpp"

namespace pendula::kernels::inline PENDULA_ISA {

using namespace arithmetic;

/// The forces besides gravity. Each kind includes those before it. A lane may be computed with a later kind than its own
/// parameters need: its bits are the same, because the additional terms are 0.
enum class Forcing {
    none,
    steady,  ///< friction or a constant torque
    driven,  ///< a drive
    shaken,  ///< a shaken pivot
};

/// The coefficients of the equation in the unit u.
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

/// True for lanes in which the equation depends on time.
template <class T>
inline auto is_driven(const Parameters<T>& p) {
    return (p.drive_amplitude != 0.0) | (p.pivot_amplitude != 0.0);
}

/// True for lanes in which gravity is the only force.
template <class T>
inline auto is_free(const Terms<T>& k) {
    return (k.drag == 0.0) & (k.torque == 0.0) & (k.drive == 0.0) & (k.pivot == 0.0);
}

/// The terms of the equation at one time.
template <class T>
struct Acting {
    T force;  ///< the sum of torque and drive
    T pull;   ///< the coefficient of -sin(theta)
};

/// The terms of the equation at a time at which the cosine of the drive's phase is `cosine`.
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

/// The derivative of the velocity of a small displacement, by the linearised equation, at an angle with the given cosine.
template <class T>
inline T tangent_acceleration(const Terms<T>& k, const Acting<T>& now, T cosine, const Tangent<T>& d) {
    return -(now.pull * cosine) * d.theta - k.drag * d.omega;
}

/// A bound on |theta(stage) - theta(start of its step)| over the next `steps` steps of the Runge-Kutta method, of length 1, for
/// drag <= 1/8.
///
/// Let a = pull + |torque| + |drive| + |pivot|. In n steps |v| grows by at most n a. The velocity of a stage is at most
///     |v| (1 + drag + drag^2/2 + drag^3/4) + a (1 + drag/2 + drag^2/4) <= 1.14 (|v| + a).
/// The factor 1.25 instead of 1.14 leaves room for rounding.
template <class T>
inline T largest_change(const Terms<T>& k, T v, int steps) {
    return 1.25 * (abs(v) + (steps + 1.0) * (k.pull + abs(k.torque) + abs(k.drive) + abs(k.pivot)));
}

/// Added to every rate, so that the step of a pendulum without any forces is finite.
inline constexpr double slowest_rate = 0x1p-900;

/// The rate at which the motion changes [s^-1]: the sum of its characteristic frequencies, without |omega|.
template <class T>
inline T rate_of_change(const Parameters<T>& p) {
    const T of_drive = select(is_driven(p), p.drive_frequency, T{});
    return sqrt(p.alpha + abs(p.torque) + abs(p.drive_amplitude) + abs(p.pivot_amplitude)) + p.beta + of_drive + slowest_rate;
}

}  // namespace pendula::kernels::inline PENDULA_ISA
