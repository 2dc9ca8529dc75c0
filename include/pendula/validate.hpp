// What is legal: the rules that every boundary (program, Python, browser, C++ callers) applies before it calls the core.
#pragma once

#include <string>

#include "pendula/measure.hpp"

namespace pendula {

/// The intervals that arguments lie in.
enum class Rule {
    finite,        ///< any finite number
    positive,      ///< finite and > 0
    not_negative,  ///< finite and >= 0
    fraction,      ///< in (0, 1)
};

bool satisfies(Rule rule, double value) noexcept;

/// "alpha must be positive and finite, got -1".
std::string complaint(const std::string& name, double value, Rule rule);

/// Throws std::invalid_argument with `complaint` unless the value satisfies the rule.
void require(const std::string& name, double value, Rule rule);

/// Throws std::invalid_argument naming the first parameter outside its interval, its value and what is legal.
void validate(const Pendulum& pendulum);

/// The same for a whole problem: parameters, initial state, schedule, and a method that can do what is asked
/// (`exact` needs a conservative pendulum, `verlet` one without friction).
void validate(const Problem& problem);

/// The same for what the measures take of one member: parameters, counts, a method that they know, and steps short enough for
/// `rk4` to be stable (see `fewest_steps`).
void validate(const Pendulum& pendulum, const Strobe& strobe);

}  // namespace pendula
