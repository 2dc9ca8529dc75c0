/* The velocity is brought to [−π, π), as if it were an angle. */
#include <stdio.h>
#include <stdlib.h>
#include <math.h>
#ifndef M_PI
#define M_PI 3.14159265358979323846
#endif
#define DOSPI (2.0 * M_PI)

typedef struct { double x, v; } punto;

static void derivada(const punto *p, double a, punto *d) { d->x = p->v; d->v = -a * sin(p->x); }

static punto suma(const punto *p, double h, const punto *d)
{
    punto q;
    q.x = p->x + h * d->x;
    q.v = p->v + h * d->v;
    return q;
}

static void rk4(punto *p, double a, double h)
{
    punto k1, k2, k3, k4, q;
    derivada(p, a, &k1);
    q = suma(p, h / 2, &k1); derivada(&q, a, &k2);
    q = suma(p, h / 2, &k2); derivada(&q, a, &k3);
    q = suma(p, h, &k3);     derivada(&q, a, &k4);
    p->x += h / 6 * (k1.x + 2 * (k2.x + k3.x) + k4.x);
    p->v += h / 6 * (k1.v + 2 * (k2.v + k3.v) + k4.v);
}

static double norm(double x)
{
    if (x < -M_PI || x >= M_PI) x -= DOSPI * floor((x + M_PI) / DOSPI);
    return x;
}

static int analisis(double x0, double v0, double a, double *lim, double *tau)
{
    double e = 0.5 * v0 * v0 + a * (1 - cos(x0)), T0, r2, c = 1, s = 1;
    long n = 1;
    if (fabs(e / (2 * a) - 1) < 1e-9) {
        *lim = v0 < 0 ? -M_PI : M_PI;
        *tau = fabs(log(tan(0.999 * *lim / 4 + M_PI / 4) / tan(x0 / 4 + M_PI / 4)) / sqrt(a));
        return 0;
    }
    r2 = e < 2 * a ? e / (2 * a) : 2 * a / e;
    T0 = e < 2 * a ? DOSPI / sqrt(a) : M_PI / sqrt(e / 2);
    *lim = e < 2 * a ? 2 * asin(sqrt(r2)) : M_PI;
    do {
        c *= r2 * (2 * n - 1) * (2 * n - 1) / (4.0 * n * n);
        s += c;
        n++;
    } while (c > 1e-11 * (1 - r2));
    *tau = T0 * s;
    return e < 2 * a ? -1 : 1;
}

int main(int argc, char **argv)
{
    int c = argc > 1 ? atoi(argv[1]) : 6, k, n, tablas = 0, j, filas;
    double f[3], x0, v0, a, lim, tau, fi, h;
    char u[2], w[2];
    while (scanf("%lf%lf%lf%lf%1s%lf%1s%lf", &f[0], &f[1], &f[2], &x0, u, &v0, w, &a) == 8) {
        punto p;
        if (u[0] == 's') x0 = x0 / 180 * M_PI;
        if (w[0] == 's') v0 = v0 / 180 * M_PI;
        x0 = norm(x0);
        k = analisis(x0, v0, a, &lim, &tau);
        fi = fabs(x0 / lim) < 1 ? asin(x0 / lim) : x0 < 0 ? -M_PI / 2 : M_PI / 2;
        if (v0 < 0 && fabs(x0 / lim) < 1) fi = M_PI - fi;
        printf("%st\tangulo\tvelocidad%s\n", tablas++ > 0 ? "\n\n" : "", k < 0 ? "\tfuncionSinusoidal" : "");
        p.x = x0;
        p.v = v0;
        j = 0;
        n = (int)(f[1] / f[0] + 0.5);
        h = f[1] * tau / n;
        filas = (int)(f[2] / f[1] + 1e-9);
        do {
            double t = j * f[1] * tau;
            int i;
            printf("%.*g\t%.*g\t%.*g", c, t, c, norm(p.x), c, norm(p.v));
            if (k < 0) printf("\t%.*g", c, lim * sin(DOSPI * t / tau + fi));
            putchar('\n');
            for (i = 0; i < n; i++) rk4(&p, a, h);
            j++;
        } while (j <= filas);
    }
    return 0;
}
