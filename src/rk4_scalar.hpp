// One trajectory by Runge-Kutta's method: the kernel for a double, shared by single steps and by `solve`.
#pragma once

#include "kernels/rk4_kernel.hpp"
#include "pendula/pendulum.hpp"

namespace pendula {

inline kernels::Rk4Step<double> rk4_constants(const Pendulum& p, double h) noexcept {
    return kernels::rk4_step<double>(p.alpha, p.beta, p.torque, p.drive_amplitude, p.drive_frequency, p.drive_phase, h);
}

/// Up to `kernels::block_steps` steps from time t.
inline void rk4_steps(const Pendulum& p, const kernels::Rk4Step<double>& step, arithmetic::DoubleDouble<double> t,
                      kernels::Motion<double>& x, int steps) noexcept {
    if (is_conservative(p))
        kernels::rk4_block<true>(step, t, x, steps);
    else
        kernels::rk4_block<false>(step, t, x, steps);
}

}  // namespace pendula
