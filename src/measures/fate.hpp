// What becomes of a motion, and the numbers that follow from that.
#pragma once

#include "ensemble/run.hpp"
#include "pendula/measure.hpp"
#include "pendula/orbit.hpp"

namespace pendula {

inline constexpr double nan = __builtin_nan("");

/// A number and a bound of its error.
struct Estimate {
    double value = nan;
    double error = nan;

    constexpr bool is_known() const noexcept { return value - value == 0; }
};

/// What becomes of a motion. The results of every measure but `section` are parts of it.
struct Fate {
    Kind kind = Kind::lost;
    State end{nan, nan};   ///< a point of the orbit, or the last state
    double period = 0;     ///< of the orbit, in periods of the strobe; 0 for none
    Estimate rotation{};   ///< turns in a period of the strobe
    Estimate velocity{};   ///< mean angular velocity [rad/s]
    Estimate exponent{};   ///< the larger Lyapunov exponent [s^-1]
    Estimate dimension{};  ///< Kaplan and Yorke's, in the plane of the section
};

/// Whether a pendulum without a drive has equilibria. Otherwise all its orbits turn over, though near alpha, where they are
/// slow, a state may move by less than a rounding in a period.
constexpr bool has_rest(const Pendulum& p) noexcept { return p.torque <= p.alpha && -p.torque <= p.alpha; }

/// Sets the rotation from the velocity.
void set_velocity(Fate& fate, Estimate velocity, double frequency) noexcept;

/// Sets the exponent, and the dimension that follows from it and from beta.
void set_exponent(Fate& fate, Estimate exponent, const Pendulum& pendulum) noexcept;

/// Finds what becomes of a pendulum without drive and shaken pivot. Returns false if the call was stopped.
bool settle_undriven(const Pendulum& pendulum, State initial, const Strobe& strobe, Thread& thread, Fate& fate) noexcept;

/// Newton's method for a periodic orbit, from a guess at a time of the strobe. It ends without a result when it leaves the
/// guess by more than `reach`, in theta [rad] and omega/sqrt(alpha). Returns false if the call was stopped.
bool refine_within(const Pendulum& pendulum, State guess, double period, double reach, const Strobe& strobe, Thread& thread,
                   PeriodicOrbit& orbit) noexcept;

/// The fate of a motion on a periodic orbit.
Fate fate_on(const PeriodicOrbit& orbit, const Pendulum& pendulum) noexcept;

}  // namespace pendula
