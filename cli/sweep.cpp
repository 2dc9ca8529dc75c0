#include "cli/sweep.hpp"

#include <algorithm>
#include <charconv>

namespace pendula::cli {

namespace {

/// Places among the parameters.
enum Swept { theta0, omega0, alpha, gravity, length, beta, torque, drive_amplitude, drive_frequency, drive_phase };

/// How options state a parameter.
struct Stated {
    std::string_view option, column;
    Rule rule = Rule::finite;
    double otherwise = 0;
    std::string_view suffix = {};  ///< of degrees, where it is an angle or turns one
};

constexpr Stated swept_names[] = {
    {.option = "--theta0", .column = "theta0", .suffix = "deg"},
    {.option = "--omega0", .column = "omega0", .suffix = "deg/s"},
    {.option = "--alpha", .column = "alpha", .rule = Rule::positive, .otherwise = 1},
    {.option = "--gravity", .column = "gravity", .rule = Rule::positive, .otherwise = 1},
    {.option = "--length", .column = "length", .rule = Rule::positive, .otherwise = 1},
    {.option = "--beta", .column = "beta", .rule = Rule::not_negative},
    {.option = "--torque", .column = "torque"},
    {.option = "--drive-amplitude", .column = "drive_amplitude"},
    {.option = "--drive-frequency", .column = "drive_frequency", .rule = Rule::not_negative},
    {.option = "--drive-phase", .column = "drive_phase", .suffix = "deg"},
};
static_assert(std::size(swept_names) == swept_count);

double end(const Options& options, const Stated& stated, std::string_view typed) {
    const Parsed parsed = stated.suffix.empty() ? parse_number(typed, stated.rule) : parse_angle(typed, stated.suffix);
    if (!parsed.wrong.empty()) refuse_value(options, stated.option, parsed.wrong);
    return parsed.value;
}

std::size_t count(const Options& options, const Stated& stated, std::string_view typed) {
    std::size_t n = 0;
    const auto [at, error] = std::from_chars(typed.data(), typed.data() + typed.size(), n);
    if (error != std::errc() || at != typed.data() + typed.size() || n < 1 || n > std::size_t{1} << 53)
        refuse_value(options, stated.option,
                     say({"{0} values: the count must be a whole number from 1 to 2^53",
                          "{0} valores: la cuenta debe ser un entero de 1 a 2^53"},
                         {in_quotes(typed)}));
    return n;
}

Parameter read(const Options& options, const Stated& stated) {
    Parameter parameter{stated.column, stated.otherwise, stated.otherwise};
    if (!is_given(options, stated.option)) return parameter;
    std::vector<std::string_view> parts;
    std::string_view rest = text(options, stated.option);
    for (std::size_t colon; (colon = rest.find(':')) != std::string_view::npos; rest.remove_prefix(colon + 1))
        parts.push_back(rest.substr(0, colon));
    parts.push_back(rest);
    if (parts.size() != 1 && parts.size() != 3)
        refuse_value(
            options, stated.option,
            say({"it must be one value, or a range first:last:count", "debe ser un valor, o un rango primero:último:cuántos"}));
    parameter.first = parameter.last = end(options, stated, parts[0]);
    if (parts.size() == 1) return parameter;
    parameter.is_range = true;
    parameter.count = count(options, stated, parts[2]);
    parameter.last = end(options, stated, parts[1]);
    if (!satisfies(Rule::finite, parameter.last - parameter.first))
        refuse_value(options, stated.option, say({"it is wider than the doubles", "es más ancho que los double"}));
    return parameter;
}

template <class Value>
Pendulum pendulum_of(const Sweep& sweep, Value value_of) {
    return {.alpha = sweep.has_length ? value_of(gravity) / value_of(length) : value_of(alpha),
            .beta = value_of(beta),
            .torque = value_of(torque),
            .drive_amplitude = value_of(drive_amplitude),
            .drive_frequency = value_of(drive_frequency),
            .drive_phase = value_of(drive_phase)};
}

double value_at(const Sweep& sweep, std::size_t parameter, std::size_t combination) {
    return value(sweep.parameters[parameter], place(sweep, parameter, combination));
}

/// What no combination may be, though each of its parameters is legal.
void require_legal(const Sweep& sweep) {
    for (const auto& p : corners(sweep)) {
        if (!satisfies(Rule::positive, p.alpha))
            throw Failure{Status::bad_usage, say({"--gravity over --length is out of the range of doubles",
                                                  "--gravity entre --length se sale del rango de double"})};
        if (p.drive_amplitude != 0 && p.drive_frequency == 0)
            throw Failure{Status::bad_usage, say({"--drive-frequency must be greater than 0 where --drive-amplitude is not 0",
                                                  "--drive-frequency debe ser mayor que 0 donde --drive-amplitude no sea 0"})};
    }
}

}  // namespace

double value(const Parameter& p, std::size_t i) {
    if (i == 0) return p.first;
    if (i + 1 == p.count) return p.last;
    return p.first + static_cast<double>(i) * ((p.last - p.first) / static_cast<double>(p.count - 1));
}

Sweep sweep(const Options& options) {
    Sweep made;
    refuse_both(options, "--alpha", "--gravity");
    refuse_both(options, "--alpha", "--length");
    if (is_given(options, "--gravity") != is_given(options, "--length"))
        throw Failure{Status::bad_usage, say({"--gravity and --length go together", "--gravity y --length van juntas"})};
    made.has_length = is_given(options, "--length");
    for (std::size_t i = 0; i < swept_count; ++i) made.parameters[i] = read(options, swept_names[i]);
    double size = 1;
    for (const auto& name : options.order) {
        const auto* const stated = std::ranges::find(swept_names, name, &Stated::option);
        const auto i = static_cast<std::size_t>(stated - swept_names);
        if (i == swept_count || !made.parameters[i].is_range) continue;
        made.ranges.push_back(i);
        size *= static_cast<double>(made.parameters[i].count);
    }
    if (size > 0x1p53)
        throw Failure{
            Status::bad_data,
            say({"the ranges make {0} pendulums, more than 2^53", "los rangos dan {0} péndulos, más de 2^53"}, {shown(size)})};
    made.size = static_cast<std::size_t>(size);
    require_legal(made);
    return made;
}

std::size_t place(const Sweep& sweep, std::size_t parameter, std::size_t combination) {
    for (auto range = sweep.ranges.rbegin(); range != sweep.ranges.rend(); ++range) {
        const std::size_t n = sweep.parameters[*range].count;
        if (*range == parameter) return combination % n;
        combination /= n;
    }
    return 0;
}

Pendulum pendulum(const Sweep& sweep, std::size_t combination) {
    return pendulum_of(sweep, [&](Swept parameter) { return value_at(sweep, parameter, combination); });
}

State initial_state(const Sweep& sweep, std::size_t combination) {
    return {value_at(sweep, theta0, combination), value_at(sweep, omega0, combination)};
}

std::vector<Pendulum> corners(const Sweep& sweep) {
    std::vector<Pendulum> found;
    for (unsigned ends = 0; ends < 1u << swept_count; ++ends) {
        const auto end_of = [&](Swept i) { return ends >> i & 1 ? sweep.parameters[i].last : sweep.parameters[i].first; };
        found.push_back(pendulum_of(sweep, end_of));
    }
    return found;
}

Members members(const Sweep& sweep, std::size_t first, std::size_t count) {
    Members m;
    for (std::size_t i = first; i < first + count; ++i) {
        const auto p = pendulum(sweep, i);
        const auto s = initial_state(sweep, i);
        m.theta.push_back(s.theta);
        m.omega.push_back(s.omega);
        m.alpha.push_back(p.alpha);
        m.beta.push_back(p.beta);
        m.torque.push_back(p.torque);
        m.drive_amplitude.push_back(p.drive_amplitude);
        m.drive_frequency.push_back(p.drive_frequency);
        m.drive_phase.push_back(p.drive_phase);
    }
    return m;
}

}  // namespace pendula::cli
