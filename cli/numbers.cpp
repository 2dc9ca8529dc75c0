#include "cli/numbers.hpp"

#include <charconv>
#include <cmath>
#include <cstring>

#include "cli/messages.hpp"
#include "cli/quantities.hpp"

namespace pendula::cli {

namespace {

/// How the texts of a kind are read.
struct Reader {
    Spelling (*spell)(std::string_view text, double& value);
    Words hint;  ///< what a number looks like
};
constexpr Reader decimal{
    spell_decimal, {"it is not a number; write it like 90, 1.5 or 2e-3", "no es un número; escríbelo como 90, 1.5 o 2e-3"}};
constexpr Reader number{
    spell_number,
    {"it is not a number; write it like 1.5, 2e-3, 2/3 or 3pi/4", "no es un número; escríbelo como 1.5, 2e-3, 2/3 o 3pi/4"}};
constexpr Reader degrees{
    spell_degrees,
    {"it is not a number of degrees; write it like 90 or 2/3", "no es un número de grados; escríbelo como 90 o 2/3"}};

bool is_number(const Reader& reader, std::string_view text) {
    double value;
    return reader.spell(text, value) == Spelling::good;
}

std::string replaced(std::string text, std::string_view old, std::string_view by) {
    for (std::size_t at = 0; (at = text.find(old, at)) != std::string::npos; at += by.size()) text.replace(at, old.size(), by);
    return text;
}

/// Characters that people, or the pages they copy from, put where `meant` belongs.
struct Slip {
    std::string_view typed, meant;
    Words message;
};
constexpr Words degree_sign{"it has a degree sign; write {0}, and the unit s behind it",
                            "tiene el signo de grado; escribe {0}, y detrás la unidad s"};
constexpr Words no_break_space{"it has a no-break space; write {0}", "tiene un espacio duro; escribe {0}"};
constexpr Slip slips[] = {
    {",", ".", {"it has a decimal comma; write {0}, with a point", "tiene coma decimal; escribe {0}, con punto"}},
    {"−", "-", {"it has a typographic minus; write {0}, with a hyphen", "tiene un menos tipográfico; escribe {0}, con guion"}},
    {"\u00a0", "", no_break_space},
    {"\u202f", "", no_break_space},
    {"°", "", degree_sign},
    {"º", "", degree_sign},
};

/// The text with the characters that were meant; `degree` for the degree signs.
std::string in_plain_characters(std::string_view text, std::string_view degree) {
    std::string plain(text);
    for (const Slip& slip : slips) plain = replaced(plain, slip.typed, slip.message.en == degree_sign.en ? degree : slip.meant);
    return plain;
}

/// What is wrong with a text that is no number, by the slips that people make.
std::string diagnosis(const Reader& reader, std::string_view text) {
    const std::string meant = in_plain_characters(text, "");
    for (const Slip& slip : slips) {
        if (text.find(slip.typed) == std::string_view::npos) continue;
        if (is_number(reader, meant)) return say(slip.message, {in_quotes(meant)});
        if (slip.message.en == no_break_space.en)
            return say({"it has a no-break space; type a plain one", "tiene un espacio duro; escribe uno normal"});
    }
    const auto digits = text.substr(text.starts_with('-') || text.starts_with('+'));
    if (digits.starts_with("0x") || digits.starts_with("0X"))
        return say({"hexadecimal is not read; write it in decimal", "no se lee en hexadecimal; escríbelo en decimal"});
    if (text.size() > 1 && (text.back() == 'r' || text.back() == 's') && is_number(reader, text.substr(0, text.size() - 1)))
        return say({"leave a space between the number and its unit {0}", "deja un espacio entre el número y su unidad {0}"},
                   {text.substr(text.size() - 1)});
    return say(reader.hint);
}

Parsed parse(const Reader& reader, std::string_view name, std::string_view text, Rule rule) {
    Parsed parsed;
    switch (reader.spell(text, parsed.value)) {
        case Spelling::good:
            if (!satisfies(rule, parsed.value))
                parsed.wrong = say({.reason = Refusal::Reason::interval, .value = parsed.value, .rule = rule},
                                   std::string(name) + ' ' + in_quotes(text));
            break;
        case Spelling::out_of_range:
            parsed.wrong = wrong_text(
                name, text,
                say({"its size must lie between 5e-324 and 1.8e308", "su tamaño debe estar entre 5e-324 y 1.8e308"}));
            break;
        case Spelling::zero_below:
            parsed.wrong = wrong_text(name, text, say({"it divides by zero", "divide por cero"}));
            break;
        case Spelling::bad:
            parsed.wrong = wrong_text(name, text, diagnosis(reader, text));
            break;
    }
    parsed.typed = parsed.value;
    return parsed;
}

}  // namespace

std::string wrong_text(std::string_view name, std::string_view text, std::string_view why) {
    return std::string(name) + ' ' + in_quotes(text) + ": " + std::string(why);
}

Parsed parse_number(std::string_view name, std::string_view text, Rule rule) { return parse(number, name, text, rule); }

Parsed parse_decimal(std::string_view name, std::string_view text, Rule rule) { return parse(decimal, name, text, rule); }

Parsed parse_angle(std::string_view name, std::string_view text, std::string_view suffix) {
    const bool is_in_degrees = text.ends_with(suffix);
    const auto digits = is_in_degrees ? text.substr(0, text.size() - suffix.size()) : text;
    Parsed parsed = parse(is_in_degrees ? degrees : number, name, digits, Rule::finite);
    parsed.is_in_degrees = is_in_degrees;
    if (is_in_degrees) spell_number(digits, parsed.typed);
    if (parsed.wrong.empty()) return parsed;
    const std::string meant = in_plain_characters(text, "deg");
    if (meant.find("deg") != text.find("deg") && meant.ends_with(suffix) &&
        is_number(degrees, meant.substr(0, meant.size() - suffix.size())))
        parsed.wrong = wrong_text(
            name, text, say({"it has a degree sign; write {0}", "tiene el signo de grado; escribe {0}"}, {in_quotes(meant)}));
    else
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

std::string shown(double value, int precision) {
    char digits[number_room];
    return {digits, put_number(digits, value, precision)};
}

}  // namespace pendula::cli
