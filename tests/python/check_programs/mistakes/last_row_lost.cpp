// The last row is lost: < for ≤.
#include <array>
#include <cmath>
#include <iostream>
#include <string>

using Vec = std::array<double, 2>;  // angle, angular velocity
const double pi = std::acos(-1.0);

template <std::size_t N>
std::array<double, N> axpy(const std::array<double, N>& x, double h, const std::array<double, N>& y) {
    auto z = x;
    for (std::size_t i = 0; i < N; ++i) z[i] += h * y[i];
    return z;
}

template <class F, class State>
State rk4(F f, const State& y, double h) {
    const State a = f(y);
    const State b = f(axpy(y, h / 2, a));
    const State c = f(axpy(y, h / 2, b));
    const State d = f(axpy(y, h, c));
    return axpy(axpy(axpy(axpy(y, h / 6, a), h / 3, b), h / 3, c), h / 6, d);
}

double wrap(double x) { return x - 2 * pi * std::floor((x + pi) / (2 * pi)); }

struct Analysis { double limit, tau; int k; };

double period(double first, double r, double eps) {
    double sum = 1, term = 1;
    const double last = r == 0 ? 0 : std::ceil(std::log(eps * (1 - r * r)) / (2 * std::log(r)));
    for (double n = 1; n <= last; ++n) {
        const double q = (2 * n - 1) / (2 * n) * r;
        sum += term *= q * q;
    }
    return first * sum;
}

Analysis analyse(Vec y, double alpha) {
    const auto [theta, omega] = y;
    const double e = omega * omega / (2 * alpha) - std::cos(theta);
    if (std::abs(e - 1) < 1e-9) {
        const double limit = std::copysign(pi, omega);
        const auto g = [](double x) { return std::log(std::tan(x / 4 + pi / 4)); };
        return {limit, std::abs(g(0.999 * limit) - g(theta)) / std::sqrt(alpha), 0};
    }
    if (e < 1) {
        const double limit = std::acos(-e);
        return {limit, period(2 * pi / std::sqrt(alpha), std::sin(limit / 2), 1e-9), -1};
    }
    const double A = std::sqrt(omega * omega + 2 * alpha * (1 - std::cos(theta))) / 2;
    return {pi, period(pi / A, std::sqrt(alpha) / A, 1e-9), 1};
}

double phase(double s, double r) {
    if (std::abs(s) >= 1) return std::copysign(pi / 2, s);
    return r < 0 ? pi - std::asin(s) : std::asin(s);
}

int main(int argc, char* argv[]) {
    std::cout.precision(argc > 1 ? std::stoi(argv[1]) : 6);
    double dt, every, until, alpha;
    char unit0, unit1;
    Vec start;
    for (std::string gap; std::cin >> dt >> every >> until >> start[0] >> unit0 >> start[1] >> unit1 >> alpha; gap = "\n\n") {
        if (unit0 == 's') start[0] *= pi / 180;
        if (unit1 == 's') start[1] *= pi / 180;
        start[0] = wrap(start[0]);
        const auto [limit, tau, k] = analyse(start, alpha);
        const double omega0 = start[1], phi = phase(start[0] / limit, omega0);
        const int n = std::lround(every / dt);
        const auto f = [alpha](const Vec& y) { return Vec{y[1], -alpha * std::sin(y[0])}; };
        std::cout << gap << "t angulo velocidad" << (k == -1 ? " funcionSinusoidal\n" : "\n");
        Vec y = start;
        for (int row = 0; row * every < until * (1 - 1e-9); ++row) {
            const double t = row * every * tau;
            std::cout << t << ' ' << wrap(y[0]) << ' ' << y[1];
            if (k == -1) std::cout << ' ' << limit * std::sin(2 * pi * t / tau + phi);
            std::cout << '\n';
            for (int i = 0; i < n; ++i) y = rk4(f, y, every * tau / n);
        }
    }
}
