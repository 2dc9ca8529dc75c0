// Numbers as people type them: 1.5, 2/3, pi/2, 3*pi/4, and the same in degrees. Each is rounded once.
#pragma once

#include <string_view>

namespace pendula::cli {

enum class Spelling { good, out_of_range, zero_below, bad };

/// The double nearest to a decimal number, sign and exponent allowed; also inf and nan.
Spelling spell_decimal(std::string_view text, double& value);

/// The double nearest to a decimal number, or to [-+][a][*][pi][/b] with decimal numbers a and b: pi/2, 3pi/4, 2/3. π is the
/// same as pi. Correctly rounded where a and b have up to 18 digits and 10^±22 at most, else within 1 ulp.
Spelling spell_number(std::string_view text, double& value);

/// The same in degrees, without pi: the angle [rad] of `text` degrees.
Spelling spell_degrees(std::string_view text, double& value);

}  // namespace pendula::cli
