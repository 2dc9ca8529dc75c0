// Parameters that are one value each or go through a range, and all the pendulums that they make.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "cli/options.hpp"
#include "pendula/ensemble.hpp"

namespace pendula::cli {

/// The values of a parameter: those of numpy.linspace(first, last, count), in the unit in which they were typed.
struct Range {
    double first = 0, last = 0;  ///< in radians, of angles
    std::size_t count = 1;
    bool is_range = false;                   ///< whether it was given as one
    bool is_in_degrees = false;              ///< whether its ends were typed in degrees
    double typed_first = 0, typed_last = 0;  ///< the ends of a range as they were typed
};

struct Sweep {
    std::array<Range, swept_count> values;
    std::vector<std::size_t> ranges;  ///< the parameters that go through one, in the order given: the last varies fastest
    bool has_length = false;          ///< alpha is gravity/length
    bool has_tau = false;             ///< theta0 is the amplitude of a period
    bool is_given = false;            ///< whether any parameter is
    std::size_t size = 1;             ///< members: combinations of values
};

/// Reads the parameters. Throws Failure with Status::bad_usage where one is not legal by itself.
Sweep read_sweep(const Options& options);

/// Refuses a sweep whose command takes one value for each parameter, or needs an initial angle (or the period in its place).
void require_single(const Options& options, const Sweep& sweep);
void require_theta0(const Options& options);

/// The value of a parameter in a member; and as it was typed, in degrees where these were.
double value_of(const Sweep& sweep, std::size_t parameter, std::size_t member);
double typed_value_of(const Sweep& sweep, std::size_t parameter, std::size_t member);
Pendulum pendulum_of(const Sweep& sweep, std::size_t member);
State initial_state_of(const Sweep& sweep, std::size_t member);
/// The period [s] of a member, where it is given.
double tau_of(const Sweep& sweep, std::size_t member);

/// Whether a parameter has a value of its own: alpha, or gravity and length.
bool has_value(const Sweep& sweep, std::size_t parameter);

/// The same without the ranges of the initial state, and which of its members has the pendulum of a member of `sweep`.
Sweep pendulums_of(const Sweep& sweep);
std::size_t member_in(const Sweep& pendulums, const Sweep& sweep, std::size_t member);

/// Asks `check` for every member, before anything is printed. Throws Failure with Status::bad_usage for the first one refused,
/// with its values of the ranges.
void require_each(const Sweep& sweep, const std::function<Refusal(const Pendulum&)>& check);

/// "where --beta is 1, --torque is 2: ", of the ranges; nothing where there are none.
std::string place_of(const Sweep& sweep, std::size_t member);

/// What a message calls the argument that a refusal names.
std::string name_in_options(const Sweep& sweep, const Refusal& refusal);

/// The values of each parameter for some members, and the ensemble that points at them. It may be moved, not copied.
struct Members {
    std::array<std::vector<double>, parameter_count> columns;
    Ensemble ensemble;
};

Members members_of(const Sweep& sweep, std::size_t first, std::size_t count);

/// The name of a swept column: "theta0", or "theta0_deg" where the range was typed in degrees.
std::string swept_name(const Sweep& sweep, std::size_t parameter);
/// The names of the swept columns, behind which those of the results come.
std::vector<std::string> swept_names(const Sweep& sweep);
/// Writes the member's values of the ranges at a place, as they were typed, from a field of its rows on; returns the end.
char* put_swept(char* at, const RowStyle& style, const Sweep& sweep, std::size_t member, std::size_t field = 0);
/// The empty lines behind a member, of gnuplot's grids: one where the last of several ranges ends, one more where the one
/// before it does, and so on.
std::string lines_behind(const Sweep& sweep, std::size_t member);

}  // namespace pendula::cli
