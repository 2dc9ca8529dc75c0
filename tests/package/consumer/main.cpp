// A program of someone else's: the period of a pendulum one metre long, let go at 90 degrees.
#include <pendula/angle.hpp>
#include <pendula/exact.hpp>
#include <pendula/validate.hpp>

#include <cstdio>

int main() {
    const double alpha = 9.81;
    const pendula::State initial{pendula::to_radians(90), 0};
    pendula::require("alpha", alpha, pendula::Rule::positive);
    const pendula::Exact orbit = pendula::exact(alpha, initial);
    const double tau = orbit.analysis.tau;
    std::printf("%.6g %.6g\n", tau, pendula::at(orbit, tau / 2).theta);
}
