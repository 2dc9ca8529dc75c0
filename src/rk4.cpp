#include "pendula/rk4.hpp"

#include "rk4_scalar.hpp"

namespace pendula {

State rk4_step(const Pendulum& pendulum, State state, double t, double dt) noexcept {
    kernels::Motion<double> x{state.theta, state.omega, 0, 0, 0};
    rk4_steps(rk4_constants(pendulum, dt), t, 0, x, 1);
    return {unwrapped({0, x.theta, 0, x.turns}), x.omega};
}

}  // namespace pendula
