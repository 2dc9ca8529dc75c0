// Mean velocities of driven pendulums, and analytic limits of undriven ones.
#include "flocks.hpp"
#include "pendula/angle.hpp"

namespace {

using namespace reference;

TEST(MeanVelocity, OfLockedOrbitsIsAWholeMultipleOfTheDrivesFrequency) {
    for (const auto& strobe : {Strobe{}, by_rk4(300, 40, 200)}) {
        const auto found = velocity_of(published({0.9, 1.07, 1.35, 1.45, 1.47}), strobe);
        for (int i : {0, 1, 2, 3, 4}) {
            EXPECT_EQ(std::abs(found["mean_velocity"][i]), i < 2 ? 0 : 2.0 / 3);
            EXPECT_EQ(found["error"][i], 0);
            EXPECT_EQ(found.kind(i), Kind::periodic);
        }
    }
}

TEST(MeanVelocity, OverdampedTendsToTheSquareRootLaw) {
    const double torque = 1.5;
    double error = 1;
    for (double beta : {4.0, 8.0, 16.0}) {
        const double expected = std::sqrt(torque * torque - 1) / beta;
        const double v = velocity_of({.beta = {beta}, .torque = {torque}}, {})["mean_velocity"][0];
        EXPECT_LT(std::abs(v - expected) / expected, 0.3 * error);
        error = std::abs(v - expected) / expected;
    }
    EXPECT_LT(error, 0.005);
}

TEST(MeanVelocity, VanishesBelowARetrappingTorqueThatTendsTo4BetaOverPi) {
    for (double beta : {0.1, 0.05}) {
        for (double alpha : {1.0, 4.0}) {
            const double scale = 4 * beta * std::sqrt(alpha) / pi;
            const auto torques = linspace(0.95 * scale, 1.05 * scale, 41);
            const auto v = velocity_of({.omega = {2.2 * std::sqrt(alpha)}, .alpha = {alpha}, .beta = {beta}, .torque = torques},
                                       {})["mean_velocity"];
            std::size_t trapped = 0;
            while (trapped < v.size() && v[trapped] == 0) ++trapped;
            ASSERT_LT(trapped, v.size());
            for (std::size_t i = trapped; i < v.size(); ++i) EXPECT_GT(v[i], 0.1);
            EXPECT_NEAR(torques[trapped] / scale, 1, 0.0026 + 2 * beta * beta) << beta;  // the grid's step, and the next order
        }
    }
}

TEST(MeanVelocity, HasShapiroStepsOfBesselWidthAtHighFrequency) {
    const double frequency = 10, beta = 2, amplitude = 150;
    const double a = amplitude / (frequency * std::sqrt(frequency * frequency + beta * beta));
    for (int n : {0, 1, 2}) {
        const double half_width = std::abs(std::cyl_bessel_j(n, a)), middle = beta * frequency * n;
        std::vector<double> torques;
        for (double part : {-1.06, -0.94, -0.5, 0.0, 0.5, 0.94, 1.06}) torques.push_back(middle + part * half_width);
        const auto found = velocity_of({.omega = {frequency * n},
                                        .beta = {beta},
                                        .torque = torques,
                                        .drive_amplitude = {amplitude},
                                        .drive_frequency = {frequency}},
                                       {});
        const auto v = found["mean_velocity"];
        for (int i = 1; i < 6; ++i) {
            EXPECT_EQ(v[i], n * frequency) << n << ' ' << i;
            EXPECT_EQ(found["error"][i], 0) << n << ' ' << i;
        }
        EXPECT_LT(v[0] + found["error"][0], n * frequency - 0.01);
        EXPECT_GT(v[6] - found["error"][6], n * frequency + 0.01);
    }
}

}  // namespace
