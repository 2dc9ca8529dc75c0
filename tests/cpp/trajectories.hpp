// Runs trajectories to their end, whatever the blocks and budgets.
#pragma once

#include <vector>

#include "pendula/solve.hpp"

namespace reference {

inline std::vector<pendula::Sample> all_rows(const pendula::Problem& problem, std::size_t block = 4096, double budget = 1e9) {
    std::vector<pendula::Sample> rows;
    auto run = pendula::begin(problem);
    std::vector<pendula::Sample> some(block);
    // A budget of one step still goes on by at least a step a call.
    for (double calls = 0; !run.is_finished() && calls <= problem.schedule.steps() + problem.schedule.rows; ++calls) {
        const std::size_t n = pendula::advance(run, some, budget);
        rows.insert(rows.end(), some.begin(), some.begin() + static_cast<std::ptrdiff_t>(n));
    }
    return rows;
}

/// Rows after each of `rows` times `steps` steps of exactly h, the first row being the initial state.
inline pendula::Problem stepwise(pendula::Method method, double alpha, pendula::State initial, double h, double steps,
                                 double rows) {
    pendula::Problem problem;
    problem.pendulum.alpha = alpha;
    problem.initial = initial;
    problem.method = method;
    problem.schedule = {h * steps, rows + 1, steps};
    return problem;
}

/// The state after some steps of exactly h.
inline pendula::Sample after(pendula::Method method, double alpha, pendula::State initial, double h, double steps) {
    return all_rows(stepwise(method, alpha, initial, h, steps, 1)).back();
}

}  // namespace reference
