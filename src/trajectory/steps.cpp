#include "pendula/steps.hpp"

#include "trajectory/scalar.hpp"

namespace pendula {

State euler_step(const Pendulum& pendulum, State state, double t, double dt) noexcept {
    return {state.theta + state.omega * dt, state.omega + acceleration(pendulum, state, t) * dt};
}

State verlet_step(const Pendulum& pendulum, State state, double t, double dt) noexcept {
    Pendulum frictionless = pendulum;
    frictionless.beta = 0;
    const double middle = state.omega + 0.5 * dt * acceleration(frictionless, state, t);
    const State drifted{state.theta + dt * middle, middle};
    return {drifted.theta, middle + 0.5 * dt * acceleration(frictionless, drifted, t + dt)};
}

State rk4_step(const Pendulum& pendulum, State state, double t, double dt) noexcept {
    kernels::Motion<double> x{state.theta, state.omega, 0, 0, 0};
    rk4_steps(kernels::rk4_constants(parameters_of(pendulum), dt), t, 0, x, 1);
    return {unwrapped({0, x.theta, 0, x.turns}), x.omega};
}

}  // namespace pendula
