// Crossings found on the steps of Taylor's method: against the closed form, and where they are easily missed or doubled.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "all_crossings.hpp"
#include "pendula/angle.hpp"
#include "pendula/exact.hpp"
#include "reference_table.hpp"

namespace {

using namespace pendula;

using reference::all_crossings;

TEST(Crossings, OfAnOscillationComeEachHalfPeriod) {
    for (double amplitude : {1e-9, 0.5, 2.0, 3.1, 3.141592}) {
        const double tau = analyze(1, {amplitude, 0}).tau;
        const auto bottom = all_crossings({}, {amplitude, 0}, Crossed::theta, 20.1 * tau);
        const auto turning = all_crossings({}, {amplitude, 0}, Crossed::omega, 20.1 * tau);
        ASSERT_EQ(bottom.size(), 40u) << amplitude;
        ASSERT_EQ(turning.size(), 40u) << amplitude;
        // Rounding moves the energy, and with it every half period that follows: by 1/kappa', the distance from the top
        // squared.
        const double slack = 4e-15 / (pi - amplitude) / (pi - amplitude) + 1e-14;
        for (std::size_t i = 0; i < 40; ++i) {
            const double n = static_cast<double>(i);
            EXPECT_NEAR(bottom[i].sample.t, (0.25 + 0.5 * n) * tau, slack * (n + 1)) << amplitude;
            EXPECT_EQ(bottom[i].is_rising, i % 2 == 1);
            EXPECT_NEAR(turning[i].sample.t, (0.5 + 0.5 * n) * tau, slack * (n + 1)) << amplitude;
            EXPECT_EQ(turning[i].is_rising, i % 2 == 0);
            EXPECT_LE(std::fabs(bottom[i].sample.theta), 1e-15 * amplitude);
        }
    }
}

TEST(Crossings, OfARotationComeEachTurn) {
    for (double omega : {2.01, -3.0, 40.0, 1e5}) {
        const double tau = analyze(1, {1, omega}).tau;
        const auto found = all_crossings({}, {1, omega}, Crossed::theta, 1000.5 * tau);
        ASSERT_NEAR(static_cast<double>(found.size()), 1000, 1) << omega;
        for (std::size_t i = 0; i < found.size(); ++i) {
            EXPECT_EQ(found[i].is_rising, omega > 0);
            EXPECT_NEAR(found[i].sample.t - found[0].sample.t, static_cast<double>(i) * tau,
                        1e-12 * tau * (1 + static_cast<double>(i)));
        }
        EXPECT_TRUE(all_crossings({}, {1, omega}, Crossed::omega, 100 * tau).empty());
    }
}

TEST(Crossings, DoNotDependOnHowTheSearchIsCutUp) {
    const Pendulum p{.beta = 0.1, .torque = 0.05, .drive_amplitude = 1, .drive_frequency = 0.7};
    const auto whole = all_crossings(p, {-1, 2}, Crossed::theta, 300);
    const auto parts = all_crossings(p, {-1, 2}, Crossed::theta, 300, 1);
    ASSERT_GT(whole.size(), 50u);
    ASSERT_EQ(parts.size(), whole.size());
    for (std::size_t i = 0; i < whole.size(); ++i) EXPECT_EQ(parts[i].sample.t, whole[i].sample.t);
    auto search = make_crossings(p, {-1, 2}, Crossed::theta);
    std::size_t count = 0;
    Crossing crossing;
    for (int i = 0; i <= 3000; ++i)
        while (next_crossing(search, 0.1 * i, crossing)) {
            EXPECT_LE(crossing.sample.t, 0.1 * i);
            EXPECT_EQ(crossing.sample.t, whole[count++].sample.t);
        }
    EXPECT_EQ(count, whole.size());
}

/// On which side of a level of omega, or between which levels of theta, a row is.
double side_of(const Sample& x, const Level& level) {
    if (level.crossed == Crossed::omega) return x.omega > level.at ? 1 : 0;
    return std::floor((unwrapped(x) - level.at) / (2 * pi));
}

TEST(Crossings, AreThoseThatDenseRowsSee) {
    const Level levels[] = {Crossed::theta,         {Crossed::theta, 0.7},  {Crossed::theta, pi}, {Crossed::theta, -9},
                            {Crossed::theta, 3.14}, {Crossed::omega, 0},    {Crossed::omega, 1},  {Crossed::omega, -1.7},
                            {Crossed::theta, -3.1}, {Crossed::omega, 1e-9}, {Crossed::omega, 2}};
    const Pendulum p{.beta = 0.25, .drive_amplitude = 1.5, .drive_frequency = 2.0 / 3, .drive_phase = 0.5};
    for (const Level& level : levels) {
        const auto found = all_crossings(p, {1, 0}, level, 500);
        auto run = make_taylor(p, {1, 0});
        std::size_t next = 0;
        auto before = at(run, 1e-3);
        if (!found.empty() && found[0].sample.t < 1e-3) ++next;
        for (double t = 0.002; t < 499; t += 0.001) {
            while (!reaches(run, t)) step(run);
            const auto s = at(run, t);
            const double side = side_of(s, level), side_before = side_of(before, level);
            if (side != side_before) {
                ASSERT_LT(next, found.size());
                EXPECT_GT(found[next].sample.t, t - 0.0011);
                EXPECT_LT(found[next].sample.t, t + 1e-9);
                EXPECT_EQ(found[next++].is_rising, side > side_before);
            }
            before = s;
        }
        EXPECT_GT(next, 25u) << level.at;
        EXPECT_GE(next + 2, found.size()) << level.at;  // the last second, and two that are closer than the rows
    }
}

/// The time from the bottom to an angle of an oscillation: Legendre's elliptic integral.
double time_from_bottom(double amplitude, double theta) {
    const double k = std::sin(amplitude / 2);
    return std::ellint_1(k, std::asin(std::sin(theta / 2) / k));
}

// Errors of 1e-15 in theta or omega, over the rate of change there, and the growth of an error in the energy over three
// periods.
TEST(Crossings, OfAnyAngleComeAtTheTimesOfTheEllipticIntegral) {
    for (double amplitude : {0.5, 2.0, 3.0})
        for (double part : {-0.999, -0.5, -1e-9, 0.3, 0.9}) {
            const double level = part * amplitude, tau = 4 * time_from_bottom(amplitude, amplitude);
            const double from_bottom = time_from_bottom(amplitude, level);
            const auto found = all_crossings({}, {amplitude, 0}, {Crossed::theta, level}, 3 * tau);
            ASSERT_EQ(found.size(), 6u) << amplitude << ' ' << level;
            for (std::size_t i = 0; i < 6; ++i) {
                const double start = static_cast<double>(i / 2) * tau;
                const double want = i % 2 == 0 ? start + tau / 4 - from_bottom : start + 3 * tau / 4 + from_bottom;
                EXPECT_NEAR(found[i].sample.t, want, 1e-13 / std::sqrt(1 - part * part)) << amplitude << ' ' << level;
                EXPECT_EQ(found[i].is_rising, i % 2 == 1);
                EXPECT_NEAR(found[i].sample.theta, level, 4.5e-16);
            }
        }
}

TEST(Crossings, OfAnyVelocityComeAtTheTimesOfTheEllipticIntegral) {
    const double amplitude = 2, k = std::sin(1.0), tau = 4 * time_from_bottom(amplitude, amplitude);
    for (double level : {-1.6, -0.4, 0.05, 0.9, 1.68}) {
        const double theta = 2 * std::asin(std::sqrt(k * k - level * level / 4));  // energy: omega^2/4 + sin^2(theta/2) = k^2
        const double late = time_from_bottom(amplitude, theta);
        const double middle = level < 0 ? tau / 4 : 3 * tau / 4;  // at the bottom
        const auto found = all_crossings({}, {amplitude, 0}, {Crossed::omega, level}, 0.999 * tau);
        ASSERT_EQ(found.size(), 2u) << level;
        EXPECT_NEAR(found[0].sample.t, middle - late, 1e-13) << level;
        EXPECT_NEAR(found[1].sample.t, middle + late, 1e-13) << level;
        EXPECT_EQ(found[0].is_rising, level > 0);
        EXPECT_EQ(found[1].is_rising, level < 0);
        EXPECT_NEAR(found[0].sample.omega, level, 4.5e-16);
    }
}

TEST(Crossings, OfTheTopComeHalfATurnAfterTheBottom) {
    for (double omega : {2.01, -3.0, 40.0}) {
        const double tau = analyze(1, {0, omega}).tau;
        for (double top : {pi, -pi, 3 * pi}) {
            const auto found = all_crossings({}, {0, omega}, {Crossed::theta, top}, 100 * tau);
            ASSERT_EQ(found.size(), 100u) << omega;
            for (std::size_t i = 0; i < 100; ++i) {
                EXPECT_NEAR(found[i].sample.t, (0.5 + static_cast<double>(i)) * tau,
                            1e-13 * tau * (1 + static_cast<double>(i)) / std::fmin(1, std::fabs(energy(1, {0, omega}) - 2)));
                EXPECT_EQ(found[i].is_rising, omega > 0);
                EXPECT_NEAR(std::fabs(found[i].sample.theta), pi, 1e-15 * std::fmax(1, std::fabs(omega)));
            }
        }
    }
}

TEST(Crossings, OfAnAngleAreThoseOfTheAngleWithoutItsTurns) {
    const Pendulum p{.beta = 0.1, .torque = 0.3, .drive_amplitude = 1, .drive_frequency = 0.7};
    for (double theta : {-2.5, 0.0, 1.0}) {
        const auto near = all_crossings(p, {0.5, 1}, {Crossed::theta, theta}, 100);
        const auto far = all_crossings(p, {0.5, 1}, {Crossed::theta, theta + 2 * pi * 1000}, 100);
        ASSERT_GT(near.size(), 10u);
        ASSERT_EQ(far.size(), near.size());
        for (std::size_t i = 0; i < near.size(); ++i)  // the far angle is a double within 5e-13 of the other
            EXPECT_NEAR(far[i].sample.t, near[i].sample.t, 1e-12 / std::fmin(1, std::fabs(near[i].sample.omega)));
    }
}

TEST(Crossings, FarFromTheBottomAreThoseOfTheAngleWithoutItsTurns) {
    for (double theta : {1e9, -3e15, 2.8e16}) {  // up to 2^52 turns
        const double start = wrap(theta);
        const auto near = all_crossings({}, {start, 2.5}, {Crossed::theta, 0.5}, 50);
        const auto far = all_crossings({}, {theta, 2.5}, {Crossed::theta, 0.5}, 50);
        ASSERT_GT(near.size(), 5u);
        ASSERT_EQ(far.size(), near.size()) << theta;
        for (std::size_t i = 0; i < near.size(); ++i) EXPECT_EQ(far[i].sample.t, near[i].sample.t);
    }
}

TEST(Crossings, InOneDirectionAreThoseOfBothWithoutTheOthers) {
    const Pendulum p{.beta = 0.1, .torque = 0.05, .drive_amplitude = 1, .drive_frequency = 0.7};
    for (Crossed crossed : {Crossed::theta, Crossed::omega}) {
        const auto both = all_crossings(p, {-1, 2}, {crossed, 0.4}, 200);
        const auto rising = all_crossings(p, {-1, 2}, {crossed, 0.4, Direction::rising}, 200);
        const auto falling = all_crossings(p, {-1, 2}, {crossed, 0.4, Direction::falling}, 200);
        ASSERT_EQ(rising.size() + falling.size(), both.size());
        ASSERT_GT(falling.size(), 10u);
        std::size_t up = 0, down = 0;
        for (const auto& crossing : both) {
            const auto& same = crossing.is_rising ? rising[up++] : falling[down++];
            EXPECT_EQ(same.sample.t, crossing.sample.t);
            EXPECT_EQ(same.is_rising, crossing.is_rising);
        }
    }
}

TEST(Crossings, OfAPendulumThatRestsOnTopAreNone) {
    const Pendulum shaken{.beta = 0.2, .pivot_amplitude = 1, .drive_frequency = 2};
    for (double top : {pi, -pi, 3 * pi, to_radians(540)})
        for (const Level& level : {Level(Crossed::theta), Level(Crossed::theta, 3), Level(Crossed::omega)}) {
            EXPECT_TRUE(all_crossings({}, {top, 0}, level, 1e4).empty());
            EXPECT_TRUE(all_crossings(shaken, {top, 0}, level, 1e4).empty());
        }
}

TEST(Crossings, AStartUponALevelIsNone) {
    const double tau = analyze(1, {0, 1}).tau;
    const auto found = all_crossings({}, {0, 1}, Crossed::theta, 1.25 * tau);
    ASSERT_EQ(found.size(), 2u);
    EXPECT_NEAR(found[0].sample.t, 0.5 * tau, 1e-14);
    EXPECT_FALSE(found[0].is_rising);
    const auto turned = all_crossings({}, {0, 6}, Crossed::theta, 2);
    ASSERT_EQ(turned.size(), 1u);
    EXPECT_NEAR(turned[0].sample.t, analyze(1, {0, 6}).tau, 1e-14);
    EXPECT_EQ(turned[0].sample.turns, 1);
    EXPECT_TRUE(all_crossings({}, {0, 0}, Crossed::theta, 100).empty());
    const auto fast = all_crossings({}, {0, 1e5}, Crossed::theta, 10.5 * 2 * pi / 1e5);  // more than a turn in a step
    ASSERT_EQ(fast.size(), 10u);
    EXPECT_NEAR(fast[0].sample.t, 2 * pi / 1e5, 1e-14);
    for (double theta : {1.0, 7.0, -100.0})
        EXPECT_EQ(all_crossings({}, {theta, 0.1}, {Crossed::theta, theta}, analyze(1, {theta, 0.1}).tau * 0.99).size(), 1u);
}

TEST(Crossings, OfAGrazedLevelAreTwoOrNone) {
    // Of a driven pendulum whose initial speed is halved in, to neighbouring doubles, on one at which omega grazes 0.
    const Pendulum p{.beta = 0.1, .drive_amplitude = 1.2, .drive_frequency = 2};
    const auto found = [&](double omega) { return all_crossings(p, {0.5, omega}, Crossed::omega, 30); };
    int grazed = 0;
    for (double omega = 0; omega < 4; omega += 0.02) {
        double low = omega, high = omega + 0.02;
        const auto count = found(low).size();
        if (found(high).size() != count + 2) continue;
        for (int i = 0; i < 60; ++i) {
            const double middle = 0.5 * (low + high);
            (found(middle).size() == count ? low : high) = middle;
        }
        const auto with = found(high), without = found(low);
        ASSERT_EQ(without.size(), count);
        ASSERT_EQ(with.size(), count + 2);
        double closest = HUGE_VAL;
        for (std::size_t i = 1; i < with.size(); ++i) {
            EXPECT_NE(with[i].is_rising, with[i - 1].is_rising);
            closest = std::fmin(closest, with[i].sample.t - with[i - 1].sample.t);
        }
        // omega departs from its least value by some 1e-16 in 1e-8.
        EXPECT_LE(closest, 1e-6);
        EXPECT_GT(closest, 0);
        ++grazed;
    }
    EXPECT_GE(grazed, 2);
}

TEST(Crossings, OfAParabolaThatTouches) {
    // alpha is so small that nothing is left but the drive: omega = 1 + least + sin(t), six times least by t = 40.
    const auto count = [](double least) {
        return all_crossings({.alpha = 1e-30, .drive_amplitude = 1, .drive_frequency = 1}, {0.1, 1 + least}, Crossed::omega, 40)
            .size();
    };
    EXPECT_EQ(count(1e-3), 0u);
    EXPECT_EQ(count(1e-9), 0u);
    EXPECT_EQ(count(1e-14), 0u);
    EXPECT_EQ(count(-1e-3), 12u);
    EXPECT_EQ(count(-1e-9), 12u);
    EXPECT_EQ(count(-1e-14), 12u);
    EXPECT_EQ(count(0) % 2, 0u);
}

TEST(Crossings, AtEndsOfStepsAreFoundOnce) {
    // Starts shifted in phase so that crossings wander through ends of steps.
    const auto solution = make_exact(1, {1, 0});
    const double tau = solution.analysis.tau;
    for (int i = 0; i < 2000; ++i) {
        const auto start = at(solution, tau * i / 2000);
        const auto found = all_crossings({}, {start.theta, start.omega}, Crossed::theta, 3 * tau);
        ASSERT_NEAR(static_cast<double>(found.size()), 6, start.theta == 0 || std::fabs(start.theta) < 1e-14 ? 1 : 0) << i;
    }
}

TEST(Crossings, OfWhatIsNotFiniteAreNone) {
    EXPECT_TRUE(all_crossings({}, {std::nan(""), 0}, Crossed::theta, 10).empty());
    EXPECT_TRUE(all_crossings({}, {0, HUGE_VAL}, Crossed::omega, 10).empty());
}

TEST(Crossings, OfAnIllegalLevelAreNone) {
    EXPECT_TRUE(all_crossings({}, {1, 0}, {Crossed::theta, std::nan("")}, 10).empty());
    EXPECT_TRUE(all_crossings({}, {1, 0}, {Crossed::omega, HUGE_VAL}, 10).empty());
    EXPECT_TRUE(all_crossings({}, {1, 0}, static_cast<Crossed>(2), 10).empty());
    EXPECT_TRUE(all_crossings({}, {1, 0}, {Crossed::theta, 0, static_cast<Direction>(3)}, 10).empty());
}

}  // namespace
