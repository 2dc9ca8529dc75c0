// Regime, amplitude and characteristic time of the frictionless pendulum (assignment 3.2, 3.5 to 3.9).
#pragma once

#include "pendula/control.hpp"

namespace pendula {

/// The kinds of motion. The values are those of the assignment's k.
enum class Regime : int { oscillation = -1, separatrix = 0, rotation = 1 };

/// The regime of a conservative pendulum, and its two characteristic numbers.
struct Analysis {
    Regime regime = Regime::oscillation;
    double theta_max = 0;  ///< limit angle [rad]: the amplitude, in [0, pi]; pi for a rotation; pi or -pi on the separatrix
    double tau = 0;        ///< characteristic time [s]: the period; on the separatrix the time to 0.999 theta_max
};

/// Regime, amplitude and characteristic time, by the arithmetic-geometric mean (DLMF 19.8).
///
/// In units of 2 m l^2 the energy is alpha sin^2(theta/2) + omega^2/4, and the energy that is missing to reach the top is alpha
/// cos^2(theta/2) - omega^2/4. Both are computed in double-double, so that the result is right close to the separatrix too. The
/// regime follows from the sign of the missing energy. It is the separatrix if a change of theta, omega and alpha by one unit
/// in the last place could make the missing energy zero.
///
/// alpha [s^-2]: positive and finite; initial: finite, theta need not be wrapped. On the separatrix theta_max has the sign of
/// omega (0 counts as positive). At rest at the top, or already past 0.999 theta_max, tau is 10/sqrt(alpha) by convention.
/// theta_max and tau are within 4 ulp (tests/cpp/analysis_test.cpp). Arguments outside their intervals give NaN in both.
Analysis analyze(double alpha, State initial) noexcept;

/// The characteristic time [s], the unit of the times that are given as factors. For a conservative pendulum it is tau of
/// `analyze`. Otherwise it is the period of the drive if there is a drive or a shaken pivot, and 2 pi/sqrt(alpha) if there is
/// none. Arguments as for `analyze`. Within 4 ulp; NaN where `analyze` gives NaN.
double characteristic_time(const Pendulum& pendulum, State initial) noexcept;

/// Whether the pendulum starts at rest at the top, to the precision of its initial angle, and stays there: omega is 0, there is
/// no torque and no drive, and `analyze` finds the separatrix. Friction and a shaken pivot do not move it.
bool rests_on_top(const Pendulum& pendulum, State initial) noexcept;

/// The smallest N that satisfies (3.9): the number of terms after the first that the series (3.6) needs for a relative error of
/// the period below epsilon, which lies in (0, 1). 0 on the separatrix, where (3.5) needs no series. Arguments outside their
/// intervals give NaN.
double series_terms(double alpha, State initial, double epsilon) noexcept;

/// The largest number of terms that `analyze_by_series` sums.
inline constexpr double series_terms_limit = 1e9;

/// Computes the same as `analyze`, with the period from the series (3.6), (3.7), summed up to the N of (3.9). Refused if an
/// argument is outside its interval or if `series_terms` is larger than `series_terms_limit`.
Outcome analyze_by_series(double alpha, State initial, double epsilon, Analysis& analysis,
                          const Control& control = {}) noexcept;

/// The inverse of `analyze` for oscillations: the amplitude [rad], in [0, pi], of the frictionless pendulum whose period is
/// tau. Let go at rest from this angle, it swings with that period.
///
/// It solves tau sqrt(alpha)/4 = K(sin(amplitude/2)) by Newton's method in double-double. alpha [s^-2]: positive and finite.
/// tau [s]: finite, and at least 2 pi/sqrt(alpha), the period of small swings; its nearest double gives 0. Within 2 ulp of the
/// amplitude for exactly these doubles (tests/cpp/analysis_test.cpp). From some 151/sqrt(alpha) on the amplitude rounds to
/// `pi`. Other arguments give NaN.
double amplitude_of_period(double alpha, double tau) noexcept;

}  // namespace pendula
