// Programs of students, replayed: arrays of numbers in, rows of states out.
#include "pendula/replay.hpp"

#include <nanobind/ndarray.h>

#include <new>
#include <stdexcept>

#include "calls.hpp"

namespace pendula::python {

namespace {

/// An array in C order.
template <class T, std::size_t axes>
using Values = nb::ndarray<const T, nb::ndim<axes>, nb::c_contig, nb::device::cpu>;

template <class Of>
Shape shape_of(const Of& values) {
    Shape shape;
    for (std::size_t d = 0; d < values.ndim(); ++d) shape.push_back(static_cast<Py_ssize_t>(values.shape(d)));
    return shape;
}

template <class Of>
void require_shape(const char* name, const Of& values, const Shape& wanted) {
    if (const Shape shape = shape_of(values); shape != wanted)
        throw std::invalid_argument(std::string(name) + " must have shape " + text(wanted) + ", got " + text(shape));
}

/// The i-th of equal parts along the first axis.
template <class Of>
auto part(const Of& values, std::size_t i) {
    const std::size_t size = values.size() / values.shape(0);
    return std::span(values.data() + i * size, size);
}

std::tuple<Array, Array> replay(const Values<double, 2>& start, const Values<double, 2>& terms,
                                const Values<std::int32_t, 1>& force, const Values<double, 1>& scale,
                                const Values<double, 1>& dt, const Values<double, 3>& stages, const Values<double, 3>& sums,
                                const Values<std::int64_t, 2>& steps, const Values<bool, 1>& single, int threads) {
    const auto n = static_cast<Py_ssize_t>(start.shape(0)), s = static_cast<Py_ssize_t>(stages.shape(1)),
               rows = static_cast<Py_ssize_t>(steps.shape(1));
    require_shape("start", start, {n, 2});
    require_shape("terms", terms, {n, 6});
    require_shape("force", force, {n});
    require_shape("scale", scale, {n});
    require_shape("dt", dt, {n});
    require_shape("stages", stages, {n, s, 3 + 4 * s});
    require_shape("sums", sums, {n, 2, 2 * s});
    require_shape("steps", steps, {n, rows});
    require_shape("single", single, {n});
    std::vector<Program> programs;
    programs.reserve(start.shape(0));
    double evaluations = 0;
    for (std::size_t i = 0; i < start.shape(0); ++i) {
        const double* const term = part(terms, i).data();
        programs.push_back({.initial = {start.data()[2 * i], start.data()[2 * i + 1]},
                            .pendulum = {.alpha = term[0],
                                         .beta = term[1],
                                         .torque = term[2],
                                         .drive_amplitude = term[3],
                                         .drive_frequency = term[4],
                                         .drive_phase = term[5]},
                            .force = static_cast<Force>(force.data()[i]),
                            .scale = scale.data()[i],
                            .dt = dt.data()[i],
                            .stages = stages.shape(1),
                            .coefficients = part(stages, i),
                            .sums = part(sums, i),
                            .steps = part(steps, i),
                            .is_single = single.data()[i]});
        if (rows > 0) evaluations += static_cast<double>(s) * static_cast<double>(programs.back().steps.back());
    }
    Output theta({n, rows}), omega({n, rows});
    const ReplayRows to{theta.values(), omega.values()};
    const Refusal refusal = run_long(evaluations < 1e4 ? 0 : many,
                                     [&](const Proceed& proceed) { return pendula::replay(programs, to, {threads, proceed}); });
    if (refusal.reason == Refusal::Reason::memory) throw std::bad_alloc();
    require(refusal);
    return {Array{theta.value()}, Array{omega.value()}};
}

}  // namespace

void define_replay(nb::module_& module) {
    nb::enum_<Force>(module, "Force", nb::is_arithmetic(), "What a program has in the place of the sine.")
        .value("sine", Force::sine)
        .value("cosine", Force::cosine)
        .value("linear", Force::linear)
        .value("cubic", Force::cubic)
        .value("quintic", Force::quintic);
    module.def(
        "replay", replay, nb::arg("start"), nb::arg("terms"), nb::arg("force").noconvert(), nb::arg("scale"), nb::arg("dt"),
        nb::arg("stages"), nb::arg("sums"), nb::arg("steps").noconvert(), nb::arg("single").noconvert(), nb::arg("threads") = 0,
        "Rows of programs that make steps by numbers (pendula/replay.hpp): theta, not wrapped, and omega, [program, row].");
}

}  // namespace pendula::python
