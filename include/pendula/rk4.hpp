// Runge-Kutta's method of order 4 (3.10).
#pragma once

#include "pendula/pendulum.hpp"

namespace pendula {

/// The state at t + dt by the classical Runge-Kutta method, of order 4 (3.10).
/// dt [s] of either sign; theta [rad] is not wrapped. NaN gives NaN.
State rk4_step(const Pendulum& pendulum, State state, double t, double dt) noexcept;

}  // namespace pendula
