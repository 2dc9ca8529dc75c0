// Additions to an angle and a velocity, with compensated summation, and wrapping of the angle into [-pi, pi).
#pragma once

#include "arithmetic/trigonometric.hpp"
#include "kernels/chunk.hpp"
#include "pendula/angle.hpp"

namespace pendula::kernels::inline PENDULA_ISA {

using namespace arithmetic;

/// Angles above this are wrapped by `split_turns`, which has enough bits of 2 pi for any double. Below it the number of turns
/// has few bits, and 2 pi as the sum of two doubles is enough.
inline constexpr double far_angle = 0x1p40;

/// Wraps an angle of any size into [-pi, pi) and counts its turns. After the first round the angle may be just outside the
/// interval by rounding; the second round corrects that.
template <class T>
inline void wrap_angle(Motion<T>& x) {
    for (int i = 0; any<T>(abs(x.theta) > far_angle) && i < lanes<T>; ++i) {
        if (!(abs(lane(x.theta, i)) > far_angle)) continue;
        const auto angle = split_turns(lane(x.theta, i));
        lane(x.theta, i) = angle.theta;
        lane(x.theta_lo, i) = 0;
        lane(x.turns, i) += angle.turns;
    }
    for (int round = 0; round < 2; ++round) {
        const auto is_outside = (x.theta >= pi_dd[0]) | (x.theta < -pi_dd[0]);
        if (!any<T>(is_outside)) return;
        const T turn = select(is_outside, floor((x.theta + pi_dd[0]) * inverse_two_pi_dd[0]), T{});
        const auto back = two_prod(turn, splat<T>(-two_pi_dd[0]));
        const auto wrapped = two_sum(x.theta, back.hi);
        x.theta = wrapped.hi;
        x.theta_lo = wrapped.lo + (x.theta_lo + (back.lo - turn * two_pi_dd[1]));
        x.turns = x.turns + turn;
    }
}

/// Adds to the angle and the velocity, with compensated summation (Kahan), and wraps the angle.
template <class T>
inline void add(Motion<T>& x, T d_theta, T d_omega) {
    const auto omega = two_sum(x.omega, d_omega + x.omega_lo);
    x.omega = omega.hi;
    x.omega_lo = omega.lo;
    const auto theta = two_sum(x.theta, d_theta + x.theta_lo);
    x.theta = theta.hi;
    x.theta_lo = theta.lo;
    wrap_angle(x);
}

/// x in the lanes where the mask is true, y in the others.
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
