// The times at which a trajectory crosses an angle or its velocity changes sign, from the polynomials of Taylor's method.
#pragma once

#include "pendula/control.hpp"
#include "pendula/taylor.hpp"

namespace pendula {

/// The crossed quantity and its levels: theta at whole multiples of 2 pi, or omega at 0.
enum class Crossed { theta, omega };

struct Crossing {
    Sample sample;
    bool is_rising = false;  ///< whether the crossed quantity increases there
};

/// The state of a search for crossings.
///
/// Each step of the trajectory is divided at the points where the derivative of the crossed quantity changes its sign. On each
/// part the quantity is monotone and crosses a level at most once, so that the signs at the ends of the parts count the
/// crossings. A step's last value and the next step's first value have the same bits: no crossing is missed or found twice, and
/// at one level rising and falling crossings alternate. Where the quantity approaches a level to within its rounding error,
/// about 1e-16, rounding decides whether there are two crossings or none. A motion that touches a level and turns back does not
/// cross it, nor does a motion that starts on it.
struct Crossings {
    Taylor run;
    Crossed crossed = Crossed::theta;
    double side = 0;       ///< 2 m + 1 between the levels m and m + 1; 0 while still on the level of the start
    double cuts[27] = {};  ///< the ends of the parts of the step, in seconds from its start
    int cut_count = 0;
    int cut = 0;           ///< index of the part that is searched next
    bool is_upon = false;  ///< the last value was exactly on a level, first reached at `upon`
    Sample upon;
};

/// Starts a search along the trajectory that begins at time t [s]. The other arguments are those of `make_taylor`, with the
/// same intervals; an argument outside its interval gives a search without crossings.
Crossings make_crossings(const Pendulum& pendulum, State initial, Crossed crossed, double tolerance = 1e-15,
                         double t = 0) noexcept;

/// Finds the next crossing up to time `until` [s] and returns true. The error of its time is about the rounding error of the
/// crossed quantity divided by its rate of change (tests/cpp/crossings_test.cpp). Returns false if there is no such crossing,
/// if the motion is not finite, if it would take more than 2^53 steps, or after about `step_budget` steps. The search is
/// complete if `reaches(search.run, until)` then holds; otherwise the call may be repeated.
bool next_crossing(Crossings& search, double until, Crossing& crossing, double step_budget = 0x1p53) noexcept;

/// Computes the period [s]: the mean time between crossings of theta through multiples of 2 pi in the direction of the first,
/// up to time `until` [s]. That is the period of an oscillation or a rotation; where the motion repeats only after several
/// crossings, it is the mean over them. The error is that of two crossing times, divided by the number of periods. NaN if there
/// are fewer than two such crossings. Refused where an argument is outside its interval: until >= 0 and finite, tolerance in
/// (0, 1).
Outcome measured_period(const Pendulum& pendulum, State initial, double until, double tolerance, double& period,
                        const Control& control = {}) noexcept;

}  // namespace pendula
