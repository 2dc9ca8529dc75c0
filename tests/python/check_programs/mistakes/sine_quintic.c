/* Error: el seno, con tres terminos de su serie. */
#include <stdio.h>
#include <stdlib.h>
#include <math.h>

double seno(double x)
{
    return x - x*x*x/6 + x*x*x*x*x/120;
}

int main(int argc, char *argv[])
{
    double pi = 4*atan(1), fd, fc, fs, o, v, al, c, m, tau, fi, h, tt, x, S, a, r, T0;
    double o1, o2, o3, o4, v1, v2, v3, v4;
    char u, z;
    int d = 6, k, n, i, j, primera = 1;

    if (argc > 1) d = atoi(argv[1]);
otra:
    if (scanf("%lf %lf %lf %lf %c %lf %c %lf", &fd, &fc, &fs, &o, &u, &v, &z, &al) != 8) return 0;
    if (u == 's') o = o/180*pi;
    if (z == 's') v = v/180*pi;
    o = o - 2*pi*floor((o + pi)/(2*pi));

    /* analisis */
    c = v*v/(2*al) - cos(o);
    fi = 0;
    if (fabs(c - 1) < 1e-9) {
        k = 0;
        m = (v < 0) ? -pi : pi;
        tau = fabs(log(tan(0.999*m/4 + pi/4)/tan(o/4 + pi/4)))/sqrt(al);
    } else {
        if (c < 1) {
            k = -1;
            m = acos(-c);
            T0 = 2*pi/sqrt(al);
            r = sin(m/2);
            if (o >= m) fi = pi/2;
            else if (o <= -m) fi = -pi/2;
            else if (v < 0) fi = pi - asin(o/m);
            else fi = asin(o/m);
        } else {
            k = 1;
            m = pi;
            a = sqrt(v*v + 2*al*(1 - cos(o)))/2;
            T0 = pi/a;
            r = sqrt(al)/a;
        }
        for (S = a = 1, n = 1; a > 1e-15*(1 - r*r); n++) S += a *= r*r*(2*n - 1.)*(2*n - 1.)/(4.*n*n);
        tau = T0*S;
    }

    if (!primera) puts("\n");
    primera = 0;
    printf("t\tangulo\tvelocidad");
    if (k == -1) printf("\tfuncionSinusoidal");
    h = fd*tau;
    tt = 0;
    for (i = 0, j = 0; tt <= fs*tau + h/2; tt = ++i*h) {
        if (fabs(tt - j*fc*tau) < h/2) {
            x = o;
            while (x >= pi) x -= 2*pi;
            while (x < -pi) x += 2*pi;
            printf("\n%.*g\t%.*g\t%.*g", d, tt, d, x, d, v);
            if (k == -1) printf("\t%.*g", d, m*sin(2*pi/tau*tt + fi));
            j++;
        }
        o1 = v;
        v1 = -al*seno(o);
        o2 = v + v1*h/2;
        v2 = -al*seno(o + o1*h/2);
        o3 = v + v2*h/2;
        v3 = -al*seno(o + o2*h/2);
        o4 = v + v3*h;
        v4 = -al*seno(o + o3*h);
        o += (o1 + 2*o2 + 2*o3 + o4)*h/6;
        v += (v1 + 2*v2 + 2*v3 + v4)*h/6;
    }
    puts("");
    goto otra;
}
