// Benchmarks of Taylor's method for one trajectory and for ensembles: at a tolerance of 1e-15, with the peer heyoka in
// peers_taylor.py, and at looser ones. An item is a unit of time of one trajectory.
#include <benchmark/benchmark.h>

#include <bit>
#include <cstdlib>
#include <string>
#include <vector>

#include "counted.hpp"
#include "kernels/taylor_kernel.hpp"
#include "pendula/ensemble.hpp"
#include "reference_table.hpp"

namespace {

using namespace pendula;

constexpr double span = 100, tightest = 1e-15, released = 1.5;
constexpr std::size_t members = 256;

struct Run {
    const char* name;
    Pendulum pendulum;
};

constexpr Run runs[] = {{"undamped", {}},
                        {"driven", {.alpha = 1, .beta = 0.5, .drive_amplitude = 1.15, .drive_frequency = 2.0 / 3}}};

/// The multiplications and additions that a unit of time needs: those of a step divided by its length.
void count_operations(benchmark::State& state, const Run& run, double tolerance) {
    using bench::Counted;
    const auto d = kernels::taylor_pendulum(std::bit_cast<kernels::Parameters<double>>(run.pendulum));
    const kernels::TaylorPendulum<Counted> k{
        bench::counted_parameters(run.pendulum), {d.turn_rate.hi, d.turn_rate.lo}, {d.turn_start.hi, d.turn_start.lo}, d.rate};
    const auto control = kernels::step_control(tolerance);
    kernels::TaylorStep<Counted> step{};
    kernels::Series<Counted> cosine{};
    step.start.theta = released;
    step.start.omega = 0.3;
    step.t = 7.7;
    Counted::trace.clear();
    kernels::with_order(control.order, [&](auto order) {
        kernels::expand<order.value>(k, step, cosine);
        kernels::set_length<order.value>(step, kernels::log2_length_of<order.value, Counted>(step, control.log2_fraction));
        kernels::move_to_end<order.value>(step);
    });
    const auto done = bench::operations_behind({step.start.theta, step.start.omega, step.start.theta_lo, step.start.omega_lo});
    // The length of a step is the mean over a whole run.
    auto trajectory = make_taylor(run.pendulum, {released, 0}, tolerance);
    double steps = 0;
    for (; !reaches(trajectory, span); ++steps) pendula::step(trajectory);
    state.counters["multiplications"] = done.multiplications * steps / span;
    state.counters["additions"] = done.additions * steps / span;
}

/// The largest error over the driven pendulums of the reference table, up to t = 50.
double largest_error(double tolerance) {
    reference::Largest largest;
    Taylor run;
    for (const auto& r : reference::table("driven.txt")) {
        if (r.words[0] == "problem") {
            run = make_taylor({r[0], r[1], r[2], r[3], 0, r[4], r[5]}, {r[6], r[7]}, tolerance);
            continue;
        }
        while (!reaches(run, r[0])) step(run);
        const auto s = at(run, r[0]);
        largest(reference::angle_error(s.theta, s.turns, r.value(1), 0));
        largest(reference::error(s.omega, r.value(3)));
    }
    return largest.value;
}

void one(benchmark::State& state, const Run& run, double tolerance) {
    for (auto _ : state) {
        auto trajectory = make_taylor(run.pendulum, {released, 0}, tolerance);
        while (!reaches(trajectory, span)) step(trajectory);
        benchmark::DoNotOptimize(at(trajectory, span));
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(span));
    state.counters["error"] = largest_error(tolerance);
}

void ensemble(benchmark::State& state, const Run& run, double tolerance) {
    std::vector<double> theta(members), end(members), speed(members), turns(members);
    for (std::size_t i = 0; i < members; ++i) theta[i] = released + static_cast<double>(i) / members;
    const Ensemble e = bench::ensemble_of(run.pendulum, theta);
    const EnsembleTimes times{.first = span, .rows = 1};
    for (auto _ : state) {
        const auto outcome = solve(e, Method::taylor, tolerance, times, {end, speed, turns}, {.threads = 1});
        if (!outcome.is_done()) state.SkipWithError("not solved");
        benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(span) * static_cast<std::int64_t>(members));
    count_operations(state, run, tolerance);
    state.counters["error"] = largest_error(tolerance);
}

[[maybe_unused]] const bool is_registered = [] {
    const auto add = [](const std::string& name, auto* benchmark, const Run& run, double tolerance) {
        benchmark::RegisterBenchmark((name + run.name + "/pendula").c_str(), benchmark, run, tolerance);
    };
    for (const Run& run : runs) {
        add("taylor_", one, run, tightest);
        add("taylor_ensemble_", ensemble, run, tightest);
        for (const char* tolerance : {"1e-15", "1e-12", "1e-10", "1e-9", "1e-8", "1e-6", "1e-4"}) {
            add(std::string("tolerance_") + tolerance + "_", one, run, std::strtod(tolerance, nullptr));
            add(std::string("tolerance_") + tolerance + "_ensemble_", ensemble, run, std::strtod(tolerance, nullptr));
        }
    }
    return true;
}();

}  // namespace
