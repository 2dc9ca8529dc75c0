// What the core's rules say of whole arrays.
#pragma once

#include <string>

#include "numpy.hpp"
#include "pendula/validate.hpp"

namespace pendula::python {

/// Throws std::invalid_argument with the first element outside the rule's interval, and its index in the array.
void require_all(const std::string& name, Operand& values, Rule rule);

}  // namespace pendula::python
