// How long-time measures sample their trajectories, and how long they go on.
#pragma once

#include "pendula/crossings.hpp"
#include "pendula/solve.hpp"

namespace pendula {

/// The surface on which a section is taken: times of the strobe, or the plane where theta (up to whole turns) or omega has a
/// given value.
enum class Plane { strobe, theta, omega };
inline constexpr const char* plane_names[] = {"strobe", "theta", "omega"};

/// How trajectories are sampled and how long they are followed.
///
/// The strobe samples once per period of the drive (or of the shaken pivot), at the times t_n = (2 pi n + phase -
/// drive_phase)/drive_frequency >= 0, where the phase of the drive is `phase`; with drive_frequency = 0, at t_n = 2 pi
/// n/sqrt(alpha).
///
/// The equation is the same after every t_n. So the time is counted from 0 again in each period, and no rounding errors of
/// times add up. At each t_n theta and omega are rounded to doubles, which are the reported ones. An orbit is thus the
/// iteration of a map from doubles to doubles, and can be continued from any of its points with the same bits.
struct Strobe {
    double transient = 200;          ///< periods before the measurement; a whole number >= 0
    double periods = 100;            ///< measured periods; a whole number >= 1
    double steps_per_period = 1000;  ///< for method `rk4`; a whole number >= 1
    Method method = Method::taylor;  ///< of the strobe map: `taylor` or `rk4`
    double tolerance = 1e-15;        ///< for method `taylor`, in (0, 1)
    double budget = 10000;           ///< periods after which a motion that has not settled is given up; a whole number >= 1
    double phase = 0;                ///< of the drive at the times of the strobe [rad]
    Plane plane = Plane::strobe;     ///< for `section`
    double level = 0;                ///< for `section` by a plane: the value of theta [rad] or omega [rad/s]
    Direction direction = Direction::both;  ///< for `section` by a plane
    double history_rows = 0;                ///< for `lyapunov`: rows of the history; a whole number from 0 to periods
    double match = 1e-6;                    ///< the distance at which a motion is on a periodic orbit; > 0
    double orbit_period = 1;                ///< for `orbit`: periods of the strobe after which the orbit closes; >= 1
};

/// The angular frequency of the strobe [rad/s]: drive_frequency, or sqrt(alpha) if that is 0. NaN for a driven pendulum with
/// drive_frequency = 0.
double strobe_frequency(const Pendulum& pendulum) noexcept;

/// The smallest number of steps per period for which `rk4` is stable: beta h <= 2.78 and sqrt(alpha + |pivot_amplitude|) h <=
/// 2.82, the bounds of its stability region on the real and the imaginary axis (Hairer & Wanner II, IV.2). `taylor` takes about
/// that many. Accurate results need tens of steps for each turn and each oscillation. NaN where `strobe_frequency` is NaN.
double fewest_steps(const Pendulum& pendulum) noexcept;

/// Why the pendulum cannot be measured with these settings, or no refusal: an illegal parameter, count or method, steps too
/// long for `rk4` to be stable, or more than 2^53 steps.
Refusal check(const Pendulum& pendulum, const Strobe& strobe) noexcept;

/// A number among the settings, as the interfaces offer it. The choices (method, plane, direction) have their lists of names.
struct Setting {
    const char* name;  ///< in Python; the option of the program has hyphens for underscores
    const char* unit;
    Words meaning;
    double Strobe::* value;
    unsigned measures;  ///< a bit, 1 << Measure, for each measure that uses it
    bool is_angle = false;
};

}  // namespace pendula
