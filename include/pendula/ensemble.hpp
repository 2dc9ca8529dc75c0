// Many trajectories at once: columns in, rows out, on every core.
#pragma once

#include <span>

#include "pendula/control.hpp"
#include "pendula/solve.hpp"

namespace pendula {

/// When members are looked at [s]: row j of a member is at first + j every, the start being t = 0.
struct EnsembleTimes {
    Column first = 0.0;           ///< >= 0
    Column every = 1.0;           ///< > 0; of no account for a single row
    std::size_t rows = 1;         ///< >= 1
    Column steps_to_first = 1.0;  ///< equal steps from the start to a first row later than it; a whole number >= 1
    Column steps_per_row = 1.0;   ///< equal steps from row to row; a whole number >= 1
};

/// Where rows go: arrays of rows x size values, row by row. theta in [-pi, pi) [rad], omega [rad/s], whole turns.
struct EnsembleRows {
    std::span<double> theta, omega, turns;
};

/// Solves every member by any method (`taylor` to `tolerance`).
///
/// A member's bits depend on its own parameters only, not on its neighbours, the number of threads or the instruction set,
/// and are those of `advance`. A member whose motion leaves the doubles becomes NaN in its own places. Refused as a whole where a
/// member, a length, a count or the method is not legal. Memory is the rows, a place in a list for each member whose number
/// of steps is its own, and a constant for each thread.
Outcome solve(const Ensemble& ensemble, Method method, double tolerance, const EnsembleTimes& times, const EnsembleRows& rows,
              const Control& control = {}) noexcept;

}  // namespace pendula
