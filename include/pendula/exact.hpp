// The closed form of the frictionless pendulum in every regime, by theta series in the phase t/tau.
#pragma once

#include <cstddef>

#include "pendula/analysis.hpp"

namespace pendula {

/// A conservative pendulum made ready to be evaluated at any time; docs/numerics.md derives it.
///
/// The phase P = phase + rate t counts half periods of an oscillation, periods of a rotation; its whole part n gives the sign
/// or the turns, and its fraction f in [-1/2, 1/2] the state: with (s, c) = (sin, cos)(pi f) and x = s^2, or
/// (s, c) = (sinh, cosh)(stretch f) and x = -s^2,
///     theta = 2 atan(s A(x)/B(x)),  omega = C(x)/D(x)
/// for cubics A to D, some of them times c. On the separatrix P is the argument of the sinh itself.
struct Exact {
    Analysis analysis;
    State initial;
    double phase = 0;    ///< P at t = 0
    double rate_hi = 0;  ///< dP/dt in two doubles [s^-1]
    double rate_lo = 0;
    double turns = 0;          ///< whole turns of the angle that the motion starts from
    double stretch = 0;        ///< argument of sinh and cosh for f = 1; 0 selects sin and cos
    double angle_num[4] = {};  ///< coefficients of A
    double angle_den[4] = {};  ///< of B
    double speed_num[4] = {};  ///< of C [s^-1]
    double speed_den[4] = {};  ///< of D
    double latest = 0;         ///< `latest_time` [s]
};

/// Prepares the closed form. Same domain as `analyze`; NaN throughout outside it.
Exact make_exact(double alpha, State initial) noexcept;

/// The latest time [s] of either sign that `at` and `sinusoid` serve; beyond it they give NaN. 2^52 tau, where a double no
/// longer counts half periods; near the separatrix less, where the period is not known well enough to tell the phase to 2^-41
/// of a period, but never less than 2^20 tau. On the separatrix, which has no period, the largest double.
double latest_time(const Exact& solution) noexcept;

/// The state at time t [s], |t| <= latest_time.
///
/// theta [rad, mod 2 pi] and omega [in units of its maximum] are within
///     1e-14 for |t| <= 30 tau,
///     1e-13 to 1e6 tau for |kappa'| >= 1e-12, and 1e-25/|kappa'| nearer to the separatrix,
///     1e-13 to latest_time where |kappa'| >= cos^2(theta/2)/10, as for all that start at rest; otherwise 1e-9.
/// On the separatrix omega decays to 0 with zeta = asinh(tan(theta/2)) +- sqrt(alpha) t, and its error, relative to itself, is
/// below (4 + 3 |zeta| + 6 |zeta(0)|) 2^-53. A start within 1e-6 of the top can double the first bound there.
Sample at(const Exact& solution, double t) noexcept;

/// `at` for n times, with the same bits, by the widest registers of this processor: t [s] in; theta in [-pi, pi) [rad],
/// omega [rad/s] and turns out, n of each. The arrays must not overlap.
void at(const Exact& solution, std::size_t n, const double* t, double* theta, double* omega, double* turns) noexcept;

/// The assignment's sinusoid (3.4) at time t [rad], wrapped: theta_max sin(2 pi t/tau + phi0). NaN unless oscillating.
double sinusoid(const Exact& solution, double t) noexcept;

}  // namespace pendula
