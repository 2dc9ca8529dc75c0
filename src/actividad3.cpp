#include "pendula/actividad3.hpp"

#include "pendula/analysis.hpp"
#include "pendula/angle.hpp"
#include "pendula/steps.hpp"

namespace pendula::actividad3 {

bool validaAngulo(double& theta, char unidad) noexcept {
    if (unidad == 's') theta = to_radians(theta);
    return unidad == 'r' || unidad == 's';
}

double fase(double s, double r) noexcept { return phase(s, r); }

double normaliza(double theta) noexcept { return wrap(theta); }

void analisis(double alpha, double theta0, double omega0, double, double& thetaM, double& tau, int& k) noexcept {
    const auto analysis = analyze(alpha, {theta0, omega0});
    thetaM = analysis.theta_max;
    tau = analysis.tau;
    k = static_cast<int>(analysis.regime);
}

void RungeKutta(double alpha, double& theta, double& omega, double t, double dt) noexcept {
    Pendulum pendulum;
    pendulum.alpha = alpha;
    const auto state = rk4_step(pendulum, {theta, omega}, t, dt);
    theta = state.theta;
    omega = state.omega;
}

}  // namespace pendula::actividad3
