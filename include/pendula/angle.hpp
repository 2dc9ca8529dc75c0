// Angles: units, the interval [-pi, pi), and the phase of a sinusoid.
#pragma once

namespace pendula {

/// The double nearest to pi. It is 1.2e-16 less than pi.
inline constexpr double pi = 0x1.921fb54442d18p+1;

/// The largest double below `pi`. An angle of [-pi, pi) that rounds to `pi` is returned as this one.
inline constexpr double last_below_pi = 0x1.921fb54442d17p+1;

/// degrees pi/180 [rad], with the true pi. degrees: any finite double. Within 1 ulp (tests/cpp/angle_test.cpp); 180 gives `pi`.
/// An infinite argument or NaN gives NaN.
double to_radians(double degrees) noexcept;

/// theta - 2 pi n [rad] in [-pi, pi), for the whole number n that puts it there (3.3), with the true pi. theta [rad]: any
/// finite double. Within 1 ulp for |theta| <= 1e15 (tests/cpp/angle_test.cpp), and in the interval for every finite theta.
/// `-pi` gives `-pi`, and so does `pi`. An infinite theta or NaN gives NaN.
double wrap(double theta) noexcept;

/// An angle as theta + 2 pi turns, with theta in [-pi, pi) [rad] and a whole number of turns.
struct Angle {
    double theta = 0;
    double turns = 0;
};

/// An unwrapped angle [rad] split into `wrap(theta)` and whole turns. The number of turns is exact for |theta| <= 1e15.
Angle split_turns(double theta) noexcept;

/// The angle phi in [-pi, pi] [rad] with sin(phi) = s whose cosine has the sign of r (r = 0 counts as positive). s >= 1 gives
/// pi/2 and s <= -1 gives -pi/2. Within 2 ulp (tests/cpp/angle_test.cpp). NaN for s gives NaN; NaN for r counts as negative.
double phase(double s, double r) noexcept;

}  // namespace pendula
