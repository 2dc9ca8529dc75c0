/* A right program in C: tabs, ten decimals, no header, a row as soon as the sum of the steps has come to it. */
#include <math.h>
#include <stdio.h>

static double alpha;

static void rk4(double *x, double *v, double h) {
    double k1 = *v, l1 = -alpha * sin(*x);
    double k2 = *v + 0.5 * h * l1, l2 = -alpha * sin(*x + 0.5 * h * k1);
    double k3 = *v + 0.5 * h * l2, l3 = -alpha * sin(*x + 0.5 * h * k2);
    double k4 = *v + h * l3, l4 = -alpha * sin(*x + h * k3);
    *x += h * (k1 + 2 * k2 + 2 * k3 + k4) / 6;
    *v += h * (l1 + 2 * l2 + 2 * l3 + l4) / 6;
}

/* Each program has its own way to the period; this is the arithmetic-geometric mean. */
static double agm(double a, double b) {
    while (fabs(a - b) > 1e-7 * a) {
        double c = (a + b) / 2;
        b = sqrt(a * b);
        a = c;
    }
    return a;
}

int main(void) {
    double fd, fc, fs, x, v;
    char ux, uv;
    while (scanf("%lf %lf %lf %lf %c %lf %c %lf", &fd, &fc, &fs, &x, &ux, &v, &uv, &alpha) == 8) {
        if (ux == 's') x *= acos(-1) / 180;
        if (uv == 's') v *= acos(-1) / 180;
        double e = v * v / (2 * alpha) - cos(x), limit = acos(-1), tau, phase = 0;
        int k = fabs(e - 1) < 1e-13 ? 0 : e < 1 ? -1 : 1;
        if (k == 0) {
            limit = v < 0 ? -limit : limit;
            tau = fabs(log(tan(0.999 * limit / 4 + acos(-1) / 4) / tan(x / 4 + acos(-1) / 4))) / sqrt(alpha);
        } else if (k < 0) {
            limit = acos(-e);
            tau = 2 * acos(-1) / sqrt(alpha) / agm(1, cos(limit / 2));
            phase = asin(fmax(-1, fmin(1, x / limit)));
            if (v < 0) phase = acos(-1) - phase;
        } else {
            double a = sqrt(v * v + 2 * alpha * (1 - cos(x))) / 2;
            tau = acos(-1) / agm(a, sqrt(a * a - alpha));
        }
        double h = fd * tau, t = 0, next = 0;
        for (;;) {
            if (t >= next - h / 2) {
                double wrapped = x - 2 * acos(-1) * floor((x + acos(-1)) / (2 * acos(-1)));
                printf("%.10f\t%.10f\t%.10f", t, wrapped, v);
                if (k < 0) printf("\t%.10f", limit * sin(2 * acos(-1) * t / tau + phase));
                printf("\n");
                next += fc * tau;
                if (next > fs * tau * (1 + 1e-9)) break;
            }
            rk4(&x, &v, h);
            t += h;
        }
    }
    return 0;
}
