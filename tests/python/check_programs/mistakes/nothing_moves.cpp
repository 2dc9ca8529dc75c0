// Error: avanza cambia una copia del estado (falta &).
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>
using namespace std;
typedef vector<double> Vector;

const double pi = 4 * atan(1.0);
const double c[4][4] = {{0, 0, 0, 0}, {1. / 2, 0, 0, 0}, {0, 1. / 2, 0, 0}, {0, 0, 1, 0}};
const double b[4] = {1. / 6, 1. / 3, 1. / 3, 1. / 6};

Vector f(const Vector& y, double alpha) {
    Vector dy(2);
    dy[0] = y[1];
    dy[1] = -alpha * sin(y[0]);
    return dy;
}

void avanza(Vector y, double h, double alpha) {
    vector<Vector> k;
    for (int i = 0; i < 4; i++) {
        Vector z = y;
        for (int j = 0; j < i; j++)
            for (int m = 0; m < 2; m++) z[m] += h * c[i][j] * k[j][m];
        k.push_back(f(z, alpha));
    }
    for (int i = 0; i < 4; i++)
        for (int m = 0; m < 2; m++) y[m] += h * b[i] * k[i][m];
}

double T(double T0, double r) {
    double suma = 0, a = 1;
    for (int n = 1; a > 1e-17 * suma; n++) {
        suma += a;
        a *= (2 * n - 1) * r / (2 * n) * (2 * n - 1) * r / (2 * n);
    }
    return T0 * suma;
}

int main(int argc, char** argv) {
    const int cifras = argc > 1 ? atoi(argv[1]) : 6;
    double fd, fc, fs, th, w, alpha;
    string uth, uw;
    for (int problema = 0; cin >> fd >> fc >> fs >> th >> uth >> w >> uw >> alpha; problema++) {
        if (uth == "s") th *= pi / 180;
        if (uw == "s") w *= pi / 180;
        th = atan2(sin(th), cos(th));
        const double E = w * w / (2 * alpha) + 1 - cos(th);  // en unidades de mgl
        double limite, tau, phi = 0;
        int k;
        if (fabs(E - 2) < 1e-9 * 2) {
            k = 0;
            limite = w < 0 ? -pi : pi;
            tau = (w < 0 ? -1 : 1) * log(tan((0.999 * limite + pi) / 4) / tan((th + pi) / 4)) / sqrt(alpha);
        } else if (E < 2) {
            k = -1;
            limite = acos(1 - E);
            tau = T(2 * pi / sqrt(alpha), sin(limite / 2));
            const double s = limite > 0 ? th / limite : 0;
            phi = s >= 1 ? pi / 2 : s <= -1 ? -pi / 2 : w < 0 ? pi - asin(s) : asin(s);
        } else {
            k = 1;
            limite = pi;
            const double A = sqrt(alpha * E / 2);
            tau = T(pi / A, sqrt(alpha) / A);
        }
        printf("%st angulo velocidad%s\n", problema ? "\n\n" : "", k == -1 ? " funcionSinusoidal" : "");
        Vector y = {th, w};
        const int porFila = (int)(fc / fd + 0.5), filas = (int)(fs / fc + 1e-6);
        for (int fila = 0; fila <= filas; fila++) {
            const double t = fila * fc * tau;
            printf("%.*g %.*g %.*g", cifras, t, cifras, y[0] - 2 * pi * floor((y[0] + pi) / (2 * pi)), cifras, y[1]);
            if (k == -1) printf(" %.*g", cifras, limite * sin(2 * pi / tau * t + phi));
            printf("\n");
            for (int i = 0; i < porFila; i++) avanza(y, fd * tau, alpha);
        }
    }
}
