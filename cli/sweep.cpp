#include "cli/sweep.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "cli/terminal.hpp"
#include "pendula/analysis.hpp"
#include "pendula/angle.hpp"

namespace pendula::cli {

namespace {

constexpr std::size_t gravity = parameter_count, length = parameter_count + 1, tau = parameter_count + 2;

Parsed read_end(const Parameter& parameter, std::string_view typed) {
    const std::string name = option_of(parameter.name);
    const Parsed parsed =
        parameter.is_angle ? parse_angle(name, typed, degrees_of(parameter.unit)) : parse_number(name, typed, parameter.rule);
    if (!parsed.wrong.empty()) throw Failure{Status::bad_usage, parsed.wrong};
    return parsed;
}

std::size_t read_count(const Options& options, std::string_view name, std::string_view typed) {
    std::size_t n = 0;
    const auto [at, error] = std::from_chars(typed.data(), typed.data() + typed.size(), n);
    if (error != std::errc() || at != typed.data() + typed.size() || n < 1 || n > std::size_t{1} << 53)
        refuse_value(options, name,
                     say({"{0} values: the count must be a whole number from 1 to 2^53",
                          "{0} valores: la cuenta debe ser un entero de 1 a 2^53"},
                         {in_quotes(typed)}));
    return n;
}

/// Whether bare values are angles; an angular velocity may well be large.
bool is_angle(const Parameter& parameter) { return std::string_view(parameter.unit) == "rad"; }

/// `remark_on_degrees` of a range with both ends beyond a turn; one that begins within may well be in radians.
void remark_on_range(std::string_view name, std::string_view first, std::string_view last, const Range& range) {
    tell(say({"{0}: from {1} to {2} radians; for degrees type {1}deg:{2}deg:{3}",
              "{0}: de {1} a {2} radianes; en grados se escribe {1}deg:{2}deg:{3}"},
             {name, first, last, std::to_string(range.count)}));
}

Range read_range(const Options& options, const Parameter& parameter) {
    const std::string name = option_of(parameter.name);
    if (!is_given(options, name)) return {parameter.otherwise, parameter.otherwise};
    std::vector<std::string_view> parts;
    auto rest = text_of(options, name);
    for (std::size_t colon; (colon = rest.find(':')) != std::string_view::npos; rest.remove_prefix(colon + 1))
        parts.push_back(rest.substr(0, colon));
    parts.push_back(rest);
    if (parts.size() != 1 && parts.size() != 3)
        refuse_value(
            options, name,
            say({"it must be one value, or a range first:last:count", "debe ser un valor, o un rango primero:último:cuántos"}));
    const Parsed first = read_end(parameter, parts[0]);
    if (parts.size() == 1) {
        if (is_angle(parameter)) remark_on_degrees(name, parts[0], first);
        return {.first = first.value, .last = first.value};
    }
    const Parsed last = read_end(parameter, parts[1]);
    if (first.is_in_degrees != last.is_in_degrees && (first.is_in_degrees ? last : first).value != 0)
        refuse_value(options, name,
                     say({"one end is in degrees and the other is not; type deg behind both or none",
                          "un extremo está en grados y el otro no; escribe deg tras los dos o tras ninguno"}));
    const Range range{
        first.value, last.value, read_count(options, name, parts[2]), true, first.is_in_degrees || last.is_in_degrees,
        first.typed, last.typed};
    if (!satisfies(Rule::finite, range.typed_last - range.typed_first))
        refuse_value(options, name, say({"it is wider than the doubles", "es más ancho que los double"}));
    if (is_angle(parameter) && looks_like_degrees(first) && looks_like_degrees(last))
        remark_on_range(name, parts[0], parts[1], range);
    return range;
}

double typed_at(const Range& range, std::size_t i) {
    if (i == 0) return range.typed_first;
    if (i + 1 == range.count) return range.typed_last;
    return range.typed_first +
           static_cast<double>(i) * ((range.typed_last - range.typed_first) / static_cast<double>(range.count - 1));
}

double value_at(const Range& range, std::size_t i) {
    if (i == 0) return range.first;
    if (i + 1 == range.count) return range.last;
    return range.is_in_degrees ? to_radians(typed_at(range, i)) : typed_at(range, i);
}

/// Which of its values a range has in a member.
std::size_t index_of(const Sweep& sweep, std::size_t parameter, std::size_t member) {
    auto range = sweep.ranges.rbegin();
    for (; *range != parameter; ++range) member /= sweep.values[*range].count;
    return member % sweep.values[parameter].count;
}

/// The same of one in the table of parameters, where gravity and length are alpha.
double table_value_of(const Sweep& sweep, std::size_t parameter, std::size_t member) {
    if (parameters[parameter].value == &Pendulum::alpha && sweep.has_length)
        return value_of(sweep, gravity, member) / value_of(sweep, length, member);
    return value_of(sweep, parameter, member);
}

/// Combinations of the ranges. They are few enough to be counted.
std::size_t size_of(const Sweep& sweep) {
    double size = 1;
    for (const std::size_t i : sweep.ranges) size *= static_cast<double>(sweep.values[i].count);
    if (size > 0x1p53)
        throw bad_usage({"the ranges make {0} pendulums, more than 2^53", "los rangos dan {0} péndulos, más de 2^53"},
                        {shown(size)});
    return static_cast<std::size_t>(size);
}

}  // namespace

Sweep read_sweep(const Options& options) {
    refuse_both(options, "--alpha", "--gravity");
    refuse_both(options, "--alpha", "--length");
    if (is_given(options, "--gravity") != is_given(options, "--length"))
        throw bad_usage({"--gravity and --length go together", "--gravity y --length van juntas"});
    refuse_both(options, "--tau", "--theta0");
    refuse_both(options, "--tau", "--omega0");
    Sweep sweep;
    sweep.has_tau = is_given(options, "--tau");
    sweep.has_length = is_given(options, "--length");
    for (std::size_t i = 0; i < swept_count; ++i) sweep.values[i] = read_range(options, swept_parameter(i));
    for (const auto& given : options.given)
        for (std::size_t i = 0; i < swept_count; ++i) {
            if (given.name != option_of(swept_parameter(i).name)) continue;
            sweep.is_given = true;
            if (sweep.values[i].is_range) sweep.ranges.push_back(i);
        }
    sweep.size = size_of(sweep);
    return sweep;
}

void require_single(const Options& options, const Sweep& sweep) {
    if (sweep.ranges.empty()) return;
    refuse_value(options, option_of(swept_parameter(sweep.ranges[0]).name),
                 say({"solve takes one value; ranges are for analyze and the measures",
                      "solve toma un solo valor; los rangos son para analyze y las medidas"}));
}

void require_theta0(const Options& options) {
    if (!is_given(options, "--theta0") && !is_given(options, "--tau"))
        throw bad_usage({"--theta0 is missing: the initial angle, as 1.5 (radians) or 90deg",
                         "falta --theta0: el ángulo inicial, como 1.5 (radianes) o 90deg"});
}

double value_of(const Sweep& sweep, std::size_t parameter, std::size_t member) {
    const Range& range = sweep.values[parameter];
    return range.is_range ? value_at(range, index_of(sweep, parameter, member)) : range.first;
}

double typed_value_of(const Sweep& sweep, std::size_t parameter, std::size_t member) {
    return typed_at(sweep.values[parameter], index_of(sweep, parameter, member));
}

Pendulum pendulum_of(const Sweep& sweep, std::size_t member) {
    Pendulum pendulum;
    for (std::size_t i = 0; i < parameter_count; ++i)
        if (const auto place = parameters[i].value) pendulum.*place = table_value_of(sweep, i, member);
    return pendulum;
}

State initial_state_of(const Sweep& sweep, std::size_t member) {
    State initial;
    for (std::size_t i = 0; i < parameter_count; ++i)
        if (const auto place = parameters[i].initial) initial.*place = value_of(sweep, i, member);
    if (sweep.has_tau) initial.theta = amplitude_of_period(pendulum_of(sweep, member).alpha, tau_of(sweep, member));
    return initial;
}

double tau_of(const Sweep& sweep, std::size_t member) { return value_of(sweep, tau, member); }

bool has_value(const Sweep& sweep, std::size_t parameter) {
    if (parameter == gravity || parameter == length) return sweep.has_length;
    if (parameter == tau) return sweep.has_tau;
    return !sweep.has_length || parameters[parameter].value != &Pendulum::alpha;
}

Sweep pendulums_of(const Sweep& sweep) {
    Sweep pendulums = sweep;
    std::erase_if(pendulums.ranges, [](std::size_t i) { return swept_parameter(i).initial != nullptr; });
    pendulums.size = size_of(pendulums);
    return pendulums;
}

std::size_t member_in(const Sweep& pendulums, const Sweep& sweep, std::size_t member) {
    std::size_t found = 0;
    for (const std::size_t i : pendulums.ranges) found = found * sweep.values[i].count + index_of(sweep, i, member);
    return found;
}

void require_each(const Sweep& sweep, const std::function<Refusal(const Pendulum&)>& check) {
    const Sweep pendulums = pendulums_of(sweep);  // what they start from is of no account
    for (std::size_t member = 0; member < pendulums.size; ++member) {
        if (is_interrupted()) throw Failure{Status::interrupted, {}};
        if (const auto refusal = check(pendulum_of(pendulums, member)))
            throw Failure{Status::bad_usage, place_of(pendulums, member) + say(refusal, name_in_options(sweep, refusal))};
    }
}

std::string place_of(const Sweep& sweep, std::size_t member) {
    std::vector<std::string> values;
    for (const std::size_t i : sweep.ranges)
        values.push_back(say({"{0} is {1}", "{0} es {1}"},
                             {option_of(swept_parameter(i).name), shown(typed_value_of(sweep, i, member), full)}));
    return values.empty() ? "" : say({"where {0}: ", "donde {0}: "}, {joined(values)});
}

std::string name_in_options(const Sweep& sweep, const Refusal& refusal) {
    const std::string_view name = refusal.name;
    if (name == "alpha" && sweep.has_length) return say({"--gravity over --length", "--gravity entre --length"});
    if (name == "steps_per_period") return "--steps";
    return find_option(option_of(name)) ? option_of(name) : std::string(name);
}

Members members_of(const Sweep& sweep, std::size_t first, std::size_t count) {
    Members members;
    members.ensemble.size = count;
    for (std::size_t i = 0; i < parameter_count; ++i) {
        const bool is_alpha_of_length = parameters[i].value == &Pendulum::alpha && sweep.has_length;
        if (!sweep.values[i].is_range && !is_alpha_of_length) {
            members.ensemble.*parameters[i].column = sweep.values[i].first;
            continue;
        }
        auto& column = members.columns[i];
        column.resize(count);
        for (std::size_t j = 0; j < count; ++j) column[j] = table_value_of(sweep, i, first + j);
        members.ensemble.*parameters[i].column = column;
    }
    return members;
}

std::string swept_name(const Sweep& sweep, std::size_t parameter) {
    return swept_parameter(parameter).name + std::string(sweep.values[parameter].is_in_degrees ? "_deg" : "");
}

std::vector<std::string> swept_names(const Sweep& sweep) {
    std::vector<std::string> names;
    for (const std::size_t i : sweep.ranges) names.push_back(swept_name(sweep, i));
    return names;
}

char* put_swept(char* at, const RowStyle& style, const Sweep& sweep, std::size_t member, std::size_t field) {
    for (const std::size_t i : sweep.ranges) at = put_field(at, style, field++, typed_value_of(sweep, i, member));
    return at;
}

std::string lines_behind(const Sweep& sweep, std::size_t member) {
    std::string lines;
    std::size_t length_of_block = 1;
    for (std::size_t i = sweep.ranges.size(); i-- > 1;) {
        length_of_block *= sweep.values[sweep.ranges[i]].count;
        if ((member + 1) % length_of_block == 0) lines += '\n';
    }
    return lines;
}

}  // namespace pendula::cli
