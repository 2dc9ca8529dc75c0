// One trajectory, sampled: which rows there are, how many steps lie between them, and the rows themselves as a stream.
#pragma once

#include <cstddef>
#include <cstdint>

#include "pendula/exact.hpp"
#include "pendula/taylor.hpp"

namespace pendula {

enum class Method { rk4, euler, verlet, taylor, exact };

/// When to step and when to report [s]; all positive.
struct Times {
    double dt = 0;     ///< the longest step
    double every = 0;  ///< between rows
    double until = 0;  ///< the last row is at or before it
};

/// Rows and steps that follow from `Times`: rows at t_j = j every exactly, m equal steps between rows.
/// Counts are doubles so that too large ones can be told; see `Schedule::is_feasible`.
struct Schedule {
    double every = 0;
    double rows = 0;           ///< floor(until/every) + 1, with a relative slack of 1e-9
    double steps_per_row = 0;  ///< ceil(every/dt), same slack
    double step = 0;           ///< every/steps_per_row, at most dt

    double steps() const noexcept { return (rows - 1) * steps_per_row; }
    /// At most 2^53 rows and 2^53 steps.
    bool is_feasible() const noexcept;
};

/// The schedule of positive, finite times.
Schedule schedule(const Times& times) noexcept;

/// A problem: what swings, from where, how it is solved and when it is looked at.
struct Problem {
    Pendulum pendulum;
    State initial;
    Method method = Method::rk4;
    Schedule schedule;
    double tolerance = 1e-15;  ///< of `taylor`
};

/// A run in progress; memory does not grow with its length. Start it with `begin`.
struct Trajectory {
    Problem problem;
    Exact solution;               ///< of a conservative pendulum
    Taylor taylor;                ///< where that is the method
    double theta = 0, omega = 0;  ///< at the last step, theta in [-pi, pi)
    double turns = 0;
    double theta_lo = 0, omega_lo = 0;  ///< what rounding has kept out of them
    double rows_done = 0;               ///< rows delivered
    double steps_done = 0;              ///< steps taken since the last row
    bool is_resting = false;            ///< at rest on top, as far as the initial values can tell: every row is the first

    bool is_finished() const noexcept { return rows_done >= problem.schedule.rows; }
};

/// Puts a trajectory at its first row. Takes valid problems only (see validate.hpp).
Trajectory begin(const Problem& problem) noexcept;

/// Computes up to n further rows into `rows` and returns how many, taking at most about `step_budget` steps, so that a
/// caller can stop, report or go on between calls: 0 rows only says that the budget ran out. The bits of the rows depend
/// neither on n nor on the budget.
std::size_t advance(Trajectory& trajectory, std::size_t n, Sample* rows, double step_budget) noexcept;

}  // namespace pendula
