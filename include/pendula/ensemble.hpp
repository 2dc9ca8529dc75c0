// Many trajectories at once: structure of arrays in, rows out, on every core.
#pragma once

#include <span>

#include "pendula/solve.hpp"

namespace pendula {

/// Pendulums and their initial states, one value each or one for all: every span has 1 or `size` elements.
/// Symbols, units and intervals are those of `Pendulum` and `State`.
struct Ensemble {
    std::size_t size = 0;
    std::span<const double> theta, omega;
    std::span<const double> alpha, beta, torque, drive_amplitude, drive_frequency, drive_phase;
};

/// When members are looked at [s]: row j of a member is at first + j every, the start being t = 0. Spans have 1 or `size`
/// elements; `first` >= 0, `every` > 0.
struct EnsembleTimes {
    std::span<const double> first, every;
    std::size_t rows = 1;
    double steps_per_row = 1;  ///< of rk4: equal steps from row to row, and from the start to a first row later than it
};

/// How a long call is run.
struct Control {
    int threads = 0;                                                 ///< 0: as many as there are processors
    bool (*proceed)(void* context, double done) noexcept = nullptr;  ///< told the fraction done; false stops the call
    void* context = nullptr;
};

/// Where rows go: arrays of rows x size values, row by row. theta in [-pi, pi) [rad], omega [rad/s], whole turns.
struct EnsembleRows {
    double* theta = nullptr;
    double* omega = nullptr;
    double* turns = nullptr;
};

/// Solves every member by `rk4`, `taylor` (to `tolerance`) or `exact` and returns whether the call ran to its end.
///
/// A member's bits depend on its own parameters only, not on its neighbours, the number of threads or the instruction set,
/// and are those of `advance`. A member that diverges or is not legal becomes NaN in its own places.
/// Memory is the rows and a constant for each thread.
bool solve(const Ensemble& ensemble, Method method, double tolerance, const EnsembleTimes& times, const Control& control,
           const EnsembleRows& rows) noexcept;

}  // namespace pendula
