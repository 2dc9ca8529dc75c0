// What is wrong, in words: the boundary of the core, and its only part that throws.
#pragma once

#include <string>

#include "pendula/measure.hpp"

namespace pendula {

enum class Language { en, es };

/// "alpha must be positive and finite, got -1". Members of ensembles are named by their number. A face that spells the argument
/// otherwise, as the program its options, gives its own name for it.
std::string describe(const Refusal& refusal, Language language = Language::en, const std::string& name = {});

/// Throws std::invalid_argument with the description of a refusal, if there is one.
void require(const Refusal& refusal);

/// The same for the outcome of a call; returns whether it ran to its end.
bool require(const Outcome& outcome);

}  // namespace pendula
