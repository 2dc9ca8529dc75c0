// Benchmarks of the characteristic time and of exact samples, with the series of the assignment, Boost and GSL as peers.
#include <benchmark/benchmark.h>
#include <gsl/gsl_sf_elljac.h>

#include <boost/math/special_functions/jacobi_elliptic.hpp>

#include "closed_form_errors.hpp"
#include "pendula/exact.hpp"
#include "student.hpp"

namespace {

using namespace pendula;

constexpr double figure_3_2 = 1.999999895801368;  // [rad/s], from the bottom: 1e-7 less than needed to turn over

void tau_pendula(benchmark::State& state) {
    double omega = figure_3_2;
    for (auto _ : state) {
        benchmark::DoNotOptimize(omega);
        benchmark::DoNotOptimize(analyze(1, {0, omega}));
    }
    state.SetItemsProcessed(state.iterations());
}
BENCHMARK(tau_pendula)->Name("tau/pendula");

void tau_series(benchmark::State& state) {
    double omega = figure_3_2, theta_max = 0, tau = 0;
    int k = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(omega);
        estudiante::analisis(1, 0, omega, 1e-7, theta_max, tau, k);
        benchmark::DoNotOptimize(tau);
    }
    state.SetItemsProcessed(state.iterations());
}
BENCHMARK(tau_series)->Name("tau/series")->Iterations(1);

/// An oscillation from the bottom: sin(theta/2) = k sn(u), cos(theta/2) = dn(u), omega = 2 k sqrt(alpha) cn(u), u = sqrt(alpha)
/// t.
struct Orbit {
    double root;  ///< sqrt(alpha)
    double k;

    Orbit(double alpha, double omega) : root(std::sqrt(alpha)), k(std::fabs(omega) / (2 * root)) {}
    State state(double sn, double cn, double dn) const { return {2 * std::atan2(k * sn, dn), 2 * k * root * cn}; }
};

State by_boost(const Orbit& orbit, double t) {
    using namespace boost::math::policies;
    double cn, dn;  // without promotion to long double, which is several times slower
    const double sn = boost::math::jacobi_elliptic(orbit.k, orbit.root * t, &cn, &dn, policy<promote_double<false>>());
    return orbit.state(sn, cn, dn);
}

State by_gsl(const Orbit& orbit, double t) {
    double sn, cn, dn;
    gsl_sf_elljac_e(orbit.root * t, orbit.k * orbit.k, &sn, &cn, &dn);
    return orbit.state(sn, cn, dn);
}

constexpr std::size_t count = 1000;

std::vector<double> times(double omega) {
    std::vector<double> t(count);
    const double tau = analyze(1, {0, omega}).tau;
    for (std::size_t i = 0; i < count; ++i) t[i] = tau * static_cast<double>(i) / count;
    return t;
}

/// The largest error over the reference solutions of oscillations from the bottom with |kappa'| from 1e-12 to 1e-2: of theta
/// [rad], or relative to theta_max if that is less than 1, and of omega relative to its maximum.
template <class Evaluate>
double error_near_separatrix(Evaluate evaluate) {
    reference::Largest largest;
    for (const auto& c : reference::closed_form()) {
        if (c.group != "near" || c.k != -1 || c.initial.theta != 0) continue;
        for (const auto& at : c.instants) {
            if (reference::is_late(c, at)) continue;
            const State s = evaluate(c, at.t);
            const double sense = c.initial.omega < 0 ? -1 : 1;
            largest(reference::angle_error(sense * s.theta, 0, at.theta, at.turns) / c.scale());
            largest(reference::error(sense * s.omega, at.omega) / c.largest_omega());
        }
    }
    return largest.value;
}

void samples_pendula(benchmark::State& state, double omega) {
    const auto t = times(omega);
    std::vector<double> theta(count), speed(count), turns(count);
    const auto orbit = make_exact(1, {0, omega});
    for (auto _ : state) {
        at(orbit, count, t.data(), theta.data(), speed.data(), turns.data());
        benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(state.iterations() * count);
    state.counters["error"] = error_near_separatrix([](const reference::Case& c, double time) {
        const auto s = at(make_exact(c.alpha, {0, std::fabs(c.initial.omega)}), time);
        return State{s.theta, s.omega};
    });
}

template <State (*by)(const Orbit&, double)>
void samples_peer(benchmark::State& state, double omega) {
    const auto t = times(omega);
    std::vector<double> theta(count), speed(count);
    const Orbit orbit(1, omega);
    for (auto _ : state) {
        for (std::size_t i = 0; i < count; ++i) {
            const State s = by(orbit, t[i]);
            theta[i] = s.theta;
            speed[i] = s.omega;
        }
        benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(state.iterations() * count);
    state.counters["error"] =
        error_near_separatrix([](const reference::Case& c, double time) { return by({c.alpha, c.initial.omega}, time); });
}

[[maybe_unused]] const bool is_registered = [] {
    for (const auto& [name, omega] : {std::pair{"samples", 1.0}, std::pair{"samples_near", figure_3_2}}) {
        const auto add = [omega](const std::string& title, auto* run) {
            benchmark::RegisterBenchmark(title.c_str(), run, omega);
        };
        add(std::string(name) + "/pendula", samples_pendula);
        add(std::string(name) + "/boost", samples_peer<by_boost>);
        add(std::string(name) + "/gsl", samples_peer<by_gsl>);
    }
    return true;
}();

}  // namespace
