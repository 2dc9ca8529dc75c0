// The closed form of the frictionless pendulum in every regime, by theta series in the phase t/tau.
#pragma once

#include <cstddef>

#include "pendula/analysis.hpp"

namespace pendula {

/// A conservative pendulum, prepared for evaluation at any time. docs/numerics.md derives the formulas.
///
/// The phase P = phase + rate t counts half periods of an oscillation or periods of a rotation. Its nearest whole number n
/// gives the sign of an oscillation or the turns of a rotation. The fraction f = P - n in [-1/2, 1/2] gives the state:
///     theta = 2 atan(s A(x)/B(x)),  omega = C(x)/D(x),
///     (s, c) = (sin, cos)(pi f), x = s^2;  or (s, c) = (sinh, cosh)(stretch f), x = -s^2.
/// A to D are cubics, some of them multiplied by c. On the separatrix P is the argument of sinh and cosh.
struct Exact {
    Analysis analysis;
    State initial;
    double phase = 0;    ///< P at t = 0
    double rate_hi = 0;  ///< dP/dt in two doubles [s^-1]
    double rate_lo = 0;
    double turns = 0;          ///< whole turns of the initial angle
    double stretch = 0;        ///< the argument of sinh and cosh for f = 1; 0 where sin and cos are used
    double angle_num[4] = {};  ///< coefficients of A
    double angle_den[4] = {};  ///< of B
    double speed_num[4] = {};  ///< of C [s^-1]
    double speed_den[4] = {};  ///< of D
    double latest = 0;         ///< returned by `latest_time` [s]
};

/// The prepared closed form. Same arguments as `analyze`. An argument outside its interval gives NaN at every time.
Exact make_exact(double alpha, State initial) noexcept;

/// The largest |t| [s] for which `at` and `sinusoid` give a result; beyond it they give NaN. It is at most 2^52 tau, where a
/// double can no longer count half periods. Close to the separatrix it is smaller: there it is the time at which the error of
/// the phase may reach 2^-41 of a period, because the period is known less well. It is at least 2^20 tau. On the separatrix,
/// which has no period, it is the largest double.
double latest_time(const Exact& solution) noexcept;

/// The state at time t [s] of either sign, |t| <= `latest_time`. theta in [-pi, pi) [rad], omega [rad/s], whole turns.
///
/// With kappa' = cos^2(theta0/2) - omega0^2/(4 alpha), the errors of theta [rad, mod 2 pi; relative to theta_max if that is
/// below 1] and of omega [relative to its maximum] are at most (tests/cpp/exact_test.cpp)
///     1e-14 for |t| <= 30 tau,
///     1e-13 for |t| <= 1e6 tau if |kappa'| >= 1e-12, and 1e-25/|kappa'| closer to the separatrix,
///     1e-13 up to `latest_time` if |kappa'| >= cos^2(theta0/2)/10, which holds for every start at rest; otherwise 1e-9.
/// On the separatrix omega decays to 0. With zeta(t) = asinh(tan(theta0/2)) +- sqrt(alpha) t, its relative error is at most (4
/// + 3 |zeta(t)| + 6 |zeta(0)|) 2^-53. The first of the bounds above can be twice as large there for a start within 1e-6 of the
/// top. NaN for a later time and for NaN.
Sample at(const Exact& solution, double t) noexcept;

/// `at` for n times, with the same bits, by the vector instructions of this processor. Input: t [s]. Outputs: theta in [-pi,
/// pi) [rad], omega [rad/s] and whole turns; n values each. The arrays must not overlap.
void at(const Exact& solution, std::size_t n, const double* t, double* theta, double* omega, double* turns) noexcept;

/// theta_max sin(2 pi t/tau + phi0) [rad], wrapped into [-pi, pi): the assignment's sinusoid (3.4) at time t [s]. NaN unless
/// the regime is oscillation, and for |t| > `latest_time`.
double sinusoid(const Exact& solution, double t) noexcept;

}  // namespace pendula
