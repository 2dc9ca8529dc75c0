#include "cli/quantities.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>

#include "arithmetic/coefficients.hpp"
#include "arithmetic/double_double.hpp"

namespace pendula::cli {

namespace {

using Number = arithmetic::DoubleDouble<double>;

constexpr Number pi{arithmetic::pi_dd[0], arithmetic::pi_dd[1]};
constexpr Number radians_of_degree{arithmetic::pi_over_180_dd[0], arithmetic::pi_over_180_dd[1]};

/// number 2^exponent, with 1/2 <= |number| < 1 or number = 0: double-double needs room on both sides.
struct Scaled {
    Number number;
    int exponent = 0;
};

Scaled scaled(Number number) {
    Scaled made;
    made.number.hi = std::frexp(number.hi, &made.exponent);
    made.number.lo = std::ldexp(number.lo, -made.exponent);
    return made;
}

bool starts_a_number(std::string_view text) { return !text.empty() && (text[0] == '.' || (text[0] >= '0' && text[0] <= '9')); }

/// The decimal number of such digits, `nearest` to it, with what the rounding has lost if the digits are few.
Number with_rest(std::string_view text, double nearest) {
    constexpr std::size_t most_digits = 18;
    constexpr int largest_power = 22;  // of ten that is a double
    std::string digits;
    int exponent = 0;
    const auto e = std::min(text.find_first_of("eE"), text.size());
    for (const char c : text.substr(0, e))
        if (c != '.') digits += c;
    if (const auto point = text.substr(0, e).find('.'); point != std::string_view::npos)
        exponent = -static_cast<int>(e - point - 1);
    if (e < text.size()) {
        const auto written = text.substr(e + 1 + (text[e + 1] == '+'));
        int power = 0;
        std::from_chars(written.data(), written.data() + written.size(), power);
        exponent += power;
    }
    digits.erase(0, std::min(digits.find_first_not_of('0'), digits.size()));
    if (digits.empty() || digits.size() > most_digits || std::abs(exponent) > largest_power) return {nearest, 0};
    std::int64_t whole = 0;
    std::from_chars(digits.data(), digits.data() + digits.size(), whole);
    const auto high = static_cast<double>(whole);
    const Number integer{high, static_cast<double>(whole - static_cast<std::int64_t>(high))};
    double power = 1;
    for (int i = 0; i < std::abs(exponent); ++i) power *= 10;
    return exponent < 0 ? integer / Number{power, 0} : integer * power;
}

/// Takes an unsigned decimal number off the front.
std::optional<Scaled> take_decimal(std::string_view& text) {
    double value;
    if (!starts_a_number(text)) return {};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc()) return {};
    const auto length = static_cast<std::size_t>(end - text.data());
    const auto typed = text.substr(0, length);
    text.remove_prefix(length);
    return scaled(with_rest(typed, value));
}

bool take(std::string_view& text, std::string_view word) {
    if (!text.starts_with(word)) return false;
    text.remove_prefix(word.size());
    return true;
}

Spelling spell(std::string_view text, bool is_in_degrees, double& value) {
    const bool is_negative = take(text, "-");
    if (!is_negative) take(text, "+");
    const auto factor = take_decimal(text);
    const bool has_sign = factor && take(text, "*");
    const bool has_pi = !is_in_degrees && (take(text, "pi") || take(text, "π"));
    if (!has_pi && (!factor || has_sign)) return Spelling::bad;
    Scaled result = factor.value_or(Scaled{{1, 0}});
    const bool is_zero = result.number.hi == 0;
    if (has_pi) result.number = result.number * pi;
    if (is_in_degrees) result.number = result.number * radians_of_degree;
    if (take(text, "/")) {
        const auto below = take_decimal(text);
        if (!below) return Spelling::bad;
        if (below->number.hi == 0) return Spelling::zero_below;
        result = {result.number / below->number, result.exponent - below->exponent};
    }
    if (!text.empty()) return Spelling::bad;
    value = std::ldexp(is_negative ? -result.number.hi : result.number.hi, result.exponent);
    return std::isfinite(value) && (value != 0 || is_zero) ? Spelling::good : Spelling::out_of_range;
}

}  // namespace

Spelling spell_decimal(std::string_view text, double& value) {
    if (text.starts_with('+') && !text.substr(1).starts_with('-')) text.remove_prefix(1);
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error == std::errc::invalid_argument || end != text.data() + text.size()) return Spelling::bad;
    return error == std::errc() ? Spelling::good : Spelling::out_of_range;
}

Spelling spell_number(std::string_view text, double& value) {
    const auto spelling = spell_decimal(text, value);
    return spelling == Spelling::bad ? spell(text, false, value) : spelling;
}

Spelling spell_degrees(std::string_view text, double& value) {
    const auto spelling = spell_decimal(text, value);
    const bool is_decimal = spelling != Spelling::bad;
    return spelling == Spelling::out_of_range || (is_decimal && !std::isfinite(value)) ? spelling : spell(text, true, value);
}

}  // namespace pendula::cli
