#include "pendula/measure.hpp"

#include "checks.hpp"
#include "measures/strobe.hpp"
#include "pendula/angle.hpp"

namespace pendula {

namespace {

/// Records the states at successive strobe times.
struct SectionObserver {
    static constexpr bool has_tangent = false;
    const MeasureCall& call;

    explicit SectionObserver(const MeasureCall& of) noexcept : call(of) {}

    bool start(const StrobedMembers& m) noexcept { return at_strobe(m, 0); }
    bool at_strobe(const StrobedMembers& m, double done) noexcept {
        const auto row = static_cast<std::size_t>(done);
        for (int i = 0; i < m.chunk.count; ++i) {
            call.result(0, row, m.number[i]) = m.chunk.motion.theta[i];
            call.result(1, row, m.number[i]) = m.chunk.motion.omega[i];
            call.result(2, row, m.number[i]) = m.chunk.motion.turns[i];
            call.result(3, row, m.number[i]) = __builtin_nan("");
        }
        return done + 1 < call.strobe.periods;
    }
    void finish(const StrobedMembers&) noexcept {}
};

/// Measures the mean velocity from the first and the last state.
struct MeanVelocityObserver {
    static constexpr bool has_tangent = false;
    const MeasureCall& call;
    kernels::Motion<kernels::Row> first{};

    explicit MeanVelocityObserver(const MeasureCall& of) noexcept : call(of) {}

    bool start(const StrobedMembers& m) noexcept {
        first = m.chunk.motion;
        return true;
    }
    bool at_strobe(const StrobedMembers&, double) noexcept { return true; }
    void finish(const StrobedMembers& m) noexcept {
        const auto& last = m.chunk.motion;
        for (int i = 0; i < m.chunk.count; ++i) {
            const double turned = (last.turns[i] - first.turns[i]) + (last.theta[i] - first.theta[i]) / (2 * pi);
            call.result(0, 0, m.number[i]) = turned / call.strobe.periods * m.frequency[i];
            call.result(1, 0, m.number[i]) = __builtin_nan("");
            call.result(2, 0, m.number[i]) = 0;
            call.result(3, 0, m.number[i]) = last.theta[i];
            call.result(4, 0, m.number[i]) = last.omega[i];
        }
    }
};

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
    if (call.columns.size() < info.columns.size())
        return {.reason = Refusal::Reason::length,
                .name = "results",
                .value = static_cast<double>(call.columns.size()),
                .least = static_cast<double>(info.columns.size())};
    for (std::size_t i = 0; i < info.columns.size(); ++i) {
        const double values =
            static_cast<double>(rows_of(info.columns[i], call.strobe)) * static_cast<double>(call.ensemble.size);
        if (const auto refusal = check_length(call.columns[i], values, info.columns[i].name)) return refusal;
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
            return observe<SectionObserver>(call, control);
        case Measure::mean_velocity:
            return observe<MeanVelocityObserver>(call, control);
        case Measure::lyapunov:
            return measure_lyapunov(call, control);
        case Measure::attractors:
            return measure_attractors(call, control);
        case Measure::orbit:
            return {};
    }
    return {};
}

}  // namespace pendula
