// Functions of numbers made functions of arrays.
#pragma once

#include <tuple>

#include "broadcast.hpp"
#include "long_call.hpp"

namespace pendula::python {

/// compute(In doubles) -> array of Out doubles, for every element of the broadcast.
template <std::size_t In, std::size_t Out, class Compute>
std::array<nb::object, Out> elementwise(Broadcast<In, Out>& arrays, const Compute& compute) {
    {
        LongCall call(arrays.size());
        const auto axes = arrays.axes();
        walk<In + Out>(axes, arrays.start(), [&](const Places<In + Out>& at) {
            std::array<double, In> arguments;
            for (std::size_t k = 0; k < In; ++k) arguments[k] = load(at[k]);
            const std::array<double, Out> results = std::apply(compute, arguments);
            for (std::size_t k = 0; k < Out; ++k) store(at[In + k], results[k]);
            call.worked(1);
        });
    }
    return arrays.results();
}

}  // namespace pendula::python
