// Single steps of the methods that need no more than a state.
#pragma once

#include "pendula/pendulum.hpp"

namespace pendula {

// Each returns the state at t + dt. dt [s] may have either sign; theta [rad] is not wrapped; NaN gives NaN.

/// Euler's method, of order 1: theta + omega dt, omega + a dt.
State euler_step(const Pendulum& pendulum, State state, double t, double dt) noexcept;

/// Velocity Verlet (kick, drift, kick), of order 2 and symplectic: errors of the energy stay bounded.
/// Hairer, Lubich & Wanner, Geometric Numerical Integration, I.1.4. It is for pendulums without friction: beta is not used.
State verlet_step(const Pendulum& pendulum, State state, double t, double dt) noexcept;

/// The classical Runge-Kutta method, of order 4 (3.10).
State rk4_step(const Pendulum& pendulum, State state, double t, double dt) noexcept;

}  // namespace pendula
