// Euler's method.
#pragma once

#include "pendula/pendulum.hpp"

namespace pendula {

/// The state at t + dt by Euler's method, of order 1: theta + omega dt, omega + a dt.
/// dt [s] of either sign; theta [rad] is not wrapped. NaN gives NaN.
State euler_step(const Pendulum& pendulum, State state, double t, double dt) noexcept;

}  // namespace pendula
