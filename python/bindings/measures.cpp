#include "measures.hpp"

#include <memory>

#include "elementwise.hpp"
#include "ensembles.hpp"
#include "pendula/measure.hpp"
#include "pendula/validate.hpp"

namespace pendula::python {

namespace {

/// transient, periods, steps_per_period, method, tolerance.
Strobe strobe_of(const nb::tuple& settings) {
    return {nb::cast<double>(settings[0]), nb::cast<double>(settings[1]), nb::cast<double>(settings[2]),
            static_cast<Method>(nb::cast<int>(settings[3])), nb::cast<double>(settings[4])};
}

/// Raises ValueError for the first argument that is outside its interval, or that cannot be measured so.
void check(const nb::tuple& arguments, const nb::tuple& settings) {
    const Columns all = columns(arguments);
    const Strobe strobe = strobe_of(settings);
    require_members(all);
    // Nothing else has a say in how it can be measured.
    Broadcast<4, 0> arrays({all[2], all[3], all[5], all[6]});
    elementwise(arrays, [&](double alpha, double beta, double drive_amplitude, double drive_frequency) {
        validate({alpha, beta, 0, drive_amplitude, drive_frequency, 0}, strobe);
        return std::array<double, 0>{};
    });
}

double* data(Output& output) { return reinterpret_cast<double*>(output.data()); }

/// theta, omega and turns: (3, periods, size).
nb::object section(const nb::tuple& arguments, const nb::tuple& settings, Py_ssize_t size, int threads) {
    Members members(columns(arguments), size);
    const Strobe strobe = strobe_of(settings);
    const auto periods = static_cast<Py_ssize_t>(strobe.periods);
    Output output({3, periods, size});
    double* const to = data(output);
    const EnsembleRows rows{to, to + periods * size, to + 2 * periods * size};
    run_long(threads, [&](const Control& control) { return pendula::section(members.ensemble, strobe, control, rows); });
    return output.value();
}

nb::object mean_velocity(const nb::tuple& arguments, const nb::tuple& settings, Py_ssize_t size, int threads) {
    Members members(columns(arguments), size);
    const Strobe strobe = strobe_of(settings);
    Output output({size});
    run_long(threads,
             [&](const Control& control) { return pendula::mean_velocity(members.ensemble, strobe, control, data(output)); });
    return output.value();
}

/// exponent, error and horizon (3, size); history (rows, size).
nb::tuple lyapunov(const nb::tuple& arguments, const nb::tuple& settings, Py_ssize_t size, int threads, Py_ssize_t rows) {
    Members members(columns(arguments), size);
    const Strobe strobe = strobe_of(settings);
    Output output({3, size}), history({rows, size});
    double* const to = data(output);
    const LyapunovValues values{to, to + size, to + 2 * size, rows > 0 ? data(history) : nullptr,
                                static_cast<std::size_t>(rows)};
    run_long(threads, [&](const Control& control) { return pendula::lyapunov(members.ensemble, strobe, control, values); });
    return nb::make_tuple(output.value(), history.value());
}

/// period, rotation, theta and omega: (4, size).
nb::object orbits(const nb::tuple& arguments, const nb::tuple& settings, Py_ssize_t size, int threads, double match) {
    require("match", match, Rule::positive);
    Members members(columns(arguments), size);
    const Strobe strobe = strobe_of(settings);
    Output output({4, size});
    double* const to = data(output);
    const OrbitValues values{to, to + size, to + 2 * size, to + 3 * size};
    run_long(threads,
             [&](const Control& control) { return pendula::orbits(members.ensemble, strobe, match, control, values); });
    return output.value();
}

/// Labels of the orbits of one pendulum, given by its six parameters: (size,).
nb::object labels(const nb::tuple& pendulum, const nb::tuple& settings, double match, nb::handle found_orbits) {
    Operand orbit_values(found_orbits);
    const Py_ssize_t size = orbit_values.shape()[1];
    auto* const from = reinterpret_cast<double*>(orbit_values.data());
    const OrbitValues values{from, from + size, from + 2 * size, from + 3 * size};
    std::array<double, 6> p;
    for (std::size_t k = 0; k < p.size(); ++k) p[k] = nb::cast<double>(pendulum[k]);
    const Strobe strobe = strobe_of(settings);
    Output output({size});
    {
        const nb::gil_scoped_release released;
        const auto numbers = std::make_unique<int[]>(static_cast<std::size_t>(size));
        const auto attractors = std::make_unique<Attractor[]>(attractors_limit);
        label_attractors({p[0], p[1], p[2], p[3], p[4], p[5]}, strobe, match, static_cast<std::size_t>(size), values,
                         numbers.get(), attractors.get());
        std::copy_n(numbers.get(), size, data(output));
    }
    return output.value();
}

}  // namespace

void define_measures(nb::module_& module) {
    const auto arguments = nb::arg("arguments");
    const auto settings = nb::arg("settings");
    const auto size = nb::arg("size");
    const auto threads = nb::arg("threads");
    module.def("check_measure", check, arguments, settings);
    module.def("section", section, arguments, settings, size, threads);
    module.def("mean_velocity", mean_velocity, arguments, settings, size, threads);
    module.def("lyapunov", lyapunov, arguments, settings, size, threads, nb::arg("rows"));
    module.def("orbits", orbits, arguments, settings, size, threads, nb::arg("match"));
    module.def("labels", labels, nb::arg("pendulum"), settings, nb::arg("match"), nb::arg("orbits"));
}

}  // namespace pendula::python
