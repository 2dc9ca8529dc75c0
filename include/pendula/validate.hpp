// Refusals as sentences, and as exceptions. Only these functions and `solve(Problem)` throw.
#pragma once

#include <string>

#include "pendula/measure.hpp"

namespace pendula {

enum class Language { en, es };

/// A sentence that describes a refusal, for example "alpha must be positive and finite, got -1". For a member of an ensemble it
/// ends with the number of the member. `name` replaces the name of the argument, for callers that spell it in another way, such
/// as the options of the program.
std::string describe(const Refusal& refusal, Language language = Language::en, const std::string& name = {});

/// Throws std::invalid_argument with the description of the refusal, if there is one.
void require(const Refusal& refusal);

/// Throws if the outcome is a refusal; otherwise returns whether the call is done, true, or was stopped, false.
bool require(const Outcome& outcome);

}  // namespace pendula
