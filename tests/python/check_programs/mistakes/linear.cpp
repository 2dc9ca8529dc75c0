// Error: theta en lugar de sen(theta).
#include <cmath>
#include <cstdlib>
#include <iomanip>
#include <iostream>

template <typename Real>
class Pendulo {
  public:
    Pendulo(Real alfa, Real theta, Real omega) : alfa(alfa), theta(normaliza(theta)), omega(omega) { analisis(); }

    static Real normaliza(Real x) { return x - dos_pi() * std::floor((x + dos_pi() / 2) / dos_pi()); }
    static Real dos_pi() { return 2 * std::acos(Real(-1)); }

    Real aceleracion(Real x) const { return -alfa * x; }

    void avanza(Real h) {
        Real kt[4], kw[4];
        kt[0] = omega;
        kw[0] = aceleracion(theta);
        kt[1] = omega + h / 2 * kw[0];
        kw[1] = aceleracion(theta + h / 2 * kt[0]);
        kt[2] = omega + h / 2 * kw[1];
        kw[2] = aceleracion(theta + h / 2 * kt[1]);
        kt[3] = omega + h * kw[2];
        kw[3] = aceleracion(theta + h * kt[2]);
        theta += h * (kt[0] + 2 * kt[1] + 2 * kt[2] + kt[3]) / 6;
        omega += h * (kw[0] + 2 * kw[1] + 2 * kw[2] + kw[3]) / 6;
    }

    void escribe(Real t) const {
        std::cout << t << '\t' << normaliza(theta) << '\t' << omega;
        if (regimen == -1) std::cout << '\t' << maximo * std::sin(dos_pi() * t / tau + fase);
        std::cout << '\n';
    }

    int regimen;
    Real maximo, tau, fase = 0;

  private:
    Real alfa, theta, omega;

    void analisis() {
        const Real pi = dos_pi() / 2, e = omega * omega / (2 * alfa) - std::cos(theta);
        const Real signo = omega < 0 ? -1 : 1;
        maximo = pi;
        if (std::abs(e - 1) < Real(1e-9)) {
            regimen = 0;
            maximo = signo * pi;
            tau = signo / std::sqrt(alfa) * std::log(std::tan(Real(0.999) * maximo / 4 + pi / 4) / std::tan(theta / 4 + pi / 4));
        } else if (e > 1) {
            regimen = 1;
            const Real a = std::sqrt(omega * omega + 2 * alfa * (1 - std::cos(theta))) / 2;
            tau = periodo(pi / a, std::sqrt(alfa) / a);
        } else {
            regimen = -1;
            maximo = std::acos(-e);
            tau = periodo(dos_pi() / std::sqrt(alfa), std::sin(maximo / 2));
            const Real s = theta / maximo;
            fase = s >= 1 ? pi / 2 : s <= -1 ? -pi / 2 : signo > 0 ? std::asin(s) : pi - std::asin(s);
        }
    }

    static Real periodo(Real t0, Real r) {
        const int terminos = int(std::ceil(std::log(Real(1e-13) * (1 - r * r)) / (2 * std::log(r))));
        Real suma = 1, a = 1;
        for (int n = 1; n <= terminos; ++n) suma += a *= std::pow((2 * n - 1) * r / (2 * n), 2);
        return t0 * suma;
    }
};

typedef double real;

int main(int argc, char** argv) {
    std::cout << std::setprecision(argc > 1 ? std::atoi(argv[1]) : 6);
    real paso, salida, final, theta, omega, alfa;
    char u, v;
    const char* separa = "";
    while (std::cin >> paso >> salida >> final >> theta >> u >> omega >> v >> alfa) {
        if (u == 's') theta *= Pendulo<real>::dos_pi() / 360;
        if (v == 's') omega *= Pendulo<real>::dos_pi() / 360;
        Pendulo<real> p(alfa, theta, omega);
        std::cout << separa << "t\tangulo\tvelocidad" << (p.regimen == -1 ? "\tfuncionSinusoidal\n" : "\n");
        separa = "\n\n";
        const int filas = int(final / salida + real(0.001)), pasos = int(salida / paso + real(0.5));
        p.escribe(0);
        for (int j = 1; j <= filas; ++j) {
            for (int i = 0; i < pasos; ++i) p.avanza(paso * p.tau);
            p.escribe(j * salida * p.tau);
        }
    }
}
