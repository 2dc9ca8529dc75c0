// One trajectory, sampled at the times of a schedule: all rows at once, or a few at a time in constant memory.
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

/// Whether the user chooses the step of a method: `taylor` chooses its own, and `exact` has none.
constexpr bool takes_steps(Method method) noexcept { return method != Method::taylor && method != Method::exact; }

/// A problem: pendulum, initial state, method, and the times of the rows.
struct Problem {
    Pendulum pendulum;
    State initial;
    Method method = Method::rk4;
    Schedule schedule;
    double tolerance = 1e-15;  ///< for method `taylor`, in (0, 1)
};

/// Why a problem cannot be solved, or no refusal: an illegal parameter or schedule; a method that does not apply (`exact` needs
/// a conservative pendulum and times up to `latest_time`, `verlet` a pendulum without friction); or steps too long for the
/// friction. `euler` needs beta h <= 2 and `rk4` beta h <= 2.78; with longer steps rounding errors grow without bound.
Refusal check(const Problem& problem) noexcept;

/// All rows. Throws std::invalid_argument with the reason if the problem is refused, and std::bad_alloc if the rows do not fit
/// in memory.
std::vector<Sample> solve(const Problem& problem);

/// The state of a run. Its memory does not grow with the length of the run. It is made by `begin`.
struct Trajectory {
    Problem problem;
    Refusal refusal;          ///< why the problem is refused; such a run has no rows
    Exact solution;           ///< for a conservative pendulum
    Taylor taylor;            ///< for method `taylor`
    Motion motion;            ///< for the other methods: the state after the last step
    double rows_done = 0;     ///< rows returned so far
    double steps_done = 0;    ///< steps taken since the last row
    bool is_resting = false;  ///< `rests_on_top`: every row is the first

    bool is_finished() const noexcept { return refusal || rows_done >= problem.schedule.rows; }
};

/// The state of a run before its first row.
Trajectory begin(const Problem& problem) noexcept;

/// Computes the next rows and returns how many: at most as many as `rows` holds, with at most about `step_budget` steps. So the
/// caller can stop, report progress or continue between calls. A return value of 0 for an unfinished run means only that the
/// budget was used up. The bits of the rows depend neither on the length of `rows` nor on the budget
/// (tests/cpp/solve_test.cpp).
[[nodiscard]] std::size_t advance(Trajectory& trajectory, std::span<Sample> rows, double step_budget) noexcept;

}  // namespace pendula
