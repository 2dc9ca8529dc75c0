// A problem as people state it, with options or on standard input, and what becomes of it.
#pragma once

#include <optional>
#include <string>

#include "cli/messages.hpp"
#include "pendula/solve.hpp"

namespace pendula::cli {

/// Where a problem was stated: messages begin with the place, "problem 2, line 5: " on standard input. What is wrong with
/// options is bad usage.
struct Source {
    Status status = Status::bad_usage;
    std::string place = {};
};

struct Statement {
    Pendulum pendulum;
    State initial;
    Method method = Method::rk4;
    double tolerance = 1e-15;
    Durations durations;
    Source source;
};

/// A problem that is ready to be solved, with what is known about it beforehand.
struct Prepared {
    Problem problem;
    std::optional<Analysis> analysis;  ///< of a conservative pendulum
    Times times;                       ///< as asked
    Source source;
};

/// Throws Failure with the source's status, and its place before the message.
[[noreturn]] void refuse(const Source& source, const std::string& message);

/// Refuses numbers that are legal one by one and make no run.
Prepared prepare(const Statement& statement);

}  // namespace pendula::cli
