// What the program says to people: in English or Spanish, on standard error, with a status that scripts can tell apart.
#pragma once

#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "src/messages.hpp"

namespace pendula::cli {

/// Ends the work. `main` tells the message, unless it is empty, and exits with the status.
struct Failure {
    Status status;
    std::string message;
};

void set_language(Language language);

/// The text in the language set, with values in place of {0}, {1}...
std::string say(const Words& text, std::initializer_list<std::string_view> values = {});
/// Why the library refused something; `name` is what the argument is called here.
std::string say(const Refusal& refusal, const std::string& name);

/// Failure with Status::bad_usage and such a text.
Failure bad_usage(const Words& text, std::initializer_list<std::string_view> values = {});

/// Writes "pendula: message" and a line end to standard error.
void tell(std::string_view message);

/// A token as messages show it: in quotes, at most `longest` bytes of it, what does not print escaped.
std::string in_quotes(std::string_view token, std::size_t longest = 40);

/// Why a system call failed, in the language set.
std::string reason(int error);

/// The words with commas, or another separator, between them.
std::string joined(const std::vector<std::string>& words, std::string_view separator = ", ");

/// The name that is the fewest typing slips away from `typed`, or else the first that ends in it; empty where there is none.
std::string nearest(std::string_view typed, const std::vector<std::string>& names);

}  // namespace pendula::cli
