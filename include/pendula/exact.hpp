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
    double latest = 0;         ///< see `latest_time`
};

/// Prepares the closed form. Same domain as `analyze`; NaN throughout outside it.
Exact make_exact(double alpha, State initial) noexcept;

/// The largest |t| [s] at which `at` and `sinusoid` have an answer.
double latest_time(const Exact& solution) noexcept;

/// The state at time t [s], any finite t of either sign; |t|/tau up to 2^52 has a meaning.
/// theta within 1e-14 rad (mod 2 pi) and omega within 1e-14 of its maximum for |t| <= 30 tau, 1e-13 to 1e6 tau.
Sample at(const Exact& solution, double t) noexcept;

/// `at` for n times, with the same bits, by the widest registers of this processor: t [s] in; theta in [-pi, pi) [rad],
/// omega [rad/s] and turns out, n of each. The arrays must not overlap.
void at(const Exact& solution, std::size_t n, const double* t, double* theta, double* omega, double* turns) noexcept;

/// The assignment's sinusoid (3.4) at time t [rad], wrapped: theta_max sin(2 pi t/tau + phi0). NaN unless oscillating.
double sinusoid(const Exact& solution, double t) noexcept;

}  // namespace pendula
