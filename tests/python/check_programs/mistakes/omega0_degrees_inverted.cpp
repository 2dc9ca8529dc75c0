// Error: los grados por segundo se multiplican por 180/pi.
#include <cmath>
#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <string>

struct Estado {
    double angulo, velocidad;
};

Estado operator+(Estado x, Estado y) { return {x.angulo + y.angulo, x.velocidad + y.velocidad}; }
Estado operator*(double c, Estado x) { return {c * x.angulo, c * x.velocidad}; }

struct Pendulo {
    double alfa;
    Estado derivada(Estado x) const { return {x.velocidad, -alfa * std::sin(x.angulo)}; }
    Estado rk4(Estado x, double h) const {
        Estado k1 = derivada(x);
        Estado k2 = derivada(x + 0.5 * h * k1);
        Estado k3 = derivada(x + 0.5 * h * k2);
        Estado k4 = derivada(x + h * k3);
        return x + h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
    }
};

double mediaAG(double a, double b) {
    while (std::abs(a - b) > 1e-15 * a) {
        double m = 0.5 * (a + b);
        b = std::sqrt(a * b);
        a = m;
    }
    return a;
}

double entre_menos_pi_y_pi(double x) {
    while (x >= M_PI) x -= 2 * M_PI;
    while (x < -M_PI) x += 2 * M_PI;
    return x;
}

int main(int argc, char** argv) {
    std::string linea;
    bool otro = false;
    std::cout << std::setprecision(argc > 1 ? std::stoi(argv[1]) : 6);
    while (std::getline(std::cin, linea)) {
        std::istringstream datos(linea);
        double fdt, fcout, fsim, th0, om0, alfa;
        char u1, u2;
        if (!(datos >> fdt >> fcout >> fsim >> th0 >> u1 >> om0 >> u2 >> alfa)) continue;
        if (u1 == 's') th0 = th0 * M_PI / 180;
        if (u2 == 's') om0 = om0 * 180 / M_PI;
        Pendulo p{alfa};
        Estado x{entre_menos_pi_y_pi(th0), om0};
        double energia = om0 * om0 / 2 / alfa - cos(th0), max = M_PI, tau, fi = 0;
        bool oscila = false;
        if (std::abs(energia - 1) <= 1e-9) {
            if (om0 < 0) max = -M_PI;
            tau = std::abs(std::log(std::tan(0.999 * max / 4 + M_PI / 4) / std::tan(x.angulo / 4 + M_PI / 4))) / std::sqrt(alfa);
        } else if (energia > 1) {
            double a = std::sqrt(om0 * om0 + 2 * alfa * (1 - cos(th0))) / 2;
            tau = M_PI / mediaAG(a, std::sqrt(a * a - alfa));
        } else {
            oscila = true;
            max = std::acos(-energia);
            tau = 2 * M_PI / std::sqrt(alfa) / mediaAG(1, std::cos(max / 2));
            double s = x.angulo / max;
            fi = std::abs(s) >= 1 ? std::copysign(M_PI / 2, s) : std::asin(s);
            if (om0 < 0 && std::abs(s) < 1) fi = M_PI - fi;
        }
        if (otro) std::cout << std::endl << std::endl;
        otro = true;
        std::cout << (oscila ? "t angulo velocidad funcionSinusoidal" : "t angulo velocidad") << std::endl;
        double dt = fdt * tau, t = 0, proximo = 0;
        while (proximo <= fsim * tau * (1 + 1e-9)) {
            if (t >= proximo - dt / 2) {
                std::cout << t << " " << entre_menos_pi_y_pi(x.angulo) << " " << x.velocidad;
                if (oscila) std::cout << " " << max * std::sin(2 * M_PI * t / tau + fi);
                std::cout << std::endl;
                proximo += fcout * tau;
            }
            x = p.rk4(x, dt);
            t += dt;
        }
    }
    return 0;
}
