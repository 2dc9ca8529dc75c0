// La actividad 3 como la escribiría una buena estudiante: las fórmulas del enunciado, sin cambios, con <cmath>. Sirve de
// referencia para comparar tiempos y no usa nada de pendula.
#pragma once

#include <cmath>

namespace estudiante {

const double PI = std::acos(-1.0);

inline bool validaAngulo(double& theta, char unidad) {
    if (unidad == 's') theta *= PI / 180;
    return unidad == 'r' || unidad == 's';
}

inline double fase(double s, double r) {
    if (s >= 1) return PI / 2;
    if (s <= -1) return -PI / 2;
    return r >= 0 ? std::asin(s) : PI - std::asin(s);
}

/// (3.3)
inline double normaliza(double theta) { return theta - 2 * PI * std::floor((theta + PI) / (2 * PI)); }

/// La serie (3.6), (3.7), con el número de términos de (3.9).
inline double periodo(double T0, double r, double epsilon) {
    if (r == 0) return T0;
    const double N = std::log(epsilon * (1 - r * r)) / (2 * std::log(r));
    double a = 1, suma = 1;
    for (double n = 1; n <= N; n++) {
        const double factor = (2 * n - 1) / (2 * n) * r;
        a *= factor * factor;
        suma += a;
    }
    return T0 * suma;
}

/// (3.2), (3.5) a (3.8).
inline void analisis(double alpha, double theta0, double omega0, double epsilon, double& thetaM, double& tau, int& k) {
    const double energia = omega0 * omega0 / (2 * alpha) - std::cos(theta0);
    if (std::fabs(energia - 1) < 1e-14) {
        k = 0;
        thetaM = omega0 >= 0 ? PI : -PI;
        const double C = 1 / std::tan(theta0 / 4 + PI / 4);
        tau = std::log(C * std::tan(0.999 * thetaM / 4 + PI / 4)) / std::sqrt(alpha);
        if (omega0 < 0) tau = -tau;
    } else if (energia < 1) {
        k = -1;
        thetaM = std::acos(-energia);
        tau = periodo(2 * PI / std::sqrt(alpha), std::sin(thetaM / 2), epsilon);
    } else {
        k = 1;
        thetaM = PI;
        const double A = std::sqrt(omega0 * omega0 + 2 * alpha * (1 - std::cos(theta0))) / 2;
        tau = periodo(PI / A, std::sqrt(alpha) / A, epsilon);
    }
}

/// (3.10)
inline void RungeKutta(double alpha, double& theta, double& omega, double dt) {
    const double thetaA = omega * dt;
    const double omegaA = -alpha * std::sin(theta) * dt;
    const double thetaB = (omega + omegaA / 2) * dt;
    const double omegaB = -alpha * std::sin(theta + thetaA / 2) * dt;
    const double thetaC = (omega + omegaB / 2) * dt;
    const double omegaC = -alpha * std::sin(theta + thetaB / 2) * dt;
    const double thetaD = (omega + omegaC) * dt;
    const double omegaD = -alpha * std::sin(theta + thetaC) * dt;
    theta += thetaA / 6 + thetaB / 3 + thetaC / 3 + thetaD / 6;
    omega += omegaA / 6 + omegaB / 3 + omegaC / 3 + omegaD / 6;
}

}  // namespace estudiante
