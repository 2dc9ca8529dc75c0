// Taylor's method: a trajectory as polynomials in time, one for each step, of any tolerance down to a double's precision.
#pragma once

#include "pendula/pendulum.hpp"

namespace pendula {

/// One step: theta and omega as polynomials in x = (t - start)/unit. omega(t) is the sum of series[k] x^k / unit, and theta is
/// its integral from theta at the start.
struct TaylorPolynomial {
    Motion start;
    double t = 0, t_lo = 0;  ///< the step's start in two doubles [s]
    double unit = 1;         ///< a power of two [s]
    double length = 0;       ///< of the step [s]; NaN once the motion is not finite
    double series[26] = {};
    double series_1_lo = 0;  ///< what rounding has kept out of series[1]
};

/// A run of Taylor's method at one of its steps.
struct Taylor {
    Pendulum pendulum;
    int order = 0;             ///< of the polynomial of omega
    double log2_fraction = 0;  ///< log2 of the part of the radius of convergence that a step covers
    TaylorPolynomial step;
};

/// The first step of a trajectory from time t [s], to be continued by `step`.
///
/// The step's length follows from the tolerance as in Jorba & Zou, Experimental Mathematics 14 (2005): what the polynomials of a
/// step leave out is less than a hundredth of the tolerance, relative to the angle and its change in the step. tolerance in
/// (0, 1); the order is 25, or 13 from 1e-9 up, and below 2^-52 nothing more is gained. Memory and time of a step are constant.
///
/// At 1e-15, against 50 digits up to t = 50 (tests/cpp/taylor_test.cpp): within 1e-12 where the motion is chaotic, 1e-13
/// elsewhere; with a shaken pivot (tests/cpp/pivot_test.cpp) within 5e-15 times the growth of small displacements times the
/// largest angle or velocity. NaN throughout where the pendulum, the state, the tolerance or t is not legal.
Taylor make_taylor(const Pendulum& pendulum, State initial, double tolerance = 1e-15, double t = 0) noexcept;

/// On to the next step, which starts where this one ends.
void step(Taylor& run) noexcept;

/// Whether the step extends to time t [s]. A motion that is not finite reaches every time, as NaN.
bool reaches(const Taylor& run, double t) noexcept;

/// The state at time t [s] of the step: dense output, as accurate as the step's ends. NaN once the motion is not finite.
Sample at(const Taylor& run, double t) noexcept;

}  // namespace pendula
