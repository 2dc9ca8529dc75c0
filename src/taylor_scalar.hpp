// One trajectory by Taylor's method: the kernel's step for a double, shared by the stepper and the search for crossings.
#pragma once

#include "kernels/taylor_kernel.hpp"
#include "pendula/taylor.hpp"

namespace pendula {

kernels::TaylorStep<double> step_of(const Taylor& run) noexcept;

}  // namespace pendula
