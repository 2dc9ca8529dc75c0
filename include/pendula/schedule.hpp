// The times of the rows of a run and the steps between them: from times as users state them to whole numbers of rows and steps.
#pragma once

#include <cstddef>
#include <span>

namespace pendula {

/// A time [s], or a factor of the characteristic time of the pendulum.
struct Duration {
    double value = 0;
    bool is_factor = true;
};

/// The requested times of a run. The defaults are those of the assignment.
struct Durations {
    Duration dt{0.0001};   ///< the longest step
    Duration every{0.02};  ///< the time between rows
    Duration until{1};     ///< the largest time of a row
};

/// The requested times in seconds; all positive.
struct Times {
    double dt = 0;
    double every = 0;
    double until = 0;
};

/// The requested times in seconds. characteristic_time [s] multiplies those that are factors.
Times in_seconds(const Durations& durations, double characteristic_time) noexcept;

/// The smallest number of equal steps, each at most dt [s], that cover a length of time [s]: ceil(length/dt), with a relative
/// tolerance of 1e-9; at least 1.
double steps_in(double length, double dt) noexcept;

/// Rows and steps: row j is at t_j = first + j every; the run starts at t = 0, and equal steps lead from each row to the next.
/// The counts are doubles, so that a count too large for any integer type can still be reported.
///
/// If `times` is not empty, row j is at times[j]. The largest step is then `dt`, and the other members but `rows` are not used.
/// The schedule refers to the times and does not own them.
struct Schedule {
    double every = 0;                    ///< time between rows [s], > 0
    double rows = 0;                     ///< number of rows; a whole number >= 1
    double steps_per_row = 1;            ///< a whole number >= 1
    double first = 0;                    ///< time of the first row [s], >= 0
    double steps_to_first = 1;           ///< number of steps from the start to the first row, if first > 0; a whole number >= 1
    std::span<const double> times = {};  ///< of the rows [s], >= 0 and not decreasing; as many as `rows`
    double dt = 0;                       ///< the longest step between given times [s], > 0, for methods that take steps

    constexpr double time_of(double row) const noexcept {
        return times.empty() ? first + row * every : times[static_cast<std::size_t>(row)];
    }
    /// The number of all steps; between given times, a bound of it.
    constexpr double steps() const noexcept {
        if (!times.empty()) return dt > 0 ? times.back() / dt + rows : rows;
        return (first > 0 ? steps_to_first : 0) + (rows - 1) * steps_per_row;
    }
};

/// A schedule with a row at each of the given times [s], and steps of at most dt [s]. A method that takes no steps needs no dt.
constexpr Schedule make_schedule(std::span<const double> times, double dt = 0) noexcept {
    return {.rows = static_cast<double>(times.size()), .times = times, .dt = dt};
}

/// The schedule of a run with these times, which are positive and finite. The first row is at t = 0; there are
/// floor(until/every) + 1 rows and ceil(every/dt) steps between two rows. Both quotients have a relative tolerance of 1e-9
/// before they are rounded.
Schedule make_schedule(const Times& times) noexcept;

}  // namespace pendula
