#include "pendula/measure.hpp"

#include "arithmetic/pack.hpp"
#include "checks.hpp"
#include "measures/settle.hpp"

namespace pendula {

using arithmetic::sqrt;

namespace {

constexpr double log_of_2_to_52 = 0x1.205966f2b4f12p+5;
constexpr double infinity = __builtin_inf();

Outcome measure_mean_velocity(const MeasureCall& call, const Control& control) noexcept {
    const auto put = [&](std::size_t member, const Fate& fate) {
        call.put(member,
                 {fate.velocity.value, fate.velocity.error, static_cast<double>(fate.kind), fate.end.theta, fate.end.omega});
    };
    return settle(call.ensemble, call.strobe, {}, control, put);
}

Outcome measure_lyapunov(const MeasureCall& call, const Control& control) noexcept {
    constexpr std::size_t history = std::size(lyapunov_columns) - 1;
    const std::size_t rows = call.has(history) ? rows_of(lyapunov_columns[history], call.strobe) : 0;
    for (std::size_t row = 0; row < rows; ++row)
        for (std::size_t member = 0; member < call.ensemble.size; ++member) call.result(history, row, member) = nan;
    const auto put = [&](std::size_t member, const Fate& fate) {
        const auto [exponent, error] = fate.exponent;
        const double horizon = !fate.exponent.is_known() ? nan : exponent > 3 * error ? log_of_2_to_52 / exponent : infinity;
        const double second = 0 - call.ensemble.beta[member] - exponent;
        call.put(member, {exponent, error, horizon, second, fate.dimension.value, fate.dimension.error,
                          static_cast<double>(fate.kind), fate.end.theta, fate.end.omega});
        const bool is_estimated = fate.kind == Kind::chaotic || fate.kind == Kind::quasi_periodic ||
                                  (fate.kind == Kind::unsettled && is_driven(pendulum_of(call.ensemble, member)));
        for (std::size_t row = 0; !is_estimated && row < rows; ++row) call.result(history, row, member) = exponent;
    };
    return settle(call.ensemble, call.strobe, rows > 0 ? call.columns[history] : std::span<double>(), control, put);
}

Outcome measure_orbit(const MeasureCall& call, const Control& control) noexcept {
    const double units = static_cast<double>(call.ensemble.size);
    return for_each_piece(call.ensemble.size, units, control, [&](Thread& thread, std::size_t member) {
        const auto p = pendulum_of(call.ensemble, member);
        PeriodicOrbit o;
        constexpr double no_limit = __builtin_inf();
        if (!refine_within(p, initial_state_of(call.ensemble, member), call.strobe.orbit_period, no_limit, call.strobe, thread,
                           o))
            return;
        const auto found = [&](double x) { return o.is_found ? x : nan; };
        call.put(member,
                 {found(o.point.theta), found(o.point.omega), found(o.error), found(o.turns / o.period), found(o.multiplier[0]),
                  found(o.multiplier[1]), found(o.imaginary), found(o.exponent[0]), found(o.exponent_error)});
        thread.report(1);
    });
}

Refusal check(const Strobe& strobe) noexcept {
    if (strobe.method != Method::rk4 && strobe.method != Method::taylor)
        return {.reason = Refusal::Reason::not_among, .name = "method", .legal = "rk4, taylor"};
    if (const auto refusal = check_count("transient", strobe.transient, 0)) return refusal;
    if (const auto refusal = check_count("periods", strobe.periods, 1)) return refusal;
    if (const auto refusal = check_count("steps_per_period", strobe.steps_per_period, 1)) return refusal;
    if (const auto refusal = check_count("budget", strobe.budget, 1)) return refusal;
    if (const auto refusal = check_rule("strobe_phase", strobe.phase, Rule::finite)) return refusal;
    if (const auto refusal = check_rule("level", strobe.level, Rule::finite)) return refusal;
    if (const auto refusal = check_count("orbit_period", strobe.orbit_period, 1)) return refusal;
    if (const auto refusal = check_count("history_rows", strobe.history_rows, 0, strobe.periods)) return refusal;
    if (const auto refusal = check_rule("tolerance", strobe.tolerance, Rule::fraction)) return refusal;
    return check_rule("match", strobe.match, Rule::positive);
}

Refusal check_steps(const Pendulum& pendulum, const Strobe& strobe) noexcept {
    using enum Refusal::Reason;
    const double fewest = fewest_steps(pendulum);
    const bool is_rk4 = strobe.method == Method::rk4;
    if (is_rk4 && !(strobe.steps_per_period >= fewest))
        return {.reason = unstable, .name = "steps_per_period", .value = strobe.steps_per_period, .least = fewest};
    const double steps = (strobe.transient + strobe.periods) * (is_rk4 ? strobe.steps_per_period : fewest);
    return steps <= 0x1p53 ? Refusal{} : Refusal{.reason = too_many_steps, .value = steps};
}

Refusal check_results(const MeasureInfo& info, const MeasureCall& call) noexcept {
    std::size_t least = info.columns.size();
    while (least > 0 && info.columns[least - 1].is_detail) --least;
    if (call.columns.size() < least)
        return {.reason = Refusal::Reason::length,
                .name = "results",
                .value = static_cast<double>(call.columns.size()),
                .least = static_cast<double>(least)};
    for (std::size_t i = 0; i < info.columns.size(); ++i) {
        // A history is a detail too, but whoever asks for rows of it wants them.
        if (info.columns[i].is_detail && info.columns[i].rows != ResultColumn::Rows::history && !call.has(i)) continue;
        const double values =
            static_cast<double>(rows_of(info.columns[i], call.strobe)) * static_cast<double>(call.ensemble.size);
        const auto values_given = call.has(i) ? call.columns[i] : std::span<double>();
        if (const auto refusal = check_length(values_given, values, info.columns[i].name)) return refusal;
    }
    return {};
}

}  // namespace

Refusal check(const Pendulum& pendulum, const Strobe& strobe) noexcept {
    if (const auto refusal = check(pendulum)) return refusal;
    if (const auto refusal = check(strobe)) return refusal;
    return check_steps(pendulum, strobe);
}

std::size_t rows_of(const ResultColumn& column, const Strobe& strobe) noexcept {
    if (column.rows == ResultColumn::Rows::one) return 1;
    return static_cast<std::size_t>(column.rows == ResultColumn::Rows::periods ? strobe.periods : strobe.history_rows);
}

Refusal check(Measure what, const MeasureCall& call, const Control& control) noexcept {
    if (!(what >= Measure::section && what <= Measure::orbit))
        return {.reason = Refusal::Reason::not_among,
                .name = "measure",
                .legal = "section, mean_velocity, lyapunov, attractors, orbit"};
    if (const auto refusal = check(call.strobe)) return refusal;
    if (const auto refusal = check_call(call.ensemble, control)) return refusal;
    if (const auto refusal = check_results(measures[static_cast<int>(what)], call)) return refusal;
    return check_each(call.ensemble, [&](std::size_t, const Pendulum& pendulum) { return check_steps(pendulum, call.strobe); });
}

Outcome measure(Measure what, const Ensemble& ensemble, const Strobe& strobe, const Results& results,
                const Control& control) noexcept {
    const MeasureCall call{ensemble, strobe, results.columns()};
    if (const auto refusal = check(what, call, control)) return refusal;
    switch (what) {
        case Measure::section:
            return measure_section(call, control);
        case Measure::mean_velocity:
            return measure_mean_velocity(call, control);
        case Measure::lyapunov:
            return measure_lyapunov(call, control);
        case Measure::attractors:
            return measure_attractors(call, control);
        case Measure::orbit:
            return measure_orbit(call, control);
    }
    return {};
}

double share_error(double count, double trials) noexcept {
    constexpr double z = 1.96;  // 95 % of a normal distribution
    const double share = count / trials, shrink = 1 + z * z / trials;
    const double centre = (share + 0.5 * z * z / trials) / shrink;
    const double half = z * sqrt(share * (1 - share) / trials + 0.25 * z * z / (trials * trials)) / shrink;
    return half + (centre > share ? centre - share : share - centre);
}

}  // namespace pendula
