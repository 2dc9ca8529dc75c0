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

TEST(MeanVelocity, OfQuasiPeriodicMotionsIsWithinASmallError) {
    // Rotation numbers by SciPy: DOP853 with rtol = 3e-14 for 1500 periods, and the weighted mean exp(-1/(s (1 - s))). That of
    // the frictionless pendulum, whose energy drifts in SciPy, is extrapolated from means over three lengths.
    const struct {
        double beta, torque, amplitude, frequency, omega, rotation, slack;
    } cases[] = {{0.5, 1.2, 0.1, 1, 1, 2.364133034454745, 1e-14},
                 {0.3, 0.9, 0.2, 0.7, 3, 4.258479172150220, 1e-14},
                 {0, 0, 0.05, 1, 3, 2.604141817614, 1e-12}};
    for (const auto& strobe : {Strobe{.periods = 400}, Strobe{.periods = 400, .method = Method::rk4}})
        for (const auto& c : cases) {
            const Flock flock{.omega = {c.omega},
                              .beta = {c.beta},
                              .torque = {c.torque},
                              .drive_amplitude = {c.amplitude},
                              .drive_frequency = {c.frequency}};
            const auto found = attractors_of(flock, strobe);
            const double slack = strobe.method == Method::rk4 ? 1e-9 : c.slack;  // some (2 pi rotation/1000)^4/120 of rk4
            EXPECT_EQ(found.kind(0), Kind::quasi_periodic) << c.beta;
            EXPECT_NEAR(found["rotation"][0], c.rotation, found["error"][0] + slack) << c.beta;
            EXPECT_LT(found["error"][0], 1e-8) << c.beta;
            EXPECT_LE(std::abs(found["exponent"][0]), found["exponent_error"][0]) << c.beta;
            EXPECT_EQ(found["label"][0], 0);
            const auto velocity = velocity_of(flock, strobe);
            EXPECT_EQ(velocity["mean_velocity"][0], found["rotation"][0] * c.frequency);
            EXPECT_EQ(velocity["error"][0], found["error"][0] * c.frequency);
        }
}

TEST(MeanVelocity, OfASlowApproachToALockedOrbitIsNeverThatOfAQuasiPeriodicOne) {
    // The drive changes its sign after half a period, and so does the motion: the mean velocity is 0. The larger multipliers of
    // the three orbits, by SciPy's DOP853 with rtol = 1e-13, are 0.99944791, 0.99937182 and 0.99930306. The first motion
    // arrives too late for the budget; it creeps by less than 0.1 turns in 1,000 periods.
    const struct {
        double beta, amplitude, frequency, transient;
        Kind kind;
    } cases[] = {{100, 1e4, 100, 200, Kind::unsettled},
                 {100, 100, 100, 200, Kind::periodic},
                 {30, 9e3, 300, 200, Kind::periodic},
                 {100, 1e4, 100, 9000, Kind::unsettled}};
    for (const auto& c : cases) {
        const Flock flock{.theta = {1}, .beta = {c.beta}, .drive_amplitude = {c.amplitude}, .drive_frequency = {c.frequency}};
        const auto found = attractors_of(flock, {.transient = c.transient});
        EXPECT_LE(std::abs(found["rotation"][0]), found["error"][0]) << c.beta << ' ' << c.amplitude;
        EXPECT_LT(found["error"][0], 1e-4) << c.beta << ' ' << c.amplitude;
        EXPECT_EQ(found.kind(0), c.kind) << c.beta << ' ' << c.amplitude;
        EXPECT_EQ(exponent_of(flock, {.transient = c.transient}).kind(0), c.kind) << c.beta << ' ' << c.amplitude;
    }
}

}  // namespace
