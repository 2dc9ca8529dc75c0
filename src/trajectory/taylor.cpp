#include "pendula/taylor.hpp"

#include "pendula/parameters.hpp"
#include "trajectory/scalar.hpp"

namespace pendula {

namespace {

template <int order>
void expand(Taylor& run) noexcept {
    kernels::Series<double> cosine;
    kernels::expand<order>(kernels::taylor_pendulum(parameters_of(run.pendulum)), run.step, cosine);
    kernels::set_length<order>(run.step, kernels::log2_length_of<order, double>(run.step, run.log2_fraction));
}

}  // namespace

Taylor make_taylor(const Pendulum& pendulum, State initial, double tolerance, double t) noexcept {
    constexpr double nan = __builtin_nan("");
    const bool is_legal = !check(pendulum, initial) && satisfies(Rule::fraction, tolerance) && satisfies(Rule::finite, t);
    Taylor run;
    run.pendulum = pendulum;
    const auto control = kernels::step_control(satisfies(Rule::fraction, tolerance) ? tolerance : 0.5);
    run.order = control.order;
    run.log2_fraction = control.log2_fraction;
    const auto angle = split_turns(initial.theta);
    run.step.start = {is_legal ? angle.theta : nan, is_legal ? initial.omega : nan, angle.turns};
    run.step.t = t;
    kernels::with_order(run.order, [&](auto order) { expand<order.value>(run); });
    return run;
}

void step(Taylor& run) noexcept {
    kernels::with_order(run.order, [&](auto order) {
        kernels::move_to_end<order.value>(run.step);
        expand<order.value>(run);
    });
}

bool reaches(const Taylor& run, double t) noexcept { return !kernels::ends_before(run.step, t); }

Sample at(const Taylor& run, double t) noexcept {
    const auto m = motion_at(run, (t - run.step.t) - run.step.t_lo);
    return {t, m.theta, m.omega, m.turns};
}

}  // namespace pendula

void pendula::kernels::start_taylor(TaylorChunk& steps, const Chunk& chunk, double tolerance, const Row& t) noexcept {
    const auto control = step_control(tolerance);
    steps.order = control.order;
    steps.log2_fraction = control.log2_fraction;
    steps.step = {};
    steps.tangent = {};
    steps.step.start = chunk.motion;
    steps.tangent.start = chunk.tangent;
    for (int i = 0; i < chunk_size; ++i) {
        steps.step.t[i] = t[i];
        steps.step.unit[i] = 1;
        steps.tangent.u[1][i] = chunk.tangent.omega[i];  // the displacement of a step of length 0 is read from its series
    }
}
