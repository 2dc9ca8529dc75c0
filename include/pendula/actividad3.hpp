// The five subalgorithms of the assignment under their own names: thin forwards to the library.
#pragma once

namespace pendula::actividad3 {

/// Converts theta to radians from `unidad`: 'r' radians, 's' sexagesimal degrees. Another unit: false, theta untouched.
bool validaAngulo(double& theta, char unidad) noexcept;

/// pendula::phase: the angle of sine s whose cosine has the sign of r (r = 0 counts as positive).
double fase(double s, double r) noexcept;

/// pendula::wrap: theta in [-pi, pi), for every finite theta (3.3).
double normaliza(double theta) noexcept;

/// pendula::analyze (3.2), (3.5) to (3.8): limit angle, characteristic time, and k = -1, 0 or 1.
/// epsilon is the relative error asked of tau, which is right to 4 ulp whatever it says.
void analisis(double alpha, double theta0, double omega0, double epsilon, double& thetaM, double& tau, int& k) noexcept;

/// One step of Runge-Kutta's method of order 4 (3.10), from t to t + dt; theta is not wrapped. The equation does not depend on
/// t.
void RungeKutta(double alpha, double& theta, double& omega, double t, double dt) noexcept;

}  // namespace pendula::actividad3
