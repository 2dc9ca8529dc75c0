// The road to chaos of the driven, damped pendulum (Baker & Gollub, Chaotic Dynamics, CUP 1996: friction 1/2, frequency 2/3):
// the periods of the orbits that it settles on, and whether neighbours drift apart.
#include <cstdio>
#include <pendula/pendula.hpp>
#include <vector>

int main() {
    const std::vector<double> amplitude{0.9, 1.07, 1.15, 1.35, 1.45, 1.47, 1.5};
    const std::size_t n = amplitude.size();
    const pendula::Ensemble pendulums{
        .size = n, .theta = 0.2, .beta = 0.5, .drive_amplitude = amplitude, .drive_frequency = 2.0 / 3};
    pendula::Strobe strobe{.transient = 200, .periods = 256, .budget = 1000};
    std::vector<double> label(n), kind(n), period(n), rotation(n), theta(n), omega(n), exponent(n), error(n), horizon(n);
    using enum pendula::Measure;
    const auto orbits = pendula::measure(attractors, pendulums, strobe, {label, kind, period, rotation, theta, omega});
    const auto growth = pendula::measure(lyapunov, pendulums, strobe, {exponent, error, horizon});
    if (!pendula::require(orbits) || !pendula::require(growth)) return 1;
    std::printf("amplitude period exponent\n");
    for (std::size_t i = 0; i < n; ++i) std::printf("%9g %6g %+8.2f\n", amplitude[i], period[i], exponent[i]);

    // The diagram itself: 100 points of the section for each of 401 amplitudes.
    std::vector<double> grid(401), points(grid.size() * 100), speeds(points.size()), turns(points.size());
    for (std::size_t i = 0; i < grid.size(); ++i) grid[i] = 1 + 0.5 * static_cast<double>(i) / 400;
    strobe.periods = 100;
    const pendula::Ensemble fine{
        .size = grid.size(), .theta = 0.2, .beta = 0.5, .drive_amplitude = grid, .drive_frequency = 2.0 / 3};
    const pendula::Control control{.proceed = [](double done) { return std::fprintf(stderr, "\r%3.0f %%", 100 * done) > 0; }};
    if (!pendula::require(pendula::measure(section, fine, strobe, {points, speeds, turns}, control))) return 1;
    std::FILE* const file = std::fopen("bifurcation.txt", "w");
    if (!file) return 1;
    for (std::size_t i = 0; i < points.size(); ++i) std::fprintf(file, "%g %.6f\n", grid[i % grid.size()], points[i]);
    return std::fclose(file) == 0 ? 0 : 1;
}
