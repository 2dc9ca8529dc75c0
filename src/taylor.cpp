#include "kernels/taylor_chunk.hpp"
#include "pendula/angle.hpp"
#include "taylor_scalar.hpp"

namespace pendula {

using namespace arithmetic;
using kernels::Series;
using kernels::TaylorStep;

TaylorStep<double> step_of(const Taylor& run) noexcept {
    TaylorStep<double> step{{run.theta, run.omega, run.turns, run.theta_lo, run.omega_lo},
                            {run.t, run.t_lo},
                            run.unit,
                            run.length,
                            {},
                            run.series_1_lo};
    static_assert(sizeof step.v == sizeof run.series);
    __builtin_memcpy(step.v, run.series, sizeof step.v);
    return step;
}

namespace {

void put_step(Taylor& run, const TaylorStep<double>& step) noexcept {
    run.theta = step.start.theta;
    run.omega = step.start.omega;
    run.turns = step.start.turns;
    run.theta_lo = step.start.theta_lo;
    run.omega_lo = step.start.omega_lo;
    run.t = step.t.hi;
    run.t_lo = step.t.lo;
    run.unit = step.unit;
    run.length = step.length;
    run.series_1_lo = step.v1_lo;
    __builtin_memcpy(run.series, step.v, sizeof step.v);
}

void expand(Taylor& run, TaylorStep<double>& step) noexcept {
    const Pendulum& p = run.pendulum;
    const auto parameters =
        kernels::taylor_pendulum(p.alpha, p.beta, p.torque, p.drive_amplitude, p.drive_frequency, p.drive_phase);
    Series<double> cosine;
    kernels::expand(parameters, {run.order, run.log2_fraction}, step, cosine);
    put_step(run, step);
}

}  // namespace

Taylor taylor(const Pendulum& pendulum, State initial, double tolerance, double t) noexcept {
    Taylor run;
    run.pendulum = pendulum;
    const auto reach = kernels::taylor_reach(tolerance);
    run.order = reach.order;
    run.log2_fraction = reach.log2_fraction;
    const auto angle = split_turns(initial.theta);
    run.theta = angle.theta;
    run.turns = angle.turns;
    run.omega = initial.omega;
    run.t = t;
    auto first = step_of(run);
    expand(run, first);
    return run;
}

void step(Taylor& run) noexcept {
    auto next = step_of(run);
    kernels::go_to_end(next);
    expand(run, next);
}

void kernels::start_taylor(TaylorChunk& steps, const Chunk& chunk, double tolerance, const double* t) noexcept {
    const auto reach = taylor_reach(tolerance);
    steps.order = reach.order;
    steps.log2_fraction = reach.log2_fraction;
    for (int i = 0; i < chunk_size; ++i) {
        steps.t[i] = t[i];
        steps.t_lo[i] = steps.length[i] = steps.series_1_lo[i] = 0;
        steps.unit[i] = 1;
        steps.theta[i] = chunk.theta[i];
        steps.omega[i] = chunk.omega[i];
        steps.turns[i] = chunk.turns[i];
        steps.theta_lo[i] = chunk.theta_lo[i];
        steps.omega_lo[i] = chunk.omega_lo[i];
        steps.tangent_theta[i] = chunk.tangent_theta[i];
        steps.tangent_omega[i] = chunk.tangent_omega[i];
        for (int k = 0; k < taylor_coefficients; ++k) steps.series[k][i] = steps.tangent_series[k][i] = 0;
        // A step of no length: its displacement is read from the series.
        steps.tangent_series[1][i] = chunk.tangent_omega[i];
    }
}

bool reaches(const Taylor& run, double t) noexcept { return !((run.t - t) + (run.t_lo + run.length) < 0); }

bool goes_on_to(Taylor& run, double t) noexcept {
    if (reaches(run, t)) return false;
    auto step = step_of(run);
    kernels::give_up_endless(step, t);
    if (step.length == step.length) return true;
    put_step(run, step);
    return false;
}

Sample at(const Taylor& run, double t) noexcept {
    const auto m = kernels::motion_at(step_of(run), (t - run.t) - run.t_lo);
    return {t, m.theta, m.omega, m.turns};
}

}  // namespace pendula
