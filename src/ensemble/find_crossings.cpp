#include "checks.hpp"
#include "ensemble/members.hpp"
#include "trajectory/period.hpp"

namespace pendula {

namespace {

constexpr double steps_between_looks = 256;

Refusal check_column(const char* name, const Column& column, std::size_t size) noexcept {
    if (column.fits(size)) return {};
    return {.reason = Refusal::Reason::length,
            .name = name,
            .value = static_cast<double>(column.length()),
            .least = static_cast<double>(size)};
}

Refusal check(const EnsembleLevels& levels, std::size_t size) noexcept {
    using enum Refusal::Reason;
    if (!(levels.crossed >= Crossed::theta && levels.crossed <= Crossed::omega))
        return {.reason = not_among, .name = "crossed", .legal = "theta, omega"};
    if (!(levels.direction >= Direction::both && levels.direction <= Direction::falling))
        return {.reason = not_among, .name = "direction", .legal = "both, rising, falling"};
    if (const auto refusal = check_column("at", levels.at, size)) return refusal;
    return check_column("until", levels.until, size);
}

/// Hands over the crossings of one member. Returns false if `receive` ended the call.
bool search_member(const EnsembleLevels& levels, std::size_t member, Crossings& search, Thread& thread,
                   const Receive& receive) noexcept {
    const double until = levels.until[member];
    Crossing crossing;
    while (thread.goes_on()) {
        for (int i = 0; i < steps_between_looks; ++i) {
            if (next_crossing(search, until, crossing, steps_between_looks)) {
                if (!receive(member, crossing)) return false;
                continue;
            }
            if (!reaches(search.run, until)) break;
            constexpr double nan = __builtin_nan("");
            const bool is_lost = search.run.step.length != search.run.step.length;
            return !is_lost || receive(member, {.sample = {nan, nan, nan, nan}});
        }
    }
    return true;
}

}  // namespace

Outcome find_crossings(const Ensemble& ensemble, const EnsembleLevels& levels, double tolerance, const Receive& receive,
                       const Control& control) noexcept {
    if (const auto refusal = check_call(ensemble, control)) return refusal;
    if (const auto refusal = check(levels, ensemble.size)) return refusal;
    const auto check_member = [&](std::size_t member, const Pendulum& pendulum) {
        if (const auto refusal = check(pendulum, Method::taylor, tolerance)) return refusal;
        if (const auto refusal = check_rule("at", levels.at[member], Rule::finite)) return refusal;
        return check_rule("until", levels.until[member], Rule::not_negative);
    };
    if (const auto refusal = check_each(ensemble, check_member)) return refusal;
    bool goes_on = true;
    const auto outcome =
        for_each_piece(ensemble.size, static_cast<double>(ensemble.size), control, [&](Thread& thread, std::size_t member) {
            if (!__atomic_load_n(&goes_on, __ATOMIC_RELAXED)) return;
            const Level level{levels.crossed, levels.at[member], levels.direction};
            auto search = make_crossings(pendulum_of(ensemble, member), initial_state_of(ensemble, member), level, tolerance);
            if (!search_member(levels, member, search, thread, receive)) __atomic_store_n(&goes_on, false, __ATOMIC_RELAXED);
            thread.report(1);
        });
    return goes_on ? outcome : Outcome(Outcome::Kind::stopped);
}

Outcome measured_period(const Ensemble& ensemble, const Column& until, double tolerance, std::span<double> periods,
                        const Control& control) noexcept {
    if (const auto refusal = check_call(ensemble, control)) return refusal;
    if (const auto refusal = check_column("until", until, ensemble.size)) return refusal;
    if (const auto refusal = check_length(periods, static_cast<double>(ensemble.size), "periods")) return refusal;
    const auto check_member = [&](std::size_t member, const Pendulum& pendulum) {
        if (const auto refusal = check(pendulum, Method::taylor, tolerance)) return refusal;
        return check_rule("until", until[member], Rule::not_negative);
    };
    if (const auto refusal = check_each(ensemble, check_member)) return refusal;
    return for_each_piece(ensemble.size, static_cast<double>(ensemble.size), control, [&](Thread& thread, std::size_t member) {
        MeasuredPeriod measured(pendulum_of(ensemble, member), initial_state_of(ensemble, member), tolerance);
        do {
            if (!thread.goes_on()) return;
        } while (measured.goes_on(until[member]));
        periods[member] = measured.period();
        thread.report(1);
    });
}

}  // namespace pendula
