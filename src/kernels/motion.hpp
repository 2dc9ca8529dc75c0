// An angle and a velocity on their way, with the rounding that sums have kept out of them.
#pragma once

#include "arithmetic/trigonometric.hpp"

namespace pendula::kernels::inline PENDULA_ISA {

using namespace arithmetic;

template <class T>
struct Motion {
    T theta;  ///< in [-pi, pi)
    T omega;
    T turns;
    T theta_lo;  ///< what rounding has kept out of theta and omega (Kahan)
    T omega_lo;
};

/// A small displacement, which follows the linearised equation.
template <class T>
struct Tangent {
    T theta;
    T omega;
};

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
    const auto back = two_prod(turn, splat<T>(-two_pi_dd[0]));
    const auto wrapped = two_sum(theta.hi, back.hi);
    x.theta = wrapped.hi;
    x.theta_lo = wrapped.lo + (theta.lo + (back.lo - turn * two_pi_dd[1]));
}

/// Where the mask holds, x; elsewhere y.
template <class T>
inline Motion<T> choose(const Mask<T>& mask, const Motion<T>& x, const Motion<T>& y) {
    return {select<T>(mask, x.theta, y.theta), select<T>(mask, x.omega, y.omega), select<T>(mask, x.turns, y.turns),
            select<T>(mask, x.theta_lo, y.theta_lo), select<T>(mask, x.omega_lo, y.omega_lo)};
}

template <class T>
inline Tangent<T> choose(const Mask<T>& mask, const Tangent<T>& x, const Tangent<T>& y) {
    return {select<T>(mask, x.theta, y.theta), select<T>(mask, x.omega, y.omega)};
}

}  // namespace pendula::kernels::inline PENDULA_ISA
