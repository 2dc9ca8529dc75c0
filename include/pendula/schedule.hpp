// When a run is looked at, and how many steps lie between: from times as people state them to counts.
#pragma once

namespace pendula {

/// A time [s], or a factor of the pendulum's characteristic time.
struct Duration {
    double value = 0;
    bool is_factor = true;
};

/// What is asked of a run. The defaults are the assignment's.
struct Durations {
    Duration dt{0.0001};   ///< the longest step
    Duration every{0.02};  ///< between rows
    Duration until{1};     ///< the last row is at or before it
};

/// The same in seconds; all positive.
struct Times {
    double dt = 0;
    double every = 0;
    double until = 0;
};

Times in_seconds(const Durations& durations, double characteristic_time) noexcept;

/// Rows and steps: row j is at t_j = first + j every, the start being t = 0; equal steps lead from row to row.
/// Counts are doubles, so that one that is too large can be told.
struct Schedule {
    double every = 0;           ///< between rows [s], > 0
    double rows = 0;            ///< a whole number >= 1
    double steps_per_row = 1;   ///< a whole number >= 1
    double first = 0;           ///< [s], >= 0
    double steps_to_first = 1;  ///< where `first` is later than the start; a whole number >= 1

    constexpr double time_of(double row) const noexcept { return first + row * every; }
    constexpr double steps() const noexcept { return (first > 0 ? steps_to_first : 0) + (rows - 1) * steps_per_row; }
};

/// The schedule that follows from positive, finite times: rows from the start on, floor(until/every) + 1 of them, and
/// ceil(every/dt) steps between two, both with a relative slack of 1e-9.
Schedule make_schedule(const Times& times) noexcept;

/// How many equal steps of at most dt [s] there are in a length of time [s]: ceil(length/dt), with a relative slack of 1e-9;
/// at least 1.
double steps_in(double length, double dt) noexcept;

}  // namespace pendula
