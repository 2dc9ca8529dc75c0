#include <algorithm>
#include <bit>

#include "cli/settings.hpp"

namespace pendula::cli {

namespace {

constexpr unsigned all_solutions = solve_input_command | solve_command;
constexpr unsigned all_but_input = solve_command | analyze_command | measure_commands;
constexpr unsigned all_commands = all_but_input | solve_input_command;

/// The commands that take a parameter; analyze takes what the equation of a free pendulum has, and alone the period.
unsigned takers(const Parameter& parameter) {
    const bool is_forcing = parameter.value && parameter.value != &Pendulum::alpha;
    if (std::string_view(parameter.name) == "tau") return analyze_command;
    return is_forcing ? solve_command | measure_commands : all_but_input;
}

/// "100, lyapunov 1000", of the measures that use a setting.
std::string default_periods(const Setting& setting) {
    std::string text = shown(measures[0].periods);
    for (const auto& info : measures)
        if (info.periods != measures[0].periods && (setting.measures & bits_of({info.measure})))
            text += ", " + hyphenated(info.name) + ' ' + shown(info.periods);
    return text;
}

}  // namespace

const MeasureInfo* measure_of(Command command) {
    return command < first_measure_command ? nullptr : &measures[std::countr_zero(command / first_measure_command)];
}

std::optional<Command> command_named(std::string_view name) {
    if (name == "solve") return solve_command;
    if (name == "analyze") return analyze_command;
    for (const auto& info : measures)
        if (name == hyphenated(info.name)) return command_of(info);
    return {};
}

std::vector<std::string> command_names() {
    std::vector<std::string> names{"solve", "analyze"};
    for (const auto& info : measures) names.push_back(hyphenated(info.name));
    return names;
}

std::string typed_commands(unsigned mask, const std::string& lead) {
    std::vector<std::string> typed;
    if (mask & solve_input_command) typed.push_back("pendula");
    for (const auto& name : command_names())
        if (const auto command = command_named(name); command && (mask & *command)) typed.push_back(lead + name);
    return joined(typed);
}

std::string hyphenated(std::string_view name) {
    std::string typed(name);
    std::ranges::replace(typed, '_', '-');
    return typed;
}

std::string option_of(std::string_view name) { return "--" + (name == "steps_per_period" ? "steps" : hyphenated(name)); }

std::string degrees_of(std::string_view unit) { return "deg" + std::string(unit.substr(std::string_view("rad").size())); }

const Parameter& swept_parameter(std::size_t i) {
    static constexpr Parameter others[] = {
        {"gravity", "g", "m/s²", {"of alpha = g/l", "de alpha = g/l"}, 1, Rule::positive, false, nullptr, nullptr, nullptr},
        {"length", "l", "m", {"of alpha = g/l", "de alpha = g/l"}, 1, Rule::positive, false, nullptr, nullptr, nullptr},
        {"tau",
         "τ",
         "s",
         {"period, in place of theta0", "periodo, en lugar de theta0"},
         0,
         Rule::positive,
         false,
         nullptr,
         nullptr,
         nullptr},
    };
    return i < parameter_count ? parameters[i] : others[i - parameter_count];
}

const std::vector<Option>& known_options() {
    static const std::vector<Option> known = [] {
        std::vector<Option> all;
        for (std::size_t i = 0; i < swept_count; ++i) {
            const Parameter& parameter = swept_parameter(i);
            all.push_back({option_of(parameter.name), takers(parameter), parameter.symbol, parameter.meaning});
        }
        for (const auto& setting : settings)
            if (is_option(setting))
                all.push_back({option_of(setting.name),
                               takers(setting) | (setting.value == &Strobe::tolerance ? all_solutions : 0u),
                               setting.is_angle ? "X" : "N", setting.meaning,
                               setting.value == &Strobe::periods ? default_periods(setting) : shown(Strobe{}.*setting.value)});
        for (const auto& setting : {plane_setting, direction_setting, carry_setting})
            all.push_back({option_of(setting.name), setting.commands, joined({setting.words.begin(), setting.words.end()}, "|"),
                           setting.meaning, setting.name == carry_setting.name ? "" : setting.words[0]});
        const Words seconds{"the same in seconds", "lo mismo en segundos"};
        const Option others[] = {
            {"--locate",
             settling_commands,
             "TOL",
             {"with --carry: where branches end, within TOL", "con --carry: dónde acaban las ramas, hasta TOL"}},
            {"--shares",
             attractors_command,
             "",
             {"the share of theta0 and omega0 that ends on each", "la parte de theta0 y omega0 que acaba en cada uno"}},
            {"--details", detail_commands, "", {"more columns, see MEASURES", "más columnas, véase MEDIDAS"}},
            {"--threads", measure_commands, "N", {"results do not depend on them", "los resultados no dependen de ellos"}},
            {"--dt-factor", solve_command, "F", {"longest step, as a factor of τ", "paso máximo, como factor de τ"}, "0.0001"},
            {"--dt", solve_command, "S", seconds},
            {"--every-factor", solve_command, "F", {"time between rows", "tiempo entre filas"}, "0.02"},
            {"--every", solve_command, "S", seconds},
            {"--until-factor", solve_command, "F", {"length of the run", "duración"}, "1"},
            {"--until", solve_command, "S", seconds},
            {"--columns", all_solutions, "LIST", {"see COLUMNS", "véase COLUMNAS"}},
            {"--dry-run",
             all_solutions,
             "",
             {"check the problems and write neither rows nor files", "comprueba los problemas y no escribe filas ni ficheros"}},
            {"--epsilon", analyze_command, "E", {"relative error of the series", "error relativo de la serie"}, "1e-7"},
            {"--method", all_commands, "M", {"see METHODS", "véase MÉTODOS"}},
            {"--format",
             all_commands,
             "F",
             {"text, csv, or json: an object a line", "text, csv o json: un objeto por línea"},
             "text"},
            {"--precision",
             all_commands,
             "N",
             {"digits from 1 to 17, or full: those that read back the same",
              "cifras, de 1 a 17, o full: las que se releen igual"},
             "6"},
            {"--output",
             all_commands,
             "FILE",
             {"untouched if the first problem is bad; - is standard output",
              "intacto si el primer problema está mal; - es la salida estándar"}},
            {"--lang",
             all_commands,
             "L",
             {"en or es, else as LC_ALL, LC_MESSAGES or LANG say", "en o es; si no, según LC_ALL, LC_MESSAGES o LANG"}},
        };
        all.insert(all.end(), std::begin(others), std::end(others));
        return all;
    }();
    return known;
}

const Option* find_option(std::string_view name) {
    const auto found = std::ranges::find(known_options(), name, &Option::name);
    return found == known_options().end() ? nullptr : &*found;
}

}  // namespace pendula::cli
