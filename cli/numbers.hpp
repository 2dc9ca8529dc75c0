// Numbers as people write them and as the program prints them: always those of the C locale.
#pragma once

#include <string>
#include <string_view>

#include "pendula/validate.hpp"

namespace pendula::cli {

/// A number that was read, or what is wrong with its text and what would be legal.
struct Parsed {
    double value = 0;
    std::string wrong;  ///< empty where the value stands
};

/// The finite decimal number that `text` spells, sign and exponent allowed, if it satisfies the rule.
Parsed parse_number(std::string_view text, Rule rule);

/// The angle or angular velocity [rad] of a bare number of radians, or of one of degrees followed by `suffix`.
Parsed parse_angle(std::string_view text, std::string_view suffix);

/// Significant digits of every number printed; `full` is the fewest decimals that read back to the same double.
inline constexpr int full = 0;

/// The most bytes that `put_number` writes.
inline constexpr std::size_t number_room = 32;

/// Writes the value as C++ streams do in the C locale, with `precision` significant digits and never -0; returns the end.
/// NaN is written as `nan`.
char* put_number(char* at, double value, int precision);

/// `put_number` with six digits, as messages show numbers.
std::string shown(double value);

}  // namespace pendula::cli
