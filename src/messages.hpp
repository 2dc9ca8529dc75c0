// What the program and the console scripts of the Python package share: exit statuses, and the choice of the language.
#pragma once

#include <span>
#include <string_view>

#include "pendula/validate.hpp"

namespace pendula {

/// The exit statuses.
enum class Status : int { done = 0, bad_data = 1, bad_usage = 2, not_written = 3, interrupted = 130 };

/// The language given by `--lang`, at any place among the arguments. Without that option: Spanish if the first of LC_ALL,
/// LC_MESSAGES and LANG that is set and not empty begins with "es", otherwise English.
Language language_of(std::span<const std::string_view> arguments);

}  // namespace pendula
