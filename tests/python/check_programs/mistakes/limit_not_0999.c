/* τ of the separatrix is the time to π itself, which only rounding makes finite. */
#include <stdio.h>
#include <string.h>
#include <stdlib.h>
#include <math.h>

#define NE 2
const double pi = 3.14159265358979324;
const double c[4] = {0, 0.5, 0.5, 1}, b[4] = {1. / 6, 1. / 3, 1. / 3, 1. / 6};

void rk(double y[NE], double alpha, double h) {
    double k[5][NE] = {{0}}, z[NE];
    for (int s = 0; s < 4; s++) {
        for (int i = 0; i < NE; i++) z[i] = y[i] + c[s] * k[s][i];
        k[s + 1][0] = h * z[1];
        k[s + 1][1] = -h * alpha * sin(z[0]);
    }
    for (int s = 0; s < 4; s++)
        for (int i = 0; i < NE; i++) y[i] += b[s] * k[s + 1][i];
}

int main(int argc, char **argv) {
    int d = 6, primera = 1;
    double f1, f2, f3, y0[NE], y[NE], alpha;
    char u1, u2, formato[20];
    if (argc == 2) d = atoi(argv[1]);
    sprintf(formato, "%%.%dg%%c", d);
    for (; scanf("%lf%lf%lf%lf %c%lf %c%lf", &f1, &f2, &f3, y0, &u1, y0 + 1, &u2, &alpha) > 7; primera = 0) {
        if (u1 == 's') y0[0] *= pi / 180;
        if (u2 == 's') y0[1] *= pi / 180;
        y0[0] = y0[0] - 2 * pi * floor((y0[0] + pi) / (2 * pi));
        double e = y0[1] * y0[1] / 2 / alpha - cos(y0[0]), thM = pi, tau, A;
        int k = 1;
        if (fabs(e - 1) <= 1e-9) {
            k = 0;
            if (y0[1] < 0) thM = -pi;
            tau = log(tan(pi / 4 + pi / 4)) + (y0[1] < 0 ? 1 : -1) * log(tan(y0[0] / 4 + pi / 4));
            tau /= sqrt(alpha);
        } else {
            double T0, r, term = 1, S = 1;
            if (e < 1) {
                k = -1;
                thM = acos(-e);
                T0 = 2 * pi / sqrt(alpha), r = sin(thM / 2);
            } else {
                A = sqrt(y0[1] * y0[1] + 2 * alpha * (1 - cos(y0[0]))) / 2;
                T0 = pi / A, r = sqrt(alpha) / A;
            }
            double N = log(1e-9 * (1 - r * r)) / (2 * log(r));
            for (int n = 1; n < N + 1; n++) term *= (n - 0.5) * (n - 0.5) / n / n * r * r, S += term;
            tau = T0 * S;
        }
        double q = y0[0] / thM, phi = q >= 1 ? pi / 2 : q <= -1 ? -pi / 2 : y0[1] < 0 ? pi - asin(q) : asin(q);
        if (!primera) puts("\n");
        puts(k < 0 ? "t angulo velocidad funcionSinusoidal" : "t angulo velocidad");
        memcpy(y, y0, sizeof y);
        long i, m = 0, cada = lround(f2 / f1), hasta = (long)(f3 / f2 + 1e-9) * cada;
        double dt = f2 * tau / cada, t = 0;
        for (i = 0; i <= hasta; i++, m++) {
            if (i == 0 || m == cada) {
                m = 0;
                t = i * dt;
                double fila[4] = {t, y[0] - 2 * pi * floor((y[0] + pi) / (2 * pi)), y[1], thM * sin(2 * pi / tau * t + phi)};
                int n = k < 0 ? 4 : 3;
                for (int j = 0; j < n; j++) printf(formato, fila[j], j < n - 1 ? ' ' : '\n');
            }
            rk(y, alpha, dt);
        }
    }
    return 0;
}
