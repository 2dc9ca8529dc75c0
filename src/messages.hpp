// What the program and the package's console scripts have in common: statuses, and the language of messages.
#pragma once

#include <span>
#include <string_view>

#include "pendula/validate.hpp"

namespace pendula {

/// How a program ends.
enum class Status : int { done = 0, bad_data = 1, bad_usage = 2, not_written = 3, interrupted = 130 };

/// The language of `--lang`, wherever it stands among the arguments; else that of LC_ALL, LC_MESSAGES or LANG, the first that is
/// set and not empty: Spanish if it begins with "es".
Language language_of(std::span<const std::string_view> arguments);

}  // namespace pendula
