#include "cli/options.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "cli/settings.hpp"
#include "pendula/angle.hpp"

namespace pendula::cli {

namespace {

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
