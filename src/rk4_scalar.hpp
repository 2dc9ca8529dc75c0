// One trajectory by Runge-Kutta's method: the kernel for a double, shared by single steps and by `solve`.
#pragma once

#include "kernels/rk4_kernel.hpp"
#include "pendula/pendulum.hpp"

namespace pendula {

inline kernels::Rk4Step<double> rk4_constants(const Pendulum& p, double h) noexcept {
    return kernels::rk4_constants<double>(p.alpha, p.beta, p.torque, p.drive_amplitude, p.drive_frequency, p.drive_phase, h);
}

/// Steps from the time row_time + first h, in blocks counted from the row.
inline void rk4_steps(const kernels::Rk4Step<double>& step, double row_time, double first, kernels::Motion<double>& x,
                      int steps) noexcept {
    kernels::Tangent<double> none{};
    for (int done = 0; done < steps; done += kernels::block_steps) {
        const int left = steps - done;
        kernels::rk4_block<false>(step, arithmetic::two_sum(row_time, (first + done) * step.h), x, none,
                                  left < kernels::block_steps ? left : kernels::block_steps);
    }
}

}  // namespace pendula
