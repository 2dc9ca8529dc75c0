// Rows, steps, and the stream of rows.
#include <gtest/gtest.h>

#include <cstring>
#include <random>
#include <vector>

#include "pendula/angle.hpp"
#include "pendula/pendula.hpp"
#include "trajectories.hpp"

namespace {

using namespace pendula;
using reference::all_rows;
using reference::stepwise;

constexpr Method methods[] = {Method::rk4, Method::euler, Method::verlet, Method::exact};

TEST(Schedule, CountsRowsWithASlackOf1em9) {
    EXPECT_EQ(make_schedule({0.1, 1, 3}).rows, 4);
    EXPECT_EQ(make_schedule({0.1, 1, 3 * (1 - 1e-10)}).rows, 4);
    EXPECT_EQ(make_schedule({0.1, 1, 3 * (1 - 1e-8)}).rows, 3);
    EXPECT_EQ(make_schedule({0.1, 1, 0.5}).rows, 1);
    EXPECT_EQ(make_schedule({0.1, 0.02 * 7.3, 7.3}).rows, 51);
}

TEST(Schedule, CountsStepsWithASlackOf1em9) {
    EXPECT_EQ(make_schedule({0.1, 1, 3}).steps_per_row, 10);
    EXPECT_EQ(make_schedule({0.1 * (1 - 1e-10), 1, 3}).steps_per_row, 10);
    EXPECT_EQ(make_schedule({0.1 * (1 - 1e-8), 1, 3}).steps_per_row, 11);
    EXPECT_EQ(make_schedule({5, 1, 3}).steps_per_row, 1);
}

TEST(Schedule, NeverStraddlesARowNorExceedsDt) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> exponent(-6, 6);
    for (int i = 0; i < 20000; ++i) {
        const Times times{std::pow(10, exponent(random)), std::pow(10, exponent(random)), std::pow(10, exponent(random))};
        const auto s = make_schedule(times);
        EXPECT_EQ(s.every, times.every);
        EXPECT_EQ(s.steps_per_row, std::floor(s.steps_per_row));
        EXPECT_LE(s.every / s.steps_per_row, times.dt * (1 + 1.1e-9));
        EXPECT_GT(s.every, (s.steps_per_row - 1) * times.dt);  // no more steps than needed
        EXPECT_LE((s.rows - 1) * s.every, times.until * (1 + 1.1e-9));
        EXPECT_GT(s.rows * s.every, times.until * (1 - 1e-15));
    }
}

TEST(Schedule, TellsWhatIsTooLong) {
    using enum Refusal::Reason;
    const auto reason = [](Times times) { return check({.schedule = make_schedule(times)}).reason; };
    EXPECT_EQ(reason({1, 1, 0x1p52}), none);
    EXPECT_EQ(reason({1, 1, 0x1p54}), too_many_rows);
    EXPECT_EQ(reason({0x1p-54, 1, 1}), too_many_steps);
    EXPECT_EQ(reason({1e-200, 1e200, 1e300}), too_many_rows);
    EXPECT_EQ(make_schedule({0.25, 1, 3}).steps(), 12);
}

Problem problem(Method method, double alpha, State initial, Times times) {
    Problem p;
    p.pendulum.alpha = alpha;
    p.initial = initial;
    p.method = method;
    p.schedule = make_schedule(times);
    return p;
}

TEST(Advance, GivesRowsAtProductsOfTheInterval) {
    for (Method method : methods) {
        const auto rows = all_rows(problem(method, 1, {1, 0}, {0.003, 0.1, 50}));
        ASSERT_EQ(rows.size(), 501u);
        for (std::size_t j = 0; j < rows.size(); ++j) EXPECT_EQ(rows[j].t, static_cast<double>(j) * 0.1);
    }
}

TEST(Advance, GivesTheSameBitsForAnyBlockAndBudget) {
    for (Method method : methods)
        for (State initial : {State{1, 0.2}, State{0, 2.5}, State{-3, -1}, State{0, 2}, State{40, 3}}) {
            const auto p = problem(method, 1.7, initial, {0.013, 0.1, 20});
            const auto want = all_rows(p);
            ASSERT_EQ(want.size(), 201u);
            for (std::size_t block : {1, 2, 7, 100})
                for (double budget : {1.0, 3.0, 17.0, 1e9}) {
                    const auto got = all_rows(p, block, budget);
                    ASSERT_EQ(got.size(), want.size()) << block << ' ' << budget;
                    EXPECT_EQ(std::memcmp(got.data(), want.data(), want.size() * sizeof want[0]), 0) << block << ' ' << budget;
                }
        }
}

TEST(Solve, GivesTheRowsOfAdvance) {
    for (Method method : {Method::rk4, Method::euler, Method::verlet, Method::taylor, Method::exact}) {
        const auto p = problem(method, 1.7, {1, 0.2}, {0.013, 0.1, 20});
        const auto want = all_rows(p), got = solve(p);
        ASSERT_EQ(got.size(), want.size());
        EXPECT_EQ(std::memcmp(got.data(), want.data(), want.size() * sizeof want[0]), 0) << static_cast<int>(method);
    }
}

TEST(Names, LeaveThoseOfVariablesFree) {
    const auto exact = make_exact(1, {1, 0});
    auto taylor = make_taylor({}, {1, 0});
    auto crossings = make_crossings({}, {1, 0}, Crossed::theta);
    const auto schedule = make_schedule({0.1, 1, 10});
    while (!reaches(taylor, 5)) step(taylor);
    EXPECT_NEAR(at(taylor, 5).theta, at(exact, 5).theta, 1e-13);
    Crossing crossing;
    EXPECT_TRUE(next_crossing(crossings, 5, crossing));
    EXPECT_EQ(schedule.rows, 11);
}

TEST(Advance, IsFinishedAfterTheLastRow) {
    auto run = begin(problem(Method::rk4, 1, {1, 0}, {0.1, 0.1, 1}));
    Sample rows[20];
    EXPECT_FALSE(run.is_finished());
    EXPECT_EQ(advance(run, rows, 1e9), 11u);
    EXPECT_TRUE(run.is_finished());
    EXPECT_EQ(advance(run, rows, 1e9), 0u);
}

TEST(Advance, StaysInTheInterval) {
    std::mt19937_64 random(2);
    std::uniform_real_distribution<double> theta(-20, 20), omega(-5, 5), step(0.001, 3);
    for (int i = 0; i < 300; ++i)
        for (Method method : methods) {
            const double h = step(random);
            for (const auto& s : all_rows(stepwise(method, 1, {theta(random), omega(random)}, h, 1, 200)))
                ASSERT_TRUE(s.theta >= -pi && s.theta < pi) << h << ' ' << s.t;
        }
}

TEST(Advance, StartsFromTheAngleAndTheTurnsInIt) {
    for (double theta : {1 + 2 * pi * 1000, -4.0, 1e6, -1e12})
        for (Method method : methods) {
            const Angle start = split_turns(theta);
            const auto rows = all_rows(problem(method, 1, {theta, 0.5}, {0.01, 0.1, 5}));
            const auto near = all_rows(problem(method, 1, {start.theta, 0.5}, {0.01, 0.1, 5}));
            EXPECT_NEAR(rows[0].theta, start.theta, 1e-14);  // the closed form's bound; the others start there to the bit
            EXPECT_NEAR(rows[0].omega, 0.5, 1e-14);
            for (std::size_t i = 0; i < rows.size(); ++i) {
                if (method == Method::exact) continue;  // theta less its turns is more than a double
                EXPECT_EQ(rows[i].theta, near[i].theta);
                EXPECT_EQ(rows[i].turns, near[i].turns + start.turns);
            }
        }
}

// Doubles cannot say exactly upright; all methods take what is meant.
TEST(Advance, RestsWhereItIsInEquilibrium) {
    for (Method method : methods)
        for (double theta : {0.0, pi, -pi, 3 * pi, to_radians(180), to_radians(-540), to_radians(180 + 360 * 50)}) {
            const auto rows = all_rows(problem(method, 9.8, {theta, 0}, {0.1, 1, 100}));
            ASSERT_EQ(rows.size(), 101u);
            for (const auto& s : rows) {
                EXPECT_EQ(s.theta, rows[0].theta) << theta;
                EXPECT_EQ(s.turns, rows[0].turns) << theta;
                EXPECT_EQ(s.omega, 0) << theta;
            }
        }
}

TEST(Advance, DoesNotRestBesideTheTop) {
    for (Method method : methods) {
        const auto rows = all_rows(problem(method, 1, {3.14159, 0}, {0.01, 1, 30}));
        EXPECT_LT(std::fabs(rows[14].theta), 2) << static_cast<int>(method);  // half a period, 28 s, brings it round
    }
}

TEST(Advance, ByTheClosedFormIsTheClosedForm) {
    const State initial{0.4, 1.9};
    const auto solution = make_exact(2, initial);
    for (const auto& s : all_rows(problem(Method::exact, 2, initial, {0.01, 0.37, 100}))) {
        const auto want = at(solution, s.t);
        EXPECT_TRUE(s.t == 0 || (s.theta == want.theta && s.omega == want.omega && s.turns == want.turns)) << s.t;
    }
}

constexpr Method all_methods[] = {Method::rk4, Method::euler, Method::verlet, Method::taylor, Method::exact};

/// Measured times of thirty pictures a second, to a thousandth of a second; some repeated, and a gap.
std::vector<double> measured_times() {
    std::vector<double> t{0, 0, 1e-7};
    for (int j = 1; j < 90; ++j) t.push_back(std::round(1000 * j / 30.0) / 1000);
    t.insert(t.end(), {2.967, 2.967, 20, 20.5});
    return t;
}

TEST(GivenTimes, HaveTheStatesOfTheClosedForm) {
    const auto t = measured_times();
    const double bound[] = {1e-11, 0.2, 1e-5, 1e-13, 1e-14};  // of 20.5 s with orders 4, 1 and 2 in steps of 0.001
    const auto solution = make_exact(1.7, {2, 0.2});
    for (Method method : all_methods) {
        const auto rows =
            solve({.pendulum = {.alpha = 1.7}, .initial = {2, 0.2}, .method = method, .schedule = make_schedule(t, 0.001)});
        ASSERT_EQ(rows.size(), t.size());
        for (std::size_t j = 0; j < rows.size(); ++j) {
            EXPECT_EQ(rows[j].t, t[j]);
            EXPECT_NEAR(rows[j].theta, at(solution, t[j]).theta, bound[static_cast<int>(method)])
                << method_names[static_cast<int>(method)] << ' ' << t[j];
        }
        EXPECT_EQ(std::memcmp(&rows[0].theta, &rows[1].theta, sizeof(double)), 0);  // the same time, the same state
    }
}

TEST(GivenTimes, ThatAreEvenlySpacedGiveTheBitsOfTheSchedule) {
    std::vector<double> t;
    for (int j = 0; j < 40; ++j) t.push_back(j * 0.25);  // without rounding
    for (Method method : all_methods) {
        auto p = problem(method, 1.7, {1, 0.2}, {0.013, 0.25, 9.75});
        p.pendulum.alpha = 1.7;
        const auto want = solve(p);
        p.schedule = make_schedule(t, 0.013);
        const auto got = solve(p);
        ASSERT_EQ(got.size(), want.size());
        EXPECT_EQ(std::memcmp(got.data(), want.data(), want.size() * sizeof want[0]), 0) << static_cast<int>(method);
    }
}

TEST(GivenTimes, GiveTheSameBitsForAnyBlockAndBudget) {
    const auto t = measured_times();
    for (Method method : all_methods) {
        const Problem p{.pendulum = {.alpha = 1.7},
                        .initial = {2.5, 1},
                        .method = method,
                        .schedule = make_schedule(std::span<const double>(t), 0.013)};
        const auto want = all_rows(p);
        for (std::size_t block : {1, 7})
            for (double budget : {1.0, 17.0}) {
                const auto got = all_rows(p, block, budget);
                ASSERT_EQ(got.size(), want.size());
                EXPECT_EQ(std::memcmp(got.data(), want.data(), want.size() * sizeof want[0]), 0) << block << ' ' << budget;
            }
    }
}

TEST(GivenTimes, AreRefusedWithIndexAndValue) {
    using enum Refusal::Reason;
    const auto refusal = [](std::vector<double> t, double dt = 0.1, double beta = 0, Method method = Method::rk4) {
        return check({.pendulum = {.beta = beta}, .method = method, .schedule = make_schedule(t, dt)});
    };
    EXPECT_FALSE(refusal({0, 1, 1, 2}));
    const auto decreases = refusal({0, 1, 0.5, 2});
    EXPECT_EQ(decreases.reason, decreasing);
    EXPECT_EQ(decreases.row, 2u);
    EXPECT_EQ(describe(decreases), "times must not decrease, got 0.5 after 1 at index 2");
    EXPECT_EQ(describe(refusal({-1, 2})), "times must be finite and not negative, got -1 at index 0");
    EXPECT_EQ(refusal({0, std::nan(""), 2}).row, 1u);
    EXPECT_EQ(refusal({0, 1, HUGE_VAL}).row, 2u);
    EXPECT_EQ(refusal({0, 1}, 0).name, std::string("dt"));
    EXPECT_EQ(refusal({0, 1}, 1e-17).reason, too_many_steps);
    EXPECT_FALSE(refusal({0, 1, 5}, 3, 1));  // steps of 1 and 2 s; up to 2.78 s rk4 is stable
    EXPECT_EQ(refusal({0, 1, 4}, 3, 1).reason, unstable);
    EXPECT_FALSE(refusal({0, 1, 5}, 0, 0, Method::taylor));
    EXPECT_EQ(refusal({0, 1e300}, 0, 0, Method::exact).reason, too_late);
    auto p = Problem{.method = Method::taylor, .schedule = {.rows = 3}};
    const std::vector<double> two{0, 1};
    p.schedule.times = two;
    EXPECT_EQ(check(p).reason, length);
}

}  // namespace
