#include <unistd.h>

#include "cli/commands.hpp"
#include "cli/reading.hpp"

namespace pendula::cli {

void solve_input(const Options& options) {
    const Layout chosen = layout(options);
    const Method by = method(options);
    const double to = tolerance(options);
    Writer writer{.path = output_path(options)};
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
    while (auto read = read_problem(tokens, number)) {
        read->statement.method = by;
        read->statement.tolerance = to;
        const Prepared prepared = prepare(read->statement, read->place);
        open(writer);
        print_table(writer, prepared, chosen, number++);
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
    const Layout chosen = layout(options);
    Statement statement{.pendulum = pendulum(options),
                        .initial = initial_state(options),
                        .method = method(options),
                        .tolerance = tolerance(options)};
    require_able(statement, chosen);
    read_durations(options, statement);
    Writer writer{.path = output_path(options)};
    const Prepared prepared = prepare(statement, "");
    open(writer);
    print_table(writer, prepared, chosen, 1);
    close(writer);
}

}  // namespace pendula::cli
