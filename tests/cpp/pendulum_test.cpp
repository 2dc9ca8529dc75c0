#include "pendula/pendulum.hpp"

#include <gtest/gtest.h>

#include "reference_table.hpp"

namespace {

using namespace pendula;

TEST(Acceleration, SumsTheTermsOfTheEquation) {
    const Pendulum p{.alpha = 2,
                     .beta = 0.25,
                     .torque = 0.5,
                     .drive_amplitude = 0.75,
                     .pivot_amplitude = 1.25,
                     .drive_frequency = 3,
                     .drive_phase = 0.1};
    const double cosine = std::cos(3 * 1.25 + 0.1);
    const double want = -(2 + 1.25 * cosine) * std::sin(0.7) - 0.25 * 1.5 + 0.5 + 0.75 * cosine;
    EXPECT_NEAR(acceleration(p, {0.7, 1.5}, 1.25), want, 10 * reference::ulp(2.0));  // ten roundings of terms below 4
    EXPECT_EQ(acceleration({}, {0, 5}, 100), 0);
}

TEST(Energy, KeepsItsDigitsWhereTheAngleIsSmall) {
    EXPECT_NEAR(energy(3, {1e-9, 0}), 1.5e-18, 3 * reference::ulp(1.5e-18));  // 1 - cos would give 0
    EXPECT_NEAR(energy(3, {0, 2}), 2, 0);
    EXPECT_NEAR(energy(3, {3.141592653589793, 0}), 6, reference::ulp(6.0));
}

}  // namespace
