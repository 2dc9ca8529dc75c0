// Crossings of levels and measured periods of many pendulums.
#include "pendula/crossings.hpp"

#include <atomic>
#include <cmath>
#include <new>

#include "calls.hpp"

namespace pendula::python {

namespace {

using Found = std::vector<std::vector<Crossing>>;

/// The crossings of each member; those whose motion leaves the range of doubles have a NaN in `lost`.
Refusal find(const Members& members, const EnsembleLevels& levels, double tolerance, int threads, Found& found,
             std::vector<double>& lost) {
    return run_long(many, [&](const Proceed& proceed) -> Outcome {
        std::atomic<bool> is_full = false;
        const auto receive = [&found, &lost, &is_full](std::size_t member, const Crossing& crossing) {
            if (std::isnan(crossing.sample.t)) {
                lost[member] = crossing.sample.t;
                return true;
            }
            try {
                found[member].push_back(crossing);
            } catch (const std::bad_alloc&) {
                is_full = true;
            }
            return !is_full;
        };
        const Outcome outcome = find_crossings(members.ensemble(), levels, tolerance, receive, {threads, proceed});
        if (is_full) return Refusal{.reason = Refusal::Reason::memory};
        return outcome;
    });
}

/// t, theta, omega and whether the quantity rises, [..., crossing]; NaN and 0 behind the last crossing of a member.
std::tuple<Array, Array, Array, Array> rows_of(const Found& found, const Shape& shape) {
    std::size_t most = 0;
    for (const auto& each : found) most = std::max(most, each.size());
    Shape with_rows = shape;
    with_rows.push_back(static_cast<Py_ssize_t>(most));
    Output t(with_rows), theta(with_rows), omega(with_rows), rising(with_rows);
    for (std::size_t member = 0; member < found.size(); ++member)
        for (std::size_t row = 0; row < most; ++row) {
            const std::size_t at = member * most + row;
            const bool is_there = row < found[member].size();
            const Crossing crossing = is_there ? found[member][row] : Crossing{{NAN, NAN, NAN, NAN}, false};
            t.values()[at] = crossing.sample.t;
            theta.values()[at] = crossing.sample.theta;
            omega.values()[at] = crossing.sample.omega;
            rising.values()[at] = crossing.is_rising;
        }
    return {Array{t.value()}, Array{theta.value()}, Array{omega.value()}, Array{rising.value()}};
}

std::tuple<Array, Array, Array, Array> crossings(const Pendulums& p, const Reals& until, const Name& of, const Reals& at,
                                                 const Name& direction, const Number& tolerance, const Threads& threads) {
    EnsembleLevels levels;
    levels.crossed = static_cast<Crossed>(of.among("of", crossed_names));
    levels.direction = static_cast<Direction>(direction.among("direction", direction_names));
    const NamedReals others[] = {{"at", &at.named("at")}, {"until", &until.named("until")}};
    Members members(p, others);
    levels.at = members.column(at);
    levels.until = members.column(until);
    Found found(members.size());
    std::vector<double> lost(members.size());
    members.require(find(members, levels, tolerance.named("tolerance"), threads.number(), found, lost));
    warn_of_nan("crossings", lost, 1);
    return rows_of(found, members.shape());
}

Array measured_period(const Pendulums& p, const Reals& until, const Number& tolerance_given, const Threads& threads_given) {
    const NamedReals others[] = {{"until", &until.named("until")}};
    const double tolerance = tolerance_given.named("tolerance");
    const int threads = threads_given.number();
    Members members(p, others);
    const Column times = members.column(until);
    Output periods(members.shape());
    members.require(run_long(many, [&](const Proceed& proceed) {
        return pendula::measured_period(members.ensemble(), times, tolerance, periods.values(), {threads, proceed});
    }));
    return Array{periods.value()};
}

}  // namespace

void define_crossings(nb::module_& module) {
    define<Reals, Name, Reals, Name, Number, Threads>(
        module, "crossings", crossings, nb::kw_only(), nb::arg("until"), nb::arg("of") = crossed_names[0], nb::arg("at") = 0.0,
        nb::arg("direction") = direction_names[0], nb::arg("tolerance") = Problem{}.tolerance, nb::arg("threads") = nb::none());
    define<Reals, Number, Threads>(module, "measured_period", measured_period, nb::kw_only(), nb::arg("until"),
                                   nb::arg("tolerance") = Problem{}.tolerance, nb::arg("threads") = nb::none());
}

}  // namespace pendula::python
