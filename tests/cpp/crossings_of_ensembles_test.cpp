// Crossings of ensembles against those of their members alone, and the periods that they measure.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "all_crossings.hpp"
#include "pendula/analysis.hpp"
#include "pendula/angle.hpp"

namespace {

using namespace pendula;
using reference::all_crossings;

/// Members of every kind: free, driven, at rest on top, and one whose motion leaves the doubles.
struct Members {
    std::vector<double> theta, omega, torque, at, until;
    Ensemble ensemble() const {
        return {.size = theta.size(), .theta = theta, .omega = omega, .beta = 0.1, .torque = torque, .drive_amplitude = 0.0};
    }
};

Members members() {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> any(-3, 3);
    Members m;
    for (int i = 0; i < 150; ++i) {
        m.theta.push_back(i == 10 ? pi : any(random));
        m.omega.push_back(i == 10 ? 0 : any(random));
        m.torque.push_back(i == 10 ? 0 : i == 20 ? 1e308 : 0.5 * any(random));
        m.at.push_back(any(random));
        m.until.push_back(20 + 6 * any(random));
    }
    return m;
}

TEST(CrossingsOfEnsembles, AreThoseOfTheirMembersWithAnyNumberOfThreads) {
    const Members m = members();
    const Ensemble e = m.ensemble();
    for (int threads : {1, 3}) {
        std::vector<std::vector<Crossing>> found(e.size);
        const auto receive = [&found](std::size_t member, const Crossing& crossing) {
            found[member].push_back(crossing);
            return true;
        };
        ASSERT_TRUE(find_crossings(e, {.at = m.at, .until = m.until}, 1e-15, receive, {.threads = threads}).is_done());
        for (std::size_t i = 0; i < e.size; ++i) {
            const auto alone = all_crossings(pendulum_of(e, i), initial_state_of(e, i), {Crossed::theta, m.at[i]}, m.until[i]);
            if (i == 20) {
                ASSERT_FALSE(found[i].empty());
                EXPECT_TRUE(std::isnan(found[i].back().sample.t));
                continue;
            }
            ASSERT_EQ(found[i].size(), alone.size()) << i;
            for (std::size_t j = 0; j < alone.size(); ++j) {
                EXPECT_EQ(found[i][j].sample.t, alone[j].sample.t);
                EXPECT_EQ(found[i][j].is_rising, alone[j].is_rising);
            }
        }
    }
}

TEST(CrossingsOfEnsembles, EndWhereTheReceiverOrTheCallerEndsThem) {
    const Members m = members();
    const auto full = [](std::size_t, const Crossing&) { return false; };
    const auto more = [](std::size_t, const Crossing&) { return true; };
    EXPECT_EQ(find_crossings(m.ensemble(), {.until = 50.0}, 1e-15, full).kind, Outcome::Kind::stopped);
    EXPECT_EQ(find_crossings(m.ensemble(), {.until = 1e12}, 1e-15, more, {.proceed = [](double) { return false; }}).kind,
              Outcome::Kind::stopped);
}

TEST(CrossingsOfEnsembles, AreRefusedWithTheirArgument) {
    const Members m = members();
    const Ensemble e = m.ensemble();
    const auto more = [](std::size_t, const Crossing&) { return true; };
    const auto refused = [&](const EnsembleLevels& levels, double tolerance) {
        return std::string(find_crossings(e, levels, tolerance, more).refusal.name);
    };
    EXPECT_EQ(refused({.crossed = static_cast<Crossed>(2)}, 1e-15), "crossed");
    EXPECT_EQ(refused({.direction = static_cast<Direction>(3)}, 1e-15), "direction");
    EXPECT_EQ(refused({.at = std::nan("")}, 1e-15), "at");
    EXPECT_EQ(refused({.until = -1.0}, 1e-15), "until");
    EXPECT_EQ(refused({}, 1), "tolerance");
    const std::vector<double> two{1, 2};
    EXPECT_EQ(refused({.at = two}, 1e-15), "at");
    EXPECT_EQ(refused({.until = two}, 1e-15), "until");
    std::vector<double> periods(e.size - 1);
    EXPECT_EQ(measured_period(e, 10.0, 1e-15, periods).refusal.name, std::string("periods"));
    EXPECT_EQ(measured_period(e, two, 1e-15, periods).refusal.name, std::string("until"));
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

TEST(MeasuredPeriod, OfAnEnsembleIsThatOfItsMembers) {
    const Members m = members();
    const Ensemble e = m.ensemble();
    std::vector<double> periods(e.size);
    ASSERT_TRUE(measured_period(e, m.until, 1e-15, periods, {.threads = 2}).is_done());
    int numbers = 0;
    for (std::size_t i = 0; i < e.size; ++i) {
        const double alone = period_of(pendulum_of(e, i), initial_state_of(e, i), m.until[i]);
        EXPECT_TRUE(periods[i] == alone || (std::isnan(periods[i]) && std::isnan(alone))) << i;
        numbers += alone == alone;
    }
    EXPECT_GT(numbers, 50);
    EXPECT_TRUE(std::isnan(periods[10]) && std::isnan(periods[20]));
}

}  // namespace
