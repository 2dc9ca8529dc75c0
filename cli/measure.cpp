#include "pendula/measure.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <thread>

#include "cli/commands.hpp"
#include "cli/sweep.hpp"
#include "cli/terminal.hpp"
#include "cli/writing.hpp"

namespace pendula::cli {

namespace {

constexpr std::size_t most_points = std::size_t{1} << 20;    // with a row each, that wait to be printed: 24 MiB
constexpr std::size_t most_members = 4096;                   // measured before the first of them is printed
constexpr std::size_t most_compared = std::size_t{1} << 24;  // of a measure that compares its members: 1 GiB

Strobe read_strobe(const MeasureInfo& info, const Options& options) {
    const auto number = [&](std::string_view name, double otherwise) {
        return number_of(options, name, Rule::finite, otherwise);
    };
    Strobe strobe;
    strobe.method = method_of(options);
    strobe.tolerance = tolerance_of(options);
    strobe.transient = number("--transient", strobe.transient);
    strobe.periods = number("--periods", info.periods);
    strobe.steps_per_period = number("--steps", strobe.steps_per_period);
    strobe.match = number("--match", strobe.match);
    return strobe;
}

int read_threads(const Options& options) {
    const double threads = number_of(options, "--threads", Rule::finite, 0);
    if (is_given(options, "--threads") && !(threads >= 1 && threads <= threads_limit && threads == static_cast<int>(threads)))
        throw Failure{
            Status::bad_usage,
            say({.reason = Refusal::Reason::whole, .value = threads, .least = 1, .most = threads_limit}, "--threads")};
    return static_cast<int>(threads);
}

/// A measure of a sweep, from its options to its last row.
struct Run {
    const MeasureInfo& info;
    Sweep sweep;
    Strobe strobe;
    int threads;
    Style style;
    Writer writer;
    std::vector<std::size_t> printed = {};  ///< the columns that have a header
    bool has_points = false;                ///< whether a member has a row for each period
    RowStyle row_style = {};
    ProgressLine progress = {};
    std::size_t done = 0, at_hand = 0;  ///< members printed, and being measured
    std::size_t lost = 0;               ///< members whose motion left the range of doubles, so that results are nan
};

std::string json_head(const Run& run) {
    std::string line = "{\"measure\":" + json_string(run.info.name);
    const Strobe& strobe = run.strobe;
    add_member(line, "method", json_string(method_names[static_cast<std::size_t>(strobe.method)]));
    add_number(line, "transient", strobe.transient);
    add_number(line, "periods", strobe.periods);
    if (strobe.method == Method::rk4) add_number(line, "steps", strobe.steps_per_period);
    if (strobe.method == Method::taylor) add_number(line, "tolerance", strobe.tolerance);
    if (run.info.measure == Measure::attractors) add_number(line, "match", strobe.match);
    for (std::size_t i = 0; i < swept_count; ++i) {
        const Parameter& parameter = swept_parameter(i);
        const bool is_of_length = i >= parameter_count;
        if (run.sweep.has_length ? parameter.value == &Pendulum::alpha : is_of_length) continue;
        const Range& range = run.sweep.values[i];
        if (!range.is_range) {
            add_number(line, parameter.name, range.first);
            continue;
        }
        std::string values = "[";
        values.append(shown(range.first, full)).append(",").append(shown(range.last, full)).append(",");
        values.append(std::to_string(range.count)).append("]");
        add_member(line, parameter.name, values);
    }
    return line + "}\n";
}

void start_output(Run& run) {
    auto names = swept_names(run.sweep);
    for (std::size_t i = 0; i < run.info.columns.size(); ++i) {
        const ResultColumn& column = run.info.columns[i];
        if (column.is_detail) continue;
        names.push_back(column.header ? column.header : column.name);
        run.printed.push_back(i);
        run.has_points |= column.rows == ResultColumn::Rows::periods;
    }
    run.row_style = row_style(names, run.style);
    open(run.writer);
    if (run.style.format == Format::json) return append(run.writer, json_head(run));
    append(run.writer, (run.style.format == Format::text ? "# " : "") + header_line(names, run.style.format));
}

/// How many members are measured before the first of them is printed: enough for all threads, but no more than some seconds of
/// steps, nor points than memory is meant for; and all, where they are compared.
std::size_t block_size(const Run& run) {
    if (run.info.compares_members) return run.sweep.size;
    constexpr double most_steps = 1 << 28;
    const auto processors = static_cast<std::size_t>(std::max(1u, std::thread::hardware_concurrency()));
    const std::size_t threads = run.threads > 0 ? static_cast<std::size_t>(run.threads) : processors;
    const double steps = (run.strobe.transient + run.strobe.periods) * run.strobe.steps_per_period;
    const auto timely = static_cast<std::size_t>(std::min(most_steps / steps, static_cast<double>(most_members)));
    const std::size_t size = std::clamp(timely, std::min(64 * threads, most_members), most_members);
    const double room = static_cast<double>(most_points) / run.strobe.periods;
    return run.has_points && room < static_cast<double>(size) ? std::max<std::size_t>(1, static_cast<std::size_t>(room)) : size;
}

/// The results of the members at hand, a column each. Ends the program where it is interrupted.
std::vector<std::vector<double>> results_of(Run& run, const Ensemble& ensemble, const Strobe& strobe) {
    std::vector<std::vector<double>> columns;
    std::vector<std::span<double>> spans;
    for (const auto& column : run.info.columns)
        spans.emplace_back(columns.emplace_back(rows_of(column, strobe) * ensemble.size));
    const auto proceed = [&run](double fraction) {
        const double members = static_cast<double>(run.done) + fraction * static_cast<double>(run.at_hand);
        return show_and_go_on(run.progress, members / static_cast<double>(run.sweep.size));
    };
    const auto outcome = measure(run.info.measure, ensemble, strobe, std::span<const std::span<double>>(spans),
                                 {.threads = run.threads, .proceed = proceed});
    if (outcome.kind == Outcome::Kind::stopped) flush(run.writer);
    if (outcome.refusal) throw Failure{Status::bad_usage, say(outcome.refusal, name_in_options(run.sweep, outcome.refusal))};
    if (isatty(run.writer.descriptor)) clear(run.progress);
    return columns;
}

/// The rows of a member at hand, number `i` of the results.
void append_rows(Run& run, const std::vector<std::vector<double>>& results, std::size_t i, std::size_t first,
                 std::size_t rows) {
    for (std::size_t row = first; row < rows; ++row) {
        char* at = room(run.writer, run.row_style.leads.size() * field_room);
        at = put_swept(at, run.row_style, run.sweep, run.done + i);
        std::size_t field = run.sweep.ranges.size();
        for (const std::size_t column : run.printed)
            at = put_field(at, run.row_style, field++, results[column][row * run.at_hand + i]);
        commit(run.writer, put_text(at, run.row_style.end));
    }
}

/// Measures the members at hand and prints them one after the other. A single one may have more points than wait to be printed:
/// it then goes on from its last point, which gives the same bits.
void print_block(Run& run) {
    const Members members = members_of(run.sweep, run.done, run.at_hand);
    Ensemble ensemble = members.ensemble;
    Strobe strobe = run.strobe;
    const std::size_t room = most_points / run.at_hand;
    std::size_t known = 0;  // points at the front that were printed before
    for (double left = run.strobe.periods; left > 0; known = 1) {
        strobe.periods = left + static_cast<double>(known);
        if (run.has_points) strobe.periods = std::min(strobe.periods, static_cast<double>(room));
        const auto results = results_of(run, ensemble, strobe);
        left -= strobe.periods - static_cast<double>(known);
        const auto& last_printed = results[run.printed.back()];
        if (std::isnan(last_printed.back())) left = 0;  // a motion that is lost once stays so
        const std::size_t rows = run.has_points ? static_cast<std::size_t>(strobe.periods) : 1;
        for (std::size_t i = 0; i < run.at_hand; ++i) {
            append_rows(run, results, i, known, rows);
            if (left == 0 && run.style.format == Format::text) append(run.writer, lines_behind(run.sweep, run.done + i));
        }
        if (left == 0) {
            const auto ends = std::span(last_printed).last(run.at_hand);
            run.lost += static_cast<std::size_t>(std::ranges::count_if(ends, [](double x) { return std::isnan(x); }));
            break;
        }
        strobe.transient = 0;
        ensemble.theta = results[0].back();
        ensemble.omega = results[1].back();
        ensemble.drive_phase = 0.0;
        flush(run.writer);
    }
}

}  // namespace

void measure(const MeasureInfo& info, const Options& options) {
    Run run{.info = info,
            .sweep = read_sweep(options),
            .strobe = read_strobe(info, options),
            .threads = read_threads(options),
            .style = style_of(options),
            .writer = {.path = output_path(options)}};
    if (info.compares_members && run.sweep.size > most_compared)
        throw bad_usage({"{0} compares its pendulums and takes at most {1} at once; the ranges make {2}",
                         "{0} compara sus péndulos y toma a la vez {1} como mucho; los rangos dan {2}"},
                        {hyphenated(info.name), std::to_string(most_compared), std::to_string(run.sweep.size)});
    require_each(run.sweep, [&run](const Pendulum& pendulum) { return check(pendulum, run.strobe); });
    start_output(run);
    for (const std::size_t size = block_size(run); run.done < run.sweep.size; run.done += run.at_hand) {
        run.at_hand = std::min(size, run.sweep.size - run.done);
        print_block(run);
        flush(run.writer);
    }
    close(run.writer);
    if (run.lost > 0)
        throw Failure{Status::bad_data,
                      say({"the motion of {0} of {1} pendulums leaves the range of doubles; their results are nan",
                           "el movimiento de {0} de {1} péndulos se sale del rango de double; sus resultados son nan"},
                          {std::to_string(run.lost), std::to_string(run.sweep.size)})};
}

}  // namespace pendula::cli
