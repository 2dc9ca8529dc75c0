// Kapitza's pendulum: shaken fast enough, it stands upright. With theta'' = -(alpha + P cos(Omega t)) sin(theta) it does so
// where P exceeds sqrt(2 alpha) Omega, for Omega^2 far above alpha.
#include <cmath>
#include <cstdio>
#include <pendula/pendula.hpp>

int main() {
    const double alpha = 1, frequency = 30, threshold = std::sqrt(2 * alpha) * frequency;
    std::printf("P/threshold  largest departure from the top [rad]\n");
    for (const double part : {0.9, 0.98, 1.02, 1.1, 1.5}) {
        const pendula::Problem problem{
            .pendulum = {.alpha = alpha, .pivot_amplitude = part * threshold, .drive_frequency = frequency},
            .initial = {pendula::pi - 0.01, 0},
            .method = pendula::Method::taylor,
            .schedule = pendula::make_schedule({.dt = 0.01, .every = 0.01, .until = 60})};
        double departure = 0;
        for (const auto& row : pendula::solve(problem))
            departure = std::fmax(departure, std::fabs(pendula::wrap(row.theta - pendula::pi)));
        std::printf("%11g  %.2f\n", part, departure);
    }
}
