// The kernels for one pendulum: what the public functions and the runs of one trajectory share.
#pragma once

#include "kernels/rk4_kernel.hpp"
#include "kernels/taylor_kernel.hpp"
#include "pendula/taylor.hpp"

namespace pendula {

/// Kernels' structs of doubles have the layout of the public ones.
inline kernels::Parameters<double> parameters_of(const Pendulum& p) noexcept {
    return __builtin_bit_cast(kernels::Parameters<double>, p);
}

/// Runge-Kutta steps from the time row_time + first h, in blocks counted from the row.
inline void rk4_steps(const kernels::Rk4Step<double>& step, double row_time, double first, kernels::Motion<double>& x,
                      int steps) noexcept {
    kernels::Tangent<double> none{};
    for (int done = 0; done < steps; done += kernels::block_steps) {
        const int left = steps - done;
        kernels::rk4_block<false>(step, arithmetic::two_sum(row_time, (first + done) * step.h), x, none,
                                  left < kernels::block_steps ? left : kernels::block_steps);
    }
}

/// Whether Taylor's method has to step on towards time t. Makes NaN of a motion that would take more than 2^53 steps to it.
inline bool goes_on_to(Taylor& run, double t) noexcept {
    if (reaches(run, t)) return false;
    kernels::give_up_endless(run.step, t);
    return run.step.length == run.step.length;
}

}  // namespace pendula
