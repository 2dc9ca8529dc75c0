#include "pendula/verlet.hpp"

namespace pendula {

State verlet_step(const Pendulum& pendulum, State state, double t, double dt) noexcept {
    Pendulum frictionless = pendulum;
    frictionless.beta = 0;
    const double middle = state.omega + 0.5 * dt * acceleration(frictionless, state, t);
    const State drifted{state.theta + dt * middle, middle};
    return {drifted.theta, middle + 0.5 * dt * acceleration(frictionless, drifted, t + dt)};
}

}  // namespace pendula
