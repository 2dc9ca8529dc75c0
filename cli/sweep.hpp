// Parameters that are one value each or go through a range, and all the pendulums that they make.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "cli/options.hpp"
#include "pendula/ensemble.hpp"

namespace pendula::cli {

/// The values of a parameter: those of numpy.linspace(first, last, count).
struct Range {
    double first = 0, last = 0;
    std::size_t count = 1;
    bool is_range = false;  ///< whether it was given as one
};

struct Sweep {
    std::array<Range, swept_count> values;
    std::vector<std::size_t> ranges;  ///< the parameters that go through one, in the order given: the last varies fastest
    bool has_length = false;          ///< alpha is gravity/length
    bool is_given = false;            ///< whether any parameter is
    std::size_t size = 1;             ///< members: combinations of values
};

/// Reads the parameters. Throws Failure with Status::bad_usage where one is not legal by itself.
Sweep read_sweep(const Options& options);

/// Refuses a sweep whose command takes one value for each parameter, or needs an initial angle.
void require_single(const Options& options, const Sweep& sweep);
void require_theta0(const Options& options);

/// The value of a parameter in a member.
double value_of(const Sweep& sweep, std::size_t parameter, std::size_t member);
Pendulum pendulum_of(const Sweep& sweep, std::size_t member);
State initial_state_of(const Sweep& sweep, std::size_t member);

/// Asks `check` for every member, before anything is printed. Throws Failure with Status::bad_usage for the first one refused,
/// with its values of the ranges.
void require_each(const Sweep& sweep, const std::function<Refusal(const Pendulum&)>& check);

/// What a message calls the argument that a refusal names.
std::string name_in_options(const Sweep& sweep, const Refusal& refusal);

/// The values of each parameter for some members, and the ensemble that points at them. It may be moved, not copied.
struct Members {
    std::array<std::vector<double>, parameter_count> columns;
    Ensemble ensemble;
};

Members members_of(const Sweep& sweep, std::size_t first, std::size_t count);

/// The names of the swept columns, behind which those of the results come.
std::vector<std::string_view> swept_names(const Sweep& sweep);
/// Writes the member's values of the ranges at a place, as the first fields of its rows; returns the end.
char* put_swept(char* at, const RowStyle& style, const Sweep& sweep, std::size_t member);
/// The empty lines behind a member, of gnuplot's grids: one where the last of several ranges ends, one more where the one
/// before it does, and so on.
std::string lines_behind(const Sweep& sweep, std::size_t member);

}  // namespace pendula::cli
