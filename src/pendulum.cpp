#include "pendula/pendulum.hpp"

#include "kernels/equation.hpp"

namespace pendula {

using namespace arithmetic;

double acceleration(const Pendulum& p, State state, double t) noexcept {
    const auto k = kernels::terms(__builtin_bit_cast(kernels::Parameters<double>, p), 1.0);
    const double cosine = is_driven(p) ? cos(p.drive_frequency * t + p.drive_phase) : 0.0;
    return kernels::acceleration(k, kernels::acting<kernels::Forcing::shaken>(k, cosine), sin(state.theta), state.omega);
}

double energy(double alpha, State state) noexcept {
    const double s = sin(0.5 * state.theta);
    return 0.5 * state.omega * state.omega + 2 * alpha * s * s;
}

double unwrapped(const Sample& sample) noexcept {
    const auto turns = DoubleDouble<double>{two_pi_dd[0], two_pi_dd[1]} * sample.turns;
    return (turns + sample.theta).hi;
}

}  // namespace pendula
