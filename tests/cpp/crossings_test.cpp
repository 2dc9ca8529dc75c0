// Crossings found on the steps of Taylor's method: against the closed form, and where they are easily missed or doubled.
#include "pendula/crossings.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "pendula/angle.hpp"
#include "pendula/exact.hpp"
#include "reference_table.hpp"

namespace {

using namespace pendula;

std::vector<Crossing> all_crossings(const Pendulum& p, State initial, Crossed crossed, double until, double budget = 0x1p53) {
    auto search = make_crossings(p, initial, crossed);
    std::vector<Crossing> found;
    Crossing crossing;
    for (int calls = 0; calls < 100000; ++calls) {
        if (next_crossing(search, until, crossing, budget))
            found.push_back(crossing);
        else if (reaches(search.run, until))
            break;
    }
    return found;
}

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

TEST(Crossings, AreThoseThatDenseRowsSee) {
    for (Crossed crossed : {Crossed::theta, Crossed::omega}) {
        const Pendulum p{.beta = 0.25, .drive_amplitude = 1.5, .drive_frequency = 2.0 / 3, .drive_phase = 0.5};
        const auto found = all_crossings(p, {1, 0}, crossed, 500);
        auto run = make_taylor(p, {1, 0});
        std::size_t next = 0;
        Sample before{0, 1, 0, 0};
        for (double t = 0.001; t < 499; t += 0.001) {
            while (!reaches(run, t)) step(run);
            const auto s = at(run, t);
            const auto side = [&](const Sample& x) {
                return crossed == Crossed::theta ? 2 * x.turns + (x.theta > 0 ? 1 : -1) : x.omega > 0 ? 1 : -1;
            };
            if (before.omega != 0 && side(s) != side(before)) {
                ASSERT_LT(next, found.size());
                EXPECT_GT(found[next].sample.t, t - 0.0011);
                EXPECT_LT(found[next].sample.t, t + 1e-9);
                EXPECT_EQ(found[next++].is_rising, side(s) > side(before));
            }
            before = s;
        }
        EXPECT_GT(next, 50u);
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

double period_of(const Pendulum& p, State initial, double until) {
    double period = 0;
    EXPECT_TRUE(measured_period(p, initial, until, 1e-15, period).is_done());
    return period;
}

TEST(MeasuredPeriod, IsThatOfTheClosedForm) {
    for (State initial : {State{1e-6, 0}, {1, 0}, {2, 1}, {3.1, 0}, {0, 2.1}, {1, -5}}) {
        const double tau = analyze(1, initial).tau;
        EXPECT_NEAR(period_of({}, initial, 50 * tau), tau, 1e-14 * tau / std::fmin(1, std::fabs(energy(1, initial) - 2)));
    }
}

TEST(MeasuredPeriod, OfALockedOrbitIsTheDrives) {
    const Pendulum p{.beta = 0.5, .drive_amplitude = 0.9, .drive_frequency = 2.0 / 3};
    auto run = make_taylor(p, {0.2, 0});
    const double period = 2 * pi / p.drive_frequency;
    while (!reaches(run, 40 * period)) step(run);
    const auto s = at(run, 40 * period);
    EXPECT_NEAR(period_of(p, {s.theta, s.omega}, 20 * period), period, 1e-13);
}

TEST(MeasuredPeriod, OfTooFewCrossingsIsNan) {
    EXPECT_TRUE(std::isnan(period_of({}, {1, 0}, 3)));
    EXPECT_TRUE(std::isnan(period_of({}, {0, 0}, 1000)));
}

}  // namespace
