// Single steps of the one-step methods.
#pragma once

#include "pendula/pendulum.hpp"

namespace pendula {

// Each function returns the state at t + dt. dt [s] may have either sign; theta [rad] is not wrapped; NaN gives NaN.

/// The Euler method, of order 1: theta + omega dt, omega + a dt, with the acceleration a at time t.
State euler_step(const Pendulum& pendulum, State state, double t, double dt) noexcept;

/// The velocity Verlet method (kick, drift, kick), of order 2 and symplectic, so that the error of the energy stays bounded.
/// Hairer, Lubich & Wanner, Geometric Numerical Integration, I.1.4. It is for pendulums without friction and takes beta as 0.
State verlet_step(const Pendulum& pendulum, State state, double t, double dt) noexcept;

/// The classical Runge-Kutta method, of order 4 (3.10).
State rk4_step(const Pendulum& pendulum, State state, double t, double dt) noexcept;

}  // namespace pendula
