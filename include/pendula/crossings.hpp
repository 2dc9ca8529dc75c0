// When a trajectory crosses an angle or comes to rest, to full precision, from the polynomials of Taylor's method.
#pragma once

#include "pendula/control.hpp"
#include "pendula/taylor.hpp"

namespace pendula {

/// What is crossed: theta through a whole number of turns, or omega through 0.
enum class Crossed { theta, omega };

struct Crossing {
    Sample sample;
    bool is_rising = false;  ///< whether what is crossed grows there
};

/// A search for crossings in progress.
///
/// Each step is cut where the derivative of what is crossed changes its sign, so that every piece has at most one crossing of a
/// level; the signs at the cuts then count crossings. The end of a step and the start of the next share their bits: no crossing
/// is missed or found twice, and rising and falling ones alternate. Where what is crossed comes closer to a level than its
/// rounding, some 1e-16, rounding decides whether it crosses twice or not at all. To touch a level exactly is no crossing, nor
/// is a start on it.
struct Crossings {
    Taylor run;
    Crossed crossed = Crossed::theta;
    double side = 0;       ///< the odd number 2 m + 1 between the levels m and m + 1; 0 until the level of the start is left
    double cuts[27] = {};  ///< of the step, in seconds since its start
    int cut_count = 0;
    int cut = 0;           ///< the next one to be looked at
    bool is_upon = false;  ///< the motion lies on a level exactly, since the sample `upon`
    Sample upon;
};

/// The search along a trajectory from time t [s]. Same arguments as `make_taylor`.
Crossings make_crossings(const Pendulum& pendulum, State initial, Crossed crossed, double tolerance = 1e-15,
                         double t = 0) noexcept;

/// The next crossing up to time `until` [s]. Its time is right to the rounding of what is crossed over its rate of change.
/// False where there is none, where the motion is not finite or would take more than 2^53 steps, or after about `step_budget`
/// steps; with `reaches(search.run, until)` the search is done, otherwise the call may be repeated.
bool next_crossing(Crossings& search, double until, Crossing& crossing, double step_budget = 0x1p53) noexcept;

/// The mean time [s] between crossings of theta through whole turns in the direction of the first, up to time `until` [s]: the
/// period of an oscillation or a rotation; of a motion of a longer period, the mean over the returns. Right to the rounding of
/// the times, so that more periods give more digits. NaN for fewer than two crossings.
Outcome measured_period(const Pendulum& pendulum, State initial, double until, double tolerance, double& period,
                        const Control& control = {}) noexcept;

}  // namespace pendula
