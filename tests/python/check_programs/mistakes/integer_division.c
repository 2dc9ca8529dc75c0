/* Error: 1 / 6 y 1 / 3 son divisiones de enteros, que valen 0. */
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>

#define N_MAX 1000000

typedef struct { double t, th, w, seno; } fila_t;
typedef double (*fuerza_t)(double);

const double pi = 3.14159265358979323846;
double alpha;

double fuerza(double th) { return -alpha * sin(th); }

void runge_kutta(double *th, double *w, double h, fuerza_t a) {
    double x = *th, v = *w;
    double p1 = v, q1 = a(x);
    double p2 = v + h * q1 / 2, q2 = a(x + h * p1 / 2);
    double p3 = v + h * q2 / 2, q3 = a(x + h * p2 / 2);
    double p4 = v + h * q3, q4 = a(x + h * p3);
    *th = x + h * (1 / 6 * p1 + 1 / 3 * p2 + 1 / 3 * p3 + 1 / 6 * p4);
    *w = v + h * (1 / 6 * q1 + 1 / 3 * q2 + 1 / 3 * q3 + 1 / 6 * q4);
}

bool validaAngulo(double *angulo, char u) {
    if (u != 'r' && u != 's') return false;
    if (u == 's') *angulo *= pi / 180;
    return true;
}

double fase(double s, double r) {
    if (s >= 1) return pi / 2;
    if (s <= -1) return -pi / 2;
    return r >= 0 ? asin(s) : pi - asin(s);
}

double integral(double T0, double r) { /* de la integral eliptica, por la regla del punto medio */
    double media = 0, antes;
    int i, n = 16;
    do {
        antes = media;
        media = 0;
        for (i = 0; i < n; i++) media += 1 / sqrt(1 - pow(r * sin(pi / 2 * (i + 0.5) / n), 2)) / n;
        n *= 2;
    } while (fabs(media - antes) > 1e-12 * media);
    return T0 * media;
}

void analisis(double th, double w, double *thM, double *tau, int *k) {
    double c = w * w / (2 * alpha) - cos(th), signo = w < 0 ? -1 : 1;
    *k = fabs(c - 1) < 1e-9 ? 0 : c < 1 ? -1 : 1;
    *thM = *k < 0 ? acos(-c) : *k > 0 ? pi : signo * pi;
    if (*k == 0) *tau = signo * log(tan(0.999 * *thM / 4 + pi / 4) / tan(th / 4 + pi / 4)) / sqrt(alpha);
    if (*k < 0) *tau = integral(2 * pi / sqrt(alpha), sin(*thM / 2));
    if (*k > 0) {
        double A = sqrt(w * w + 2 * alpha * (1 - cos(th))) / 2;
        *tau = integral(pi / A, sqrt(alpha) / A);
    }
}

int main(int argc, char *argv[]) {
    int d = argc > 1 ? atoi(argv[1]) : 6, k, tabla = 0, i, j;
    double f[3], th, w, thM, tau;
    char u[2];
    while (scanf("%lf %lf %lf %lf %c %lf %c %lf", f, f + 1, f + 2, &th, u, &w, u + 1, &alpha) == 8) {
        if (!validaAngulo(&th, u[0]) || !validaAngulo(&w, u[1])) return fprintf(stderr, "unidades\n"), 1;
        th = atan2(sin(th), cos(th));
        analisis(th, w, &thM, &tau, &k);
        int filas = (int)floor(f[2] / f[1] + 1e-6) + 1, pasos = (int)lround(f[1] / f[0]);
        double h = f[0] * tau, phi0 = fase(th / thM, w);
        fila_t *datos = malloc(filas * sizeof *datos);
        for (i = 0; i < filas; i++) {
            datos[i] = (fila_t){i * pasos * h, atan2(sin(th), cos(th)), w, 0};
            datos[i].seno = thM * sin(2 * pi * datos[i].t / tau + phi0);
            for (j = 0; j < pasos; j++) runge_kutta(&th, &w, h, fuerza);
        }
        if (tabla++) printf("\n\n");
        printf("%*s%*s%*s", d + 8, "t", d + 8, "angulo", d + 8, "velocidad");
        if (k == -1) printf(" %*s", d + 12, "funcionSinusoidal");
        printf("\n");
        for (i = 0; i < filas; i++) {
            printf("%*.*e%*.*e%*.*e", d + 8, d - 1, datos[i].t, d + 8, d - 1, datos[i].th, d + 8, d - 1, datos[i].w);
            if (k == -1) printf(" %*.*e", d + 12, d - 1, datos[i].seno);
            printf("\n");
        }
        free(datos);
    }
    return 0;
}
