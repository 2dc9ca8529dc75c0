#include "pendula/euler.hpp"

namespace pendula {

State euler_step(const Pendulum& pendulum, State state, double t, double dt) noexcept {
    return {state.theta + state.omega * dt, state.omega + acceleration(pendulum, state, t) * dt};
}

}  // namespace pendula
