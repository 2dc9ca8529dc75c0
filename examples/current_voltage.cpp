// The current-voltage curve of a Josephson junction: theta is the phase difference, torque the bias current over the critical
// one, and the mean angular velocity the voltage. Without microwaves an overdamped junction follows V = sqrt(I^2 - 1)/beta;
// with them (a drive) there are Shapiro steps, where the voltage is a whole multiple of the frequency.
#include <cmath>
#include <cstdio>
#include <pendula/pendula.hpp>
#include <vector>

int main() {
    const std::vector<double> current{0.5, 0.9, 1.1, 1.5, 2.0, 3.0};
    const std::size_t n = current.size();
    std::vector<double> voltage(n), driven(n), error(n);
    const double beta = 10, frequency = 0.1;
    const pendula::Ensemble junctions{.size = n, .beta = beta, .torque = current};
    pendula::Ensemble with_microwaves = junctions;
    with_microwaves.drive_amplitude = 1.0;
    with_microwaves.drive_frequency = frequency;
    using pendula::Measure;
    if (!pendula::require(pendula::measure(Measure::mean_velocity, junctions, {}, {voltage, error}))) return 1;
    if (!pendula::require(pendula::measure(Measure::mean_velocity, with_microwaves, {.periods = 400}, {driven, error})))
        return 1;
    std::printf("current voltage sqrt(I^2-1)/beta driven/frequency\n");
    for (std::size_t i = 0; i < n; ++i) {
        const double law = current[i] > 1 ? std::sqrt(current[i] * current[i] - 1) / beta : 0;
        std::printf("%7.2f %7.4f %16.4f %16.2f\n", current[i], voltage[i], law, driven[i] / frequency);
    }
}
