// Angles: units, the interval [-pi, pi), and the phase of a sinusoid.
#pragma once

namespace pendula {

/// The double nearest to pi; it lies 1.2e-16 below pi.
inline constexpr double pi = 0x1.921fb54442d18p+1;

/// The largest double of [-pi, pi): what angles of the interval that round to `pi` are given as.
inline constexpr double last_below_pi = 0x1.921fb54442d17p+1;

/// Radians of an angle in sexagesimal degrees, within 1 ulp. 180 gives `pi` exactly. NaN gives NaN.
double to_radians(double degrees) noexcept;

/// theta - 2 pi n in [-pi, pi), with the true pi in 2 pi n (3.3).
/// theta [rad]: any finite double. Within 1 ulp for |theta| <= 1e15 and inside the interval for all;
/// `-pi` stays, `pi` becomes `-pi`. NaN or infinite theta gives NaN.
double wrap(double theta) noexcept;

/// An angle in [-pi, pi) [rad] and the whole number of turns beside it: theta + 2 pi turns.
struct Angle {
    double theta = 0;
    double turns = 0;
};

/// The two parts of an unwrapped angle [rad]: `wrap(theta)`, and turns exact for |theta| <= 1e15.
Angle split_turns(double theta) noexcept;

/// The angle phi in [-pi, pi] [rad] with sin(phi) = s and cos(phi) of the sign of r (r = 0 counts as positive).
/// pi/2 for s >= 1 and -pi/2 for s <= -1. Within 2 ulp. NaN gives NaN.
double phase(double s, double r) noexcept;

}  // namespace pendula
