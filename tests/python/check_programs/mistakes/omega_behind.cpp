// Error: se escribe la velocidad de antes del último paso.
#include <cmath>
#include <cstdlib>
#include <iomanip>
#include <iostream>
using namespace std;

const double pi = acos(-1.0);

bool validaAngulo(double& angulo, char unidad) {
    if (unidad == 's') angulo = angulo * pi / 180;
    return unidad == 'r' || unidad == 's';
}

double fase(double s, double r) {
    if (s >= 1) return pi / 2;
    if (s <= -1) return -pi / 2;
    double phi = asin(s);
    if (r < 0) phi = pi - phi;
    return phi;
}

double normaliza(double theta) { return theta - 2 * pi * floor((theta + pi) / (2 * pi)); }

void analisis(double alpha, double theta0, double omega0, double epsilon, double& thetaM, double& tau, int& k) {
    double energia = omega0 * omega0 / (2 * alpha) - cos(theta0);
    if (abs(energia - 1) <= 1e-9) {
        k = 0;
        double signo = omega0 >= 0 ? 1 : -1;
        thetaM = signo * pi;
        double C = 1 / tan(theta0 / 4 + pi / 4);
        tau = signo / sqrt(alpha) * log(C * tan(0.999 * thetaM / 4 + pi / 4));
        return;
    }
    double T0, r;
    if (energia < 1) {
        k = -1;
        thetaM = acos(cos(theta0) - omega0 * omega0 / (2 * alpha));
        T0 = 2 * pi / sqrt(alpha);
        r = sin(thetaM / 2);
    } else {
        k = 1;
        thetaM = pi;
        double A = sqrt(omega0 * omega0 + 2 * alpha * (1 - cos(theta0))) / 2;
        T0 = pi / A;
        r = sqrt(alpha) / A;
    }
    double an = 1, suma = 1;
    for (int n = 1; an > epsilon * (1 - r * r); ++n) {
        double factor = (2.0 * n - 1) / (2.0 * n) * r;
        an = factor * factor * an;
        suma += an;
    }
    tau = T0 * suma;
}

void RungeKutta(double alpha, double& theta, double& omega, double& t, double dt) {
    double thA = omega * dt, wA = -alpha * sin(theta) * dt;
    double thB = (omega + wA / 2) * dt, wB = -alpha * sin(theta + thA / 2) * dt;
    double thC = (omega + wB / 2) * dt, wC = -alpha * sin(theta + thB / 2) * dt;
    double thD = (omega + wC) * dt, wD = -alpha * sin(theta + thC) * dt;
    theta = theta + thA / 6 + thB / 3 + thC / 3 + thD / 6;
    omega = omega + wA / 6 + wB / 3 + wC / 3 + wD / 6;
    t = t + dt;
}

int main(int argc, char** argv) {
    double factorD, factorCout, factorTSimul, theta0, omega0, alpha;
    char uTheta, uOmega;
    bool primera = true;
    cout << setprecision(argc > 1 ? atoi(argv[1]) : 6);
    while (cin >> factorD >> factorCout >> factorTSimul >> theta0 >> uTheta >> omega0 >> uOmega >> alpha) {
        if (factorD <= 0 || factorCout <= 0 || factorTSimul <= 0 || alpha <= 0 || !validaAngulo(theta0, uTheta) ||
            !validaAngulo(omega0, uOmega)) {
            cout << "Error en los datos de entrada" << endl;
            return 1;
        }
        theta0 = normaliza(theta0);
        double thetaM, tau;
        int k;
        analisis(alpha, theta0, omega0, 1e-10, thetaM, tau, k);
        double tSimul = factorTSimul * tau, tCout = factorCout * tau, dt = tCout / round(factorCout / factorD);
        double phi0 = fase(theta0 / thetaM, omega0);
        if (!primera) cout << "\n\n";
        primera = false;
        cout << "t angulo velocidad";
        if (k == -1) cout << " funcionSinusoidal";
        cout << endl;
        double t = 0, theta = theta0, omega = omega0, antes = omega0, siguiente = 0;
        while (t < tSimul + dt / 2) {
            if (t > siguiente - dt / 2) {
                cout << t << ' ' << normaliza(theta) << ' ' << antes;
                if (k == -1) cout << ' ' << thetaM * sin(2 * pi / tau * t + phi0);
                cout << endl;
                siguiente += tCout;
            }
            antes = omega;
            RungeKutta(alpha, theta, omega, t, dt);
        }
    }
    return 0;
}
