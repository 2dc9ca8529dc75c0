// Verlet's method in its velocity form.
#pragma once

#include "pendula/pendulum.hpp"

namespace pendula {

/// The state at t + dt by velocity Verlet (kick, drift, kick), of order 2 and symplectic: energy errors stay bounded.
/// Hairer, Lubich & Wanner, Geometric Numerical Integration, I.1.4. For pendulums without friction: beta is not looked at.
/// dt [s] of either sign; theta [rad] is not wrapped. NaN gives NaN.
State verlet_step(const Pendulum& pendulum, State state, double t, double dt) noexcept;

}  // namespace pendula
