// One trajectory, sampled: all rows at once, or as a stream whose memory does not grow.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "pendula/exact.hpp"
#include "pendula/parameters.hpp"
#include "pendula/schedule.hpp"
#include "pendula/taylor.hpp"

namespace pendula {

enum class Method { rk4, euler, verlet, taylor, exact };

/// The names of the methods, in the order of the enumerators.
inline constexpr const char* method_names[] = {"rk4", "euler", "verlet", "taylor", "exact"};

/// Whether a method takes steps of a length that is chosen for it: Taylor's chooses its own, and the closed form has none.
constexpr bool takes_steps(Method method) noexcept { return method != Method::taylor && method != Method::exact; }

/// A problem: what swings, from where, how it is solved and when it is looked at.
struct Problem {
    Pendulum pendulum;
    State initial;
    Method method = Method::rk4;
    Schedule schedule;
    double tolerance = 1e-15;  ///< of `taylor`, in (0, 1)
};

/// What is wrong with a problem: parameters, schedule, a method that cannot do what is asked (`exact` needs a conservative
/// pendulum and times up to `latest_time`, `verlet` one without friction), or steps too long for friction: euler needs
/// beta h <= 2 and rk4 beta h <= 2.78, or rounding grows without bound.
Refusal check(const Problem& problem) noexcept;

/// All rows. Throws std::invalid_argument with what is wrong, and std::bad_alloc where memory does not hold them.
std::vector<Sample> solve(const Problem& problem);

/// A run in progress; memory does not grow with its length. Start it with `begin`.
struct Trajectory {
    Problem problem;
    Refusal refusal;         ///< of a problem that is not legal; such a run has no rows
    Exact solution;          ///< of a conservative pendulum
    Taylor taylor;           ///< where that is the method
    Motion motion;           ///< at the last step of the others
    double rows_done = 0;    ///< rows delivered
    double steps_done = 0;   ///< steps taken since the last row
    bool is_resting = false; ///< at rest on top, as far as the initial values can tell: every row is the first

    bool is_finished() const noexcept { return refusal || rows_done >= problem.schedule.rows; }
};

/// Puts a trajectory at its first row.
Trajectory begin(const Problem& problem) noexcept;

/// Computes further rows and returns how many, at most as many as `rows` holds, taking at most about `step_budget` steps, so
/// that a caller can stop, report or go on between calls: 0 rows only says that the budget ran out. The bits of the rows depend
/// neither on the number asked for nor on the budget.
[[nodiscard]] std::size_t advance(Trajectory& trajectory, std::span<Sample> rows, double step_budget) noexcept;

}  // namespace pendula
