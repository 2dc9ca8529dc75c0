// `solve` and what it needs beforehand.
#pragma once

#include "numpy.hpp"

namespace pendula::python {

void define_trajectories(nb::module_& module);

}  // namespace pendula::python
