// The kernels for one pendulum, as the public functions and the runs of one trajectory use them.
#pragma once

#include "kernels/rk4_kernel.hpp"
#include "kernels/taylor_kernel.hpp"
#include "pendula/taylor.hpp"

namespace pendula {

/// Conversions between the public structs and the structs of the kernels with T = double, which have the same layout.
inline kernels::Parameters<double> parameters_of(const Pendulum& p) noexcept {
    return __builtin_bit_cast(kernels::Parameters<double>, p);
}

/// Makes Runge-Kutta steps from the time row_time + first h, in blocks that are counted from the row.
inline void rk4_steps(const kernels::Rk4Step<double>& step, double row_time, double first, kernels::Motion<double>& x,
                      int steps) noexcept {
    kernels::Tangent<double> none{};
    for (int done = 0; done < steps; done += kernels::block_steps) {
        const int left = steps - done;
        kernels::rk4_block<false>(step, arithmetic::two_sum(row_time, (first + done) * step.h), x, none,
                                  left < kernels::block_steps ? left : kernels::block_steps);
    }
}

/// The motion at a time within the present Taylor step, given as the time since its start [s].
inline kernels::Motion<double> motion_at(const Taylor& run, double since) noexcept {
    return kernels::with_order(run.order, [&](auto order) { return kernels::motion_at<order.value>(run.step, since); });
}

/// Whether another Taylor step is needed to reach time t. A motion that needs more than 2^53 steps becomes NaN.
inline bool needs_step_to(Taylor& run, double t) noexcept {
    if (reaches(run, t)) return false;
    kernels::stop_endless(run.step, t);
    return run.step.length == run.step.length;
}

}  // namespace pendula
