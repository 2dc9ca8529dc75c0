// How the period grows with the amplitude: in closed form, by the usual series, and as a run of Taylor's method measures it.
#include <cmath>
#include <cstdio>
#include <pendula/pendula.hpp>

int main() {
    std::printf("amplitude  period/T0   1 + a^2/16 + 11 a^4/3072  measured/T0\n");
    for (const double degrees : {1.0, 30.0, 90.0, 150.0, 179.0}) {
        const double amplitude = pendula::to_radians(degrees), small = 2 * pendula::pi;  // T0, for alpha = 1
        const double period = pendula::analyze(1, {amplitude, 0}).tau;
        const double series = 1 + std::pow(amplitude, 2) / 16 + 11 * std::pow(amplitude, 4) / 3072;
        double measured = 0;
        if (!pendula::require(pendula::measured_period({}, {amplitude, 0}, 20 * period, 1e-15, measured))) return 1;
        std::printf("%8g°  %.9f  %.9f               %.9f\n", degrees, period / small, series, measured / small);
    }
}
