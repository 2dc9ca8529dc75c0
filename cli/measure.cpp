#include "pendula/measure.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <thread>

#include "cli/commands.hpp"
#include "cli/sweep.hpp"
#include "cli/terminal.hpp"

namespace pendula::cli {

namespace {

constexpr std::size_t most_points = std::size_t{1} << 20;  // of a section, that wait to be printed: 24 MiB
constexpr std::size_t most_members = 4096;                 // measured before the first of them is printed

double whole(const Options& options, std::string_view name, double least, double most, double otherwise) {
    if (!is_given(options, name)) return otherwise;
    const double n = number(options, name, Rule::finite, 0);
    if (!(n >= least && n <= most && n == std::floor(n)))
        refuse_value(
            options, name,
            say({"it must be a whole number from {0} to {1}", "debe ser un entero de {0} a {1}"}, {shown(least), shown(most)}));
    return n;
}

Strobe strobe(const Options& options, double periods) {
    constexpr std::string_view words[] = {"rk4", "taylor"};
    const bool is_taylor = choice(options, "--method", words) == 1;
    if (is_taylor && is_given(options, "--steps"))
        throw Failure{Status::bad_usage, say({"--steps goes with --method rk4", "--steps va con --method rk4"})};
    if (!is_taylor && is_given(options, "--tolerance"))
        throw Failure{Status::bad_usage, say({"--tolerance goes with --method taylor", "--tolerance va con --method taylor"})};
    return {.transient = whole(options, "--transient", 0, 1e15, 200),
            .periods = whole(options, "--periods", 1, 1e15, periods),
            .steps_per_period = whole(options, "--steps", 1, 1e15, 1000),
            .method = is_taylor ? Method::taylor : Method::rk4,
            .tolerance = number(options, "--tolerance", Rule::fraction, 1e-15)};
}

void require_feasible(const Sweep& swept, const Strobe& strobe) {
    double fewest = 0;
    for (const auto& p : corners(swept)) fewest = std::max(fewest, fewest_steps(p));
    const bool is_rk4 = strobe.method == Method::rk4;
    if (is_rk4 && !(strobe.steps_per_period >= fewest))
        throw Failure{Status::bad_usage,
                      say({"with so much friction or stiffness rk4 is stable from {0} steps a period on; --steps is {1}",
                           "con tanto rozamiento o rigidez, rk4 es estable desde {0} pasos por periodo; --steps es {1}"},
                          {shown(fewest), shown(strobe.steps_per_period)})};
    const double periods = static_cast<double>(swept.size) * (strobe.transient + strobe.periods);
    const double steps = periods * (is_rk4 ? strobe.steps_per_period : fewest);
    if (steps > 0x1p53)
        throw Failure{Status::bad_data, say({"it would take {0} steps, more than 2^53 = 9007199254740992",
                                             "daría {0} pasos, más de 2^53 = 9007199254740992"},
                                            {shown(steps)})};
}

/// One run of a command, from its options to its last row.
struct Run {
    std::string_view name;
    Sweep swept;
    Strobe strobe;
    Control control;
    Layout layout;
    std::vector<std::string_view> results;  ///< names of the columns behind the swept ones
    Writer writer;
    Progress progress = {};
    RowStyle style = {};
    std::size_t done = 0, at_hand = 0;  ///< members printed, and in the block being measured

    void put_head();
    void put_row(std::size_t member, std::initializer_list<double> values);
    void end_member(std::size_t member);
    void require(bool was_finished);
};

std::string json_head(const Run& run) {
    std::string line = "{\"measure\":" + json_string(run.name);
    const auto digits = [](double value) {
        char room[number_room];
        return std::string(room, put_number(room, value, full));
    };
    const auto add = [&](std::string_view name, const std::string& text) {
        line.append(",\"").append(name).append("\":").append(text);
    };
    add("method", json_string(method_names[static_cast<std::size_t>(run.strobe.method)]));
    add("transient", digits(run.strobe.transient));
    add("periods", digits(run.strobe.periods));
    if (run.strobe.method == Method::rk4) add("steps", digits(run.strobe.steps_per_period));
    if (run.strobe.method == Method::taylor) add("tolerance", digits(run.strobe.tolerance));
    for (const auto& p : run.swept.parameters) {
        const bool is_of_length = p.column == "gravity" || p.column == "length";
        if (run.swept.has_length ? p.column == "alpha" : is_of_length) continue;
        const auto range = [&] { return '[' + digits(p.first) + ',' + digits(p.last) + ',' + std::to_string(p.count) + ']'; };
        add(p.column, p.is_range ? range() : digits(p.first));
    }
    return line + "}\n";
}

void Run::put_head() {
    std::vector<std::string_view> names;
    for (const auto range : swept.ranges) names.push_back(swept.parameters[range].column);
    names.insert(names.end(), results.begin(), results.end());
    style = row_style(names, layout.format, layout.precision);
    open(writer);
    if (layout.format == Format::json) return put(writer, json_head(*this));
    std::string header = layout.format == Format::text ? "#" : "";
    for (const auto column : names) {
        if (layout.format == Format::text || !header.empty()) header += layout.format == Format::csv ? ',' : ' ';
        header += column;
    }
    put(writer, header + '\n');
}

void Run::put_row(std::size_t member, std::initializer_list<double> values) {
    constexpr std::size_t field_room = number_room + 32;
    char* end = room(writer, (swept_count + values.size()) * field_room);
    std::size_t field = 0;
    for (const auto range : swept.ranges)
        end = put_field(end, style, field++, value(swept.parameters[range], place(swept, range, member)));
    for (const double x : values) end = put_field(end, style, field++, x);
    commit(writer, put_text(end, style.end));
}

/// gnuplot's grids: an empty line wherever the last of several ranges ends, one more wherever the one before it does, ...
void Run::end_member(std::size_t member) {
    if (layout.format != Format::text) return;
    std::size_t length = 1;
    for (std::size_t i = swept.ranges.size(); i-- > 1;) {
        length *= swept.parameters[swept.ranges[i]].count;
        if ((member + 1) % length == 0) put(writer, "\n");
    }
}

/// After a measure: either it was finished, or interrupted.
void Run::require(bool was_finished) {
    if (!was_finished) flush(writer);
    if (isatty(writer.descriptor)) clear(progress);
}

/// Tells how far the whole is, and stops it on an interruption.
bool proceed(void* context, double fraction) noexcept {
    auto& run = *static_cast<Run*>(context);
    if (is_interrupted()) return false;
    if (is_due(run.progress))
        show(run.progress, (static_cast<double>(run.done) + fraction * static_cast<double>(run.at_hand)) /
                               static_cast<double>(run.swept.size));
    return true;
}

/// A section of the members at hand, printed member by member. A single one may have more points than wait to be printed: it
/// then goes on from its last point, which gives the same bits.
void print_section(Run& run) {
    auto some = members(run.swept, run.done, run.at_hand);
    const std::size_t size = run.at_hand;
    Strobe strobe = run.strobe;
    double known = 0;  // points at the front that were printed before
    for (double left = run.strobe.periods; left > 0; known = 1) {
        strobe.periods = std::min(left + known, static_cast<double>(most_points / size));
        const auto rows = static_cast<std::size_t>(strobe.periods);
        std::vector<double> theta(rows * size), omega(rows * size), turns(rows * size);
        run.require(section(some.ensemble(), strobe, run.control, {theta.data(), omega.data(), turns.data()}));
        left -= strobe.periods - known;
        for (std::size_t i = 0; i < size; ++i) {
            for (auto row = static_cast<std::size_t>(known); row < rows; ++row)
                run.put_row(run.done + i, {theta[row * size + i], omega[row * size + i]});
            if (left == 0) run.end_member(run.done + i);
        }
        strobe.transient = 0;
        some.theta = {theta.back()};
        some.omega = {omega.back()};
        some.drive_phase = {0};
        if (left > 0) flush(run.writer);
    }
}

void print_velocities(Run& run) {
    std::vector<double> velocity(run.at_hand);
    const auto some = members(run.swept, run.done, run.at_hand);
    run.require(mean_velocity(some.ensemble(), run.strobe, run.control, velocity.data()));
    for (std::size_t i = 0; i < run.at_hand; ++i) {
        run.put_row(run.done + i, {velocity[i]});
        run.end_member(run.done + i);
    }
}

void print_exponents(Run& run) {
    std::vector<double> exponent(run.at_hand), error(run.at_hand), horizon(run.at_hand);
    const auto some = members(run.swept, run.done, run.at_hand);
    run.require(lyapunov(some.ensemble(), run.strobe, run.control, {exponent.data(), error.data(), horizon.data()}));
    for (std::size_t i = 0; i < run.at_hand; ++i) {
        run.put_row(run.done + i, {exponent[i], error[i], horizon[i]});
        run.end_member(run.done + i);
    }
}

/// How many members are measured before the first of them is printed: enough for all threads, but no more than some seconds of
/// steps, nor points than memory is meant for.
std::size_t block_size(const Run& run, bool keeps_points) {
    constexpr double most_steps = 1 << 28;
    const auto processors = static_cast<std::size_t>(std::max(1u, std::thread::hardware_concurrency()));
    const std::size_t threads = run.control.threads > 0 ? static_cast<std::size_t>(run.control.threads) : processors;
    const double steps = (run.strobe.transient + run.strobe.periods) * run.strobe.steps_per_period;
    const double timely = std::min(most_steps / steps, static_cast<double>(most_members));
    const std::size_t size = std::clamp(static_cast<std::size_t>(timely), std::min(64 * threads, most_members), most_members);
    const double room = static_cast<double>(most_points) / run.strobe.periods;
    return keeps_points && room < static_cast<double>(size) ? std::max<std::size_t>(1, static_cast<std::size_t>(room)) : size;
}

}  // namespace

void measure(Command command, const Options& options) {
    const bool is_section = command == sections;
    const auto print = is_section ? print_section : command == velocities ? print_velocities : print_exponents;
    Run run{.name = std::ranges::find(commands, command, &CommandName::command)->name,
            .swept = sweep(options),
            .strobe = strobe(options, command == exponents ? 1000 : 100),
            .layout = layout(options),
            .writer = {.path = output_path(options)}};
    run.control = {static_cast<int>(whole(options, "--threads", 1, 256, 0)), proceed, &run};
    require_feasible(run.swept, run.strobe);
    if (is_section) run.results = {"theta", "omega"};
    if (command == velocities) run.results = {"velocity"};
    if (command == exponents) run.results = {"lyapunov", "error", "horizon"};
    run.put_head();
    for (const std::size_t size = block_size(run, is_section); run.done < run.swept.size; run.done += run.at_hand) {
        run.at_hand = std::min(size, run.swept.size - run.done);
        print(run);
        flush(run.writer);
    }
    close(run.writer);
}

}  // namespace pendula::cli
