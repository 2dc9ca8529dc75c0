// Ensembles of pendulums as Python passes them, and long calls of the core upon them.
#pragma once

#include <array>
#include <functional>
#include <span>

#include "numpy.hpp"
#include "pendula/ensemble.hpp"

namespace pendula::python {

inline constexpr std::size_t member_columns = 8;

/// theta0, omega0 and the six parameters, in the order of `Ensemble`: tuples of floats and arrays.
using Columns = std::array<nb::handle, member_columns>;
Columns columns(const nb::tuple& arguments);

/// Raises ValueError for the first value outside its interval, whatever is done with it.
void require_members(const Columns& columns);

/// Values one behind the other, which must stay where they are while the span is used.
std::span<const double> values_of(Operand& contiguous);

/// Columns that are contiguous, of 1 or `size` values.
struct Members {
    std::array<Operand, member_columns> values;
    Ensemble ensemble;

    Members(const Columns& columns, Py_ssize_t size);
};

/// Calls work(control) without the GIL; raises what a signal's handler raised, if that is why work returned false.
void run_long(int threads, const std::function<bool(const Control&)>& work);

}  // namespace pendula::python
