// Taylor's method: a trajectory as a sequence of polynomials in time, one for each step, with any tolerance down to the
// precision of a double.
#pragma once

#include "pendula/pendulum.hpp"

namespace pendula {

/// One step: theta and omega as polynomials in x = (t - start)/unit. omega(t) is the sum of series[k] x^k, divided by unit;
/// theta is the integral of omega plus theta at the start of the step.
struct TaylorPolynomial {
    Motion start;
    double t = 0, t_lo = 0;  ///< the step's start in two doubles [s]
    double unit = 1;         ///< a power of two [s]
    double length = 0;       ///< of the step [s]; NaN if the motion is not finite
    double series[26] = {};  ///< 0 above the order
    double series_1_lo = 0;  ///< the rounding error of series[1]: its value is series[1] + series_1_lo; 0 below order 25
};

/// A run of Taylor's method and its present step.
struct Taylor {
    Pendulum pendulum;
    int order = 0;             ///< of the polynomial of omega: 25, 21 or 17
    double log2_fraction = 0;  ///< log2 of the step length divided by the radius of convergence
    TaylorPolynomial step;
};

/// The first step of the trajectory that starts at time t [s]. `step` continues it.
///
/// The length of a step follows from the tolerance as in Jorba & Zou, Experimental Mathematics 14 (2005). tolerance: in (0, 1);
/// the order is 25, 21 for a tolerance of 1e-12 or more, or 17 for 1e-5 or more, and a tolerance below 2^-52 gives the steps of
/// 2^-52. What a step leaves out is less than a fiftieth of the tolerance, and in 499 of 500 steps less than a hundredth,
/// relative to the angle and its change during the step (tests/cpp/taylor_tolerance_test.cpp); the rounding of a step is some
/// 1e-16 besides. Each step takes constant memory and time, and a run less time the looser the tolerance is.
///
/// Errors at a tolerance of 1e-15, against solutions with 50 digits up to t = 50: 1e-13 for regular motions and 1e-12 for
/// chaotic ones (tests/cpp/taylor_test.cpp). At looser ones up to 1e-4, 200 times the tolerance for regular motions and 2,000
/// times for chaotic ones, which grow a thousandfold (tests/cpp/taylor_tolerance_test.cpp). With a shaken pivot, at most 5e-15
/// times the growth of small displacements times the largest angle or velocity (tests/cpp/pivot_test.cpp). NaN at every time
/// if the pendulum, the state, the tolerance or t is not legal.
Taylor make_taylor(const Pendulum& pendulum, State initial, double tolerance = 1e-15, double t = 0) noexcept;

/// Replaces the present step by the next one, which starts where the present one ends.
void step(Taylor& run) noexcept;

/// Whether the present step extends to time t [s]. True for a motion that is not finite: its state is NaN at every later time.
bool reaches(const Taylor& run, double t) noexcept;

/// The state at time t [s] within the present step, by the polynomials: as accurate as the state at the end of the step. theta
/// in [-pi, pi) [rad], omega [rad/s], whole turns. NaN if the motion is not finite.
Sample at(const Taylor& run, double t) noexcept;

}  // namespace pendula
