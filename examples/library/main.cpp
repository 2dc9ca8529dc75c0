#include <cstdio>
#include <pendula/angle.hpp>
#include <pendula/exact.hpp>

int main() {
    const pendula::Exact orbit = pendula::exact(1, {pendula::to_radians(90), 0});
    const pendula::Sample row = pendula::at(orbit, orbit.analysis.tau / 50);
    std::printf("%.6g %.6g %.6g\n", row.t, row.theta, row.omega);  // 0.148326 1.5598 -0.148324
}
