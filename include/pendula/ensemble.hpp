// Many trajectories at once, on several threads: columns of parameters in, rows of states out.
#pragma once

#include <span>

#include "pendula/control.hpp"
#include "pendula/solve.hpp"

namespace pendula {

/// The times of the rows [s]: row j of a member is at first + j every, or at times[j] for all members. The member starts at
/// t = 0.
struct EnsembleTimes {
    Column first = 0.0;           ///< >= 0
    Column every = 1.0;           ///< > 0; not used if there is only one row
    std::size_t rows = 1;         ///< >= 1
    Column steps_to_first = 1.0;  ///< number of equal steps from the start to the first row, if first > 0; a whole number >= 1
    Column steps_per_row = 1.0;   ///< number of equal steps between rows; a whole number >= 1
    std::span<const double> times = {};  ///< if not empty: `rows` times, >= 0 and not decreasing; only they and dt are used
    Column dt = 0.0;                     ///< the longest step between given times [s], > 0, for methods that take steps
};

/// The arrays that receive the rows: rows x size values each, row by row. theta in [-pi, pi) [rad], omega [rad/s], whole turns.
struct EnsembleRows {
    std::span<double> theta, omega, turns;
};

/// Computes the rows of every member by the given method. `tolerance` is used by `taylor` only.
///
/// A member's bits are those of `advance` (solve.hpp) for that member alone. They do not depend on the other members, the
/// number of threads or the instruction set (tests/cpp/ensemble_test.cpp). Where a member's motion overflows, its own values
/// become NaN and no others. The whole call is refused if a member, the length of a column or of a result, a count, or the
/// method is not legal. Besides the rows, memory is constant for each thread; where numbers of steps are given member by
/// member, `rk4` also sorts the members, which takes 8 bytes for each.
Outcome solve(const Ensemble& ensemble, Method method, double tolerance, const EnsembleTimes& times, const EnsembleRows& rows,
              const Control& control = {}) noexcept;

}  // namespace pendula
