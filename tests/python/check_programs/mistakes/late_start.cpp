// The first tenth of the rows is left out, as if it were a transient.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <vector>

#define PI 3.14159265358979323846

struct Estado { double t, theta, omega; };

struct Pendulo {
    double theta0, omega0, alpha;  // leidos
    double thetaM, tau, phi0;      // calculados
    int k;

    void analiza() {
        const double e = omega0 * omega0 / 2 / alpha - std::cos(theta0);
        if (std::fabs(e - 1) < 1e-9) {
            k = 0;
            thetaM = omega0 < 0 ? -PI : PI;
            tau = std::fabs(std::log(std::tan((0.999 * thetaM + PI) / 4)) - std::log(std::tan((theta0 + PI) / 4))) / std::sqrt(alpha);
            return;
        }
        if (e < 1) {
            k = -1;
            thetaM = std::acos(-e);
            tau = 2 * PI / std::sqrt(alpha) / media(1, std::cos(thetaM / 2));
        } else {
            k = 1;
            thetaM = PI;
            double A2 = omega0 * omega0 / 4 + alpha * (1 - std::cos(theta0)) / 2;
            tau = PI / media(std::sqrt(A2), std::sqrt(A2 - alpha));
        }
        double s = theta0 / thetaM;
        phi0 = s >= 1 ? PI / 2 : s <= -1 ? -PI / 2 : omega0 < 0 ? PI - std::asin(s) : std::asin(s);
    }

    // media aritmetico-geometrica: la serie (3.6) vale 1/media(1, sqrt(1-r^2))
    static double media(double a, double b) {
        for (int i = 0; i < 40 && a - b > 1e-15 * a; i++) {
            double c = (a + b) / 2;
            b = std::sqrt(a * b);
            a = c;
        }
        return a;
    }

    double seno(double t) const { return thetaM * std::sin(2 * PI * t / tau + phi0); }

    Estado avanza(Estado s, double h) const {
        double k1 = s.omega, l1 = -alpha * std::sin(s.theta);
        double k2 = s.omega + h / 2 * l1, l2 = -alpha * std::sin(s.theta + h / 2 * k1);
        double k3 = s.omega + h / 2 * l2, l3 = -alpha * std::sin(s.theta + h / 2 * k2);
        double k4 = s.omega + h * l3, l4 = -alpha * std::sin(s.theta + h * k3);
        return {s.t + h, s.theta + h * (k1 + 2 * k2 + 2 * k3 + k4) / 6, s.omega + h * (l1 + 2 * l2 + 2 * l3 + l4) / 6};
    }
};

double enIntervalo(double x) {
    while (x >= PI) x -= 2 * PI;
    while (x < -PI) x += 2 * PI;
    return x;
}

int main(int argc, char** argv) {
    int digitos = argc > 1 ? std::atoi(argv[1]) : 6, tabla = 0;
    double fd, fc, fs;
    char u, v;
    Pendulo p;
    while (std::cin >> fd >> fc >> fs >> p.theta0 >> u >> p.omega0 >> v >> p.alpha) {
        if (u == 's') p.theta0 *= PI / 180;
        if (v == 's') p.omega0 *= PI / 180;
        p.theta0 = enIntervalo(p.theta0);
        p.analiza();
        int porFila = std::lround(fc / fd), filas = int(fs / fc + 1e-9);
        double h = fc * p.tau / porFila;
        std::vector<Estado> resultado;
        Estado s = {0, p.theta0, p.omega0};
        for (int i = 0; i <= filas * porFila; i++) {
            if (i % porFila == 0) resultado.push_back(s);
            s = p.avanza(s, h);
        }
        std::printf("%st angulo velocidad%s\n", tabla++ ? "\n\n" : "", p.k < 0 ? " funcionSinusoidal" : "");
        for (std::size_t i = resultado.size() / 10; i < resultado.size(); i++) {
            const Estado& e = resultado[i];
            std::printf("%.*g %.*g %.*g", digitos, e.t, digitos, enIntervalo(e.theta), digitos, e.omega);
            if (p.k < 0) std::printf(" %.*g", digitos, p.seno(e.t));
            std::printf("\n");
        }
    }
}
