// The closed form over arrays of pendulums and of times.
#pragma once

#include <algorithm>

#include "broadcast.hpp"
#include "long_call.hpp"
#include "pendula/exact.hpp"

namespace pendula::python {

/// Times computed together and what comes of them; all of it stays in the first cache.
template <std::size_t Out>
struct Block {
    static constexpr Py_ssize_t size = 512;
    double t[size];
    double results[Out][size];
};

/// One pendulum along one axis of times.
template <std::size_t Out, class Evaluate>
void run(const Exact& solution, const Axis<4 + Out>& axis, Places<4 + Out> at, LongCall& call, const Evaluate& evaluate) {
    Block<Out> block;
    for (Py_ssize_t done = 0; done < axis.length;) {
        const Py_ssize_t n = std::min(Block<Out>::size, axis.length - done);
        for (Py_ssize_t i = 0; i < n; ++i) block.t[i] = load(at[3] + i * axis.step[3]);
        evaluate(solution, static_cast<std::size_t>(n), block);
        for (std::size_t k = 0; k < Out; ++k)
            for (Py_ssize_t i = 0; i < n; ++i) store(at[4 + k] + i * axis.step[4 + k], block.results[k][i]);
        move(at, axis, n);
        done += n;
        call.worked(n);
    }
}

/// evaluate(solution, n, block) for every element of the broadcast of theta0, omega0, alpha and t. Axes along which only the
/// time changes are innermost, so that each pendulum is prepared once.
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
