// One trajectory by Taylor's method: the kernel's step for a double, shared by the stepper and the search for crossings.
#pragma once

#include "kernels/taylor_kernel.hpp"
#include "pendula/taylor.hpp"

namespace pendula {

kernels::TaylorStep<double> step_of(const Taylor& run) noexcept;

/// Whether to step on towards time t. Makes NaN of a motion that would take more than 2^53 steps to it.
bool goes_on_to(Taylor& run, double t) noexcept;

}  // namespace pendula
