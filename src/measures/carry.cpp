#include "pendula/carry.hpp"

#include <algorithm>
#include <memory>
#include <new>
#include <string_view>

#include "arithmetic/pack.hpp"
#include "checks.hpp"
#include "measures/carry.hpp"

namespace pendula {

namespace {

constexpr std::size_t most_columns = 16;
constexpr double units_of_member = 1000;  // of progress

/// The place of the column `name`; every measure has theta and omega.
std::size_t place_of(const MeasureInfo& info, std::string_view name) noexcept {
    std::size_t place = 0;
    while (info.columns[place].name != name) ++place;
    return place;
}

/// The arguments of one call of `measure_carried`, and what follows from them.
struct CarriedCall {
    MeasureCall call;
    const MeasureInfo& info;
    std::size_t line;
    Carry carry;
    std::size_t theta = place_of(info, "theta"), omega = place_of(info, "omega");
    bool is_out_of_memory = false;

    std::size_t lines() const noexcept { return call.ensemble.size / line; }
    std::size_t rows(std::size_t column) const noexcept { return rows_of(info.columns[column], call.strobe); }
    /// The number of doubles that one line needs.
    std::size_t width() const noexcept {
        std::size_t width = parameter_count;
        for (std::size_t column = 0; column < info.columns.size(); ++column) width += rows(column);
        return width;
    }
};

/// Some lines, and room for one member of each.
struct Lines {
    CarriedCall& carried;
    std::size_t first, count;
    double* inputs;   ///< parameter_count x count
    double* outputs;  ///< the rows of all columns x count

    std::size_t member(std::size_t i, std::size_t k) const noexcept { return (first + i) * carried.line + k; }

    /// The last row of a column in the present outputs.
    const double* last_of(std::size_t place) const noexcept {
        std::size_t rows = 0;
        for (std::size_t column = 0; column <= place; ++column) rows += carried.rows(column);
        return outputs + (rows - 1) * count;
    }

    /// The k-th members, each from the end of its neighbour.
    Ensemble load(std::size_t k, bool has_neighbour) const noexcept {
        const MeasureCall& call = carried.call;
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t number = member(i, k);
            auto pendulum = pendulum_of(call.ensemble, number);
            auto initial = initial_state_of(call.ensemble, number);
            if (has_neighbour)
                continue_from({last_of(carried.theta)[i], last_of(carried.omega)[i]}, call.strobe, pendulum, initial);
            for (std::size_t j = 0; j < parameter_count; ++j)
                inputs[j * count + i] = value_of(parameters[j], pendulum, initial);
        }
        Ensemble members{.size = count};
        for (std::size_t j = 0; j < parameter_count; ++j)
            members.*parameters[j].column = std::span<const double>(inputs + j * count, count);
        return members;
    }

    void store(std::size_t k) const noexcept {
        const double* from = outputs;
        for (std::size_t column = 0; column < carried.info.columns.size(); ++column)
            for (std::size_t row = 0; row < carried.rows(column); ++row, from += count)
                for (std::size_t i = 0; i < count; ++i) carried.call.set(column, row, member(i, k), from[i]);
    }

    /// Measures the lines, one member after the other.
    void measure_all(Thread& thread, int threads) const noexcept {
        std::span<double> columns[most_columns];
        double* to = outputs;
        for (std::size_t column = 0; column < carried.info.columns.size(); ++column) {
            columns[column] = {to, carried.rows(column) * count};
            to += columns[column].size();
        }
        const Results results(std::span<const std::span<double>>(columns, carried.info.columns.size()));
        for (std::size_t done = 0; done < carried.line; ++done) {
            const std::size_t k = carried.carry == Carry::up ? done : carried.line - 1 - done;
            double told = 0;
            const double all = units_of_member * static_cast<double>(count);
            const auto tell = [&thread, &told, all](double part) {
                const double now = arithmetic::floor(part * all);
                thread.report(now - told);
                told = now;
                return thread.goes_on();
            };
            const auto outcome =
                measure(carried.info.measure, load(k, done > 0), carried.call.strobe, results, {threads, tell});
            if (outcome.kind == Outcome::Kind::refused) __atomic_store_n(&carried.is_out_of_memory, true, __ATOMIC_RELAXED);
            if (!outcome.is_done()) return;
            store(k);
            tell(1);
        }
    }
};

}  // namespace

void continue_from(State end, const Strobe& strobe, Pendulum& pendulum, State& initial) noexcept {
    if (!satisfies(Rule::finite, end.theta) || !satisfies(Rule::finite, end.omega)) return;
    initial = {end.omega == 0 ? end.theta + 0x1p-26 : end.theta, end.omega};
    pendulum.drive_phase = strobe.phase;
}

Refusal check_carried(Measure what, const MeasureCall& call, std::size_t line, const Control& control) noexcept {
    if (const auto refusal = check(what, call, control)) return refusal;
    if (const auto refusal = check_count("line", static_cast<double>(line), 1)) return refusal;
    const std::size_t size = call.ensemble.size, lines = (size + line - 1) / line;
    if (size % line != 0)
        return {.reason = Refusal::Reason::length,
                .name = "ensemble",
                .value = static_cast<double>(size),
                .least = static_cast<double>(lines * line)};
    if (what == Measure::section && call.strobe.plane != Plane::strobe)
        return {.reason = Refusal::Reason::not_among, .name = "plane", .legal = "strobe"};
    return {};
}

Outcome measure_carried(Measure what, const Ensemble& ensemble, std::size_t line, Carry carry, const Strobe& strobe,
                        const Results& results, const Control& control) noexcept {
    const MeasureCall call{ensemble, strobe, results.columns()};
    if (const auto refusal = check_carried(what, call, line, control)) return refusal;
    const MeasureInfo& info = measures[static_cast<int>(what)];
    CarriedCall carried{call, info, line, carry};
    const std::size_t width = carried.width(), lines = carried.lines();
    const std::unique_ptr<double[]> room(new (std::nothrow) double[width * lines]);
    if (!room) return Refusal{.reason = Refusal::Reason::memory, .name = "ensemble"};
    // Groups of lines do not wait for each other. Members that are compared with each other are in one group.
    const std::size_t group = info.compares_members ? std::max<std::size_t>(lines, 1) : std::size_t{kernels::chunk_size};
    const std::size_t groups = (lines + group - 1) / group;
    const double units = units_of_member * static_cast<double>(ensemble.size);
    const auto outcome = for_each_piece(groups, units, control, [&](Thread& thread, std::size_t piece) {
        const std::size_t first = piece * group, count = std::min(group, lines - first);
        double* const inputs = room.get() + first * width;
        const Lines together{carried, first, count, inputs, inputs + parameter_count * count};
        together.measure_all(thread, groups == 1 ? control.threads : 1);
    });
    if (carried.is_out_of_memory) return Refusal{.reason = Refusal::Reason::memory, .name = "ensemble"};
    return outcome;
}

}  // namespace pendula
