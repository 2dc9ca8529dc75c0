// Benchmarks of the Runge-Kutta method, for one trajectory and for ensembles, with the formulas of the assignment and
// Boost.Odeint as peers.
#include <benchmark/benchmark.h>

#include <array>
#include <boost/numeric/odeint.hpp>
#include <string>
#include <vector>

#include "counted.hpp"
#include "kernels/rk4_kernel.hpp"
#include "pendula/ensemble.hpp"
#include "student.hpp"

namespace {

using namespace pendula;

constexpr int steps = 2000;
constexpr std::size_t members = 256;
constexpr double released = 2;  // [rad]

/// A pendulum and the length of its steps [s].
struct Run {
    const char* name;
    Pendulum pendulum;
    double h;
};

constexpr Pendulum driven{.alpha = 1, .beta = 0.5, .drive_amplitude = 1.15, .drive_frequency = 2.0 / 3};
constexpr Run runs[] = {{"fine", {}, 7.4e-4},  // the step of the assignment: 10,000 steps in a period
                        {"middle", {}, 0.008},
                        {"coarse", {}, 0.07},  // 100 steps in a period
                        {"driven", driven, 0.003},
                        {"driven_coarse", driven, 0.07}};

/// n pendulums in the usual form for Boost.Odeint: first the angles, then the velocities. All have the same drive.
template <std::size_t n>
struct Pendulums {
    using Point = std::array<double, 2 * n>;
    using Stepper = boost::numeric::odeint::runge_kutta4<Point, double, Point, double, boost::numeric::odeint::array_algebra>;

    Pendulum p;

    void operator()(const Point& x, Point& dx, double t) const {
        const double force =
            p.torque + (p.drive_amplitude == 0 ? 0 : p.drive_amplitude * std::cos(p.drive_frequency * t + p.drive_phase));
        for (std::size_t i = 0; i < n; ++i) {
            dx[i] = x[n + i];
            dx[n + i] = force - p.alpha * std::sin(x[i]) - p.beta * x[n + i];
        }
    }
};

double angle(std::size_t member) { return 2.5 * static_cast<double>(member + 1) / members; }

template <std::size_t n>
void odeint(benchmark::State& state, const Run& run) {
    static typename Pendulums<n>::Point x;
    typename Pendulums<n>::Stepper stepper;
    for (auto _ : state) {
        for (std::size_t i = 0; i < n; ++i) x[i] = n == 1 ? released : angle(i), x[n + i] = 0;
        for (int i = 0; i < steps; ++i) stepper.do_step(Pendulums<n>{run.pendulum}, x, i * run.h, run.h);
        benchmark::DoNotOptimize(x);
    }
    state.SetItemsProcessed(state.iterations() * steps * static_cast<std::int64_t>(n));
}

void formulas(benchmark::State& state, const Run& run) {
    double alpha = run.pendulum.alpha;
    for (auto _ : state) {
        double theta = released, omega = 0;
        benchmark::DoNotOptimize(alpha);
        for (int i = 0; i < steps; ++i) estudiante::RungeKutta(alpha, theta, omega, run.h);
        benchmark::DoNotOptimize(theta);
    }
    state.SetItemsProcessed(state.iterations() * steps);
}

/// The multiplications and additions that a step needs: those of a block divided by its number of steps.
void count_operations(benchmark::State& state, const Run& run) {
    using bench::Counted;
    const auto k = kernels::rk4_constants(bench::counted_parameters(run.pendulum), Counted(run.h));
    kernels::Motion<Counted> x{released, 0, 0, 0, 0};
    kernels::Tangent<Counted> none{};
    Counted::trace.clear();
    kernels::rk4_block<false>(k, {0, 0}, x, none, kernels::block_steps);
    const auto done = bench::operations_behind({x.theta, x.omega, x.theta_lo, x.omega_lo});
    state.counters["multiplications"] = done.multiplications / kernels::block_steps;
    state.counters["additions"] = done.additions / kernels::block_steps;
}

void one(benchmark::State& state, const Run& run) {
    const double span = steps * run.h;
    const Problem problem{
        .pendulum = run.pendulum, .initial = {released, 0}, .schedule = {.every = span, .rows = 2, .steps_per_row = steps}};
    Sample rows[2];
    for (auto _ : state) {
        auto trajectory = begin(problem);
        if (advance(trajectory, rows, steps) != 2) state.SkipWithError("rows are missing");
        benchmark::DoNotOptimize(rows);
    }
    state.SetItemsProcessed(state.iterations() * steps);
    count_operations(state, run);
}

void ensemble(benchmark::State& state, const Run& run, std::size_t n, int threads) {
    std::vector<double> theta(n), end(n), speed(n), turns(n);
    for (std::size_t i = 0; i < n; ++i) theta[i] = angle(i % members);
    const Ensemble e = bench::ensemble_of(run.pendulum, theta);
    const EnsembleTimes times{.first = steps * run.h, .rows = 1, .steps_to_first = steps};
    for (auto _ : state) {
        const auto outcome = solve(e, Method::rk4, 1e-15, times, {end, speed, turns}, {.threads = threads});
        if (!outcome.is_done()) state.SkipWithError("not solved");
        benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(state.iterations() * steps * static_cast<std::int64_t>(n));
    count_operations(state, run);
}

template <class... Arguments>
auto* add(const std::string& name, Arguments... arguments) {
    return benchmark::RegisterBenchmark(name.c_str(), arguments...);
}

[[maybe_unused]] const bool is_registered = [] {
    for (const Run& run : runs) {
        const std::string trajectory = std::string("rk4_") + run.name, many = std::string("rk4_ensemble_") + run.name;
        add(trajectory + "/pendula", one, run);
        if (is_conservative(run.pendulum)) add(trajectory + "/formulas", formulas, run);
        add(trajectory + "/odeint", odeint<1>, run);
        add(many + "/pendula", ensemble, run, members, 1);
        add(many + "/odeint", odeint<members>, run);
    }
    add("threads/pendula", ensemble, runs[0], 32 * members, 2)->UseRealTime();
    add("threads/one", ensemble, runs[0], 32 * members, 1)->UseRealTime();
    return true;
}();

}  // namespace
