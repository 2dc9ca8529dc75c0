// Sections, mean velocities, Lyapunov exponents, attractors.
#pragma once

#include "numpy.hpp"

namespace pendula::python {

void define_measures(nb::module_& module);

}  // namespace pendula::python
