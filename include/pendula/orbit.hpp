// Periodic orbits of the strobe map, stable or not, by Newton's method.
#pragma once

#include "pendula/control.hpp"
#include "pendula/strobe.hpp"

namespace pendula {

/// A periodic orbit of the strobe map: a point that the map returns to itself after `period` periods of the strobe, up to
/// `turns` whole turns.
struct PeriodicOrbit {
    State point;                ///< theta in [-pi, pi) [rad], omega [rad/s]
    double error = 0;           ///< bound of the distance of the point from the orbit, in theta [rad] and omega/frequency
    double period = 0;          ///< in periods of the strobe
    double turns = 0;           ///< of theta in one period of the orbit; a whole number
    double trace = 0;           ///< of the monodromy matrix
    double determinant = 0;     ///< of the monodromy matrix: exp(-beta times the period), not measured
    double mismatch = 0;        ///< relative difference between the measured determinant and that
    double multiplier[2] = {};  ///< the real parts of Floquet's multipliers, the larger one in modulus first
    double imaginary = 0;       ///< the imaginary part of the first multiplier, >= 0; the second has the opposite one
    double exponent[2] = {};    ///< Floquet's exponents [s^-1]: ln |multiplier|/time, the larger first
    double exponent_error = 0;  ///< bound of the error of the exponents [s^-1]
    bool is_found = false;      ///< whether Newton's method converged, and not on rest where there is none
    bool is_stable = false;     ///< whether both multipliers are inside the unit circle, by more than their error
};

/// Refines a guess to a periodic orbit by Newton's method on the strobe map. The guess belongs to a time of the strobe;
/// drive_phase is not used. is_found is false if the method does not converge in 32 iterations. The result can be another orbit
/// than the nearest one, or one whose least period divides the given period. Refused where an argument is outside its interval.
Outcome refine(const Pendulum& pendulum, State guess, const Strobe& strobe, PeriodicOrbit& orbit,
               const Control& control = {}) noexcept;

}  // namespace pendula
