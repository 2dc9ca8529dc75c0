/* Mistake: the initial velocity goes through a variable for whole numbers. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static double g_alpha;

static void derivs(const double y[2], double dydt[2]) {
    dydt[0] = y[1];
    dydt[1] = -g_alpha * sin(y[0]);
}

static void rk4(double y[2], double h) {
    double k[4][2], tmp[2];
    int i;
    derivs(y, k[0]);
    for (i = 0; i < 2; i++) tmp[i] = y[i] + h / 2 * k[0][i];
    derivs(tmp, k[1]);
    for (i = 0; i < 2; i++) tmp[i] = y[i] + h / 2 * k[1][i];
    derivs(tmp, k[2]);
    for (i = 0; i < 2; i++) tmp[i] = y[i] + h * k[2][i];
    derivs(tmp, k[3]);
    for (i = 0; i < 2; i++) y[i] += h / 6 * (k[0][i] + 2 * k[1][i] + 2 * k[2][i] + k[3][i]);
}

static double agm(double a, double b) {
    int i;
    for (i = 0; i < 40 && a != b; i++) {
        double m = (a + b) / 2;
        b = sqrt(a * b);
        a = m;
    }
    return a;
}

int main(int argc, char **argv) {
    const double pi = acos(-1.0);
    int digits = argc > 1 ? atoi(argv[1]) : 6, count = 0;
    double f1, f2, f3, y[2];
    char unit1[8], unit2[8];
    while (scanf("%lf %lf %lf %lf %7s %lf %7s %lf", &f1, &f2, &f3, &y[0], unit1, &y[1], unit2, &g_alpha) == 8) {
        double e, tau, top = pi, phase = 0, t, next;
        int osc = 0, v0;
        if (unit1[0] == 's') y[0] *= pi / 180;
        if (unit2[0] == 's') y[1] *= pi / 180;
        y[0] = remainder(y[0], 2 * pi);
        v0 = y[1];
        y[1] = v0;
        e = y[1] * y[1] / (2 * g_alpha) - cos(y[0]);
        if (fabs(e - 1) < 1e-9) {
            tau = fabs(log(tan(pi / 4 * 1.999) / tan(pi / 4 + (y[1] < 0 ? -1 : 1) * y[0] / 4))) / sqrt(g_alpha);
        } else if (e > 1) {
            double a = sqrt(y[1] * y[1] / 4 + g_alpha * pow(sin(y[0] / 2), 2));
            tau = pi / agm(a, sqrt(a * a - g_alpha));
        } else {
            osc = 1;
            top = acos(-e);
            tau = 2 * pi / sqrt(g_alpha) / agm(1, cos(top / 2));
            phase = asin(fmax(-1, fmin(1, y[0] / top)));
            if (y[1] < 0) phase = pi - phase;
        }
        if (count++) printf("\n\n");
        printf(osc ? "t angulo velocidad funcionSinusoidal\n" : "t angulo velocidad\n");
        next = 0;
        for (t = 0; t < f3 * tau + f1 * tau / 2; t += f1 * tau) {
            if (t > next - f1 * tau / 2) {
                printf("%.*g %.*g %.*g", digits, t, digits, remainder(y[0], 2 * pi), digits, y[1]);
                if (osc) printf(" %.*g", digits, top * sin(2 * pi * t / tau + phase));
                putchar('\n');
                next += f2 * tau;
            }
            rk4(y, f1 * tau);
        }
    }
    return 0;
}
