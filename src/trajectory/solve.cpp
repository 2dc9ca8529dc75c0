#include "pendula/solve.hpp"

#include "checks.hpp"
#include "pendula/steps.hpp"
#include "trajectory/scalar.hpp"

namespace pendula {

namespace {

constexpr std::size_t batch = 256;

Sample current(const Trajectory& run) noexcept {
    return {run.problem.schedule.time_of(run.rows_done), run.motion.theta, run.motion.omega, run.motion.turns};
}

/// Computes rows of the closed form, or of a pendulum at rest, up to one batch.
std::size_t evaluate(Trajectory& run, std::span<Sample> rows) noexcept {
    double t[batch] = {}, theta[batch], omega[batch], turns[batch];
    const double left = run.problem.schedule.rows - run.rows_done;
    std::size_t count = rows.size() < batch ? rows.size() : batch;
    if (left < static_cast<double>(count)) count = static_cast<std::size_t>(left);
    const auto time = [&](std::size_t i) { return run.problem.schedule.time_of(run.rows_done + static_cast<double>(i)); };
    for (std::size_t i = 0; i < count; ++i) t[i] = run.is_resting ? 0 : time(i);
    at(run.solution, count, t, theta, omega, turns);
    for (std::size_t i = 0; i < count; ++i) rows[i] = {time(i), theta[i], omega[i], turns[i]};
    run.rows_done += static_cast<double>(count);
    return count;
}

/// A length of time that is divided into equal steps.
struct Segment {
    double start = 0, length = 0;  ///< [s]
    double steps = 0;

    double step() const noexcept { return length / steps; }
};

Segment segment_to_next_row(const Trajectory& run) noexcept {
    const Schedule& s = run.problem.schedule;
    if (!s.times.empty()) {
        const double start = run.rows_done > 0 ? s.time_of(run.rows_done - 1) : 0, length = s.time_of(run.rows_done) - start;
        return {start, length, length > 0 ? steps_in(length, s.dt) : 0};
    }
    if (run.rows_done > 0) return {s.time_of(run.rows_done - 1), s.every, s.steps_per_row};
    return s.first > 0 ? Segment{0, s.first, s.steps_to_first} : Segment{};
}

/// Makes steps of a one-step method, and wraps the angle after each.
template <class Step>
void plain_steps(Trajectory& run, double t, double h, int steps, Step step) noexcept {
    State state{run.motion.theta, run.motion.omega};
    for (int i = 0; i < steps; ++i) {
        state = step(run.problem.pendulum, state, t + i * h, h);
        if (state.theta >= -pi && state.theta < pi) continue;
        const auto angle = split_turns(state.theta);
        state.theta = angle.theta;
        run.motion.turns += angle.turns;
    }
    run.motion.theta = state.theta;
    run.motion.omega = state.omega;
}

/// Makes steps towards the next row, in whole blocks that are counted from the last row. So the blocks, and with them the bits,
/// do not depend on the budget of the caller.
int take_steps(Trajectory& run, const Segment& segment) noexcept {
    constexpr int most = 64 * kernels::block_steps;
    const double left = segment.steps - run.steps_done, h = segment.step();
    const int steps = left < most ? static_cast<int>(left) : most;
    const double t = segment.start + run.steps_done * h;
    if (run.problem.method == Method::euler) plain_steps(run, t, h, steps, euler_step);
    if (run.problem.method == Method::verlet) plain_steps(run, t, h, steps, verlet_step);
    if (run.problem.method == Method::rk4) {
        auto x = __builtin_bit_cast(kernels::Motion<double>, run.motion);
        rk4_steps(kernels::rk4_constants(parameters_of(run.problem.pendulum), h), segment.start, run.steps_done, x, steps);
        run.motion = __builtin_bit_cast(Motion, x);
    }
    run.steps_done += steps;
    return steps;
}

/// Computes rows from the polynomials of the steps. The steps do not depend on the times of the rows.
std::size_t taylor_rows(Trajectory& run, std::span<Sample> rows, double step_budget) noexcept {
    std::size_t count = 0;
    for (; count < rows.size() && !run.is_finished(); ++count) {
        const double t = run.problem.schedule.time_of(run.rows_done);
        for (; needs_step_to(run.taylor, t); --step_budget) {
            if (step_budget <= 0) return count;
            step(run.taylor);
        }
        rows[count] = at(run.taylor, t);
        run.rows_done += 1;
    }
    return count;
}

Refusal check(const Schedule& s) noexcept {
    using enum Refusal::Reason;
    if (!s.times.empty()) return s.steps() <= 0x1p53 ? Refusal{} : Refusal{.reason = too_many_steps, .value = s.steps()};
    if (const auto refusal = check_rule("first", s.first, Rule::not_negative)) return refusal;
    if (const auto refusal = check_rule("every", s.every, Rule::positive); refusal && s.rows != 1) return refusal;
    if (s.rows > 0x1p53) return {.reason = too_many_rows, .value = s.rows};
    if (s.steps() > 0x1p53) return {.reason = too_many_steps, .value = s.steps()};
    if (const auto refusal = check_count("rows", s.rows, 1)) return refusal;
    if (const auto refusal = check_count("steps_to_first", s.steps_to_first, 1)) return refusal;
    return check_count("steps_per_row", s.steps_per_row, 1);
}

/// Refuses steps that are too long for the friction, between given times.
Refusal check_given_steps(const Pendulum& p, Method method, const Schedule& s) noexcept {
    if (const auto refusal = check_rule("dt", s.dt, Rule::positive)) return refusal;
    if (p.beta * s.dt <= 1) return {};  // stable by every method
    double before = 0;
    for (const double t : s.times) {
        const double length = t - before;
        if (const auto refusal = check_stability(p, method, length, steps_in(length, s.dt), "steps_per_row")) return refusal;
        before = t;
    }
    return {};
}

/// Refuses times after the latest time of the closed form.
Refusal check_latest(const Pendulum& p, State initial, double t) noexcept {
    constexpr double safe_periods = 0x1p20;  // `latest_time` is at least so many periods
    // An upper bound of the number of periods, by |omega| <= |omega0| + 2 sqrt(alpha).
    const double periods = t * (arithmetic::abs(initial.omega) + 2 * arithmetic::sqrt(p.alpha)) / (2 * pi);
    if (periods <= safe_periods) return {};
    const double latest = latest_time(make_exact(p.alpha, initial));
    return t <= latest ? Refusal{} : Refusal{.reason = Refusal::Reason::too_late, .name = "t", .value = t, .most = latest};
}

}  // namespace

Refusal check(const Pendulum& p, Method method, double tolerance) noexcept {
    using enum Refusal::Reason;
    if (!(method >= Method::rk4 && method <= Method::exact))
        return {.reason = not_among, .name = "method", .legal = "rk4, euler, verlet, taylor, exact"};
    if (method == Method::exact && !is_conservative(p)) return {.reason = not_conservative, .name = "exact"};
    if (method == Method::verlet && p.beta != 0) return {.reason = has_friction, .name = "verlet", .value = p.beta};
    return check_rule("tolerance", tolerance, Rule::fraction);
}

Refusal check_stability(const Pendulum& p, Method method, double length, double steps, const char* name) noexcept {
    const double bound = method == Method::euler ? 2.0 : 2.78;
    const double least = arithmetic::ceiling(p.beta * length / bound);
    if (!takes_steps(method) || !(steps < least)) return {};
    return {.reason = Refusal::Reason::unstable, .name = name, .value = steps, .least = least};
}

Refusal check_times(std::span<const double> times, double rows) noexcept {
    using enum Refusal::Reason;
    const auto size = static_cast<double>(times.size());
    if (size != rows) return {.reason = length, .name = "times", .value = size, .least = rows};
    for (std::size_t row = 0; row < times.size(); ++row) {
        auto refusal = check_rule("times", times[row], Rule::not_negative);
        if (!refusal && row > 0 && times[row] < times[row - 1])
            refusal = {.reason = decreasing, .name = "times", .value = times[row], .least = times[row - 1]};
        refusal.row = row;
        if (refusal) return refusal;
    }
    return {};
}

Refusal check(const Problem& problem) noexcept {
    const Schedule& s = problem.schedule;
    const auto refusal = s.times.empty() ? Refusal{} : check_times(s.times, s.rows);
    return refusal ? refusal : check_but_times(problem);
}

Refusal check_but_times(const Problem& problem) noexcept {
    const Schedule& s = problem.schedule;
    if (const auto refusal = check(problem.pendulum, problem.initial)) return refusal;
    if (const auto refusal = check(problem.pendulum, problem.method, problem.tolerance)) return refusal;
    if (const auto refusal = check(s)) return refusal;
    if (problem.method == Method::exact) return check_latest(problem.pendulum, problem.initial, s.time_of(s.rows - 1));
    if (!takes_steps(problem.method)) return {};
    if (!s.times.empty()) return check_given_steps(problem.pendulum, problem.method, s);
    if (const auto refusal = check_stability(problem.pendulum, problem.method, s.first, s.steps_to_first, "steps_to_first"))
        return refusal;
    return check_stability(problem.pendulum, problem.method, s.rows > 1 ? s.every : 0, s.steps_per_row, "steps_per_row");
}

Trajectory begin(const Problem& problem) noexcept {
    Trajectory run;
    run.problem = problem;
    run.refusal = check(problem);
    if (run.refusal) return run;
    const auto& p = problem.pendulum;
    run.is_resting = problem.method != Method::exact && rests_on_top(p, problem.initial);
    if (run.is_resting || is_conservative(p)) run.solution = make_exact(p.alpha, problem.initial);
    if (problem.method == Method::taylor) run.taylor = make_taylor(p, problem.initial, problem.tolerance);
    const auto angle = split_turns(problem.initial.theta);
    run.motion = {angle.theta, problem.initial.omega, angle.turns};
    return run;
}

std::size_t advance(Trajectory& trajectory, std::span<Sample> rows, double step_budget) noexcept {
    if (trajectory.problem.method == Method::taylor && !trajectory.is_resting)
        return taylor_rows(trajectory, rows, step_budget);
    std::size_t count = 0;
    while (count < rows.size() && !trajectory.is_finished()) {
        if (trajectory.is_resting || trajectory.problem.method == Method::exact) {
            count += evaluate(trajectory, rows.subspan(count));
            continue;
        }
        const auto segment = segment_to_next_row(trajectory);
        while (trajectory.steps_done < segment.steps) {
            if (step_budget <= 0) return count;
            step_budget -= take_steps(trajectory, segment);
        }
        rows[count++] = current(trajectory);
        trajectory.rows_done += 1;
        trajectory.steps_done = 0;
    }
    return count;
}

}  // namespace pendula
