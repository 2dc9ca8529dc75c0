// Parameters that are one value each or go through a range, and all the pendulums that they make.
#pragma once

#include <array>
#include <vector>

#include "cli/options.hpp"
#include "pendula/ensemble.hpp"

namespace pendula::cli {

/// A parameter as options state it. Its values are those of numpy.linspace(first, last, count).
struct Parameter {
    std::string_view column;  ///< its name in tables
    double first = 0, last = 0;
    std::size_t count = 1;
    bool is_range = false;
};

double value(const Parameter& parameter, std::size_t i);

inline constexpr std::size_t swept_count = 10;

struct Sweep {
    std::array<Parameter, swept_count> parameters;
    std::vector<std::size_t> ranges;  ///< those that go through one, in the order given: the last varies fastest
    bool has_length = false;          ///< alpha is gravity/length
    std::size_t size = 1;             ///< combinations
};

/// Reads the parameters. Throws Failure with Status::bad_usage where one is not legal, or some combination of them.
Sweep sweep(const Options& options);

/// Which of its values a parameter has in a combination.
std::size_t place(const Sweep& sweep, std::size_t parameter, std::size_t combination);

/// The pendulum of a combination, and how it starts.
Pendulum pendulum(const Sweep& sweep, std::size_t combination);
State initial_state(const Sweep& sweep, std::size_t combination);

/// Pendulums that stand at the corners of all ranges: whatever grows or falls with each parameter is extreme at one of them.
std::vector<Pendulum> corners(const Sweep& sweep);

/// Some successive combinations, as an ensemble.
struct Members {
    std::vector<double> theta, omega, alpha, beta, torque, drive_amplitude, drive_frequency, drive_phase;

    Ensemble ensemble() const {
        return {theta.size(), theta, omega, alpha, beta, torque, drive_amplitude, drive_frequency, drive_phase};
    }
};

Members members(const Sweep& sweep, std::size_t first, std::size_t count);

}  // namespace pendula::cli
