#include "cli/numbers.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>

#include "cli/messages.hpp"
#include "pendula/angle.hpp"

namespace pendula::cli {

namespace {

enum class Spelling { good, out_of_range, bad };

Spelling spell(std::string_view text, double& value) {
    if (text.starts_with('+') && !text.substr(1).starts_with('-')) text.remove_prefix(1);
    // from_chars would take these words too.
    if (text.find_first_not_of("+-.0123456789eE") != std::string_view::npos) return Spelling::bad;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error == std::errc::invalid_argument || end != text.data() + text.size()) return Spelling::bad;
    return error == std::errc() ? Spelling::good : Spelling::out_of_range;
}

std::string legal(Rule rule) {
    switch (rule) {
        case Rule::positive:
            return say({"it must be a number greater than 0", "debe ser un número mayor que 0"});
        case Rule::not_negative:
            return say({"it must be a number not less than 0", "debe ser un número no menor que 0"});
        case Rule::fraction:
            return say({"it must be a number between 0 and 1", "debe ser un número entre 0 y 1"});
        case Rule::finite:
            break;
    }
    return say({"it must be a finite number", "debe ser un número finito"});
}

bool is_one_of(std::string_view text, std::initializer_list<std::string_view> words) {
    std::string lower(text.substr(text.starts_with('-') || text.starts_with('+')));
    std::transform(lower.begin(), lower.end(), lower.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? char(c + 32) : c; });
    return std::find(words.begin(), words.end(), lower) != words.end();
}

/// What is wrong with a text that is no number, by the slips that people make.
std::string diagnosis(std::string_view text, Rule rule) {
    double value;
    std::string other(text);
    std::replace(other.begin(), other.end(), ',', '.');
    if (other != text && spell(other, value) == Spelling::good)
        return say({"it has a decimal comma; write {0}, with a point", "tiene coma decimal; escribe {0}, con punto"},
                   {in_quotes(other)});
    if (is_one_of(text, {"nan", "inf", "infinity"})) return legal(rule);
    const auto digits = text.substr(text.starts_with('-') || text.starts_with('+'));
    if (digits.starts_with("0x") || digits.starts_with("0X"))
        return say({"hexadecimal is not read; write it in decimal", "no se lee en hexadecimal; escríbelo en decimal"});
    if (text.size() > 1 && (text.back() == 'r' || text.back() == 's') &&
        spell(text.substr(0, text.size() - 1), value) == Spelling::good)
        return say({"leave a space between the number and its unit {0}", "deja un espacio entre el número y su unidad {0}"},
                   {text.substr(text.size() - 1)});
    return say({"it is not a number; write it like 90, 1.5 or 2e-3", "no es un número; escríbelo como 90, 1.5 o 2e-3"});
}

}  // namespace

Parsed parse_number(std::string_view text, Rule rule) {
    Parsed parsed;
    switch (spell(text, parsed.value)) {
        case Spelling::good:
            if (!satisfies(rule, parsed.value)) parsed.wrong = legal(rule);
            break;
        case Spelling::out_of_range:
            parsed.wrong = say({"its size must lie between 5e-324 and 1.8e308", "su tamaño debe estar entre 5e-324 y 1.8e308"});
            break;
        case Spelling::bad:
            parsed.wrong = diagnosis(text, rule);
            break;
    }
    return parsed;
}

Parsed parse_angle(std::string_view text, std::string_view suffix) {
    const bool is_in_degrees = text.ends_with(suffix);
    if (is_in_degrees) text.remove_suffix(suffix.size());
    Parsed parsed = parse_number(text, Rule::finite);
    if (is_in_degrees) parsed.value = to_radians(parsed.value);
    if (!parsed.wrong.empty())
        parsed.wrong += say({" (radians; degrees like 90{0})", " (radianes; los grados, como 90{0})"}, {suffix});
    return parsed;
}

char* put_number(char* at, double value, int precision) {
    if (std::isnan(value)) return static_cast<char*>(std::memcpy(at, "nan", 3)) + 3;
    value += 0.0;  // -0 becomes 0
    char* const end = at + number_room;
    if (precision == full) return std::to_chars(at, end, value).ptr;
    return std::to_chars(at, end, value, std::chars_format::general, precision).ptr;
}

std::string shown(double value) {
    char digits[number_room];
    return {digits, put_number(digits, value, 6)};
}

}  // namespace pendula::cli
