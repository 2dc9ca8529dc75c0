#include <algorithm>
#include <memory>
#include <new>

#include "arithmetic/pack.hpp"
#include "checks.hpp"
#include "measures/branches.hpp"
#include "pendula/carry.hpp"

namespace pendula {

using arithmetic::abs;

namespace {

constexpr std::size_t attractor_columns = std::size(attractors_columns);

/// The arguments of one call, and room for the rounds.
struct JumpSearch {
    const Ensemble& ensemble;
    std::size_t line;
    Carry carry;
    const Parameter& swept;
    double tolerance;
    const Strobe& strobe;
    Branches branches;
    std::span<const std::span<double>> columns;  ///< the results
    Cell* cells;                                 ///< one for each member
    double* inputs;                              ///< parameter_count x members
    double* outputs;                             ///< attractor_columns x members
    std::size_t count = 0;                       ///< number of active cells

    Settled settled(std::size_t i, std::size_t size, double value) const noexcept {
        const auto column = [&](std::size_t c) { return outputs[c * size + i]; };
        return {value, static_cast<Kind>(column(1)), column(2), column(3), column(6), {column(4), column(5)}};
    }

    /// The interval before a member, from the results of the carried sweep.
    void begin(std::size_t member, Thread& thread) const noexcept {
        const auto settled_of = [&](std::size_t i) { return settled(i, ensemble.size, (ensemble.*swept.column)[i]); };
        const bool is_first = member % line == (carry == Carry::up ? 0 : line - 1);
        const std::size_t neighbour = is_first ? member : carry == Carry::up ? member - 1 : member + 1;
        Cell& cell = cells[member];
        cell = {.member = member, .near = settled_of(neighbour), .far = settled_of(member), .last = settled_of(member)};
        cell.behind = cell.last;
        if (cell.near.kind == Kind::lost || cell.near.value == cell.far.value)
            cell.stage = Cell::Stage::none;
        else
            branches.proceed_with(cell, thread);
    }

    void put(const Cell& cell, Thread& thread) const noexcept {
        const bool is_found = cell.stage == Cell::Stage::found;
        const auto put_value = [&](std::size_t c, double x) { columns[c][cell.member] = is_found ? x : nan; };
        const bool has_gap = is_found && has_orbit(cell.near) && has_orbit(cell.behind);
        put_value(0, cell.middle());
        put_value(1, cell.error());
        put_value(2, has_gap ? branches.gap(cell.near, cell.behind, cell.member, thread) : nan);
        put_value(3, static_cast<double>(cell.near.kind));
        put_value(4, static_cast<double>(cell.behind.kind));
    }

    /// Goes on by Newton's method as far as that decides, and writes the results when the search has ended.
    void go_on(Cell& cell, Thread& thread) const noexcept {
        while (cell.is_active() && thread.goes_on() && branches.try_newton(cell, thread)) {
        }
        if (!cell.is_active()) put(cell, thread);
    }

    /// Keeps the active cells only.
    void compact() noexcept {
        count = static_cast<std::size_t>(
            std::remove_if(cells, cells + count, [](const Cell& cell) { return !cell.is_active(); }) - cells);
    }

    Ensemble load_trials() const noexcept {
        for (std::size_t i = 0; i < count; ++i) {
            Pendulum pendulum = branches.pendulum_at(cells[i].member, cells[i].trial());
            State initial;
            continue_from(cells[i].near.point, strobe, pendulum, initial);
            for (std::size_t j = 0; j < parameter_count; ++j)
                inputs[j * count + i] = value_of(parameters[j], pendulum, initial);
        }
        Ensemble trials{.size = count};
        for (std::size_t j = 0; j < parameter_count; ++j)
            trials.*parameters[j].column = std::span<const double>(inputs + j * count, count);
        return trials;
    }

    /// The number of rounds that one halving after the other takes.
    double rounds() const noexcept {
        double widest = 0;
        for (std::size_t i = 0; i + 1 < ensemble.size; ++i) {
            const double width = abs((ensemble.*swept.column)[i + 1] - (ensemble.*swept.column)[i]);
            if ((i + 1) % line != 0 && width > widest) widest = width;
        }
        double rounds = 2;
        for (double error = 0.5 * widest; error > tolerance && rounds < 64; error *= 0.5) ++rounds;
        return rounds;
    }

    Outcome run(const Control& control) noexcept {
        std::span<double> results[attractor_columns];
        const auto results_of = [&](std::size_t size) -> Results {
            for (std::size_t c = 0; c < attractor_columns; ++c) results[c] = {outputs + c * size, size};
            return std::span<const std::span<double>>(results);
        };
        const MeasureCall sweep{ensemble, strobe, results_of(ensemble.size).columns()};
        if (const auto refusal = check_carried(Measure::attractors, sweep, line, control)) return refusal;
        const double all = rounds();
        double from = static_cast<double>(line) / (static_cast<double>(line) + all);
        auto outcome =
            measure_carried(Measure::attractors, ensemble, line, carry, strobe, sweep.columns, part_of(control, 0, from));
        if (!outcome.is_done()) return outcome;
        count = ensemble.size;
        outcome = for_each_piece(count, 0, part_of(control, from, from), [&](Thread& thread, std::size_t i) {
            begin(i, thread);
            go_on(cells[i], thread);
        });
        for (compact(); outcome.is_done() && count > 0; compact()) {
            const double to = std::min(from + 1 / (static_cast<double>(line) + all), 1.0);
            outcome = measure(Measure::attractors, load_trials(), strobe, results_of(count), part_of(control, from, to));
            if (!outcome.is_done()) break;
            outcome = for_each_piece(count, 0, part_of(control, to, to), [&](Thread& thread, std::size_t i) {
                branches.judge(cells[i], settled(i, count, cells[i].trial()), thread);
                go_on(cells[i], thread);
            });
            from = to;
        }
        return outcome;
    }
};

Refusal check(const JumpSearch& search) noexcept {
    if (!search.swept.value || search.swept.value == &Pendulum::drive_phase)
        return {.reason = Refusal::Reason::not_among,
                .name = "swept",
                .legal = "alpha, beta, torque, drive_amplitude, pivot_amplitude, drive_frequency"};
    // The name of the setting of a measure is `tolerance`.
    if (const auto refusal = check_rule("jump_tolerance", search.tolerance, Rule::positive)) return refusal;
    for (std::size_t c = 0; c < std::size(jump_columns); ++c) {
        const auto values = c < search.columns.size() ? search.columns[c] : std::span<double>();
        if (const auto refusal = check_length(values, static_cast<double>(search.ensemble.size), jump_columns[c].name))
            return refusal;
    }
    return {};
}

}  // namespace

Outcome locate_jumps(const Ensemble& ensemble, std::size_t line, Carry carry, const Parameter& swept, double tolerance,
                     const Strobe& strobe, const Results& results, const Control& control) noexcept {
    const Branches branches(ensemble, swept, tolerance, strobe);
    JumpSearch search{ensemble, line, carry, swept, tolerance, strobe, branches, results.columns(), nullptr, nullptr, nullptr};
    if (const auto refusal = check(search)) return refusal;
    const std::unique_ptr<Cell[]> cells(new (std::nothrow) Cell[ensemble.size]);
    const std::unique_ptr<double[]> inputs(new (std::nothrow) double[parameter_count * ensemble.size]),
        outputs(new (std::nothrow) double[attractor_columns * ensemble.size]);
    if (!cells || !inputs || !outputs) return Refusal{.reason = Refusal::Reason::memory, .name = "ensemble"};
    search.cells = cells.get();
    search.inputs = inputs.get();
    search.outputs = outputs.get();
    return search.run(control);
}

}  // namespace pendula
