#include "flocks.hpp"
#include "pendula/angle.hpp"
#include "pendula/carry.hpp"
namespace {
using namespace reference;
struct Jumps {
    std::vector<double> value, error, gap, before, after;
};

const Parameter& parameter(const char* name) {
    return *std::ranges::find_if(parameters, [&](const Parameter& p) { return std::strcmp(p.name, name) == 0; });
}

Jumps jumps_of(const Flock& flock, std::size_t line, Carry carry, const char* swept, double tolerance, const Strobe& strobe) {
    Jumps j;
    for (auto* column : {&j.value, &j.error, &j.gap, &j.before, &j.after}) column->resize(flock.size());
    const auto outcome = locate_jumps(flock.ensemble(), line, carry, parameter(swept), tolerance, strobe,
                                      {j.value, j.error, j.gap, j.before, j.after});
    EXPECT_TRUE(outcome.is_done()) << describe(outcome.refusal);
    for (std::size_t i = 0; i < flock.size(); ++i)
        if (j.value[i] == j.value[i])
            printf("%zu %.12g +- %.2g gap %g  %s -> %s\n", i, j.value[i], j.error[i], j.gap[i], kind_names[int(j.before[i])], kind_names[int(j.after[i])]);
    return j;
}
TEST(Jumps, Junction) {
    const Flock flock{.beta = {0.2}, .torque = linspace(0.05, 1.15, 12)};
    jumps_of(flock, 12, Carry::up, "torque", 1e-9, {200, 100});
    jumps_of(flock, 12, Carry::down, "torque", 1e-9, {200, 100});
}
TEST(Jumps, Duffing) {
    const Flock flock{.beta = {0.05}, .drive_amplitude={0.06}, .drive_frequency = linspace(0.7, 1.05, 36)};
    jumps_of(flock, 36, Carry::up, "drive_frequency", 1e-9, {200, 400});
    jumps_of(flock, 36, Carry::down, "drive_frequency", 1e-9, {200, 400});
}
}
