#include <memory>
#include <new>

#include "arithmetic/pack.hpp"
#include "checks.hpp"
#include "measures/carry.hpp"
#include "pendula/angle.hpp"
#include "pendula/carry.hpp"

namespace pendula {

using arithmetic::abs;

namespace {

constexpr double nan = __builtin_nan("");
constexpr std::size_t attractor_columns = std::size(attractors_columns);

/// What a motion has settled on.
struct Fate {
    double value;  ///< of the swept parameter
    Kind kind;
    double period, rotation, error;
    State point;
};

bool has_orbit(const Fate& fate) noexcept {
    return fate.kind == Kind::fixed_point || fate.kind == Kind::periodic || fate.kind == Kind::rotating;
}

/// Whether two fates agree in what cannot change along a branch.
bool agree(const Fate& a, const Fate& b) noexcept {
    return a.kind == b.kind && (a.kind != Kind::periodic || (a.period == b.period && a.rotation == b.rotation));
}

/// The interval between two neighbours, while it is halved.
struct Cell {
    enum class Stage {
        halving,
        checking,  ///< whether the far end is off the branch if it is approached from the present near end
        found,
        none,
    };
    std::size_t member;  ///< behind the jump
    Fate near, far, last;
    double first_distance = 0;
    int halvings = 0, returns = 0;
    bool near_has_moved = false;  ///< since the far end was measured
    Stage stage = Stage::halving;

    double middle() const noexcept { return 0.5 * near.value + 0.5 * far.value; }
    double error() const noexcept { return 0.5 * abs(far.value - near.value); }
    double trial() const noexcept { return stage == Stage::checking ? far.value : middle(); }
    bool is_active() const noexcept { return stage == Stage::halving || stage == Stage::checking; }
    bool is_narrow(double tolerance) const noexcept {
        return error() <= tolerance || middle() == near.value || middle() == far.value;
    }
};

/// The arguments of one call, and room for the rounds.
struct JumpSearch {
    const Ensemble& ensemble;
    std::size_t line;
    Carry carry;
    const Parameter& swept;
    double tolerance;
    const Strobe& strobe;
    std::span<const std::span<double>> columns;  ///< the results
    Cell* cells;                                 ///< one for each member
    double* inputs;                              ///< parameter_count x members
    double* outputs;                             ///< attractor_columns x members
    std::size_t count = 0;                       ///< number of active cells

    Pendulum pendulum_at(std::size_t member, double value) const noexcept {
        Pendulum pendulum = pendulum_of(ensemble, member);
        pendulum.*swept.value = value;
        return pendulum;
    }

    Fate fate(std::size_t i, std::size_t size, double value) const noexcept {
        const auto column = [&](std::size_t c) { return outputs[c * size + i]; };
        return {value, static_cast<Kind>(column(1)), column(2), column(3), column(6), {column(4), column(5)}};
    }

    /// The smallest distance of a point of one orbit from the other. NaN if the call was stopped.
    double gap(const Fate& a, const Fate& b, std::size_t member, Thread& thread) const noexcept {
        const bool is_longer = a.kind == Kind::periodic && (b.kind != Kind::periodic || a.period > b.period);
        const Fate &orbit = is_longer ? a : b, &other = is_longer ? b : a;
        const Pendulum pendulum = pendulum_at(member, orbit.value);
        const double frequency = strobe_frequency(pendulum);
        const double period = orbit.kind == Kind::periodic ? orbit.period : 1;
        State point = orbit.point;
        double least = __builtin_inf();
        for (double done = 0; done < period; ++done) {
            if (done > 0 && !advance_one_period(pendulum, point, thread)) return nan;
            const double x = abs(wrap(point.theta - other.point.theta)), y = abs(point.omega - other.point.omega) / frequency;
            const double distance = x > y ? x : y;
            least = distance < least ? distance : least;
        }
        return least;
    }

    bool advance_one_period(const Pendulum& pendulum, State& point, Thread& thread) const noexcept {
        Ensemble alone{.size = 1, .theta = point.theta, .omega = point.omega};
        for (const auto& parameter : parameters)
            if (parameter.value) alone.*parameter.column = pendulum.*parameter.value;
        alone.drive_phase = strobe.phase;
        StrobedMembers m;
        load_strobed(m, alone, 0);
        if (!integrate_to_next_strobe(m, {strobe, thread, false})) return false;
        point = {m.chunk.motion.theta[0], m.chunk.motion.omega[0]};
        return true;
    }

    /// How far apart two fates that agree are: their orbits, or else their rotations, as far as these are known.
    double distance(const Fate& a, const Fate& b, std::size_t member, Thread& thread) const noexcept {
        if (has_orbit(a)) return gap(a, b, member, thread);
        const double apart = abs(a.rotation - b.rotation) - (a.error + b.error);
        return apart > 0 ? apart : 0;
    }

    bool is_on_branch(const Cell& cell, const Fate& trial, Thread& thread) const noexcept {
        if (!agree(cell.near, trial)) return false;
        if (!agree(cell.near, cell.far)) return true;
        return distance(cell.near, trial, cell.member, thread) <= distance(trial, cell.far, cell.member, thread);
    }

    /// Decides whether two fates that agree are the ends of one branch, as far as the halvings tell: its ends approach each
    /// other at least as the square root of the length of the interval, a jump stays.
    bool is_one_branch(Cell& cell, Thread& thread) const noexcept {
        const double noise = has_orbit(cell.near) ? 16 * strobe.match : 0;
        const double apart = distance(cell.near, cell.far, cell.member, thread);
        if (cell.halvings == 0) cell.first_distance = apart;
        return !(apart > noise) || (cell.halvings > 0 && apart <= cell.first_distance / 4);
    }

    /// Looks at the present interval, and decides how to go on.
    void proceed_with(Cell& cell, Thread& thread) const noexcept {
        constexpr int least_halvings = 5;  // the fifth leaves less than a quarter of a square root
        const bool do_agree = agree(cell.near, cell.far);
        if (do_agree && is_one_branch(cell, thread))
            cell.stage = Cell::Stage::none;
        else if (cell.is_narrow(tolerance) && (!do_agree || cell.halvings >= least_halvings || cell.error() == 0))
            cell.stage = cell.near_has_moved ? Cell::Stage::checking : Cell::Stage::found;
        else
            cell.stage = Cell::Stage::halving;
    }

    void halve(Cell& cell, const Fate& trial, Thread& thread) const noexcept {
        cell.near_has_moved = is_on_branch(cell, trial, thread);
        (cell.near_has_moved ? cell.near : cell.far) = trial;
        ++cell.halvings;
        proceed_with(cell, thread);
    }

    /// Ends the search if the far end is off the branch also from the present near end; else goes on behind it.
    void check_far_end(Cell& cell, const Fate& trial, Thread& thread) const noexcept {
        constexpr int most_returns = 8;
        if (!is_on_branch(cell, trial, thread)) {
            cell.far = trial;
            cell.stage = Cell::Stage::found;
        } else if (cell.far.value == cell.last.value || ++cell.returns > most_returns) {
            cell.stage = Cell::Stage::none;
        } else {
            cell.near = trial;
            cell.far = cell.last;
            cell.near_has_moved = true;
            proceed_with(cell, thread);
        }
    }

    void judge(Cell& cell, const Fate& trial, Thread& thread) const noexcept {
        cell.stage == Cell::Stage::halving ? halve(cell, trial, thread) : check_far_end(cell, trial, thread);
        if (!cell.is_active()) put(cell, thread);
    }

    /// The interval before a member, from the results of the carried sweep.
    void begin(std::size_t member, Thread& thread) const noexcept {
        const auto fate_of = [&](std::size_t i) { return fate(i, ensemble.size, (ensemble.*swept.column)[i]); };
        const bool is_first = member % line == (carry == Carry::up ? 0 : line - 1);
        const std::size_t neighbour = is_first ? member : carry == Carry::up ? member - 1 : member + 1;
        Cell& cell = cells[member];
        cell = {.member = member, .near = fate_of(neighbour), .far = fate_of(member), .last = fate_of(member)};
        if (cell.near.kind == Kind::lost || cell.near.value == cell.far.value)
            cell.stage = Cell::Stage::none;
        else
            proceed_with(cell, thread);
        if (!cell.is_active()) put(cell, thread);
    }

    void put(const Cell& cell, Thread& thread) const noexcept {
        const bool is_found = cell.stage == Cell::Stage::found;
        const auto put_value = [&](std::size_t c, double x) { columns[c][cell.member] = is_found ? x : nan; };
        const bool has_gap = is_found && has_orbit(cell.near) && has_orbit(cell.far);
        put_value(0, cell.middle());
        put_value(1, cell.error());
        put_value(2, has_gap ? gap(cell.near, cell.far, cell.member, thread) : nan);
        put_value(3, static_cast<double>(cell.near.kind));
        put_value(4, static_cast<double>(cell.far.kind));
    }

    /// Keeps the active cells only.
    void compact() noexcept {
        std::size_t kept = 0;
        for (std::size_t i = 0; i < count; ++i)
            if (cells[i].is_active()) cells[kept++] = cells[i];
        count = kept;
    }

    Ensemble load_trials() const noexcept {
        for (std::size_t i = 0; i < count; ++i) {
            Pendulum pendulum = pendulum_at(cells[i].member, cells[i].trial());
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
        outcome =
            for_each_piece(count, 0, part_of(control, from, from), [&](Thread& thread, std::size_t i) { begin(i, thread); });
        for (compact(); outcome.is_done() && count > 0; compact()) {
            const double to = from + (1 - from) / (all + 1);  // approaches 1 if there are more rounds
            outcome = measure(Measure::attractors, load_trials(), strobe, results_of(count), part_of(control, from, to));
            if (!outcome.is_done()) break;
            outcome = for_each_piece(count, 0, part_of(control, to, to), [&](Thread& thread, std::size_t i) {
                judge(cells[i], fate(i, count, cells[i].trial()), thread);
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
    JumpSearch search{ensemble, line, carry, swept, tolerance, strobe, results.columns(), nullptr, nullptr, nullptr};
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
