// The equation of motion, its parameters and its state:
//     theta'' = -(alpha + pivot_amplitude cos(phase)) sin(theta) - beta theta' + torque + drive_amplitude cos(phase),
//     phase = drive_frequency t + drive_phase.
#pragma once

namespace pendula {

/// The parameters of the equation. The defaults are those of the frictionless, undriven pendulum with alpha = 1. parameters.hpp
/// lists them with symbols, units and intervals.
struct Pendulum {
    double alpha = 1;            ///< stiffness g/l [s^-2], > 0
    double beta = 0;             ///< damping [s^-1], >= 0
    double torque = 0;           ///< constant torque [s^-2]
    double drive_amplitude = 0;  ///< amplitude of a periodic torque [s^-2]
    double pivot_amplitude = 0;  ///< amplitude of the vertical acceleration of a shaken pivot, divided by the length l [s^-2]
    double drive_frequency = 0;  ///< angular frequency of drive and pivot [rad/s], >= 0; > 0 if either amplitude is not 0
    double drive_phase = 0;      ///< phase of drive and pivot at t = 0 [rad]
};

/// A point of phase space.
struct State {
    double theta = 0;  ///< angle from the bottom [rad]
    double omega = 0;  ///< angular velocity [rad/s]
};

/// A state during integration: the angle is wrapped and its turns are counted, and theta_lo and omega_lo are the rounding
/// errors of the sums theta and omega, kept for the next addition (Kahan). The exact sums are theta + theta_lo and omega +
/// omega_lo.
struct Motion {
    double theta = 0;  ///< in [-pi, pi) [rad]
    double omega = 0;  ///< [rad/s]
    double turns = 0;
    double theta_lo = 0, omega_lo = 0;
};

/// One row of a solution.
struct Sample {
    double t = 0;      ///< time [s]
    double theta = 0;  ///< angle in [-pi, pi) [rad]
    double omega = 0;  ///< angular velocity [rad/s]
    double turns = 0;  ///< whole turns: the unwrapped angle is theta + 2 pi turns
};

/// Whether the equation depends on time: there is a drive or a shaken pivot.
constexpr bool is_driven(const Pendulum& p) noexcept { return p.drive_amplitude != 0 || p.pivot_amplitude != 0; }

/// Whether there is no friction, torque, drive or shaken pivot: then energy is conserved and the closed form is valid.
constexpr bool is_conservative(const Pendulum& p) noexcept { return p.beta == 0 && p.torque == 0 && !is_driven(p); }

/// The angular acceleration [s^-2] at time t [s]: the right-hand side of the equation. NaN gives NaN.
double acceleration(const Pendulum& pendulum, State state, double t) noexcept;

/// The energy divided by m l^2 [s^-2]: omega^2/2 + alpha (1 - cos theta). It is 2 alpha on the separatrix. NaN gives NaN.
double energy(double alpha, State state) noexcept;

/// The unwrapped angle theta + 2 pi turns [rad], rounded once.
double unwrapped(const Sample& sample) noexcept;

}  // namespace pendula
