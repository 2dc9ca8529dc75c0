#include "cli/reading.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <span>

#include "cli/messages.hpp"
#include "cli/numbers.hpp"
#include "cli/terminal.hpp"
#include "pendula/angle.hpp"

namespace pendula::cli {

namespace {

constexpr std::size_t capacity = 1 << 16;
constexpr std::size_t longest_token = 4096;

bool fill(Tokens& tokens) {
    const bool is_first = !tokens.buffer;
    if (is_first) tokens.buffer = std::make_unique_for_overwrite<char[]>(capacity);
    ssize_t count;
    do {
        wait_for_input();
        count = ::read(STDIN_FILENO, tokens.buffer.get(), capacity);
    } while (count < 0 && (errno == EINTR || errno == EAGAIN));
    if (count < 0)
        throw Failure{
            Status::bad_data,
            say({"standard input could not be read: {0}", "no se ha podido leer la entrada estándar: {0}"}, {reason(errno)})};
    tokens.end = static_cast<std::size_t>(count);
    const bool has_mark = is_first && std::string_view(tokens.buffer.get(), tokens.end).starts_with("\xef\xbb\xbf");
    tokens.begin = has_mark ? 3 : 0;  // the byte order mark that some editors put first
    return tokens.begin < tokens.end;
}

bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

/// What stands at a place of a problem: a number, or the unit of the number before it.
struct Field {
    Words name;
    Rule rule = Rule::finite;
    bool is_unit = false;
};

constexpr Field fields[] = {
    {.name = {"factorΔ", "factorΔ"}, .rule = Rule::positive},
    {.name = {"factorcout", "factorcout"}, .rule = Rule::positive},
    {.name = {"factortSimul", "factortSimul"}, .rule = Rule::positive},
    {.name = {"θ0", "θ0"}},
    {.name = {"the unit of θ0", "la unidad de θ0"}, .is_unit = true},
    {.name = {"ω0", "ω0"}},
    {.name = {"the unit of ω0", "la unidad de ω0"}, .is_unit = true},
    {.name = {"α", "α"}, .rule = Rule::positive},
};
constexpr std::size_t field_count = std::size(fields);
constexpr std::size_t first_of_state = 3;

/// Stores what the token says in value[0], or as a unit in value[-1]; returns what is wrong with it.
std::string take(const Field& field, const std::string& token, double* value) {
    const auto wrong = [&](const std::string& why) { return wrong_text(say(field.name), token, why); };
    if (token.size() > longest_token)
        return wrong(say({"it is longer than {0} bytes", "tiene más de {0} bytes"}, {std::to_string(longest_token)}));
    if (!field.is_unit) {
        const Parsed parsed = parse_decimal(say(field.name), token, field.rule);
        *value = parsed.value;
        return parsed.wrong;
    }
    if (token == "s") value[-1] = to_radians(value[-1]);
    if (token == "r" || token == "s") return {};
    return wrong(
        say({"it must be r (radians) or s (sexagesimal degrees)", "debe ser r (radianes) o s (grados sexagesimales)"}));
}

std::string missing(std::span<const Field> absent, const Words& where) {
    std::vector<std::string> names;
    for (const Field& field : absent) names.push_back(say(field.name));
    return say(where) + joined(names);
}

State state(const double* values) { return {values[first_of_state], values[first_of_state + 2]}; }

}  // namespace

Next next(Tokens& tokens) {
    tokens.token.clear();
    while (tokens.begin < tokens.end || fill(tokens)) {
        const char c = tokens.buffer[tokens.begin];
        if ((is_space(c) || c == '#') && !tokens.token.empty()) return Next::token;
        ++tokens.begin;
        if (c == '#') tokens.is_comment = true;
        if (c == '\n') {
            ++tokens.line;
            tokens.is_comment = false;
            return Next::line_end;
        }
        if (!tokens.is_comment && !is_space(c) && tokens.token.size() <= longest_token) tokens.token += c;
    }
    return tokens.token.empty() ? Next::input_end : Next::token;
}

bool has_line(const Tokens& tokens) {
    return tokens.begin < tokens.end && std::memchr(tokens.buffer.get() + tokens.begin, '\n', tokens.end - tokens.begin);
}

std::optional<Statement> read_problem(Tokens& tokens, std::size_t number) {
    double values[field_count] = {};
    std::size_t line = tokens.line;  // of the last token there was
    const auto place = [&] {
        return say({"problem {0}, line {1}: ", "problema {0}, línea {1}: "}, {std::to_string(number), std::to_string(line)});
    };
    for (std::size_t i = 0; i < field_count; ++i) {
        Next kind;
        do {
            kind = next(tokens);
        } while (kind == Next::line_end);
        if (kind == Next::input_end && i == 0) return {};
        if (kind == Next::token) line = tokens.line;
        const std::string wrong = kind == Next::token
                                      ? take(fields[i], tokens.token, values + i)
                                      : missing(std::span(fields).subspan(i), {"the input ends too soon; missing: ",
                                                                               "la entrada termina antes de tiempo; falta: "});
        if (!wrong.empty()) throw Failure{Status::bad_data, place() + wrong};
    }
    return Statement{.pendulum = {.alpha = values[field_count - 1]},
                     .initial = state(values),
                     .durations = {{values[0]}, {values[1]}, {values[2]}},
                     .source = {Status::bad_data, place()}};
}

std::optional<ReadLine> read_line(Tokens& tokens) {
    Next kind;
    std::size_t line;
    do {
        line = tokens.line;
        kind = next(tokens);
    } while (kind == Next::line_end);
    if (kind == Next::input_end) return {};
    double values[field_count] = {};
    std::string wrong;
    std::size_t i = first_of_state;
    for (; kind == Next::token; kind = next(tokens), ++i) {
        if (!wrong.empty()) continue;
        wrong = i < field_count
                    ? take(fields[i], tokens.token, values + i)
                    : say({"{0}: nothing may follow α", "{0}: tras α no puede haber nada"}, {in_quotes(tokens.token)});
    }
    if (wrong.empty() && i < field_count)
        wrong = missing(std::span(fields).subspan(i),
                        {"the line ends too soon; missing: ", "la línea termina antes de tiempo; falta: "});
    return ReadLine{
        {.alpha = values[field_count - 1]}, state(values), say({"line {0}: ", "línea {0}: "}, {std::to_string(line)}), wrong};
}

}  // namespace pendula::cli
