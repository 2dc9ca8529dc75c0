// The times of the rows of a run and the steps between them: from times as users state them to whole numbers of rows and steps.
#pragma once

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

/// Rows and steps: row j is at t_j = first + j every; the run starts at t = 0, and equal steps lead from each row to the next.
/// The counts are doubles, so that a count too large for any integer type can still be reported.
struct Schedule {
    double every = 0;           ///< time between rows [s], > 0
    double rows = 0;            ///< number of rows; a whole number >= 1
    double steps_per_row = 1;   ///< a whole number >= 1
    double first = 0;           ///< time of the first row [s], >= 0
    double steps_to_first = 1;  ///< number of steps from the start to the first row, if first > 0; a whole number >= 1

    constexpr double time_of(double row) const noexcept { return first + row * every; }
    constexpr double steps() const noexcept { return (first > 0 ? steps_to_first : 0) + (rows - 1) * steps_per_row; }
};

/// The schedule of a run with these times, which are positive and finite. The first row is at t = 0; there are
/// floor(until/every) + 1 rows and ceil(every/dt) steps between two rows. Both quotients have a relative tolerance of 1e-9
/// before they are rounded.
Schedule make_schedule(const Times& times) noexcept;

/// The smallest number of equal steps, each at most dt [s], that cover a length of time [s]: ceil(length/dt), with a relative
/// tolerance of 1e-9; at least 1.
double steps_in(double length, double dt) noexcept;

}  // namespace pendula
