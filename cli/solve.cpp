#include <unistd.h>

#include <algorithm>

#include "cli/commands.hpp"
#include "cli/reading.hpp"
#include "cli/sweep.hpp"
#include "cli/table.hpp"

namespace pendula::cli {

namespace {

std::vector<TableColumn> read_columns(const Options& options) {
    std::vector<TableColumn> chosen;
    if (!is_given(options, "--columns")) return chosen;
    auto rest = text_of(options, "--columns");
    for (bool is_last = false; !is_last;) {
        const std::size_t comma = rest.find(',');
        is_last = comma == std::string_view::npos;
        const auto word = rest.substr(0, comma);
        const auto column = static_cast<TableColumn>(pick(options, "--columns", word, column_names));
        if (std::ranges::count(chosen, column))
            refuse_value(options, "--columns", say({"{0} stands there twice", "{0} está dos veces"}, {word}));
        chosen.push_back(column);
        rest.remove_prefix(is_last ? rest.size() : comma + 1);
    }
    return chosen;
}

Layout read_layout(const Options& options) {
    return {read_columns(options), style_of(options), !is_given(options, "--dry-run")};
}

void read_duration(const Options& options, std::string_view factor, std::string_view time, Duration& duration) {
    refuse_both(options, factor, time);
    if (is_given(options, factor)) duration = {number_of(options, factor, Rule::positive, 0), true};
    if (is_given(options, time)) duration = {number_of(options, time, Rule::positive, 0), false};
}

Durations read_durations(const Options& options) {
    Durations durations;
    read_duration(options, "--dt-factor", "--dt", durations.dt);
    read_duration(options, "--every-factor", "--every", durations.every);
    read_duration(options, "--until-factor", "--until", durations.until);
    return durations;
}

/// A dry run has no rows, and its headers are no reason to write over those of an earlier run.
Writer writer_of(const Options& options, const Layout& layout) {
    std::string path = output_path(options);
    if (!layout.has_rows && !path.empty()) {
        tell(say({"--dry-run leaves {0} as it is and prints to standard output",
                  "--dry-run deja {0} como está y escribe en la salida estándar"},
                 {in_quotes(path)}));
        path.clear();
    }
    return {.path = std::move(path)};
}

void solve_one(Writer& writer, const Statement& statement, const Layout& layout, std::size_t number) {
    const Prepared prepared = prepare(statement);
    require_columns(prepared, layout);
    open(writer);
    if (prepared.problem.schedule.rows == 1)
        tell(prepared.source.place + say({"the time between rows is longer than the run: there is one row",
                                          "el tiempo entre filas es mayor que la simulación: hay una sola fila"}));
    print_table(writer, prepared, layout, number);
}

}  // namespace

void solve_input(const Options& options) {
    const Layout layout = read_layout(options);
    const Method method = method_of(options, method_names);
    const double tolerance = tolerance_of(options);
    Writer writer = writer_of(options, layout);
    if (isatty(STDIN_FILENO))
        tell(
            say({"type problems, eight values each, and end with Ctrl-D:\n"
                 "  factorΔ factorcout factortSimul θ0 r|s ω0 r|s α\n"
                 "  times are factors of the period; r: radians, s: degrees; for example\n"
                 "  0.0001 0.02 1 90 s 0 r 1",
                 "escribe problemas, cada uno de ocho valores, y termina con Ctrl-D:\n"
                 "  factorΔ factorcout factortSimul θ0 r|s ω0 r|s α\n"
                 "  los tiempos son factores del periodo; r: radianes, s: grados; por ejemplo\n"
                 "  0.0001 0.02 1 90 s 0 r 1"}));
    Tokens tokens;
    std::size_t number = 1;
    for (; auto statement = read_problem(tokens, number); ++number) {
        statement->method = method;
        statement->tolerance = tolerance;
        solve_one(writer, *statement, layout, number);
    }
    if (number == 1)
        throw Failure{
            Status::bad_data,
            say({"standard input holds no problem; one looks like this: 0.0001 0.02 1 90 s 0 r 1 (see pendula --help)",
                 "la entrada estándar no trae ningún problema; uno es así: 0.0001 0.02 1 90 s 0 r 1 (consulta pendula "
                 "--help)"})};
    close(writer);
}

void solve_options(const Options& options) {
    const Layout layout = read_layout(options);
    const Sweep sweep = read_sweep(options);
    require_theta0(options);
    require_single(options, sweep);
    require_each(sweep, [](const Pendulum& pendulum) { return check(pendulum); });
    const Statement statement{.pendulum = pendulum_of(sweep, 0),
                              .initial = initial_state_of(sweep, 0),
                              .method = method_of(options, method_names),
                              .tolerance = tolerance_of(options),
                              .durations = read_durations(options)};
    Writer writer = writer_of(options, layout);
    solve_one(writer, statement, layout, 1);
    close(writer);
}

}  // namespace pendula::cli
