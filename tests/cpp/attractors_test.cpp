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

/// Starts on a grid of [-pi, pi] x [-4, 4].
Flock grid(std::size_t n) {
    Flock flock{.theta = {}, .omega = {}};
    for (double theta : linspace(-pi, pi, n))
        for (double omega : linspace(-4, 4, n)) {
            flock.theta.push_back(theta);
            flock.omega.push_back(omega);
        }
    return flock;
}

Flock two_of_period_3(std::size_t n) {
    Flock flock = grid(n);
    flock.beta = {0.2};
    flock.drive_amplitude = {1.3636363636363635};
    flock.drive_frequency = {0.5};
    return flock;
}

TEST(Attractors, OfPeriod3AttractHalfOfTheStartsEach) {
    const auto flock = two_of_period_3(16);
    const auto found = attractors_of(flock, {});
    const auto share = [&](double label) {
        return static_cast<double>(std::ranges::count(found["label"], label)) / static_cast<double>(flock.size());
    };
    for (double label : {1, 2}) {
        EXPECT_GT(share(label), 0.35);  // 1/2 by symmetry
        EXPECT_LT(share(label), 0.65);
    }
    EXPECT_EQ(share(1) + share(2), 1);
    for (std::size_t i = 0; i < flock.size(); ++i) {
        EXPECT_EQ(found.kind(i), Kind::periodic) << i;
        EXPECT_EQ(found["period"][i], 3) << i;
    }
}

/// The points that stand for the labels of a table, by label; those of members on one attractor are the same.
std::vector<State> points_of(const Table& found) {
    std::vector<State> points;
    for (double label = 1;; ++label) {
        const auto first = std::ranges::find(found["label"], label);
        if (first == found["label"].end()) return points;
        points.push_back({found["theta"][static_cast<std::size_t>(first - found["label"].begin())],
                          found["omega"][static_cast<std::size_t>(first - found["label"].begin())]});
        for (std::size_t i = 0; i < found["label"].size(); ++i) {
            if (found["label"][i] != label) continue;
            EXPECT_EQ(found["theta"][i], points.back().theta);
            EXPECT_EQ(found["omega"][i], points.back().omega);
        }
    }
}

TEST(Attractors, HaveTheSameNumbersForAnyTransientMethodAndNumberOfMembers) {
    const auto expected = points_of(attractors_of(two_of_period_3(4), {}));
    ASSERT_EQ(expected.size(), 2u);
    for (const auto& strobe :
         {Strobe{.transient = 0}, Strobe{.transient = 1000}, Strobe{.steps_per_period = 500, .method = Method::rk4}})
        for (std::size_t n : {3u, 4u}) {
            const auto points = points_of(attractors_of(two_of_period_3(n), strobe));
            ASSERT_EQ(points.size(), 2u);
            for (int i : {0, 1}) {
                EXPECT_NEAR(points[i].theta, expected[i].theta, 1e-5);  // of 500 steps
                EXPECT_NEAR(points[i].omega, expected[i].omega, 1e-5);
            }
        }
}

TEST(Attractors, OfWeakFrictionAreNotToldApartByWhatIsLeftOfTheirTransients) {
    Flock flock{.theta = {0.1, 1, 3, 3.1}, .beta = {0.02}};
    for (const auto& strobe : {Strobe{}, Strobe{.transient = 0}, Strobe{.transient = 1000}}) {
        flock.drive_amplitude = flock.drive_frequency = {0};
        const auto resting = attractors_of(flock, strobe);
        flock.drive_amplitude = {0.05};
        flock.drive_frequency = {1.5};
        const auto driven = attractors_of(flock, strobe);
        EXPECT_EQ(resting["label"], (std::vector<double>{1, 1, 1, 1}));
        EXPECT_EQ(driven["label"], (std::vector<double>{1, 1, 1, 1}));
        EXPECT_EQ(driven["period"], (std::vector<double>{1, 1, 1, 1}));
        for (std::size_t i = 0; i < 4; ++i) {
            EXPECT_EQ(resting.kind(i), Kind::fixed_point) << i;
            EXPECT_EQ(driven.kind(i), Kind::periodic) << i;
        }
    }
}

TEST(Attractors, OfATorqueWithoutADriveAreRestAndALimitCycle) {
    const auto found = attractors_of({.omega = {0, 0.5, 3, -3, 5, 8}, .beta = {0.1}, .torque = {0.5}}, {});
    EXPECT_EQ(found["label"], (std::vector<double>{2, 2, 1, 2, 1, 1}));  // the period of the cycle is below 1
    for (std::size_t i : {0u, 1u, 3u}) {
        EXPECT_EQ(found.kind(i), Kind::fixed_point);
        EXPECT_NEAR(found["theta"][i], pi / 6, 1e-15);
        EXPECT_EQ(found["omega"][i], 0);
    }
    for (std::size_t i : {2u, 4u, 5u}) {
        EXPECT_EQ(found.kind(i), Kind::rotating);
        EXPECT_EQ(found["theta"][i], 0);
        EXPECT_NEAR(found["omega"][i], 5.1980007431796716573, 1e-12);  // by mpmath, as in undriven_test.cpp
        EXPECT_NEAR(found["period"][i], 1.2576442858204133208 / (2 * pi), 1e-13);
        EXPECT_NEAR(found["rotation"][i], 4.9959955911387178478, found["error"][i] + 2e-15);
    }
}

}  // namespace
