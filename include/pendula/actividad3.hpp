// The five subalgorithms of the assignment under their Spanish names. Each calls the library's function and adds nothing.
#pragma once

namespace pendula::actividad3 {

/// True when `unidad` is known: 'r' (radians) or 's' (sexagesimal degrees). For 's' theta is converted to radians by
/// `to_radians`; in the other cases theta does not change.
bool validaAngulo(double& theta, char unidad) noexcept;

/// pendula::phase: the angle in [-pi, pi] [rad] whose sine is s and whose cosine has the sign of r (r = 0 counts as positive).
double fase(double s, double r) noexcept;

/// pendula::wrap (3.3): theta wrapped into [-pi, pi) [rad], for every finite theta.
double normaliza(double theta) noexcept;

/// pendula::analyze (3.2), (3.5) to (3.8): thetaM is the limit angle [rad], tau the characteristic time [s], and k the regime:
/// -1, 0 or 1. epsilon, the relative error that the assignment allows for tau, is not used: tau is within 4 ulp for every
/// epsilon.
void analisis(double alpha, double theta0, double omega0, double epsilon, double& thetaM, double& tau, int& k) noexcept;

/// One step of the Runge-Kutta method of order 4 (3.10), from t to t + dt, by pendula::rk4_step. theta is not wrapped. The
/// equation does not depend on t.
void RungeKutta(double alpha, double& theta, double& omega, double t, double dt) noexcept;

}  // namespace pendula::actividad3
