// The closed form of the frictionless pendulum in every regime, by theta series in the phase t/tau.
#pragma once

#include <cstddef>

#include "pendula/analysis.hpp"

namespace pendula {

/// A conservative pendulum made ready to be evaluated at any time: see docs/numerics.md, "Closed form".
/// theta(t) = 2 atan(s A(x)/B(x)) and omega(t) = C(x)/D(x) with cubics A, B, C, D in x = s^2 or -s^2, s a sine or a
/// hyperbolic sine of the phase; which, and whether a cosine multiplies B, C or D, depends on the regime.
struct Exact {
    Analysis analysis;
    State initial;
    double phase = 0;            ///< at t = 0, in units of the period; on the separatrix the argument of the sinh
    double rate_hi = 0;          ///< 1/tau, or on the separatrix +-sqrt(alpha), in two doubles [s^-1]
    double rate_lo = 0;
    double turns = 0;            ///< whole turns of the initial angle
    double sense = 1;            ///< -1 for a rotation towards negative angles
    double stretch = 0;          ///< argument of the sinh per unit of phase; 0 selects the trigonometric form
    double angle_num[4] = {};    ///< coefficients of A
    double angle_den[4] = {};    ///< of B
    double speed_num[4] = {};    ///< of C
    double speed_den[4] = {};    ///< of D
};

/// Prepares the closed form. Same domain as `analyze`; NaN throughout outside it.
Exact exact(double alpha, State initial) noexcept;

/// The state at time t [s], any finite t of either sign; |t|/tau up to 2^52 has a meaning.
/// theta within 1e-14 rad (mod 2 pi) and omega within 1e-14 of its maximum for |t| <= 30 tau, 1e-13 to 1e6 tau.
Sample at(const Exact& solution, double t) noexcept;

/// `at` for n times, with the same bits, by the widest registers of this processor. Overlapping arrays are not allowed.
void at(const Exact& solution, std::size_t n, const double* t, Sample* samples) noexcept;

/// The assignment's sinusoid (3.4) at time t [rad], wrapped: theta_max sin(2 pi t/tau + phi0). NaN unless oscillating.
double sinusoid(const Exact& solution, double t) noexcept;

}  // namespace pendula
