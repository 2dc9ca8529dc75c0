// Taylor's method: a trajectory as polynomials in time, one for each step, of any tolerance down to a double's precision.
#pragma once

#include "pendula/pendulum.hpp"

namespace pendula {

/// A run of Taylor's method at one of its steps, and the polynomials that hold from its start to its end.
///
/// omega(t) = sum of series[k] x^k / unit with x = (t - start)/unit, and theta is its integral from theta at the start.
struct Taylor {
    Pendulum pendulum;
    int order = 0;                      ///< of the polynomial of omega
    double log2_fraction = 0;           ///< of the radius of convergence that a step goes
    double t = 0, t_lo = 0;             ///< the step's start in two doubles [s]
    double length = 0;                  ///< of the step [s]; NaN once the motion is not finite
    double theta = 0, omega = 0;        ///< at the start, theta in [-pi, pi)
    double turns = 0;
    double theta_lo = 0, omega_lo = 0;  ///< what rounding has kept out of them
    double unit = 1;                    ///< a power of two [s]
    double series[22] = {};
};

/// The first step of a trajectory from time t [s], to be continued by `step`.
///
/// Order and step follow from the tolerance as in Jorba & Zou, Experimental Mathematics 14 (2005): what a step's polynomials leave
/// out is a hundredth of the tolerance, relative to the angle and its change in a step. tolerance in (0, 1); from 2.3e-16 down
/// nothing more is gained. Memory and time of a step are constants.
Taylor taylor(const Pendulum& pendulum, State initial, double tolerance = 1e-15, double t = 0) noexcept;

/// On to the next step, which starts where this one ends.
void step(Taylor& run) noexcept;

/// Whether the step goes on to time t [s]. A motion that is not finite reaches every time, as NaN.
bool reaches(const Taylor& run, double t) noexcept;

/// The state at time t [s] of the step: dense output, as accurate as the step's ends. NaN once the motion is not finite.
Sample at(const Taylor& run, double t) noexcept;

}  // namespace pendula
