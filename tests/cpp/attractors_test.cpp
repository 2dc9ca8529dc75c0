// On which orbits pendulums end.
#include "flocks.hpp"
#include "pendula/angle.hpp"

namespace {

using namespace reference;

const std::vector<double> published_amplitudes{0.9, 1.07, 1.15, 1.35, 1.45, 1.47, 1.5};

TEST(Orbits, HaveThePublishedPeriodsAndRotationNumbers) {
    for (const auto& strobe : {by_taylor(200, 256), by_rk4(200, 256, 200)}) {
        const auto found = attractors_of(published(published_amplitudes), strobe);
        EXPECT_EQ(found["period"], (std::vector<double>{1, 2, 0, 1, 2, 4, 0}));
        for (int i : {0, 1}) EXPECT_EQ(found["rotation"][i], 0);
        for (int i : {3, 4, 5}) EXPECT_EQ(std::abs(found["rotation"][i]), 1);
        for (int i : {0, 1, 3, 4, 5}) EXPECT_EQ(found["error"][i], 0);
        for (int i : {2, 6}) EXPECT_EQ(found.kind(i), Kind::chaotic);
    }
}

TEST(Orbits, OfALateComerAreFoundWithTheirSmallestPeriod) {
    const auto found = attractors_of(published({0.9, 1.07, 1.35, 1.45, 1.47}), {.transient = 0});
    EXPECT_EQ(found["period"], (std::vector<double>{1, 2, 1, 2, 4}));
}

TEST(Orbits, AreRepresentedByTheirPointOfSmallestAngle) {
    const auto flock = published({1.47});
    const auto found = attractors_of(flock, {});
    const auto points = section_of(flock, {.transient = 400, .periods = 4});
    EXPECT_NEAR(found["theta"][0], *std::ranges::min_element(points["theta"]), 1e-6);
}

/// Two attractors, by symmetry: theta, t -> -theta, t + half a period.
Flock two_mirrored() {
    Flock flock = published({1.45});
    flock.theta.clear();
    flock.omega.clear();
    for (double theta : linspace(-3, 3, 12))
        for (double omega : linspace(-2.5, 2.5, 12)) {
            flock.theta.push_back(theta);
            flock.omega.push_back(omega);
        }
    return flock;
}

TEST(Attractors, AreNumberedTheSameHoweverMembersAreOrdered) {
    Flock flock = two_mirrored();
    const auto found = attractors_of(flock, {});
    std::ranges::reverse(flock.theta);
    std::ranges::reverse(flock.omega);
    auto backward = attractors_of(flock, {});
    for (auto& column : backward.columns) std::ranges::reverse(column);
    EXPECT_EQ(found["label"], backward["label"]);
    for (std::size_t i = 0; i < flock.size(); ++i) {
        EXPECT_TRUE(found["label"][i] == 1 || found["label"][i] == 2) << i;
        EXPECT_EQ(found["rotation"][i], found["label"][i] == 1 ? -1 : 1);
        EXPECT_EQ(found["period"][i], 2);
        EXPECT_NEAR(found["theta"][i], backward["theta"][i], 1e-6);
    }
}

TEST(Attractors, OfMembersWithoutAPeriodAreNumberedZero) {
    EXPECT_EQ(attractors_of(published({1.5}), by_taylor(100, 128))["label"][0], 0);
}

TEST(Attractors, OfPendulumsThatAreAllDifferentAreNumbered1OrNone) {
    const auto flock = published(linspace(1.4, 1.5, 40));
    const auto found = attractors_of(flock, by_taylor(300, 64));
    for (std::size_t i = 0; i < flock.size(); ++i) EXPECT_EQ(found["label"][i], found["period"][i] > 0 ? 1 : 0) << i;
    EXPECT_GT(std::ranges::count(found["label"], 1), 0);
    EXPECT_GT(std::ranges::count(found["label"], 0), 0);
}

}  // namespace
