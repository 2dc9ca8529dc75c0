// Taylor's method: a trajectory as polynomials in time, one for each step, of any tolerance down to a double's precision.
#pragma once

#include "pendula/pendulum.hpp"

namespace pendula {

/// A run of Taylor's method at one of its steps, and the polynomials that hold from its start to its end.
///
/// omega(t) = sum of series[k] x^k / unit with x = (t - start)/unit, and theta is its integral from theta at the start.
struct Taylor {
    Pendulum pendulum;
    int order = 0;                ///< of the polynomial of omega
    double log2_fraction = 0;     ///< of the radius of convergence that a step goes
    double t = 0, t_lo = 0;       ///< the step's start in two doubles [s]
    double length = 0;            ///< of the step [s]; NaN once the motion is not finite
    double theta = 0, omega = 0;  ///< at the start, theta in [-pi, pi)
    double turns = 0;
    double theta_lo = 0, omega_lo = 0;  ///< what rounding has kept out of them
    double unit = 1;                    ///< a power of two [s]
    double series[26] = {};
    double series_1_lo = 0;  ///< what rounding has kept out of series[1]
};

/// The first step of a trajectory from time t [s], to be continued by `step`.
///
/// The step follows from the tolerance as in Jorba & Zou, Experimental Mathematics 14 (2005): what a step's polynomials leave
/// out is less than a hundredth of the tolerance, relative to the angle and its change in a step. tolerance in (0, 1); the
/// order is 25, or 13 from 1e-9 up, and from 2^-52 down nothing more is gained. Memory and time of a step are constants.
///
/// At 1e-15, against 50 digits up to t = 50 (tests/cpp/taylor_test.cpp): within 1e-12 where the motion is chaotic, 1e-13
/// elsewhere.
Taylor taylor(const Pendulum& pendulum, State initial, double tolerance = 1e-15, double t = 0) noexcept;

/// On to the next step, which starts where this one ends.
void step(Taylor& run) noexcept;

/// Whether the step goes on to time t [s]. A motion that is not finite reaches every time, as NaN.
bool reaches(const Taylor& run, double t) noexcept;

/// The state at time t [s] of the step: dense output, as accurate as the step's ends. NaN once the motion is not finite.
Sample at(const Taylor& run, double t) noexcept;

/// What is crossed: theta through a whole number of turns, or omega through 0.
enum class Crossed { theta, omega };

struct Crossing {
    Sample sample;
    bool is_rising = false;  ///< of what is crossed
};

/// A search for crossings in progress.
///
/// Each step is cut where the derivative of what is crossed changes its sign, so that every piece has a crossing of a level or
/// none; the signs at the cuts, of which the end of a step shares its bits with the start of the next, then count crossings:
/// none is missed or doubled, and rising ones take turns with falling ones. Where what is crossed comes closer to a level than
/// its rounding, some 1e-16, rounding decides whether it crosses twice or not at all. What only touches a level to the bit
/// does not cross it, nor does a start upon it.
struct Crossings {
    Taylor run;
    Crossed crossed = Crossed::theta;
    double side = 0;       ///< the odd number 2 m + 1 between the levels m and m + 1; 0 until the start's level is left
    double cuts[27] = {};  ///< of the step, in seconds since its start
    int cut_count = 0;
    int cut = 0;           ///< the next one to be looked at
    bool is_upon = false;  ///< a level, since:
    Sample upon;
};

/// The search along a trajectory from time t [s].
Crossings crossings(const Pendulum& pendulum, State initial, Crossed crossed, double tolerance = 1e-15, double t = 0) noexcept;

/// The next crossing up to time `until` [s], in time within the rounding of what is crossed over its rate of change.
/// False where there is none, where the motion is not finite or would take more than 2^53 steps, or after about `step_budget`
/// steps; with `reaches(search.run, until)` the search is done, otherwise the call may be repeated.
bool next_crossing(Crossings& search, double until, Crossing& crossing, double step_budget = 0x1p53) noexcept;

/// The mean time [s] between crossings of theta through whole turns in the direction of the first, up to time `until` [s]: the
/// period of an oscillation or a rotation, and of a motion of a longer period the mean over the returns. Within rounding of
/// the times, so that more periods give more digits. NaN for fewer than two.
double measured_period(const Pendulum& pendulum, State initial, double until, double tolerance = 1e-15) noexcept;

}  // namespace pendula
