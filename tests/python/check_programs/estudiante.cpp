// La actividad 3 como la programaría un estudiante. El argumento dice qué errores comete, con un + entre ellos.
#include <cmath>
#include <iomanip>
#include <iostream>
#include <string>
using namespace std;

string fallo;
bool comete(const string& nombre) { return fallo.find("+" + nombre + "+") != string::npos; }

const double PI = 3.14159265358979323846;

template <class real>
real normaliza(real theta) {
    return theta - 2 * real(PI) * floor((theta + real(PI)) / (2 * real(PI)));
}

template <class real>
real fase(real s, real r) {
    if (comete("sin_fase")) return 0;
    if (comete("fase_nan")) return asin(s * 1.000001);
    if (s >= 1) return PI / 2;
    if (s <= -1) return -PI / 2;
    real phi = asin(s);
    if (r < 0 && !comete("signo_fase")) phi = PI - phi;
    return comete("coseno") ? phi + PI / 2 : phi;
}

template <class real>
void analisis(real alpha, real theta0, real omega0, real epsilon, real& thetaM, real& tau, int& k) {
    real e = omega0 * omega0 / (2 * alpha) - cos(theta0);
    real margen = comete("regimen") ? 3e-2 : 1e-12;
    real T0, r;
    if (fabs(e - 1) < margen) {
        k = 0;
        real s = omega0 < 0 ? -1 : 1;
        thetaM = s * PI;
        tau = s / sqrt(alpha) * log(tan(real(0.999) * thetaM / 4 + real(PI) / 4) / tan(theta0 / 4 + real(PI) / 4));
        return;
    }
    if (e < 1) {
        k = -1;
        thetaM = acos(cos(theta0) - omega0 * omega0 / (2 * alpha));
        T0 = (comete("medio_periodo") ? 1 : 2) * PI / sqrt(alpha);
        r = sin(thetaM / 2);
    } else {
        k = 1;
        thetaM = PI;
        real A = sqrt(omega0 * omega0 + 2 * alpha * (1 - cos(theta0))) / 2;
        T0 = (comete("periodo_doble") ? 2 : 1) * PI / A;
        r = sqrt(alpha) / A;
    }
    real suma = 1, a = 1, N = log(epsilon * (1 - r * r)) / (2 * log(r));
    if (comete("serie_corta")) N = 3;
    if (comete("sin_serie")) N = 0;
    for (int n = 1; n <= N; n++) {
        a *= (2 * n - 1) * r / (2 * n) * (2 * n - 1) * r / (2 * n);
        suma += a;
    }
    tau = comete("tau_diez") ? 10 : T0 * suma;
}

template <class real>
real aceleracion(real alpha, real theta) {
    if (comete("lineal")) return -alpha * theta;
    if (comete("signo_aceleracion")) return alpha * sin(theta);
    if (comete("rozamiento")) return -alpha * sin(theta) * real(0.99);
    return -alpha * sin(theta);
}

template <class real>
void RungeKutta(real alpha, real& theta, real& w, real dt) {
    real tA = w * dt, wA = aceleracion(alpha, theta) * dt;
    if (comete("euler")) {
        theta += tA;
        w += wA;
        return;
    }
    if (comete("euler_cromer")) {
        w += wA;
        theta += w * dt;
        return;
    }
    real tB = (w + wA / 2) * dt, wB = aceleracion(alpha, theta + tA / 2) * dt;
    real tC = (w + wB / 2) * dt, wC = aceleracion(alpha, theta + tB / 2) * dt;
    real tD = (w + wC) * dt, wD = aceleracion(alpha, theta + tC) * dt;
    theta += tA / 6 + tB / 3 + tC / 3 + tD / 6;
    w += wA / 6 + wB / 3 + wC / 3 + wD / 6;
}

template <class real>
void lee(real& valor, char unidad, const string& nombre) {
    if (comete("como_grados_" + nombre) || comete("como_grados")) valor *= PI / 180;
    else if (unidad == 's' && !comete("grados_" + nombre) && !comete("grados")) valor *= PI / 180;
    if (comete("signo_" + nombre)) valor = -valor;
}

void cabecera(bool hay_seno) {
    if (comete("sin_cabecera") || comete("cambiadas") || comete("dos_columnas")) return;
    if (comete("otra_cabecera")) cout << "tiempo theta omega";
    else if (comete("cabecera_cambiada")) cout << "t velocidad angulo";
    else cout << "t angulo velocidad";
    if (hay_seno) cout << " funcionSinusoidal";
    cout << endl;
}

template <class real>
void escribe(real t, real theta, real w, bool hay_seno, real seno, bool es_rara) {
    real angulo = comete("sin_normalizar") ? theta : normaliza(theta);
    if (comete("en_grados")) angulo *= 180 / PI;
    if (comete("velocidad_en_grados")) w *= 180 / PI;
    if (comete("cambiadas")) swap(angulo, w);
    if (comete("nan") && es_rara) w = sqrt(real(-1));
    cout << t << ' ' << angulo;
    if (!comete("dos_columnas")) cout << ' ' << w;
    if (hay_seno && !(comete("hueco") && es_rara)) cout << ' ' << (comete("seno_es_angulo") ? angulo : seno);
    cout << endl;
}

template <class real>
void programa() {
    real fDt, fCout, fSimul, theta0, omega0, alpha;
    char uTheta, uOmega;
    while (cin >> fDt >> fCout >> fSimul >> theta0 >> uTheta >> omega0 >> uOmega >> alpha) {
        if (comete("falta_tabla") && alpha != 1) continue;
        lee(theta0, uTheta, "angulo");
        lee(omega0, uOmega, "velocidad");
        real thetaM, tau;
        int k;
        analisis(alpha, theta0, omega0, real(1e-7), thetaM, tau, k);
        real dt = fDt * tau, tCout = fCout * tau, tSimul = fSimul * tau;
        if (comete("segundos")) tCout = fCout;
        if (comete("corta")) tSimul *= 0.7;
        if (comete("larga")) tSimul *= 1.5;
        if (comete("una_fila")) tSimul = 0;
        if (comete("sin_ultima")) tSimul -= dt;
        if (comete("una_de_mas")) tSimul += tCout;

        bool hay_seno = k == -1 && !comete("sin_seno") && !comete("dos_columnas");
        if (comete("seno_siempre")) hay_seno = true;
        real phi0 = fase(theta0 / thetaM, omega0), amplitud = thetaM, T = tau;
        if (comete("amplitud_inicial")) amplitud = theta0;
        if (comete("amplitud_mal")) amplitud *= 1.1;
        if (comete("seno_T0")) T = 2 * PI / sqrt(alpha);
        if (comete("seno_doble")) T = 2 * tau;
        real alfa = alpha;
        if (comete("raiz_alfa")) alfa = sqrt(alpha);
        if (comete("alfa_cuadrado")) alfa = alpha * alpha;
        if (comete("sin_alfa")) alfa = 1;

        cabecera(hay_seno);
        cout << setprecision(comete("pocas_cifras") ? 3 : 6);
        long pasos = comete("cada_paso") ? 1 : lround(tCout / dt), n = lround(tSimul / dt);
        real theta = theta0, w = omega0, t = 0;
        for (long i = 0; i <= n; i++) {
            bool toca = i % pasos == 0;
            if (comete("desiguales") && i > n / 2) toca = i % (2 * pasos) == 0;
            if (comete("sin_primera") && i == 0) toca = false;
            if (toca) {
                real escrito = t;
                if (comete("en_periodos")) escrito = t / tau;
                if (comete("un_paso_despues")) escrito = t + dt;
                if (comete("un_paso_antes")) escrito = t - dt;
                if (comete("tiempo_suelto") && i > 0) escrito = t - dt;
                if (comete("una_fila_despues")) escrito = t + tCout;
                if (comete("una_fila_antes")) escrito = t - tCout;
                escribe(escrito, theta, w, hay_seno, normaliza(amplitud * sin(2 * real(PI) * t / T + phi0)), i == 3 * pasos);
            }
            RungeKutta(alfa, theta, w, dt);
            t += dt;
        }
        cout << endl << endl;
    }
}

int main(int argc, char* argv[]) {
    if (argc > 1) fallo = "+" + string(argv[1]) + "+";
    if (comete("float")) programa<float>();
    else programa<double>();
}
