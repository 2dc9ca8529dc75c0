// Broadcasting: which elements of the arguments and of the results belong together.
#pragma once

#include <array>
#include <span>
#include <tuple>
#include <utility>

#include "calls.hpp"
#include "numpy.hpp"

namespace pendula::python {

/// One axis of K arrays: its length, and the bytes from one element of each to the next.
template <std::size_t K>
struct Axis {
    Py_ssize_t length = 1;
    std::array<Py_ssize_t, K> step{};
};

/// One element of each of K arrays.
template <std::size_t K>
using Places = std::array<char*, K>;

template <std::size_t K>
void move(Places<K>& at, const Axis<K>& axis, Py_ssize_t n = 1) {
    for (std::size_t k = 0; k < K; ++k) at[k] += n * axis.step[k];
}

/// Calls visit(places) for every index of the axes, the last one fastest, as long as it returns true.
template <std::size_t K, class Visit>
bool walk(std::span<const Axis<K>> axes, Places<K> at, const Visit& visit) {
    if (axes.empty()) return visit(at);
    for (Py_ssize_t i = 0; i < axes[0].length; ++i, move(at, axes[0]))
        if (!walk(axes.subspan(1), at, visit)) return false;
    return true;
}

/// Arrays need not be aligned.
inline double load(const char* at) {
    double value;
    __builtin_memcpy(&value, at, sizeof value);
    return value;
}

inline void store(char* at, double value) { __builtin_memcpy(at, &value, sizeof value); }

/// Arguments and the results that their common shape gives: places are of the arguments first.
template <std::size_t In, std::size_t Out>
struct Broadcast {
    static constexpr std::size_t count = In + Out;

    std::array<const Reals*, In> inputs;
    Shape shape;
    std::array<Output, Out> outputs;

    explicit Broadcast(const std::array<const Reals*, In>& arguments) : Broadcast(arguments, std::make_index_sequence<Out>()) {}

    Places<count> start() {
        Places<count> places;
        for (std::size_t k = 0; k < In; ++k) places[k] = const_cast<char*>(inputs[k]->data());  // never written to
        for (std::size_t k = 0; k < Out; ++k) places[In + k] = outputs[k].data();
        return places;
    }

    /// Without axes of length 1, and with those made one that all arrays step through as one.
    std::vector<Axis<count>> axes() const {
        const int ndim = static_cast<int>(shape.size());
        std::vector<Axis<count>> found;  // the last axis first
        Py_ssize_t output_step = sizeof(double);
        for (int d = ndim; d-- > 0;) {
            Axis<count> axis{shape[static_cast<std::size_t>(d)], {}};
            if (axis.length == 1) continue;
            for (std::size_t k = 0; k < count; ++k) axis.step[k] = k < In ? inputs[k]->step(d, ndim) : output_step;
            output_step *= axis.length;
            if (!found.empty() && continues(found.back(), axis))
                found.back().length *= axis.length;
            else
                found.push_back(axis);
        }
        return {found.rbegin(), found.rend()};
    }

    std::array<nb::object, Out> results() const {
        std::array<nb::object, Out> values;
        for (std::size_t k = 0; k < Out; ++k) values[k] = outputs[k].value();
        return values;
    }

  private:
    template <std::size_t... O>
    Broadcast(const std::array<const Reals*, In>& arguments, std::index_sequence<O...>)
        : inputs(arguments), shape(broadcast(arguments)), outputs{Output((void(O), shape))...} {}

    static bool continues(const Axis<count>& inner, const Axis<count>& outer) {
        for (std::size_t k = 0; k < count; ++k)
            if (outer.step[k] != inner.length * inner.step[k]) return false;
        return true;
    }
};

/// compute(In doubles) -> array of Out doubles, for every element of the broadcast.
template <std::size_t In, std::size_t Out, class Compute>
std::array<nb::object, Out> elementwise(Broadcast<In, Out>& arrays, const Compute& compute) {
    const auto axes = arrays.axes();
    run_long(size_of(arrays.shape), [&](const Proceed& proceed) -> Outcome {
        Paced paced(proceed);
        const bool is_done = walk<In + Out>(axes, arrays.start(), [&](const Places<In + Out>& at) {
            std::array<double, In> arguments;
            for (std::size_t k = 0; k < In; ++k) arguments[k] = load(at[k]);
            const std::array<double, Out> results = std::apply(compute, arguments);
            for (std::size_t k = 0; k < Out; ++k) store(at[In + k], results[k]);
            return paced.after(1);
        });
        return is_done ? Outcome::Kind::done : Outcome::Kind::stopped;
    });
    return arrays.results();
}

}  // namespace pendula::python
