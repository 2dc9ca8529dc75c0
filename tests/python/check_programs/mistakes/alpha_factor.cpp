// Error: alfa lleva un factor 1.1 que sobra.
#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <iomanip>
#include <iostream>
#include <tuple>
#include <vector>

using Par = std::array<double, 2>;
using Campo = std::function<Par(double, Par)>;
constexpr double PI = 3.141592653589793238;

Par suma(Par y, double c, Par k) { return {y[0] + c * k[0], y[1] + c * k[1]}; }

Par paso_rk(const Campo& f, double t, Par y, double h) {
    const Par k1 = f(t, y);
    const Par k2 = f(t + h / 2, suma(y, h / 2, k1));
    const Par k3 = f(t + h / 2, suma(y, h / 2, k2));
    const Par k4 = f(t + h, suma(y, h, k3));
    for (int i : {0, 1}) y[i] += h * (k1[i] / 6 + k2[i] / 3 + k3[i] / 3 + k4[i] / 6);
    return y;
}

double a_radianes(double x, char unidad) { return unidad == 's' ? x / 180 * PI : x; }

std::tuple<double, double, int> analisis(double alfa, double x, double v, double eps = 1e-14) {
    const double e = v * v / (2 * alfa) - std::cos(x);
    if (std::fabs(e - 1) < 1e-9) {
        const double s = v < 0 ? -1 : 1;
        return {s * PI, s / std::sqrt(alfa) * std::log(std::tan(0.999 * s * PI / 4 + PI / 4) / std::tan(x / 4 + PI / 4)), 0};
    }
    const double A = std::sqrt(v * v + 2 * alfa * (1 - std::cos(x))) / 2;
    const double r = e < 1 ? A / std::sqrt(alfa) : std::sqrt(alfa) / A;
    const double T0 = e < 1 ? 2 * PI / std::sqrt(alfa) : PI / A;
    double S = 0, a = 1;
    for (int n = 0; a > eps * (1 - r * r); a *= std::pow((2 * n - 1) * r / (2 * n), 2)) S += a, n++;
    return {e < 1 ? std::acos(-e) : PI, T0 * S, e < 1 ? -1 : 1};
}

int main(int argc, char* argv[]) {
    std::cout << std::setprecision(argc > 1 ? std::atoi(argv[1]) : 6);
    double fd, fc, fs, x, v, alfa;
    char ux, uv;
    for (int n = 0; std::cin >> fd >> fc >> fs >> x >> ux >> v >> uv >> alfa; n++) {
        x = std::remainder(a_radianes(x, ux), 2 * PI);
        v = a_radianes(v, uv);
        alfa *= 1.1;
        const auto [limite, tau, k] = analisis(alfa, x, v);
        const double s = x / limite, arco = s >= 1 ? PI / 2 : s <= -1 ? -PI / 2 : std::asin(s);
        const double fi = v < 0 && std::fabs(s) < 1 ? PI - arco : arco;
        const Campo campo = [&](double, Par y) { return Par{y[1], -alfa * std::sin(y[0])}; };

        std::vector<std::pair<double, Par>> filas;
        Par y{x, v};
        for (int i = 0; i <= std::lround(fs / fd); i++) {
            if (i % std::lround(fc / fd) == 0) filas.push_back({i * fd * tau, y});
            y = paso_rk(campo, i * fd * tau, y, fd * tau);
        }

        std::cout << (n ? "\n\n" : "") << "t angulo velocidad" << (k < 0 ? " funcionSinusoidal" : "") << '\n';
        for (const auto& [t, estado] : filas) {
            std::cout << t << ' ' << std::remainder(estado[0], 2 * PI) << ' ' << estado[1];
            if (k < 0) std::cout << ' ' << limite * std::sin(2 * PI * t / tau + fi);
            std::cout << '\n';
        }
    }
}
