// The rest of the line and the whole next one are thrown away after each problem.
#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

static const double kPi = std::atan2(0.0, -1.0);

using Row = std::vector<double>;

int main(int argc, char** argv) {
    const int digits = argc > 1 ? std::stoi(argv[1]) : 6;
    auto normalize = [](double x) { return x - 2 * kPi * std::floor(x / (2 * kPi) + 0.5); };
    auto radians = [](double value, char unit) { return unit == 's' ? value / 180 * kPi : value; };
    auto phase = [](double s, double r) {
        if (s >= 1) return kPi / 2;
        if (s <= -1) return -kPi / 2;
        return r < 0 ? kPi - std::asin(s) : std::asin(s);
    };

    double f_dt, f_cout, f_simul, angle, velocity, alpha;
    char unit_a, unit_v;
    std::vector<std::string> tables;
    while (std::cin >> f_dt >> f_cout >> f_simul >> angle >> unit_a >> velocity >> unit_v >> alpha) {
        std::string rest;
        std::getline(std::cin, rest);
        std::getline(std::cin, rest);
        const double theta0 = normalize(radians(angle, unit_a)), omega0 = radians(velocity, unit_v);
        const double energy = omega0 * omega0 / (2 * alpha) - std::cos(theta0);
        const int k = std::abs(energy - 1) < 1e-9 ? 0 : energy < 1 ? -1 : 1;
        const double theta_max = k < 0 ? std::acos(-energy) : k == 0 && omega0 < 0 ? -kPi : kPi;

        // The series (3.6) is the inverse of this mean of 1 and the root of 1 - r*r.
        std::function<double(double, double)> mean = [&](double a, double b) {
            return std::abs(a - b) < 1e-14 * a ? a : mean((a + b) / 2, std::sqrt(a * b));
        };
        double tau;
        if (k == 0) {
            auto z = [](double theta) { return std::tan(theta / 4 + kPi / 4); };
            tau = std::abs(std::log(z(0.999 * theta_max) / z(theta0)) / std::sqrt(alpha));
        } else if (k < 0) {
            tau = 2 * kPi / std::sqrt(alpha) / mean(1, std::cos(theta_max / 2));
        } else {
            const double A = std::sqrt(omega0 * omega0 + 2 * alpha * (1 - std::cos(theta0))) / 2;
            tau = kPi / mean(A, std::sqrt(A * A - alpha));
        }

        const long per_row = std::lround(f_cout / f_dt), steps = per_row * long(f_simul / f_cout + 1e-9);
        const double h = f_cout * tau / per_row, phi0 = phase(theta0 / theta_max, omega0);
        auto acceleration = [alpha](double theta) { return -alpha * std::sin(theta); };
        auto runge_kutta = [&](double theta, double omega) {
            double dA = omega * h, wA = acceleration(theta) * h;
            double dB = (omega + wA / 2) * h, wB = acceleration(theta + dA / 2) * h;
            double dC = (omega + wB / 2) * h, wC = acceleration(theta + dB / 2) * h;
            double dD = (omega + wC) * h, wD = acceleration(theta + dC) * h;
            return std::make_pair(theta + (dA + 2 * dB + 2 * dC + dD) / 6, omega + (wA + 2 * wB + 2 * wC + wD) / 6);
        };

        std::vector<Row> rows;
        double theta = theta0, omega = omega0;
        for (long i = 0; i <= steps; ++i) {
            const double t = i * h;
            if (i % per_row == 0) {
                rows.push_back({t, normalize(theta), omega});
                if (k < 0) rows.back().push_back(theta_max * std::sin(2 * kPi / tau * t + phi0));
            }
            std::tie(theta, omega) = runge_kutta(theta, omega);
        }

        std::ostringstream out;
        out.precision(digits);
        out << "t angulo velocidad" << (k < 0 ? " funcionSinusoidal" : "");
        for (const Row& row : rows) {
            out << '\n';
            for (std::size_t i = 0; i < row.size(); ++i) out << (i ? " " : "") << row[i];
        }
        tables.push_back(out.str());
    }
    for (std::size_t i = 0; i < tables.size(); ++i) std::cout << (i ? "\n\n\n" : "") << tables[i];
    std::cout << '\n';
}
