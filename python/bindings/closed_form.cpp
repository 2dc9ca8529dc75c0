// The pendulum without friction and forcing over arrays of pendulums and of times, and functions of single states.
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "broadcast.hpp"
#include "pendula/angle.hpp"
#include "pendula/exact.hpp"

namespace pendula::python {

namespace {

constexpr Py_ssize_t block = 512;  // times computed together: what they touch stays in the first cache

/// Where results go, one behind the other.
template <std::size_t Out>
using Results = std::array<double*, Out>;

const Parameter& theta0_info = parameters[0];
const Parameter& omega0_info = parameters[1];
const Parameter& alpha_info = parameters[2];

/// Raises ValueError for the first value outside the interval of its parameter.
void require_pendulums(const Reals& theta0, const Reals& omega0, const Reals& alpha) {
    require_all(theta0_info.name, theta0, theta0_info.rule);
    require_all(omega0_info.name, omega0, omega0_info.rule);
    require_all(alpha_info.name, alpha, alpha_info.rule);
}

/// `at`, which for many times at once has the same bits but takes as long for one as for eight.
void states_at(const Exact& solution, std::size_t n, const double* t, double* theta, double* omega, double* turns) {
    constexpr std::size_t few = 4;
    if (n > few) return at(solution, n, t, theta, omega, turns);
    for (std::size_t i = 0; i < n; ++i) {
        const Sample sample = at(solution, t[i]);
        theta[i] = sample.theta;
        omega[i] = sample.omega;
        turns[i] = sample.turns;
    }
}

bool is_contiguous(const char* at, Py_ssize_t step) {
    return step == sizeof(double) && reinterpret_cast<std::uintptr_t>(at) % alignof(double) == 0;
}

/// One pendulum along one axis of times, whose place is the fourth. What is not contiguous goes through buffers.
template <std::size_t Out, class Evaluate>
Outcome along_times(const Exact& solution, const Axis<4 + Out>& axis, Places<4 + Out> at, Paced& paced,
                    const Evaluate& evaluate) {
    double buffers[1 + Out][block];
    for (Py_ssize_t done = 0; done < axis.length; done += block, move(at, axis, block)) {
        const Py_ssize_t n = std::min(block, axis.length - done);
        const bool is_direct = is_contiguous(at[3], axis.step[3]);
        if (!is_direct)
            for (Py_ssize_t i = 0; i < n; ++i) buffers[Out][i] = load(at[3] + i * axis.step[3]);
        const double* const t = is_direct ? reinterpret_cast<const double*>(at[3]) : buffers[Out];

        const double most = latest_time(solution);
        const auto is_late = [=](double time) { return !(std::abs(time) <= most); };
        bool has_late = false;
        for (Py_ssize_t i = 0; i < n; ++i) has_late |= is_late(t[i]);
        if (has_late) {
            const double value = *std::find_if(t, t + n, is_late);
            return Refusal{.reason = Refusal::Reason::too_late, .name = "t", .value = value, .most = most};
        }

        Results<Out> results;
        for (std::size_t k = 0; k < Out; ++k)
            results[k] = axis.step[4 + k] == sizeof(double) ? reinterpret_cast<double*>(at[4 + k]) : buffers[k];
        evaluate(solution, static_cast<std::size_t>(n), t, results);
        for (std::size_t k = 0; k < Out; ++k)
            if (results[k] == buffers[k])
                for (Py_ssize_t i = 0; i < n; ++i) store(at[4 + k] + i * axis.step[4 + k], buffers[k][i]);
        if (!paced.after(static_cast<std::size_t>(n))) return Outcome::Kind::stopped;
    }
    return Outcome::Kind::done;
}

/// evaluate(solution, n, t, results) for every element of the broadcast of theta0, omega0, alpha and t. Axes along which only
/// the time changes are innermost, so that each pendulum is prepared once.
template <std::size_t Out, class Evaluate>
std::array<nb::object, Out> over_times(const Reals& theta0, const Reals& omega0, const Reals& alpha, const Reals& t,
                                       const Evaluate& evaluate) {
    constexpr std::size_t count = 4 + Out;
    Broadcast<4, Out> arrays(
        {&theta0.named(theta0_info.name), &omega0.named(omega0_info.name), &alpha.named(alpha_info.name), &t.named("t")});
    require_pendulums(theta0, omega0, alpha);
    require_all("t", t, Rule::finite);
    auto axes = arrays.axes();
    const auto first_time_axis = std::stable_partition(axes.begin(), axes.end(), [](const Axis<count>& axis) {
        return axis.step[0] != 0 || axis.step[1] != 0 || axis.step[2] != 0;
    });
    const bool has_times = first_time_axis != axes.end();
    const Axis<count> last = has_times ? axes.back() : Axis<count>{};
    const std::span<const Axis<count>> pendulums(axes.begin(), first_time_axis);
    const std::span<const Axis<count>> times(first_time_axis, axes.end() - has_times);
    const Refusal refusal = run_long(size_of(arrays.shape), [&](const Proceed& proceed) {
        Paced paced(proceed);
        Outcome outcome;
        walk<count>(pendulums, arrays.start(), [&](const Places<count>& pendulum) {
            const Exact solution = make_exact(load(pendulum[2]), {load(pendulum[0]), load(pendulum[1])});
            return walk<count>(times, pendulum, [&](const Places<count>& at) {
                outcome = along_times<Out>(solution, last, at, paced, evaluate);
                return outcome.is_done();
            });
        });
        return outcome;
    });
    require(refusal);
    return arrays.results();
}

/// regime, theta_max, tau.
std::tuple<Regimes, Array, Array> analyze(const Reals& theta0, const Reals& omega0, const Reals& alpha) {
    Broadcast<3, 3> arrays({&theta0.named(theta0_info.name), &omega0.named(omega0_info.name), &alpha.named(alpha_info.name)});
    require_pendulums(theta0, omega0, alpha);
    auto [regime, theta_max, tau] = elementwise(arrays, [](double theta, double omega, double stiffness) {
        const Analysis a = pendula::analyze(stiffness, {theta, omega});
        return std::array{static_cast<double>(a.regime), a.theta_max, a.tau};
    });
    if (!arrays.shape.empty()) return {Regimes{as_int8(regime)}, Array{theta_max}, Array{tau}};
    const auto kind = static_cast<Regime>(static_cast<int>(nb::cast<double>(regime)));
    return {Regimes{nb::cast(kind)}, Array{theta_max}, Array{tau}};
}

std::tuple<Array, Array> exact(const Reals& theta0, const Reals& omega0, const Reals& t, const Reals& alpha) {
    auto [theta, omega] = over_times<2>(theta0, omega0, alpha, t,
                                        [](const Exact& solution, std::size_t n, const double* times, const Results<2>& to) {
                                            double turns[block];
                                            states_at(solution, n, times, to[0], to[1], turns);
                                            for (std::size_t i = 0; i < n; ++i)
                                                if (turns[i] != 0) to[0][i] = unwrapped({times[i], to[0][i], 0, turns[i]});
                                        });
    return {Array{theta}, Array{omega}};
}

Array sine(const Reals& theta0, const Reals& omega0, const Reals& alpha, const Reals& t) {
    return {over_times<1>(theta0, omega0, alpha, t,
                          [](const Exact& solution, std::size_t n, const double* times, const Results<1>& to) {
                              for (std::size_t i = 0; i < n; ++i) to[0][i] = sinusoid(solution, times[i]);
                          })[0]};
}

Array energy(const Reals& theta, const Reals& omega, const Reals& alpha) {
    Broadcast<3, 1> arrays({&theta.named("theta"), &omega.named("omega"), &alpha.named(alpha_info.name)});
    return {elementwise(arrays, [](double angle, double speed, double stiffness) {
        return std::array{pendula::energy(stiffness, {angle, speed})};
    })[0]};
}

/// The amplitude of oscillations by their period.
Array amplitude(const Reals& tau, const Reals& alpha) {
    Broadcast<2, 1> arrays({&tau.named("tau"), &alpha.named(alpha_info.name)});
    require_all("tau", tau, Rule::positive);
    require_all(alpha_info.name, alpha, alpha_info.rule);
    const auto found =
        elementwise(arrays, [](double period, double stiffness) { return std::array{amplitude_of_period(stiffness, period)}; });
    const auto values = arrays.outputs[0].values();
    const auto none = std::find_if(values.begin(), values.end(), [](double value) { return std::isnan(value); });
    if (none == values.end()) return {found[0]};
    const auto member = static_cast<std::size_t>(none - values.begin());
    std::vector<double> copy;
    const std::string period = nb::repr(nb::float_(column_of(tau, arrays.shape, copy)[member])).c_str();
    throw std::invalid_argument(at_place("tau must be at least 2 pi/sqrt(alpha), the period of small swings, got " + period,
                                         &tau, arrays.shape, member));
}

/// alpha = g/l, for alpha where it is not given itself.
Array stiffness(const Reals& gravity, const Reals& length) {
    Broadcast<2, 1> arrays({&gravity.named("gravity"), &length.named("length")});
    require_all("gravity", gravity, Rule::positive);
    require_all("length", length, Rule::positive);
    return {elementwise(arrays, [](double g, double l) { return std::array{g / l}; })[0]};
}

Array radians(const Reals& degrees) {
    Broadcast<1, 1> arrays({&degrees.named("degrees")});
    return {elementwise(arrays, [](double angle) { return std::array{to_radians(angle)}; })[0]};
}

Array wrap(const Reals& theta) {
    Broadcast<1, 1> arrays({&theta.named("theta")});
    return {elementwise(arrays, [](double angle) { return std::array{pendula::wrap(angle)}; })[0]};
}

Array unwrap(const Reals& theta, const Reals& turns) {
    Broadcast<2, 1> arrays({&theta.named("theta"), &turns.named("turns")});
    return {elementwise(arrays, [](double angle, double whole) { return std::array{unwrapped({0, angle, 0, whole})}; })[0]};
}

}  // namespace

std::tuple<Array, Array, Array> states(const Reals& theta0, const Reals& omega0, const Reals& alpha, const Reals& t) {
    auto [theta, omega, turns] = over_times<3>(
        theta0, omega0, alpha, t, [](const Exact& solution, std::size_t n, const double* times, const Results<3>& to) {
            states_at(solution, n, times, to[0], to[1], to[2]);
        });
    return {Array{theta}, Array{omega}, Array{turns}};
}

void define_closed_form(nb::module_& module) {
    const auto theta0 = nb::arg("theta0"), omega0 = nb::arg("omega0"), alpha = nb::arg("alpha"), t = nb::arg("t");
    const auto stiff = nb::arg("alpha") = alpha_info.otherwise;
    nb::enum_<Regime>(module, "Regime", nb::is_arithmetic(), "The kinds of motion; the values are the assignment's k.")
        .value("oscillation", Regime::oscillation)
        .value("separatrix", Regime::separatrix)
        .value("rotation", Regime::rotation);
    module.def("analyze", analyze, theta0, omega0, stiff, "regime, theta_max and tau");
    module.def("exact", exact, theta0, omega0, t, stiff, "theta, not wrapped, and omega");
    module.def("states", states, theta0, omega0, alpha, t, "theta in [-π, π), omega and turns");
    module.def("sine", sine, theta0, omega0, alpha, t, "the sinusoid (3.4), in [-π, π)");
    module.def("energy", energy, nb::arg("theta"), nb::arg("omega"), alpha);
    module.def("amplitude", amplitude, nb::arg("tau"), stiff, "the inverse of analyze for oscillations");
    module.def("stiffness", stiffness, nb::arg("gravity"), nb::arg("length"), "gravity/length");
    module.def("to_radians", radians, nb::arg("degrees"));
    module.def("wrap", wrap, nb::arg("theta"));
    module.def("unwrap", unwrap, nb::arg("theta"), nb::arg("turns"));
}

}  // namespace pendula::python
