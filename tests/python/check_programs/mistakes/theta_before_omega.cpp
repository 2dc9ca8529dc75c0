// Error: la velocidad nueva se calcula con el ángulo ya actualizado.
#include <cmath>
#include <cstdlib>
#include <iostream>
using namespace std;

const double PI = acos(-1.0);

bool validaAngulo(double& angulo, char unidades) {
    if (unidades == 's') angulo *= PI / 180;
    return unidades == 'r' || unidades == 's';
}

double fase(double s, double r) {
    if (s >= 1) return PI / 2;
    if (s <= -1) return -PI / 2;
    return r < 0 ? PI - asin(s) : asin(s);
}

double normaliza(double theta) { return theta - 2 * PI * floor((theta + PI) / (2 * PI)); }

double serie(double r, double epsilon) {
    double N = log(epsilon * (1 - r * r)) / (2 * log(r)), a = 1, suma = 1;
    for (int n = 1; n <= N + 1; n++) {
        a *= pow((2.0 * n - 1) / (2.0 * n) * r, 2);
        suma += a;
    }
    return suma;
}

void analisis(double alpha, double theta0, double w0, double epsilon, double& thetaM, double& tau, int& k) {
    double e = w0 * w0 / (2 * alpha) - cos(theta0);
    if (fabs(e - 1) < 1e-9) {
        k = 0;
        thetaM = w0 >= 0 ? PI : -PI;
        tau = log(tan(0.999 * thetaM / 4 + PI / 4) / tan(theta0 / 4 + PI / 4)) / sqrt(alpha);
        if (w0 < 0) tau = -tau;
    } else if (e < 1) {
        k = -1;
        thetaM = acos(cos(theta0) - w0 * w0 / (2 * alpha));
        tau = 2 * PI / sqrt(alpha) * serie(sin(thetaM / 2), epsilon);
    } else {
        k = 1;
        thetaM = PI;
        double A = sqrt(w0 * w0 + 2 * alpha * (1 - cos(theta0))) / 2;
        tau = PI / A * serie(sqrt(alpha) / A, epsilon);
    }
}

double nuevoAngulo(double alpha, double theta, double w, double dt) {
    double wA = -alpha * sin(theta) * dt;
    double wB = -alpha * sin(theta + w * dt / 2) * dt;
    double wC = -alpha * sin(theta + (w + wA / 2) * dt / 2) * dt;
    return theta + (w + 2 * (w + wA / 2) + 2 * (w + wB / 2) + (w + wC)) * dt / 6;
}

double nuevaVelocidad(double alpha, double theta, double w, double dt) {
    double wA = -alpha * sin(theta) * dt;
    double wB = -alpha * sin(theta + w * dt / 2) * dt;
    double wC = -alpha * sin(theta + (w + wA / 2) * dt / 2) * dt;
    double wD = -alpha * sin(theta + (w + wB / 2) * dt) * dt;
    return w + (wA + 2 * wB + 2 * wC + wD) / 6;
}

int main(int argc, char* argv[]) {
    double fDelta, fCout, fSimul, theta, w, alpha;
    char uTheta, uW;
    bool primero = true;
    cout.precision(argc > 1 ? atoi(argv[1]) : 6);
    while (cin >> fDelta >> fCout >> fSimul >> theta >> uTheta >> w >> uW >> alpha) {
        if (alpha <= 0 || fDelta <= 0 || fCout <= 0 || fSimul <= 0 || !validaAngulo(theta, uTheta) || !validaAngulo(w, uW)) {
            cerr << "Datos incorrectos\n";
            return 1;
        }
        theta = normaliza(theta);
        if (!primero) cout << "\n\n";
        primero = false;
        double thetaM, tau;
        int k;
        analisis(alpha, theta, w, 1e-13, thetaM, tau, k);
        double dt = fDelta * tau, phi = fase(theta / thetaM, w);
        int cada = round(fCout / fDelta), pasos = round(fSimul / fDelta);
        cout << "t angulo velocidad" << (k == -1 ? " funcionSinusoidal\n" : "\n");
        for (int n = 0; n <= pasos; n++) {
            if (n % cada == 0) {
                cout << n * dt << ' ' << normaliza(theta) << ' ' << w;
                if (k == -1) cout << ' ' << thetaM * sin(2 * PI * n * dt / tau + phi);
                cout << '\n';
            }
            theta = nuevoAngulo(alpha, theta, w, dt);
            w = nuevaVelocidad(alpha, theta, w, dt);
        }
    }
}
