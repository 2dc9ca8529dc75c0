// Error: en la etapa C sobra un signo menos, que ya está en aceleracion.
#include <iostream>
#include <iomanip>
#include <math.h>
#include <stdlib.h>
using namespace std;

double PI = 3.141592653589793;

double aceleracion(double alfa, double tita) { return -alfa * sin(tita); }

int main(int argc, char* argv[]) {
    double factorDt, factorTcout, factorTsimul, tita0, vel0, alfa;
    char unidAng, unidVel;
    int nTabla = 0;
    if (argc > 1) cout.precision(atoi(argv[1]));
    while (cin >> factorDt >> factorTcout >> factorTsimul >> tita0 >> unidAng >> vel0 >> unidVel >> alfa) {
        if (unidAng == 's') tita0 = tita0 * PI / 180;
        if (unidVel == 's') vel0 = vel0 * PI / 180;
        tita0 = tita0 - 2 * PI * floor((tita0 + PI) / (2 * PI));

        // caso y tiempo caracteristico
        int caso;
        double titaMax, tau;
        double c = vel0 * vel0 / (2 * alfa) - cos(tita0);
        if (c > 1 - 1e-9 && c < 1 + 1e-9) {
            caso = 0;
            if (vel0 >= 0) titaMax = PI; else titaMax = -PI;
            tau = log(tan(0.999 * titaMax / 4 + PI / 4) / tan(tita0 / 4 + PI / 4)) / sqrt(alfa);
            if (vel0 < 0) tau = -tau;
        } else {
            double t0, r;
            if (c < 1) {
                caso = -1;
                titaMax = acos(cos(tita0) - vel0 * vel0 / (2 * alfa));
                t0 = 2 * PI / sqrt(alfa);
                r = sin(titaMax / 2);
            } else {
                caso = 1;
                titaMax = PI;
                double a = sqrt(vel0 * vel0 + 2 * alfa * (1 - cos(tita0))) / 2;
                t0 = PI / a;
                r = sqrt(alfa) / a;
            }
            double termino = 1, serie = 0;
            int n = 0;
            while (termino > 1e-9 * (1 - r * r)) {
                serie = serie + termino;
                n = n + 1;
                termino = termino * (2 * n - 1.0) * (2 * n - 1.0) * r * r / (2.0 * n) / (2.0 * n);
            }
            tau = t0 * serie;
        }
        double s = tita0 / titaMax, fi0;
        if (s >= 1) fi0 = PI / 2;
        else if (s <= -1) fi0 = -PI / 2;
        else fi0 = asin(s);
        if (s > -1 && s < 1 && vel0 < 0) fi0 = PI - fi0;

        int cada = int(factorTcout / factorDt + 0.5), contador = cada;
        double dt = factorTcout * tau / cada;
        int total = int(factorTsimul / factorTcout + 1e-9) * cada;
        double tita = tita0, vel = vel0;
        if (nTabla > 0) cout << endl << endl;
        nTabla++;
        cout << "t angulo velocidad";
        if (caso == -1) cout << " funcionSinusoidal";
        cout << "\n";
        for (int paso = 0; paso <= total; paso++) {
            double t = paso * dt;
            if (contador == cada) {
                double ang = tita;
                ang = ang - 2 * PI * floor((ang + PI) / (2 * PI));
                cout << t << " " << ang << " " << vel;
                if (caso == -1) cout << " " << titaMax * sin(2 * PI * t / tau + fi0);
                cout << "\n";
                contador = 0;
            }
            double dA = vel * dt, vA = aceleracion(alfa, tita) * dt;
            double dB = (vel + vA / 2) * dt, vB = aceleracion(alfa, tita + dA / 2) * dt;
            double dC = (vel + vB / 2) * dt, vC = -aceleracion(alfa, tita + dB / 2) * dt;
            double dD = (vel + vC) * dt, vD = aceleracion(alfa, tita + dC) * dt;
            tita += (dA + 2 * dB + 2 * dC + dD) / 6;
            vel += (vA + 2 * vB + 2 * vC + vD) / 6;
            contador++;
        }
    }
}
