#include "pendula/measure.hpp"

#include <algorithm>
#include <cmath>
#include <thread>

#include "cli/commands.hpp"
#include "cli/measuring.hpp"

namespace pendula::cli {

namespace {

int read_threads(const Options& options) {
    const double threads = number_of(options, "--threads", Rule::finite, 0);
    if (is_given(options, "--threads") && !(threads >= 1 && threads <= threads_limit && threads == static_cast<int>(threads)))
        throw Failure{
            Status::bad_usage,
            say({.reason = Refusal::Reason::whole, .value = threads, .least = 1, .most = threads_limit}, "--threads")};
    return static_cast<int>(threads);
}

/// Refuses a line of members that start from each other, where there is none.
void require_line(const Run& run) {
    if (run.sweep.ranges.empty())
        throw bad_usage({"--carry needs a range to go along, as --torque 0:2:201",
                         "--carry necesita un rango que recorrer, como --torque 0:2:201"});
    const Parameter& last = swept_parameter(run.sweep.ranges.back());
    if (last.initial || last.value == &Pendulum::drive_phase)
        throw bad_usage({"--carry goes along the last range, and {0} is only where a motion starts; give another range last",
                         "--carry recorre el último rango, y {0} es solo donde empieza un movimiento; pon otro rango al final"},
                        {option_of(last.name)});
    if (run.strobe.plane != Plane::strobe)
        throw bad_usage({"{0} does not go with --plane {1}", "{0} no va con --plane {1}"},
                        {"--carry", plane_names[static_cast<std::size_t>(run.strobe.plane)]});
}

void read_carry(Run& run, const Options& options) {
    if (!is_given(options, "--carry")) {
        if (is_given(options, "--locate"))
            throw bad_usage({"--locate needs --carry up, down or both", "--locate necesita --carry up, down o both"});
        return;
    }
    constexpr Carry passes[] = {Carry::up, Carry::down};
    const std::size_t which = choice(options, "--carry", carried_names);
    const bool is_both = which == std::size(passes);
    run.carries.assign(passes + (is_both ? 0 : which), passes + (is_both ? 2 : which + 1));
    require_line(run);
    if (!is_given(options, "--locate")) return;
    for (const auto* name : {"--details", "--shares"}) refuse_both(options, "--locate", name);
    run.locate = number_of(options, "--locate", Rule::positive, 0);
    if (run.sweep.ranges.back() >= parameter_count)
        throw bad_usage({"--locate needs a range of --alpha, not of {0}", "--locate necesita un rango de --alpha, no de {0}"},
                        {option_of(swept_parameter(run.sweep.ranges.back()).name)});
}

/// Whether a member with many points can go on from its last one: at a time of the strobe, and no times or turns are printed.
bool can_go_on(const Run& run) { return run.carries.empty() && run.strobe.plane == Plane::strobe && !run.has_details; }

/// Refuses more members and points than fit in memory where they belong together.
void require_memory(const Run& run) {
    if (run.info.compares_members && run.sweep.size > most_together)
        throw bad_usage({"{0} compares its pendulums and takes at most {1} at once; the ranges make {2}",
                         "{0} compara sus péndulos y toma a la vez {1} como mucho; los rangos dan {2}"},
                        {hyphenated(run.info.name), std::to_string(most_together), std::to_string(run.sweep.size)});
    const double line = run.carries.empty() ? 1 : static_cast<double>(line_of(run));
    const double rows = line * (run.has_points ? run.strobe.periods : 1);
    if (!can_go_on(run) && rows > static_cast<double>(most_together))
        throw bad_usage({"{0} rows are made in one piece, which takes at most {1}; ask for fewer --periods or a shorter range",
                         "{0} filas se hacen de una vez, y caben {1} como mucho; pide menos --periods o un rango más corto"},
                        {shown(rows), std::to_string(most_together)});
}

/// How many members are measured before the first of them is printed: enough for all threads, but no more than some seconds of
/// steps, nor points than memory is meant for; whole lines, where they are carried; and all, where they are compared.
std::size_t block_size(const Run& run) {
    constexpr std::size_t most_members = 4096;
    constexpr double most_steps = 1 << 28;
    if (run.info.compares_members) return run.sweep.size;
    const auto processors = static_cast<std::size_t>(std::max(1u, std::thread::hardware_concurrency()));
    const std::size_t threads = run.threads > 0 ? static_cast<std::size_t>(run.threads) : processors;
    const double points = run.has_points ? run.strobe.periods : 1;
    const double room = static_cast<double>(most_points) / points;
    if (!run.carries.empty()) {
        const double lines = std::min(room / static_cast<double>(line_of(run)), static_cast<double>(16 * threads));
        return std::max<std::size_t>(1, static_cast<std::size_t>(lines)) * line_of(run);
    }
    const double measured = run.strobe.transient + run.strobe.periods;
    const double steps = (run.has_points ? measured : std::max(measured, run.strobe.budget)) * run.strobe.steps_per_period;
    const auto timely = static_cast<std::size_t>(std::min(most_steps / steps, static_cast<double>(most_members)));
    const std::size_t size = std::clamp(timely, std::min(64 * threads, most_members), most_members);
    return room < static_cast<double>(size) ? std::max<std::size_t>(1, static_cast<std::size_t>(room)) : size;
}

/// The columns in front of the results: which carry, and the ranges.
std::vector<std::string> names_of(Run& run) {
    std::vector<std::string> names;
    if (run.carries.size() == 2) names.emplace_back(carry_setting.name);
    for (auto& name : swept_names(run.sweep)) names.push_back(std::move(name));
    for (const std::size_t i : run.printed) {
        const ResultColumn& column = run.info.columns[i];
        names.emplace_back(column.header ? column.header : column.name);
    }
    return names;
}

/// The rows of a member at hand, number `i` of the results.
void append_rows(Run& run, const Columns& results, std::size_t i, std::size_t first, std::size_t rows) {
    for (std::size_t row = first; row < rows; ++row) {
        char* at = room(run.writer, run.row_style.leads.size() * field_room);
        std::size_t field = 0;
        if (run.carries.size() == 2)
            at = put_word(at, run.row_style, field++, carry_names[static_cast<std::size_t>(run.carries[run.pass])]);
        at = put_swept(at, run.row_style, run.sweep, run.done + i, field);
        field += run.sweep.ranges.size();
        for (const std::size_t column : run.printed)
            at = put_value(at, run.row_style, field++, run.info.columns[column], results[column][row * run.at_hand + i]);
        commit(run.writer, put_text(at, run.row_style.end));
    }
}

/// Measures the members at hand and prints them one after the other. A single one may have more points than wait to be printed:
/// where it can, it then goes on from its last point, which gives the same bits.
void print_block(Run& run) {
    const Members members = members_of(run.sweep, run.done, run.at_hand);
    Ensemble ensemble = members.ensemble;
    Strobe strobe = run.strobe;
    const std::size_t room = most_points / run.at_hand;
    std::size_t known = 0;  // points at the front that were printed before
    for (double left = run.strobe.periods; left > 0; known = 1) {
        strobe.periods = left + static_cast<double>(known);
        if (run.has_points && can_go_on(run)) strobe.periods = std::min(strobe.periods, static_cast<double>(room));
        const auto results = results_of(run, ensemble, strobe);
        left -= strobe.periods - static_cast<double>(known);
        if (std::isnan(results[run.printed.back()].back())) left = 0;  // a motion that is lost once stays so
        const std::size_t rows = run.has_points ? static_cast<std::size_t>(strobe.periods) : 1;
        for (std::size_t i = 0; i < run.at_hand; ++i) {
            append_rows(run, results, i, known, rows);
            if (left == 0 && run.style.format == Format::text) append(run.writer, lines_behind(run.sweep, run.done + i));
        }
        if (left == 0) return count_gaps(run, results, rows - 1);
        strobe.transient = 0;
        ensemble.theta = results[0].back();
        ensemble.omega = results[1].back();
        ensemble.drive_phase = strobe.phase;
        flush(run.writer);
    }
}

void print_pass(Run& run) {
    run.done = 0;
    for (const std::size_t size = block_size(run); run.done < run.sweep.size; run.done += run.at_hand) {
        run.at_hand = std::min(size, run.sweep.size - run.done);
        (run.locate ? print_jumps : run.has_shares ? print_shares : print_block)(run);
        flush(run.writer);
    }
}

}  // namespace

void measure(const MeasureInfo& info, const Options& options) {
    Sweep sweep = read_sweep(options);
    const Strobe strobe = read_strobe(info, options);
    const int threads = read_threads(options);
    const Style style = style_of(options);
    Run run{.info = info, .sweep = std::move(sweep), .strobe = strobe, .threads = threads, .style = style};
    run.writer.path = output_path(options);
    run.has_details = is_given(options, "--details");
    run.has_shares = is_given(options, "--shares");
    refuse_both(options, "--shares", "--details");
    refuse_both(options, "--shares", "--carry");
    for (std::size_t i = 0; i < info.columns.size(); ++i) {
        const ResultColumn& column = info.columns[i];
        if (column.is_detail && !(run.has_details && is_detail(column))) continue;
        run.printed.push_back(i);
        run.has_points |= column.rows == ResultColumn::Rows::periods;
    }
    read_carry(run, options);
    require_memory(run);
    require_each(run.sweep, [&run](const Pendulum& pendulum) { return check(pendulum, run.strobe); });
    start_output(run, run.locate ? jump_names(run) : run.has_shares ? share_names(run) : names_of(run));
    do {
        if (run.pass > 0 && run.style.format == Format::text) append(run.writer, "\n\n");  // gnuplot's index
        print_pass(run);
    } while (++run.pass < run.carries.size());
    close(run.writer);
    tell_gaps(run);
}

}  // namespace pendula::cli
