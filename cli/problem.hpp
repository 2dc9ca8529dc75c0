// A problem as people state it, whatever they state it with, and what becomes of it.
#pragma once

#include <optional>
#include <string_view>

#include "pendula/solve.hpp"

namespace pendula::cli {

/// A time [s], or a factor of the pendulum's own time.
struct Duration {
    double value;
    bool is_factor = true;
};

/// The defaults are the assignment's.
struct Statement {
    Pendulum pendulum;
    State initial;
    Method method = Method::rk4;
    double tolerance = 1e-15;
    Duration dt{0.0001}, every{0.02}, until{1};
};

/// A problem that is ready to be solved, with what is known about it beforehand.
struct Prepared {
    Problem problem;
    std::optional<Analysis> analysis;  ///< of a conservative pendulum
    double dt = 0, until = 0;          ///< as asked [s]
};

/// Throws Failure with Status::bad_data, its message beginning with `place`, where numbers that are legal one by one make
/// no run: out of the range of doubles, or longer than 2^53 steps.
Prepared prepare(const Statement& statement, std::string_view place);

}  // namespace pendula::cli
