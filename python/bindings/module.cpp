// The functions of the core as Python sees them: arguments converted, checked, and broadcast.
#include <tuple>

#include "checks.hpp"
#include "elementwise.hpp"
#include "measures.hpp"
#include "over_times.hpp"
#include "pendula/angle.hpp"
#include "trajectories.hpp"

namespace pendula::python {

namespace {

template <std::size_t Out>
nb::tuple as_tuple(const std::array<nb::object, Out>& values) {
    return std::apply([](const auto&... each) { return nb::make_tuple(each...); }, values);
}

template <class Arrays>
void require_pendulums(Arrays& arrays) {
    require_all("theta0", arrays.inputs[0], Rule::finite);
    require_all("omega0", arrays.inputs[1], Rule::finite);
    require_all("alpha", arrays.inputs[2], Rule::positive);
}

template <class Arrays>
void require_closed_form(Arrays& arrays) {
    require_pendulums(arrays);
    require_all("t", arrays.inputs[3], Rule::finite);
}

nb::tuple analyze(nb::handle theta0, nb::handle omega0, nb::handle alpha) {
    Broadcast<3, 3> arrays({theta0, omega0, alpha});
    require_pendulums(arrays);
    return as_tuple(elementwise(arrays, [](double theta, double omega, double stiffness) {
        const Analysis a = pendula::analyze(stiffness, {theta, omega});
        return std::array{static_cast<double>(a.regime), a.theta_max, a.tau};
    }));
}

nb::tuple exact(nb::handle theta0, nb::handle omega0, nb::handle alpha, nb::handle t) {
    Broadcast<4, 2> arrays({theta0, omega0, alpha, t});
    require_closed_form(arrays);
    return as_tuple(over_times<2>(arrays, [](const Exact& solution, std::size_t n, const double* times, const Results<2>& to) {
        double turns[block];
        at(solution, n, times, to[0], to[1], turns);
        for (std::size_t i = 0; i < n; ++i)
            if (turns[i] != 0) to[0][i] = unwrapped({times[i], to[0][i], 0, turns[i]});
    }));
}

/// theta in [-pi, pi), omega and turns.
nb::tuple states(nb::handle theta0, nb::handle omega0, nb::handle alpha, nb::handle t) {
    Broadcast<4, 3> arrays({theta0, omega0, alpha, t});
    require_closed_form(arrays);
    return as_tuple(over_times<3>(arrays, [](const Exact& solution, std::size_t n, const double* times, const Results<3>& to) {
        at(solution, n, times, to[0], to[1], to[2]);
    }));
}

nb::object sine(nb::handle theta0, nb::handle omega0, nb::handle alpha, nb::handle t) {
    Broadcast<4, 1> arrays({theta0, omega0, alpha, t});
    require_closed_form(arrays);
    return over_times<1>(arrays, [](const Exact& solution, std::size_t n, const double* times, const Results<1>& to) {
        for (std::size_t i = 0; i < n; ++i) to[0][i] = sinusoid(solution, times[i]);
    })[0];
}

nb::object energy(nb::handle theta, nb::handle omega, nb::handle alpha) {
    Broadcast<3, 1> arrays({theta, omega, alpha});
    return elementwise(arrays, [](double angle, double speed, double stiffness) {
        return std::array{pendula::energy(stiffness, {angle, speed})};
    })[0];
}

nb::object wrap(nb::handle theta) {
    Broadcast<1, 1> arrays({theta});
    return elementwise(arrays, [](double angle) { return std::array{pendula::wrap(angle)}; })[0];
}

nb::object unwrap(nb::handle theta, nb::handle turns) {
    Broadcast<2, 1> arrays({theta, turns});
    return elementwise(arrays, [](double angle, double whole) { return std::array{unwrapped({0, angle, 0, whole})}; })[0];
}

}  // namespace

}  // namespace pendula::python

NB_MODULE(_core, module) {
    using namespace pendula::python;
    module.attr("version") = PENDULA_VERSION;
    module.def("analyze", analyze, nb::arg("theta0"), nb::arg("omega0"), nb::arg("alpha"));
    module.def("exact", exact, nb::arg("theta0"), nb::arg("omega0"), nb::arg("alpha"), nb::arg("t"));
    module.def("states", states, nb::arg("theta0"), nb::arg("omega0"), nb::arg("alpha"), nb::arg("t"));
    module.def("sine", sine, nb::arg("theta0"), nb::arg("omega0"), nb::arg("alpha"), nb::arg("t"));
    module.def("energy", energy, nb::arg("theta"), nb::arg("omega"), nb::arg("alpha"));
    module.def("wrap", wrap, nb::arg("theta"));
    module.def("unwrap", unwrap, nb::arg("theta"), nb::arg("turns"));
    define_trajectories(module);
    define_measures(module);
}
