// El programa principal de la actividad 3.
#include "student.hpp"

#include <iostream>

using namespace estudiante;
using namespace std;

int main() {
    double factorDelta, factorCout, factorSimul, theta0, omega0, alpha;
    char unidadTheta, unidadOmega;
    cin >> factorDelta >> factorCout >> factorSimul >> theta0 >> unidadTheta >> omega0 >> unidadOmega >> alpha;
    if (!cin || alpha <= 0 || factorDelta <= 0 || factorCout <= 0 || factorSimul <= 0 || !validaAngulo(theta0, unidadTheta) ||
        !validaAngulo(omega0, unidadOmega)) {
        cout << "ERROR\n";
        return 1;
    }

    double thetaM, tau;
    int k;
    analisis(alpha, theta0, omega0, 1e-7, thetaM, tau, k);
    const double dt = factorDelta * tau, tCout = factorCout * tau, tSimul = factorSimul * tau;
    const double phi0 = k == -1 ? fase(normaliza(theta0) / thetaM, omega0) : 0;

    cout << "t angulo velocidad" << (k == -1 ? " funcionSinusoidal" : "") << '\n';
    double theta = theta0, omega = omega0, siguiente = 0;
    for (double t = 0; t <= tSimul + dt / 2; t += dt) {
        if (t >= siguiente - dt / 2) {
            cout << t << ' ' << normaliza(theta) << ' ' << omega;
            if (k == -1) cout << ' ' << normaliza(thetaM * sin(2 * PI / tau * t + phi0));
            cout << '\n';
            siguiente += tCout;
        }
        RungeKutta(alpha, theta, omega, dt);
    }
}
