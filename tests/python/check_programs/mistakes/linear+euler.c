/* Error: theta por su seno, y Euler en vez de Runge-Kutta. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#define PI 3.141592653589793

double alpha, th, w, dt;        /* el pendulo */
double thM, tau, phi;
int k;

double aceleracion(double x) { return -alpha * x; }

void paso(void) {
    double a = aceleracion(th);
    th += w * dt;
    w += a * dt;
}

double serie(double r) {
    double a = 1, s = 1;
    int n, N = (int)(log(1e-14 * (1 - r * r)) / (2 * log(r))) + 1;
    for (n = 1; n <= N; n++) {
        a *= (2. * n - 1) / (2. * n) * r * (2. * n - 1) / (2. * n) * r;
        s += a;
    }
    return s;
}

void analisis(void) {
    double e = w * w / (2 * alpha) - cos(th), A;
    if (fabs(e - 1) < 1e-9) {
        k = 0;
        thM = w >= 0 ? PI : -PI;
        tau = log(tan(0.999 * thM / 4 + PI / 4) / tan(th / 4 + PI / 4)) / sqrt(alpha);
        if (w < 0) tau = -tau;
    } else if (e < 1) {
        k = -1;
        thM = acos(cos(th) - w * w / (2 * alpha));
        tau = 2 * PI / sqrt(alpha) * serie(sin(thM / 2));
        if (th / thM >= 1) phi = PI / 2;
        else if (th / thM <= -1) phi = -PI / 2;
        else phi = w < 0 ? PI - asin(th / thM) : asin(th / thM);
    } else {
        k = 1;
        thM = PI;
        A = sqrt(w * w + 2 * alpha * (1 - cos(th))) / 2;
        tau = PI / A * serie(sqrt(alpha) / A);
    }
}

int main(int argc, char *argv[]) {
    int d = argc > 1 ? atoi(argv[1]) : 6, primero = 1, n, cada, total;
    double fd, fc, fs;
    char ut, uw;
    while (scanf("%lf%lf%lf%lf %c%lf %c%lf", &fd, &fc, &fs, &th, &ut, &w, &uw, &alpha) == 8) {
        if (ut == 's') th = th * PI / 180;
        if (uw == 's') w = w * PI / 180;
        th = th - 2 * PI * floor((th + PI) / (2 * PI));
        analisis();
        dt = fd * tau;
        cada = (int)(fc / fd + 0.5);
        total = (int)(fs / fd + 0.5);
        printf("%st angulo velocidad%s\n", primero ? "" : "\n\n", k < 0 ? " funcionSinusoidal" : "");
        primero = 0;
        for (n = 0; n <= total; n++) {
            if (n % cada == 0) {
                printf("%.*g %.*g %.*g", d, n * dt, d, th - 2 * PI * floor((th + PI) / (2 * PI)), d, w);
                if (k < 0) printf(" %.*g", d, thM * sin(2 * PI / tau * n * dt + phi));
                printf("\n");
            }
            paso();
        }
    }
    return 0;
}
