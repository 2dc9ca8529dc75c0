/* The phase is converted to degrees, which the sine does not know. */
#include <stdio.h>
#include <stdlib.h>
#include <math.h>

double PI, alpha, th0, w0, th, w, thM, tau, dt, tcout, tsimul, fi0;
int k, cifras = 6;

double normaliza(double a) { return a - 2 * PI * floor((a + PI) / (2 * PI)); }

double fase(double s, double r)
{
    if (s >= 1) return PI / 2;
    if (s <= -1) return -PI / 2;
    return r >= 0 ? asin(s) : PI - asin(s);
}

void analisis(double eps)
{
    double E = w0 * w0 / (2 * alpha) - cos(th0), T0, r, a = 1, suma = 1;
    int n, N;
    if (fabs(E - 1) < 1e-9) {
        k = 0;
        thM = w0 >= 0 ? PI : -PI;
        tau = fabs(log(tan(0.999 * thM / 4 + PI / 4) / tan(th0 / 4 + PI / 4))) / sqrt(alpha);
        return;
    }
    if (E < 1) {
        k = -1; thM = acos(cos(th0) - w0 * w0 / (2 * alpha));
        T0 = 2 * PI / sqrt(alpha); r = sin(thM / 2);
    } else {
        double A = sqrt(w0 * w0 + 2 * alpha * (1 - cos(th0))) / 2;
        k = 1; thM = PI;
        T0 = PI / A; r = sqrt(alpha) / A;
    }
    N = r > 0 ? (int)(log(eps * (1 - r * r)) / (2 * log(r))) + 1 : 0;
    for (n = 1; n <= N; n++) { a *= pow((2 * n - 1) * r / (2 * n), 2); suma += a; }
    tau = T0 * suma;
}

void rungeKutta(void)
{
    double tA, wA, tB, wB, tC, wC, tD, wD;
    tA = w * dt;            wA = -alpha * sin(th) * dt;
    tB = (w + wA / 2) * dt; wB = -alpha * sin(th + tA / 2) * dt;
    tC = (w + wB / 2) * dt; wC = -alpha * sin(th + tB / 2) * dt;
    tD = (w + wC) * dt;     wD = -alpha * sin(th + tC) * dt;
    th += tA / 6 + tB / 3 + tC / 3 + tD / 6;
    w += wA / 6 + wB / 3 + wC / 3 + wD / 6;
}

int main(int argc, char *argv[])
{
    double fd, fc, fs, t;
    char ut, uw;
    int n, cada, filas = 0, tablas = 0;
    PI = 4 * atan(1);
    if (argc > 1) cifras = atoi(argv[1]);
    while (scanf("%lf %lf %lf %lf %c %lf %c %lf", &fd, &fc, &fs, &th0, &ut, &w0, &uw, &alpha) == 8) {
        if (fd <= 0 || fc <= 0 || fs <= 0 || alpha <= 0 || (ut != 'r' && ut != 's') || (uw != 'r' && uw != 's')) {
            printf("ERROR: datos no validos\n");
            return 1;
        }
        if (ut == 's') th0 *= PI / 180;
        if (uw == 's') w0 *= PI / 180;
        th0 = normaliza(th0);
        analisis(1e-7);
        tcout = fc * tau; tsimul = fs * tau;
        cada = (int)floor(fc / fd + 0.5);
        dt = tcout / cada;
        filas = (int)floor(fs / fc + 1e-6);
        fi0 = fase(th0 / thM, w0) * 180 / PI;
        th = th0; w = w0;
        if (tablas++) printf("\n\n");
        printf(k == -1 ? "t angulo velocidad funcionSinusoidal\n" : "t angulo velocidad\n");
        for (n = 0; n <= filas * cada; n++) {
            t = n * dt;
            if (n % cada == 0) {
                printf("%.*g %.*g %.*g", cifras, t, cifras, normaliza(th), cifras, w);
                if (k == -1) printf(" %.*g", cifras, thM * sin(2 * PI / tau * t + fi0));
                printf("\n");
            }
            rungeKutta();
        }
    }
    return 0;
}
