// A phase portrait: theta and omega along six motions of one energy each, in blocks for gnuplot's `plot "file" index ...`.
#include <cmath>
#include <cstdio>
#include <pendula/pendula.hpp>

int main() {
    const double alpha = 9.81 / 0.5;  // half a metre
    for (const double of_top : {0.1, 0.5, 0.9, 1.0, 1.1, 2.0}) {
        const double energy = 2 * alpha * of_top;  // per m l^2, in parts of that at rest on top
        const pendula::Problem problem{.pendulum = {.alpha = alpha},
                                       .initial = {0, std::sqrt(2 * energy)},
                                       .method = pendula::Method::exact,
                                       .schedule = pendula::make_schedule({.dt = 0.05, .every = 0.05, .until = 1})};
        const char* const names[] = {"oscillation", "separatrix", "rotation"};
        const auto analysis = pendula::analyze(alpha, problem.initial);
        std::printf("# E/E_top = %g: %s, tau = %.6f s\n", of_top, names[static_cast<int>(analysis.regime) + 1], analysis.tau);
        for (const auto& row : pendula::solve(problem)) std::printf("%.2f %.6f %.6f\n", row.t, row.theta, row.omega);
        std::printf("\n\n");
    }
}
