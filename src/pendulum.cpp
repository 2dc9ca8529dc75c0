#include "pendula/pendulum.hpp"

#include "arithmetic/trigonometric.hpp"

namespace pendula {

using namespace arithmetic;

double acceleration(const Pendulum& p, State state, double t) noexcept {
    const double drive = p.drive_amplitude == 0 ? 0.0 : p.drive_amplitude * cos(p.drive_frequency * t + p.drive_phase);
    return -p.alpha * sin(state.theta) - p.beta * state.omega + p.torque + drive;
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
