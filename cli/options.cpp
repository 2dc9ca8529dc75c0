#include "cli/options.hpp"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>

#include "cli/settings.hpp"
#include "pendula/angle.hpp"

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

/// What to say of an argument that is no option of the command nor the value of one.
[[noreturn]] void refuse_extra(Command command, std::string_view extra) {
    if (!extra.starts_with('-') || extra == "-")
        throw bad_usage({"unexpected argument {0}; options begin with --, see pendula --help",
                         "el argumento {0} sobra; las opciones empiezan por --, consulta pendula --help"},
                        {in_quotes(extra)});
    const auto name = extra.substr(0, extra.find('='));
    if (const Option* other = find_option(name))
        throw bad_usage({"option {0} belongs to {1}", "la opción {0} es de {1}"}, {name, typed_commands(other->commands)});
    std::vector<std::string> names{"--help", "--version"};
    for (const auto& option : known_options())
        if (option.commands & command) names.push_back(option.name);
    const auto meant = nearest(name, names);
    if (meant.empty())
        throw bad_usage({"unknown option {0}; see pendula --help", "opción desconocida {0}; consulta pendula --help"},
                        {in_quotes(name)});
    throw bad_usage({"unknown option {0}; did you mean {1}?", "opción desconocida {0}; ¿querías decir {1}?"},
                    {in_quotes(name), meant});
}

const Options::Given* find(const Options& options, std::string_view name) {
    const auto found = std::ranges::find(options.given, name, &Options::Given::name);
    return found == options.given.end() ? nullptr : &*found;
}

void refuse_with(const Options& options, std::string_view name, std::string_view method) {
    if (!is_given(options, name)) return;
    if (is_given(options, "--method"))
        throw bad_usage({"{0} does not go with --method {1}", "{0} no va con --method {1}"}, {name, method});
    throw bad_usage({"{0} does not go with --method {1}, which is what is used if none is given",
                     "{0} no va con --method {1}, que es el que se usa si no se da ninguno"},
                    {name, method});
}

int precision_of(const Options& options) {
    const auto typed = text_of(options, "--precision");
    if (typed == "full") return full;
    int digits = 0;
    const auto [end, error] = std::from_chars(typed.data(), typed.data() + typed.size(), digits);
    if (error != std::errc() || end != typed.data() + typed.size() || digits < 1 || digits > 17)
        refuse_value(options, "--precision",
                     say({"it must be a whole number from 1 to 17, or full", "debe ser un entero de 1 a 17, o full"}));
    return digits;
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

Options parse(Command command, std::span<const std::string_view> arguments) {
    Options options;
    std::optional<std::string_view> extra;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const auto argument = arguments[i];
        const auto name = argument.substr(0, argument.find('='));
        const Option* const option = find_option(name);
        if (argument == "-h" || argument == "--help") {
            options.wants_help = true;
        } else if (argument == "--version") {
            options.wants_version = true;
        } else if (!option || !(option->commands & command)) {
            if (!extra) extra = argument;
        } else if (option->value.empty()) {
            if (name.size() < argument.size())
                throw bad_usage({"option {0} takes no value", "la opción {0} no lleva valor"}, {name});
            options.given.push_back({option->name, {}});
        } else if (name.size() < argument.size()) {
            options.given.push_back({std::string(name), argument.substr(name.size() + 1)});
        } else if (++i < arguments.size()) {
            options.given.push_back({std::string(name), arguments[i]});
        } else {
            throw bad_usage({"option {0} needs a value", "la opción {0} necesita un valor"}, {name});
        }
    }
    if (extra) refuse_extra(command, *extra);
    for (const auto& [name, text] : options.given)
        if (std::ranges::count(options.given, name, &Options::Given::name) > 1)
            throw bad_usage({"option {0} is given twice", "la opción {0} está dos veces"}, {name});
    constexpr const char* languages[] = {"en", "es"};
    choice(options, "--lang", languages);
    return options;
}

bool is_given(const Options& options, std::string_view name) { return find(options, name); }

std::string_view text_of(const Options& options, std::string_view name) {
    const auto* given = find(options, name);
    return given ? given->text : "";
}

void refuse_value(const Options& options, std::string_view name, std::string_view wrong) {
    throw Failure{Status::bad_usage, wrong_text(name, text_of(options, name), wrong)};
}

void refuse_both(const Options& options, std::string_view one, std::string_view other) {
    if (is_given(options, one) && is_given(options, other))
        throw bad_usage({"{0} and {1} exclude each other", "{0} y {1} se excluyen"}, {one, other});
}

double number_of(const Options& options, std::string_view name, Rule rule, double otherwise) {
    if (!is_given(options, name)) return otherwise;
    const Parsed parsed = parse_number(name, text_of(options, name), rule);
    if (!parsed.wrong.empty()) throw Failure{Status::bad_usage, parsed.wrong};
    return parsed.value;
}

double angle_of(const Options& options, std::string_view name, std::string_view unit, double otherwise) {
    if (!is_given(options, name)) return otherwise;
    const auto text = text_of(options, name);
    const Parsed parsed = parse_angle(name, text, degrees_of(unit));
    if (!parsed.wrong.empty()) throw Failure{Status::bad_usage, parsed.wrong};
    if (unit == "rad") remark_on_degrees(name, text, parsed);
    return parsed.value;
}

bool looks_like_degrees(const Parsed& angle) {
    constexpr double largest = 3600;
    const double x = angle.value;
    return !angle.is_in_degrees && x == std::trunc(x) && std::abs(x) > 2 * pi && std::abs(x) <= largest;
}

void remark_on_degrees(std::string_view name, std::string_view text, const Parsed& angle) {
    if (!looks_like_degrees(angle)) return;
    const double turns = std::trunc(angle.value / (2 * pi));
    tell(say(std::abs(turns) == 1 ? Words{"{0} {1}: {1} rad is {2} turn and {3} rad; for degrees type {1}deg",
                                          "{0} {1}: {1} rad es {2} vuelta y {3} rad; en grados se escribe {1}deg"}
                                  : Words{"{0} {1}: {1} rad is {2} turns and {3} rad; for degrees type {1}deg",
                                          "{0} {1}: {1} rad son {2} vueltas y {3} rad; en grados se escribe {1}deg"},
             {name, text, shown(turns), shown(angle.value - turns * 2 * pi)}));
}

std::size_t pick(const Options& options, std::string_view name, std::string_view typed, std::span<const char* const> words) {
    const auto found = std::ranges::find(words, typed, [](const char* word) { return std::string_view(word); });
    if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
    const std::vector<std::string> names(words.begin(), words.end());
    std::string wrong = say({"{0} is none of {1}", "{0} no es ninguno de {1}"}, {in_quotes(typed), joined(names)});
    if (const auto meant = nearest(typed, names); !meant.empty())
        wrong += say({"; did you mean {0}?", "; ¿querías decir {0}?"}, {meant});
    refuse_value(options, name, wrong);
}

std::size_t choice(const Options& options, std::string_view name, std::span<const char* const> words) {
    return is_given(options, name) ? pick(options, name, text_of(options, name), words) : 0;
}

Method method_of(const Options& options, std::span<const char* const> words) {
    const char* const name = words[choice(options, "--method", words)];
    const auto method = static_cast<Method>(std::ranges::find(method_names, std::string_view(name)) - method_names);
    if (method != Method::taylor) refuse_with(options, "--tolerance", name);
    if (!takes_steps(method))
        for (const auto* option : {"--dt", "--dt-factor", "--steps"}) refuse_with(options, option, name);
    return method;
}

double tolerance_of(const Options& options) { return number_of(options, "--tolerance", Rule::fraction, Strobe{}.tolerance); }

Style style_of(const Options& options) {
    const auto format = static_cast<Format>(choice(options, "--format", format_names));
    return {format, is_given(options, "--precision") ? precision_of(options) : Style{}.precision};
}

std::string output_path(const Options& options) {
    const auto path = text_of(options, "--output");
    if (is_given(options, "--output") && path.empty())
        refuse_value(options, "--output",
                     say({"it must be the name of a file, or - for standard output",
                          "debe ser el nombre de un fichero, o - para la salida estándar"}));
    return path == "-" ? "" : std::string(path);
}

}  // namespace pendula::cli
