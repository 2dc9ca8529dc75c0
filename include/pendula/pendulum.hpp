// The pendulum and its state: theta'' = -alpha sin(theta) - beta theta' + torque + drive_amplitude cos(drive_frequency t +
// drive_phase).
#pragma once

namespace pendula {

/// Parameters of the equation. The defaults are the frictionless, free pendulum of unit stiffness.
struct Pendulum {
    double alpha = 1;            ///< stiffness g/l [s^-2], > 0
    double beta = 0;             ///< damping [s^-1], >= 0
    double torque = 0;           ///< constant torque [s^-2]
    double drive_amplitude = 0;  ///< [s^-2]
    double drive_frequency = 0;  ///< angular frequency [rad/s], >= 0; > 0 where the amplitude is not 0
    double drive_phase = 0;      ///< [rad]
};

/// Where the pendulum is in phase space.
struct State {
    double theta = 0;  ///< angle from the bottom [rad]
    double omega = 0;  ///< angular velocity [rad/s]
};

/// One row of a solution.
struct Sample {
    double t = 0;      ///< time [s]
    double theta = 0;  ///< angle in [-pi, pi) [rad]
    double omega = 0;  ///< angular velocity [rad/s]
    double turns = 0;  ///< whole turns: the unwrapped angle is theta + 2 pi turns
};

/// Whether friction and forcing are absent, so that energy is conserved and the closed form holds.
constexpr bool is_conservative(const Pendulum& p) noexcept { return p.beta == 0 && p.torque == 0 && p.drive_amplitude == 0; }

/// Angular acceleration [s^-2] at time t [s]; the right-hand side of the equation.
double acceleration(const Pendulum& pendulum, State state, double t) noexcept;

/// Energy per unit m l^2 [s^-2]: omega^2/2 + alpha (1 - cos theta); 2 alpha on the separatrix.
double energy(double alpha, State state) noexcept;

/// The unwrapped angle theta + 2 pi turns [rad], rounded once.
double unwrapped(const Sample& sample) noexcept;

}  // namespace pendula
