// What becomes of many pendulums in the long run: stroboscopic sections, mean velocities, Lyapunov exponents, attractors.
// Nothing is stored on the way: memory is the results and a constant for each thread.
#pragma once

#include "pendula/ensemble.hpp"

namespace pendula {

/// How members are looked at: once a period of the drive, at t_n = (2 pi n - drive_phase)/drive_frequency >= 0, where its
/// phase is 0; where drive_frequency is 0, at t_n = 2 pi n/sqrt(alpha).
///
/// The equation is the same at every t_n, so that each period is computed as if it were the first, and no rounding of times
/// adds up. There theta and omega are rounded to the doubles that are reported: an orbit is one of a map of doubles, and
/// may be taken up again from any of its points.
struct Strobe {
    double transient = 0;            ///< periods before what is measured begins; a whole number >= 0
    double periods = 1;              ///< that are measured; a whole number >= 1
    double steps_per_period = 1000;  ///< of `rk4`; a whole number >= 1
    Method method = Method::rk4;     ///< `rk4` or `taylor`
    double tolerance = 1e-15;        ///< of `taylor`
};

/// The angular frequency of the strobe [rad/s]: drive_frequency, or sqrt(alpha) where it is 0. NaN where a drive has none.
double strobe_frequency(const Pendulum& pendulum) noexcept;

/// The fewest steps a period with which `rk4` is stable: beta h <= 2.78 and sqrt(alpha) h <= 2.82, the bounds of its region
/// on the two axes (Hairer & Wanner II, IV.2). `taylor` takes some as many. Accuracy needs tens of steps for each turn and
/// swing.
double fewest_steps(const Pendulum& pendulum) noexcept;

// Each of the measures below returns whether it ran to its end. A member's bits depend on its own parameters only, not on its
// neighbours, the number of threads or the instruction set. One that diverges or is not legal becomes NaN in its own places.

/// The states at `periods` successive t_n, the first after the transient: arrays of periods x size, row by row.
bool section(const Ensemble& ensemble, const Strobe& strobe, const Control& control, const EnsembleRows& rows) noexcept;

/// Mean angular velocity [rad/s] over the periods measured, from turns and the difference of two angles: nothing is summed.
/// Over drive_frequency it is the rotation number; for a Josephson junction it is the voltage.
bool mean_velocity(const Ensemble& ensemble, const Strobe& strobe, const Control& control, double* velocity) noexcept;

/// The largest Lyapunov exponent of each member [s^-1] and how far to trust it.
struct LyapunovValues {
    double* exponent = nullptr;
    double* error = nullptr;    ///< standard error [s^-1]; NaN from a single period
    double* horizon = nullptr;  ///< ln(2^52)/exponent [s], when rounding has grown to all there is; else infinite
    double* history = nullptr;  ///< rows x size estimates, row j from the first floor((j + 1) periods/rows) of the periods
    std::size_t rows = 0;       ///< of the history, at most as many as periods; 0 for none
};

/// The largest Lyapunov exponent: the mean growth, over the periods measured, of ln |(d theta, d omega/sqrt(alpha))|, where
/// the displacement follows the linearised equation and is brought back to length 1 every period, or sooner (Benettin et al.,
/// Meccanica 15, 1980). It begins with the transient, so that it has turned to the direction that grows.
///
/// The standard error is that of the mean of 32 blocks (fewer if there are fewer periods), and holds where a block is longer
/// than the growth's memory, some periods; of itself it is uncertain by 13 %. On regular orbits the estimate oscillates about
/// the exponent by no more than a constant over the time, or falls like ln(t)/t where neighbours drift apart evenly; the
/// error is then of the size of the departure. The other exponent is -beta less this one.
bool lyapunov(const Ensemble& ensemble, const Strobe& strobe, const Control& control, const LyapunovValues& values) noexcept;

/// Where members end: arrays of size values.
struct OrbitValues {
    double* period = nullptr;    ///< of the stroboscopic orbit, in periods of the strobe; 0 where none was found
    double* rotation = nullptr;  ///< mean velocity over strobe_frequency: whole turns over the period, if there is one
    double* theta = nullptr;  ///< the point of a periodic orbit of the smallest theta in [-pi, pi) [rad], else the last point
    double* omega = nullptr;  ///< [rad/s]
};

/// The periodic orbits that members settle on. An orbit is periodic when it comes back, up to whole turns, within `match` in
/// theta [rad] and in omega/strobe_frequency; the period is the smallest such, found if it began to come back before half of
/// the periods measured and is no longer than a quarter of them.
bool orbits(const Ensemble& ensemble, const Strobe& strobe, double match, const Control& control,
            const OrbitValues& values) noexcept;

/// A periodic orbit that some members have settled on.
struct Attractor {
    double period = 0;
    double rotation = 0;
    State point;  ///< of the orbit, the one of the smallest theta
    std::size_t members = 0;
    std::size_t exemplar = 0;  ///< the first member on it
};

/// The most attractors that are told apart.
inline constexpr std::size_t attractors_limit = 256;

/// Numbers the attractors of one pendulum from what `orbits` has found, 1, 2, ... by period, rotation, theta and omega of their
/// points, and puts each member's number into `label`: 0 where its orbit is not periodic, or beyond the first 256 attractors.
/// Members are on the same one if period and rotation are equal and the point of one lies within `match` of the other's orbit.
/// Returns how many attractors there are in `found`, which has room for attractors_limit.
std::size_t label_attractors(const Pendulum& pendulum, const Strobe& strobe, double match, std::size_t size,
                             const OrbitValues& values, int* label, Attractor* found) noexcept;

}  // namespace pendula
