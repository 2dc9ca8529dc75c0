#include "cli/options.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>

namespace pendula::cli {

namespace {

[[noreturn]] void refuse(const Text& text, std::initializer_list<std::string_view> values) {
    throw Failure{Status::bad_usage, say(text, values)};
}

std::size_t place(std::string_view name) {
    return static_cast<std::size_t>(std::ranges::find(option_names, name, &OptionName::name) - option_names);
}

/// The commands that take an option, as they are typed.
std::string takers(unsigned mask) {
    std::vector<std::string> names;
    for (const auto& [name, command] : commands)
        if (mask & command) names.push_back("pendula " + std::string(name));
    return joined({names.begin(), names.end()});
}

/// What to say of an argument that is no option of the command nor the value of one.
[[noreturn]] void refuse_extra(Command command, const std::string& extra) {
    if (!extra.starts_with('-') || extra == "-")
        refuse({"unexpected argument {0}; options begin with --, see pendula --help",
                "el argumento {0} sobra; las opciones empiezan por --, consulta pendula --help"},
               {in_quotes(extra)});
    const std::string name = extra.substr(0, extra.find('='));
    if (const std::size_t i = place(name); i < std::size(option_names))
        refuse({"option {0} belongs to {1}", "la opción {0} es de {1}"}, {name, takers(option_names[i].commands)});
    std::vector<std::string_view> names{"--help", "--version"};
    for (const auto& option : option_names)
        if (option.commands & command) names.push_back(option.name);
    const auto meant = nearest(name, names);
    if (meant.empty())
        refuse({"unknown option {0}; see pendula --help", "opción desconocida {0}; consulta pendula --help"},
               {in_quotes(name)});
    refuse({"unknown option {0}; did you mean {1}?", "opción desconocida {0}; ¿querías decir {1}?"}, {in_quotes(name), meant});
}

double value(const Options& options, std::string_view name, const Parsed& parsed) {
    if (!parsed.wrong.empty()) refuse_value(options, name, parsed.wrong);
    return parsed.value;
}

void read_duration(const Options& options, std::string_view factor, std::string_view time, Duration& duration) {
    refuse_both(options, factor, time);
    if (is_given(options, factor)) duration = {number(options, factor, Rule::positive, 0), true};
    if (is_given(options, time)) duration = {number(options, time, Rule::positive, 0), false};
}

/// Which of the words `typed` is; `name` is the option it was typed for.
std::size_t pick(const Options& options, std::string_view name, std::string_view typed,
                 std::span<const std::string_view> words) {
    const auto found = static_cast<std::size_t>(std::ranges::find(words, typed) - words.begin());
    if (found < words.size()) return found;
    std::string wrong =
        say({"{0} is none of {1}", "{0} no es ninguno de {1}"}, {in_quotes(typed), joined({words.begin(), words.end()})});
    if (const auto meant = nearest(typed, words); !meant.empty())
        wrong += say({"; did you mean {0}?", "; ¿querías decir {0}?"}, {meant});
    refuse_value(options, name, wrong);
}

std::vector<Column> columns(const Options& options) {
    std::vector<Column> chosen;
    std::string_view rest = text(options, "--columns");
    for (bool is_last = false; !is_last;) {
        const std::size_t comma = rest.find(',');
        is_last = comma == std::string_view::npos;
        const auto word = rest.substr(0, comma);
        const auto column = static_cast<Column>(pick(options, "--columns", word, column_names));
        if (std::ranges::count(chosen, column))
            refuse_value(options, "--columns", say({"{0} stands there twice", "{0} está dos veces"}, {word}));
        chosen.push_back(column);
        rest.remove_prefix(is_last ? rest.size() : comma + 1);
    }
    return chosen;
}

int precision(const Options& options) {
    const std::string& typed = text(options, "--precision");
    if (typed == "full") return full;
    int digits = 0;
    const auto [end, error] = std::from_chars(typed.data(), typed.data() + typed.size(), digits);
    if (error != std::errc() || end != typed.data() + typed.size() || digits < 1 || digits > 17)
        refuse_value(options, "--precision",
                     say({"it must be a whole number from 1 to 17, or full", "debe ser un entero de 1 a 17, o full"}));
    return digits;
}

}  // namespace

Options parse(Command command, const std::vector<std::string>& arguments) {
    Options options;
    CLI::App app;
    app.set_help_flag();
    app.allow_extras();
    const CLI::Option* help = app.add_flag("-h,--help");
    const CLI::Option* version = app.add_flag("--version");
    std::array<CLI::Option*, std::size(option_names)> taken{};
    for (std::size_t i = 0; i < std::size(option_names); ++i)
        if (option_names[i].commands & command)
            taken[i] = app.add_option(std::string(option_names[i].name), options.texts[i])->take_last();
    try {
        app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
    } catch (const CLI::ParseError&) {
        // All that there is left to refuse: an option whose value would stand behind the last argument.
        refuse({"option {0} needs a value", "la opción {0} necesita un valor"}, {arguments.back()});
    }
    if (const auto extras = app.remaining(); !extras.empty()) refuse_extra(command, extras.front());
    for (std::size_t i = 0; i < std::size(option_names); ++i) {
        if (!taken[i]) continue;
        options.given[i] = taken[i]->count() > 0;
        if (taken[i]->count() > 1)
            refuse({"option {0} is given twice", "la opción {0} está dos veces"}, {option_names[i].name});
    }
    for (const auto* option : app.parse_order()) options.order.push_back(option->get_name());
    constexpr std::string_view languages[] = {"en", "es"};
    choice(options, "--lang", languages);
    options.wants_help = help->count() > 0;
    options.wants_version = version->count() > 0;
    return options;
}

bool is_given(const Options& options, std::string_view name) { return options.given[place(name)]; }

const std::string& text(const Options& options, std::string_view name) { return options.texts[place(name)]; }

void refuse_value(const Options& options, std::string_view name, std::string_view wrong) {
    throw Failure{Status::bad_usage, std::string(name) + ' ' + in_quotes(text(options, name)) + ": " + std::string(wrong)};
}

void refuse_both(const Options& options, std::string_view one, std::string_view other) {
    if (is_given(options, one) && is_given(options, other))
        refuse({"{0} and {1} exclude each other", "{0} y {1} se excluyen"}, {one, other});
}

double number(const Options& options, std::string_view name, Rule rule, double otherwise) {
    return is_given(options, name) ? value(options, name, parse_number(text(options, name), rule)) : otherwise;
}

std::size_t choice(const Options& options, std::string_view name, std::span<const std::string_view> words) {
    return is_given(options, name) ? pick(options, name, text(options, name), words) : 0;
}

bool states_pendulum(const Options& options) {
    constexpr std::string_view names[] = {"--theta0", "--omega0", "--alpha", "--gravity", "--length"};
    return std::ranges::any_of(names, [&](std::string_view name) { return is_given(options, name); });
}

Pendulum pendulum(const Options& options) {
    refuse_both(options, "--alpha", "--gravity");
    refuse_both(options, "--alpha", "--length");
    if (is_given(options, "--gravity") != is_given(options, "--length"))
        refuse({"--gravity and --length go together", "--gravity y --length van juntas"}, {});
    const double gravity = number(options, "--gravity", Rule::positive, 1);
    const double length = number(options, "--length", Rule::positive, 1);
    const double alpha = number(options, "--alpha", Rule::positive, gravity / length);
    if (!satisfies(Rule::positive, alpha))
        refuse({"--gravity {0} over --length {1} is out of the range of doubles",
                "--gravity {0} entre --length {1} se sale del rango de double"},
               {shown(gravity), shown(length)});
    const Pendulum stated{
        .alpha = alpha,
        .beta = number(options, "--beta", Rule::not_negative, 0),
        .torque = number(options, "--torque", Rule::finite, 0),
        .drive_amplitude = number(options, "--drive-amplitude", Rule::finite, 0),
        .drive_frequency = number(options, "--drive-frequency", Rule::not_negative, 0),
        .drive_phase = is_given(options, "--drive-phase")
                           ? value(options, "--drive-phase", parse_angle(text(options, "--drive-phase"), "deg"))
                           : 0,
    };
    if (stated.drive_amplitude != 0 && stated.drive_frequency == 0)
        refuse({"a drive needs a --drive-frequency above 0", "un forzamiento necesita una --drive-frequency mayor que 0"}, {});
    return stated;
}

State initial_state(const Options& options) {
    if (!is_given(options, "--theta0"))
        refuse({"--theta0 is missing: the initial angle, as 1.5 (radians) or 90deg",
                "falta --theta0: el ángulo inicial, como 1.5 (radianes) o 90deg"},
               {});
    const double theta = value(options, "--theta0", parse_angle(text(options, "--theta0"), "deg"));
    if (!is_given(options, "--omega0")) return {theta, 0};
    return {theta, value(options, "--omega0", parse_angle(text(options, "--omega0"), "deg/s"))};
}

void read_durations(const Options& options, Statement& statement) {
    read_duration(options, "--dt-factor", "--dt", statement.dt);
    read_duration(options, "--every-factor", "--every", statement.every);
    read_duration(options, "--until-factor", "--until", statement.until);
}

Method method(const Options& options) {
    constexpr std::string_view words[] = {"rk4", "euler", "verlet", "exact", "taylor"};
    constexpr Method methods[] = {Method::rk4, Method::euler, Method::verlet, Method::exact, Method::taylor};
    return methods[choice(options, "--method", words)];
}

double tolerance(const Options& options) {
    if (is_given(options, "--tolerance") && method(options) != Method::taylor)
        refuse({"--tolerance goes with --method taylor", "--tolerance va con --method taylor"}, {});
    return number(options, "--tolerance", Rule::fraction, 1e-15);
}

void require_able(const Statement& statement, const Layout& layout) {
    if (is_conservative(statement.pendulum)) return;
    const Text only_alone = {"{0} needs a pendulum without friction, torque and drive",
                             "{0} necesita un péndulo sin rozamiento, par ni forzamiento"};
    if (statement.method == Method::exact) refuse(only_alone, {"--method exact"});
    if (statement.method == Method::verlet && statement.pendulum.beta != 0)
        refuse({"--method verlet needs a pendulum without friction", "--method verlet necesita un péndulo sin rozamiento"}, {});
    for (const Column column : layout.columns)
        if (column == Column::sine || column == Column::exact || column == Column::error)
            refuse(only_alone, {"--columns " + std::string(column_names[static_cast<std::size_t>(column)])});
}

double series_epsilon(const Options& options) {
    constexpr std::string_view words[] = {"agm", "series"};
    const bool is_series = choice(options, "--method", words) == 1;
    if (!is_series && is_given(options, "--epsilon"))
        refuse({"--epsilon goes with --method series", "--epsilon va con --method series"}, {});
    return is_series ? number(options, "--epsilon", Rule::fraction, 1e-7) : 0;
}

Layout layout(const Options& options) {
    Layout chosen;
    if (is_given(options, "--columns")) chosen.columns = columns(options);
    chosen.format = static_cast<Format>(choice(options, "--format", format_names));
    if (is_given(options, "--precision")) chosen.precision = precision(options);
    return chosen;
}

std::string output_path(const Options& options) {
    if (is_given(options, "--output") && text(options, "--output").empty())
        refuse_value(options, "--output", say({"it must be the name of a file", "debe ser el nombre de un fichero"}));
    return text(options, "--output");
}

Language language(const std::vector<std::string>& arguments) {
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const std::string_view argument = arguments[i];
        const std::string_view value = argument.starts_with("--lang=")                    ? argument.substr(7)
                                       : argument == "--lang" && i + 1 < arguments.size() ? std::string_view(arguments[i + 1])
                                                                                          : "";
        if (value == "es") return Language::es;
        if (value == "en") return Language::en;
    }
    return language_of_environment();
}

}  // namespace pendula::cli
