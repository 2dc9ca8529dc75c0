// What is known of driven pendulums: published periods, analytic limits, and identities that hold for each.
#include "flocks.hpp"
#include "pendula/angle.hpp"
#include "pendula/exact.hpp"

namespace {

using namespace reference;

TEST(Orbits, HaveThePublishedPeriodsAndRotationNumbers) {
    const auto found = orbits_of(published({0.9, 1.07, 1.15, 1.35, 1.45, 1.47, 1.5}), {200, 256, 200});
    EXPECT_EQ(found.period, (std::vector<double>{1, 2, 0, 1, 2, 4, 0}));
    for (int i : {0, 1}) EXPECT_EQ(found.rotation[i], 0);
    for (int i : {3, 4, 5}) EXPECT_EQ(std::abs(found.rotation[i]), 1);
}

TEST(Orbits, OfALateComerAreFoundWithTheirSmallestPeriod) {
    const auto found = orbits_of(published({0.9, 1.07, 1.35, 1.45, 1.47}), {0, 512, 200});
    EXPECT_EQ(found.period, (std::vector<double>{1, 2, 1, 2, 4}));
}

TEST(Orbits, AreRepresentedByTheirPointOfSmallestAngle) {
    const auto flock = published({1.47});
    const auto found = orbits_of(flock, {400, 64, 200});
    const auto points = section_of(flock, {400, 4, 200});
    EXPECT_NEAR(found.theta[0], *std::min_element(points.theta.begin(), points.theta.end()), 1e-6);
}

TEST(Attractors, AreNumberedTheSameHoweverMembersAreOrdered) {
    Flock flock = published({1.45});
    for (double theta : linspace(-3, 3, 12))
        for (double omega : linspace(-2.5, 2.5, 12)) {
            flock.theta.push_back(theta);
            flock.omega.push_back(omega);
        }
    flock.theta.erase(flock.theta.begin());
    flock.omega.erase(flock.omega.begin());
    Strobe strobe{300, 64, 100};
    strobe.match = 1e-4;
    const auto found = orbits_of(flock, strobe);
    std::ranges::reverse(flock.theta);
    std::ranges::reverse(flock.omega);
    auto backward = orbits_of(flock, strobe);
    for (auto* column : {&backward.label, &backward.rotation, &backward.theta}) std::ranges::reverse(*column);

    EXPECT_EQ(found.label, backward.label);
    EXPECT_EQ(std::ranges::count(found.label, 1) + std::ranges::count(found.label, 2),
              static_cast<std::ptrdiff_t>(flock.size()));
    for (std::size_t i = 0; i < flock.size(); ++i) {  // two, by symmetry: theta, t -> -theta, t + half a period
        EXPECT_EQ(found.rotation[i], found.label[i] == 1 ? -1 : 1);
        EXPECT_EQ(found.period[i], 2);
        EXPECT_NEAR(found.theta[i], backward.theta[i], 1e-6);
    }
}

TEST(Attractors, OfMembersWithoutAPeriodAreNumberedZero) {
    EXPECT_EQ(orbits_of(published({1.5}), {100, 128, 200}).label[0], 0);
}

TEST(Attractors, OfPendulumsThatAreAllDifferentAreNumbered1OrNone) {
    Strobe strobe{300, 64, 100};
    strobe.match = 1e-4;
    const auto flock = published(linspace(1.4, 1.5, 40));
    const auto found = orbits_of(flock, strobe);
    for (std::size_t i = 0; i < flock.size(); ++i) EXPECT_EQ(found.label[i], found.period[i] > 0 ? 1 : 0) << i;
    EXPECT_GT(std::ranges::count(found.label, 1), 0);
    EXPECT_GT(std::ranges::count(found.label, 0), 0);
}

TEST(MeanVelocity, OfLockedOrbitsIsAWholeMultipleOfTheDrivesFrequency) {
    for (double v : velocities_of(published({1.35, 1.45, 1.47}), {300, 40, 200})) EXPECT_NEAR(std::abs(v) / (2.0 / 3), 1, 1e-9);
    for (double v : velocities_of(published({0.9, 1.07}), {300, 40, 200})) EXPECT_NEAR(v, 0, 1e-9);
}

TEST(MeanVelocity, OverdampedTendsToTheSquareRootLaw) {
    const double torque = 1.5, periods = 2000;
    double error = 1;
    for (double beta : {4.0, 8.0, 16.0}) {
        const double expected = std::sqrt(torque * torque - 1) / beta;
        const double v = velocities_of({.beta = {beta}, .torque = {torque}}, {20, periods, 100})[0];
        const double of_one_turn = 2 * pi / (2 * pi * periods);  // which the time may cut
        EXPECT_LT(std::abs(v - expected) / expected, 0.3 * error + of_one_turn / expected);
        error = std::abs(v - expected) / expected;
    }
    EXPECT_LT(error, 0.005);
}

TEST(MeanVelocity, VanishesBelowARetrappingTorqueThatTendsTo4BetaOverPi) {
    for (double beta : {0.1, 0.05}) {
        for (double alpha : {1.0, 4.0}) {
            const double scale = 4 * beta * std::sqrt(alpha) / pi;
            const auto torques = linspace(0.95 * scale, 1.05 * scale, 41);
            const auto v = velocities_of(
                {.omega = {2.2 * std::sqrt(alpha)}, .alpha = {alpha}, .beta = {beta}, .torque = torques}, {20 / beta, 20, 100});
            std::size_t trapped = 0;
            while (trapped < v.size() && std::abs(v[trapped]) < 1e-3) ++trapped;
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
        const auto v = velocities_of({.omega = {frequency * n},
                                      .beta = {beta},
                                      .torque = torques,
                                      .drive_amplitude = {amplitude},
                                      .drive_frequency = {frequency}},
                                     {400, 400, 60});
        for (int i = 1; i < 6; ++i)
            EXPECT_NEAR(v[i], n * frequency, 1e-5) << n << ' ' << i;  // near the edges it settles slowly
        EXPECT_LT(v[0], n * frequency - 0.01);
        EXPECT_GT(v[6], n * frequency + 0.01);
    }
}

TEST(Section, IsTheSolutionAtTheDrivesPhaseZero) {
    for (double phase : {0.0, 1.0, -2.0, 100.0}) {
        Flock flock = published({0.9, 1.35});
        flock.drive_phase = {phase};
        const double period = 2 * pi / (2.0 / 3);
        double first = std::remainder(-phase / (2 * pi), 1.0);
        first = (first < 0 ? first + 1 : first) * period;
        const auto points = section_of(flock, {3, 4, 1000});
        double theta[14], omega[14], turns[14];
        const EnsembleTimes times{.first = first, .every = period, .rows = 7, .steps_to_first = 1000, .steps_per_row = 1000};
        ASSERT_TRUE(solve(flock.ensemble(), Method::rk4, 1e-15, times, {theta, omega, turns}).is_done());
        for (int i = 0; i < 8; ++i) {
            EXPECT_NEAR(points.theta[i] + 2 * pi * points.turns[i], theta[6 + i] + 2 * pi * turns[6 + i], 1e-7) << phase;
            EXPECT_NEAR(points.omega[i], omega[6 + i], 1e-7);
            EXPECT_GE(points.theta[i], -pi);
            EXPECT_LT(points.theta[i], pi);
        }
    }
}

TEST(Section, WithoutADriveIsTheClosedFormAtPeriodsOfSmallSwings) {
    const auto points = section_of({.theta = {2.5}, .alpha = {4}}, {0, 5, 2000});
    const auto solution = make_exact(4, {2.5, 0});
    for (int n = 0; n < 5; ++n) {
        const double t = n * pi;
        double theta, omega, turns;
        at(solution, 1, &t, &theta, &omega, &turns);
        EXPECT_NEAR(points.theta[n], theta, 1e-9);
        EXPECT_NEAR(points.omega[n], omega, 1e-9);
    }
}

TEST(Section, GoesOnFromAnyOfItsPointsWithTheSameBits) {
    Flock flock = published({1.5});
    const auto whole = section_of(flock, {0, 40, 150});
    flock.theta = {whole.theta[15]};
    flock.omega = {whole.omega[15]};
    const auto rest = section_of(flock, {0, 25, 150});
    EXPECT_TRUE(same_bits(rest.theta, {whole.theta.begin() + 15, whole.theta.end()}));
    EXPECT_TRUE(same_bits(rest.omega, {whole.omega.begin() + 15, whole.omega.end()}));
}

TEST(Section, StartsAtAnyPhaseBesideMembersThatStartAtZero) {
    Flock flock = published({1.2});
    flock.drive_phase = {0, 1};
    const auto both = section_of(flock, {0, 2, 100});
    flock.drive_phase = {0};
    const auto alone = section_of(flock, {0, 2, 100});
    for (int row : {0, 1}) EXPECT_EQ(both.theta[2 * row], alone.theta[row]);
}

TEST(Section, OfTaylorIsThatOfFineSteps) {
    Flock flock = published({0.9, 1.07, 1.35});
    flock.drive_phase = {1};
    const auto taylor = section_of(flock, {.transient = 20, .periods = 3, .method = Method::taylor});
    const auto rk4 = section_of(flock, {20, 3, 8000});
    for (int i = 0; i < 9; ++i) {
        EXPECT_NEAR(taylor.theta[i], rk4.theta[i], 1e-9);
        EXPECT_NEAR(taylor.omega[i], rk4.omega[i], 1e-9);
    }
}

TEST(Orbits, OfTaylorHaveThePublishedPeriodsToo) {
    const auto found = orbits_of(published({0.9, 1.07, 1.15, 1.35, 1.45, 1.47, 1.5}),
                                 {.transient = 200, .periods = 64, .method = Method::taylor});
    EXPECT_EQ(found.period, (std::vector<double>{1, 2, 0, 1, 2, 4, 0}));
}

TEST(Measures, OfTaylorHaveTheSameBitsWhateverTheNeighbours) {
    Flock flock = published(linspace(0.9, 1.5, 75));
    flock.drive_frequency = linspace(0.01, 1, 75);
    flock.pivot_amplitude.resize(75);  // shaken, driven and both side by side
    for (std::size_t i = 0; i < 75; ++i) flock.pivot_amplitude[i] = i % 3 == 1 ? 0.4 : 0;
    for (std::size_t i = 0; i < 75; ++i) flock.drive_amplitude[i] *= i % 4 != 1;
    const Strobe strobe{.transient = 1, .periods = 3, .method = Method::taylor};
    const auto exponents = exponents_of(flock, strobe, 3, {1});
    const auto again = exponents_of(flock, strobe, 3, {3});
    EXPECT_TRUE(same_bits(again.exponent, exponents.exponent) && same_bits(again.history, exponents.history));
    for (std::size_t i : {0u, 1u, 7u, 9u, 40u, 74u}) {
        Flock alone = published({flock.drive_amplitude[i]});
        alone.drive_frequency = {flock.drive_frequency[i]};
        alone.pivot_amplitude = {flock.pivot_amplitude[i]};
        EXPECT_EQ(exponents_of(alone, strobe).exponent[0], exponents.exponent[i]);
        EXPECT_EQ(section_of(alone, strobe).theta[2], section_of(flock, strobe).theta[2 * 75 + i]);
    }
}

TEST(Measures, HaveTheSameBitsOnAnyNumberOfThreads) {
    const auto flock = published(linspace(0.9, 1.5, 201));
    const Strobe strobe{5, 8, 100};
    const auto points = section_of(flock, strobe, {1});
    const auto velocities = velocities_of(flock, strobe, {1});
    const auto exponents = exponents_of(flock, strobe, 3, {1});
    for (int threads : {2, 3, 7}) {
        EXPECT_TRUE(same_bits(section_of(flock, strobe, {threads}).theta, points.theta));
        EXPECT_TRUE(same_bits(velocities_of(flock, strobe, {threads}), velocities));
        const auto again = exponents_of(flock, strobe, 3, {threads});
        EXPECT_TRUE(same_bits(again.exponent, exponents.exponent) && same_bits(again.error, exponents.error) &&
                    same_bits(again.history, exponents.history));
    }
    auto alone = published({flock.drive_amplitude[77]});
    EXPECT_EQ(exponents_of(alone, strobe).exponent[0], exponents.exponent[77]);
}

TEST(Measures, AreNaNWhereTheMotionLeavesTheDoublesAndNowhereElse) {
    Flock flock = published({0.9, 0.9, 0.9});
    flock.torque = {0, 1e308, -1e308};
    for (const auto method : {Method::rk4, Method::taylor}) {
        const Strobe strobe{2, 8, 100, method};
        const auto v = velocities_of(flock, strobe);
        const auto exponents = exponents_of(flock, strobe, 2);
        const auto found = orbits_of(flock, strobe);
        const auto points = section_of(flock, strobe);
        EXPECT_EQ(v[0], velocities_of(published({0.9}), strobe)[0]);
        EXPECT_FALSE(std::isnan(exponents.error[0]) || std::isnan(found.period[0]) || std::isnan(points.theta[0]));
        for (std::size_t i : {1u, 2u}) {
            for (double x : {v[i], exponents.exponent[i], exponents.error[i], exponents.horizon[i], exponents.history[3 + i],
                             found.period[i], found.rotation[i], found.theta[i], points.theta[i], points.omega[i]})
                EXPECT_TRUE(std::isnan(x)) << i;
            EXPECT_EQ(found.label[i], 0);
        }
    }
}

}  // namespace
