// What the program says to people: in English or Spanish, on standard error, with a status that scripts can tell apart.
#pragma once

#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pendula::cli {

enum class Status : int { done = 0, bad_data = 1, bad_usage = 2, not_written = 3, interrupted = 130 };

/// Ends the work. `main` tells the message, unless it is empty, and exits with the status.
struct Failure {
    Status status;
    std::string message;
};

/// One text in both languages, with {0}, {1}... where values go.
struct Text {
    std::string_view en, es;
};

enum class Language { en, es };

/// The language of LC_ALL, LC_MESSAGES or LANG, the first that is set and not empty: Spanish if it begins with "es".
Language language_of_environment();
void set_language(Language language);

/// The text in the language set, its places filled in.
std::string say(const Text& text, std::initializer_list<std::string_view> values = {});

/// Writes "pendula: message" and a line end to standard error.
void tell(std::string_view message);

/// A token as messages show it: in quotes, at most 40 bytes of it, what does not print escaped.
std::string in_quotes(std::string_view token);

/// Why a system call failed, in the language set.
std::string reason(int error);

/// The words with commas between them.
std::string joined(const std::vector<std::string_view>& words);

/// The one of the names that is the fewest typing slips away from `typed`; empty where none is near.
std::string_view nearest(std::string_view typed, std::span<const std::string_view> names);

}  // namespace pendula::cli
