/* Mistake: every pendulum has alpha 1. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { THETA, OMEGA, DIM };

struct pendulum {
    double alpha, limit, tau, phase;
    int oscillates;
};

static double acceleration(const struct pendulum *p, double theta)
{
    return -p->alpha * sin(theta);
}

/* Computes state number n + 1 from state number n. */
static void step(const struct pendulum *p, double (*y)[DIM], int n, double h)
{
    static const double where[4] = {0, 0.5, 0.5, 1}, weight[4] = {1. / 6, 2. / 6, 2. / 6, 1. / 6};
    double k[DIM] = {0, 0};
    y[n + 1][THETA] = y[n][THETA];
    y[n + 1][OMEGA] = y[n][OMEGA];
    for (int stage = 0; stage < 4; stage++) {
        double theta = y[n][THETA] + where[stage] * h * k[THETA];
        double omega = y[n][OMEGA] + where[stage] * h * k[OMEGA];
        k[THETA] = omega;
        k[OMEGA] = acceleration(p, theta);
        y[n + 1][THETA] += weight[stage] * h * k[THETA];
        y[n + 1][OMEGA] += weight[stage] * h * k[OMEGA];
    }
}

static double mean(double a, double g)
{
    return fabs(a - g) < 4e-16 * a ? a : mean(0.5 * (a + g), sqrt(a * g));
}

static void analyse(struct pendulum *p, double theta, double omega)
{
    double e = omega * omega / (2 * p->alpha) - cos(theta), root = sqrt(p->alpha);
    p->oscillates = 0;
    p->limit = copysign(M_PI, omega);
    if (fabs(e - 1) < 1e-9) {
        p->tau = fabs(log(tan(0.999 * p->limit / 4 + M_PI_4) / tan(theta / 4 + M_PI_4))) / root;
    } else if (e > 1) {
        double a = sqrt(omega * omega + 2 * p->alpha * (1 - cos(theta))) / 2;
        p->tau = M_PI / mean(a, sqrt(a * a - p->alpha));
    } else {
        p->oscillates = 1;
        p->limit = acos(-e);
        p->tau = 2 * M_PI / root / mean(1, cos(p->limit / 2));
        p->phase = atan2(theta, sqrt(fmax(0, p->limit * p->limit - theta * theta)) * (omega < 0 ? -1 : 1));
    }
}

int main(int argc, char **argv)
{
    int digits = argc > 1 ? atoi(argv[1]) : 6;
    char line[256], u, v;
    double factor[3], theta, omega;
    struct pendulum p;
    for (int tables = 0; fgets(line, sizeof line, stdin);) {
        if (sscanf(line, "%lf%lf%lf%lf %c%lf %c%lf", factor, factor + 1, factor + 2, &theta, &u, &omega, &v, &p.alpha) < 8) continue;
        p.alpha = 1;
        theta = fmod(u == 's' ? theta * M_PI / 180 : theta, 2 * M_PI);
        theta -= theta >= M_PI ? 2 * M_PI : theta < -M_PI ? -2 * M_PI : 0;
        omega = v == 's' ? omega * M_PI / 180 : omega;
        analyse(&p, theta, omega);
        int steps = (int)(factor[2] / factor[0] + 0.5), every = (int)(factor[1] / factor[0] + 0.5);
        double h = factor[0] * p.tau, (*y)[DIM] = malloc((steps + 1) * sizeof *y);
        y[0][THETA] = theta;
        y[0][OMEGA] = omega;
        for (int n = 0; n < steps; n++) step(&p, y, n, h);
        if (tables++) printf("\n\n");
        printf("t angulo velocidad%s\n", p.oscillates ? " funcionSinusoidal" : "");
        for (int n = 0; n <= steps; n += every) {
            double turns = floor((y[n][THETA] + M_PI) / (2 * M_PI));
            printf("%.*g %.*g %.*g", digits, n * h, digits, y[n][THETA] - 2 * M_PI * turns, digits, y[n][OMEGA]);
            if (p.oscillates) printf(" %.*g", digits, p.limit * sin(2 * M_PI / p.tau * n * h + p.phase));
            printf("\n");
        }
        free(y);
    }
    return 0;
}
