#include "pendula/solve.hpp"

#include "pendula/angle.hpp"
#include "pendula/euler.hpp"
#include "pendula/verlet.hpp"
#include "rk4_scalar.hpp"
#include "taylor_scalar.hpp"

namespace pendula {

using namespace arithmetic;

namespace {

constexpr double slack = 1e-9;  // relative, in counting rows and steps: 1/0.02 is 50 rows
constexpr std::size_t batch = 256;

Sample current(const Trajectory& run) noexcept {
    return {run.rows_done * run.problem.schedule.every, run.theta, run.omega, run.turns};
}

/// Rows of the closed form, or of a pendulum that stays where it is.
std::size_t evaluate(Trajectory& run, std::size_t n, Sample* rows) noexcept {
    double t[batch] = {}, theta[batch], omega[batch], turns[batch];
    const double left = run.problem.schedule.rows - run.rows_done;
    std::size_t count = n < batch ? n : batch;
    if (left < static_cast<double>(count)) count = static_cast<std::size_t>(left);
    const auto time = [&](std::size_t i) { return (run.rows_done + static_cast<double>(i)) * run.problem.schedule.every; };
    for (std::size_t i = 0; i < count; ++i) t[i] = run.is_resting ? 0 : time(i);
    at(run.solution, count, t, theta, omega, turns);
    for (std::size_t i = 0; i < count; ++i) rows[i] = {time(i), theta[i], omega[i], turns[i]};
    run.rows_done += static_cast<double>(count);
    return count;
}

/// Steps of the methods that need no more than a state.
template <class Step>
void plain_steps(Trajectory& run, double t, int steps, Step step) noexcept {
    const double h = run.problem.schedule.step;
    State state{run.theta, run.omega};
    for (int i = 0; i < steps; ++i) {
        state = step(run.problem.pendulum, state, t + i * h, h);
        if (state.theta >= -pi && state.theta < pi) continue;
        const auto angle = split_turns(state.theta);
        state.theta = angle.theta;
        run.turns += angle.turns;
    }
    run.theta = state.theta;
    run.omega = state.omega;
}

void take_rk4_steps(Trajectory& run, double row_time, int steps) noexcept {
    kernels::Motion<double> x{run.theta, run.omega, run.turns, run.theta_lo, run.omega_lo};
    rk4_steps(rk4_constants(run.problem.pendulum, run.problem.schedule.step), row_time, run.steps_done, x, steps);
    run.theta = x.theta;
    run.omega = x.omega;
    run.turns = x.turns;
    run.theta_lo = x.theta_lo;
    run.omega_lo = x.omega_lo;
}

/// Steps towards the next row, in whole blocks counted from the last row, so that no caller can move them.
int take_steps(Trajectory& run) noexcept {
    constexpr int most = 64 * kernels::block_steps;
    const double left = run.problem.schedule.steps_per_row - run.steps_done;
    const int steps = left < most ? static_cast<int>(left) : most;
    const double row_time = (run.rows_done - 1) * run.problem.schedule.every;
    const double t = row_time + run.steps_done * run.problem.schedule.step;
    if (run.problem.method == Method::euler) plain_steps(run, t, steps, euler_step);
    if (run.problem.method == Method::verlet) plain_steps(run, t, steps, verlet_step);
    if (run.problem.method == Method::rk4) take_rk4_steps(run, row_time, steps);
    run.steps_done += steps;
    return steps;
}

/// Rows by dense output; a row never makes a step end.
std::size_t taylor_rows(Trajectory& run, std::size_t n, Sample* rows, double step_budget) noexcept {
    std::size_t count = 0;
    for (; count < n && !run.is_finished(); ++count) {
        const double t = run.rows_done * run.problem.schedule.every;
        for (; goes_on_to(run.taylor, t); --step_budget) {
            if (step_budget <= 0) return count;
            step(run.taylor);
        }
        rows[count] = at(run.taylor, t);
        run.rows_done += 1;
    }
    return count;
}

}  // namespace

bool Schedule::is_feasible() const noexcept { return rows <= 0x1p53 && steps() <= 0x1p53; }

Schedule schedule(const Times& times) noexcept {
    Schedule s;
    s.every = times.every;
    s.rows = floor(times.until / times.every * (1 + slack)) + 1;
    const double steps = ceiling(times.every / times.dt * (1 - slack));
    s.steps_per_row = steps < 1 ? 1 : steps;
    s.step = s.every / s.steps_per_row;
    return s;
}

Trajectory begin(const Problem& problem) noexcept {
    Trajectory run;
    run.problem = problem;
    const auto& p = problem.pendulum;
    run.is_resting = rests_on_top(p, problem.initial);
    if (run.is_resting || is_conservative(p)) run.solution = exact(p.alpha, problem.initial);
    if (problem.method == Method::taylor) run.taylor = taylor(p, problem.initial, problem.tolerance);
    const auto angle = split_turns(problem.initial.theta);
    run.theta = angle.theta;
    run.turns = angle.turns;
    run.omega = problem.initial.omega;
    return run;
}

std::size_t advance(Trajectory& run, std::size_t n, Sample* rows, double step_budget) noexcept {
    if (run.problem.method == Method::taylor && !run.is_resting) return taylor_rows(run, n, rows, step_budget);
    std::size_t count = 0;
    while (count < n && !run.is_finished()) {
        if (run.is_resting || run.problem.method == Method::exact) {
            count += evaluate(run, n - count, rows + count);
            continue;
        }
        while (run.rows_done > 0 && run.steps_done < run.problem.schedule.steps_per_row) {
            if (step_budget <= 0) return count;
            step_budget -= take_steps(run);
        }
        rows[count++] = current(run);
        run.rows_done += 1;
        run.steps_done = 0;
    }
    return count;
}

}  // namespace pendula
