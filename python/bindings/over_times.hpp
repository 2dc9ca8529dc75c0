// The closed form over arrays of pendulums and of times.
#pragma once

#include <algorithm>
#include <cstdint>

#include "broadcast.hpp"
#include "long_call.hpp"
#include "pendula/exact.hpp"

namespace pendula::python {

inline constexpr Py_ssize_t block = 512;  // times computed together: what they touch stays in the first cache

/// Where results go, one behind the other.
template <std::size_t Out>
using Results = std::array<double*, Out>;

inline bool is_contiguous(const char* at, Py_ssize_t step) {
    return step == sizeof(double) && reinterpret_cast<std::uintptr_t>(at) % alignof(double) == 0;
}

/// One pendulum along one axis of times, whose place is the fourth. What is not contiguous goes through buffers.
template <std::size_t Out, class Evaluate>
void run(const Exact& solution, const Axis<4 + Out>& axis, Places<4 + Out> at, LongCall& call, const Evaluate& evaluate) {
    double buffers[1 + Out][block];
    for (Py_ssize_t done = 0; done < axis.length; done += block, move(at, axis, block)) {
        const Py_ssize_t n = std::min(block, axis.length - done);
        const bool is_direct = is_contiguous(at[3], axis.step[3]);
        if (!is_direct)
            for (Py_ssize_t i = 0; i < n; ++i) buffers[Out][i] = load(at[3] + i * axis.step[3]);
        const double* const t = is_direct ? reinterpret_cast<const double*>(at[3]) : buffers[Out];

        Results<Out> results;
        for (std::size_t k = 0; k < Out; ++k)
            results[k] = axis.step[4 + k] == sizeof(double) ? reinterpret_cast<double*>(at[4 + k]) : buffers[k];
        evaluate(solution, static_cast<std::size_t>(n), t, results);
        for (std::size_t k = 0; k < Out; ++k)
            if (results[k] == buffers[k])
                for (Py_ssize_t i = 0; i < n; ++i) store(at[4 + k] + i * axis.step[4 + k], buffers[k][i]);
        call.worked(n);
    }
}

/// evaluate(solution, n, t, results) for every element of the broadcast of theta0, omega0, alpha and t. Axes along which only
/// the time changes are innermost, so that each pendulum is prepared once.
template <std::size_t Out, class Evaluate>
std::array<nb::object, Out> over_times(Broadcast<4, Out>& arrays, const Evaluate& evaluate) {
    constexpr std::size_t count = 4 + Out;
    {
        LongCall call(arrays.size());
        auto axes = arrays.axes();
        const auto first_time_axis = std::stable_partition(axes.begin(), axes.end(), [](const Axis<count>& axis) {
            return axis.step[0] != 0 || axis.step[1] != 0 || axis.step[2] != 0;
        });
        const bool has_times = first_time_axis != axes.end();
        const Axis<count> last = has_times ? axes.back() : Axis<count>{};
        const std::span<const Axis<count>> pendulums(axes.begin(), first_time_axis);
        const std::span<const Axis<count>> times(first_time_axis, axes.end() - has_times);
        walk<count>(pendulums, arrays.start(), [&](const Places<count>& pendulum) {
            const Exact solution = exact(load(pendulum[2]), {load(pendulum[0]), load(pendulum[1])});
            walk<count>(times, pendulum, [&](const Places<count>& at) { run<Out>(solution, last, at, call, evaluate); });
        });
    }
    return arrays.results();
}

}  // namespace pendula::python
