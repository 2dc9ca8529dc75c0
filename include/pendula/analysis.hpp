// Regime, amplitude and characteristic time of the frictionless pendulum (assignment 3.2, 3.5 to 3.9).
#pragma once

#include "pendula/control.hpp"

namespace pendula {

/// The kinds of motion; the values are the assignment's k.
enum class Regime : int { oscillation = -1, separatrix = 0, rotation = 1 };

/// What a conservative pendulum does.
struct Analysis {
    Regime regime = Regime::oscillation;
    double theta_max = 0;  ///< limit angle [rad]: the amplitude in (0, pi), or pi; -pi on the separatrix for omega < 0
    double tau = 0;        ///< characteristic time [s]: the period, or the time to 0.999 theta_max on the separatrix
};

/// Regime, amplitude and characteristic time, by the arithmetic-geometric mean.
///
/// Works on the energies alpha sin^2(theta/2) + omega^2/4 and alpha cos^2(theta/2) - omega^2/4 in double-double, so it is
/// right however near the separatrix. The regime is the separatrix when the second is zero within what one unit in the last
/// place of theta, omega and alpha can move it. At rest on top, or past 0.999 pi on the way up, tau is 10/sqrt(alpha).
///
/// alpha [s^-2]: positive and finite; initial: finite, theta not wrapped. theta_max and tau within 4 ulp.
/// Arguments outside give NaN in both.
Analysis analyze(double alpha, State initial) noexcept;

/// The unit of time that factors count in [s]: tau of `analyze` for a conservative pendulum; with friction or forcing the
/// period of the drive, where there is one, or 2 pi/sqrt(alpha). Within 4 ulp; NaN where `analyze` gives NaN.
double characteristic_time(const Pendulum& pendulum, State initial) noexcept;

/// Whether a pendulum without torque and drive starts at rest on top, as far as its angle can tell: there it stays, with friction
/// or without, and with a shaken pivot too.
bool rests_on_top(const Pendulum& pendulum, State initial) noexcept;

/// How many terms of the assignment's series (3.6) its cut (3.9) asks for, for a relative error below epsilon in (0, 1) of
/// the period. 0 on the separatrix, where (3.5) needs no series. NaN for arguments outside.
double series_terms(double alpha, State initial, double epsilon) noexcept;

/// The most terms that `analyze_by_series` will sum.
inline constexpr double series_terms_limit = 1e9;

/// `analyze` with the period summed by the assignment's series (3.6), (3.7) up to its cut (3.9). Refused where an argument is
/// outside its interval or `series_terms` exceeds `series_terms_limit`.
Outcome analyze_by_series(double alpha, State initial, double epsilon, Analysis& analysis, const Control& control = {}) noexcept;

}  // namespace pendula
