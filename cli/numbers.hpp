// Numbers that were read, with what is wrong with their text, and numbers as the program prints them: those of the C locale.
#pragma once

#include <string>
#include <string_view>

#include "pendula/parameters.hpp"

namespace pendula::cli {

/// A number that was read, or what is wrong with its text and what would be legal.
struct Parsed {
    double value = 0;
    std::string wrong;           ///< empty where the value stands
    bool is_in_degrees = false;  ///< whether an angle was typed in degrees
    double typed = 0;            ///< the value in the unit in which it was typed; angles are in radians otherwise
};

/// The number that the text of an option spells (quantities.hpp), if it satisfies the rule. Messages begin with `name`.
Parsed parse_number(std::string_view name, std::string_view text, Rule rule);

/// The same of a token of standard input, where numbers are decimal.
Parsed parse_decimal(std::string_view name, std::string_view text, Rule rule);

/// The angle or angular velocity [rad] of a number of radians, or of a number of degrees with `suffix` behind it.
Parsed parse_angle(std::string_view name, std::string_view text, std::string_view suffix);

/// What is wrong with the text given for `name`.
std::string wrong_text(std::string_view name, std::string_view text, std::string_view why);

/// Significant digits of every number printed; `full` is the fewest decimals that read back to the same double.
inline constexpr int full = 0;

/// The most bytes that `put_number` writes.
inline constexpr std::size_t number_room = 32;

/// Writes the value as C++ streams do in the C locale, with `precision` significant digits and never -0; returns the end.
/// NaN is written as `nan`.
char* put_number(char* at, double value, int precision);

/// `put_number` as a string; messages show six digits.
std::string shown(double value, int precision = 6);

}  // namespace pendula::cli
