// Taylor's method: against 50 digits where it is driven, against the closed form where it is not; packs against one by one.
#include "pendula/taylor.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <random>

#include "kernels/dispatch.hpp"
#include "kernels/packs.hpp"
#include "pendula/angle.hpp"
#include "reference_table.hpp"
#include "trajectories.hpp"
#include "trajectory/scalar.hpp"

namespace {

using namespace pendula;
using namespace reference;

/// A problem of driven.txt and its solution.
struct Driven {
    bool is_chaotic;
    Pendulum pendulum;
    State initial;
    std::vector<Row> rows;
};

std::vector<Driven> driven() {
    std::vector<Driven> problems;
    for (const Row& r : table("driven.txt")) {
        if (r.words[0] == "problem")
            problems.push_back({r.words[1] == "chaotic", {r[0], r[1], r[2], r[3], 0, r[4], r[5]}, {r[6], r[7]}, {}});
        else
            problems.back().rows.push_back(r);
    }
    return problems;
}

Sample solved(Taylor& run, double t) {
    while (needs_step_to(run, t)) step(run);
    return at(run, t);
}

TEST(Taylor, SolvesTheDrivenPendulum) {
    for (const auto& problem : driven()) {
        // Rounding of 1e-16 a step, and what the motion makes of it: chaos a thousandfold by t = 50.
        const double tolerance = problem.is_chaotic ? 1e-12 : 1e-13;
        auto run = make_taylor(problem.pendulum, problem.initial);
        for (const Row& r : problem.rows) {
            const auto s = solved(run, r[0]);
            EXPECT_LE(angle_error(s.theta, s.turns, r.value(1), 0), tolerance) << problem.initial.theta << ' ' << r[0];
            EXPECT_LE(error(s.omega, r.value(3)), tolerance) << problem.initial.theta << ' ' << r[0];
        }
    }
}

TEST(Taylor, KeepsRelativePrecisionOfSmallAmplitudes) {
    auto run = make_taylor({}, {1e-9, 0});
    const auto solution = make_exact(1, {1e-9, 0});
    for (int i = 1; i <= 100; ++i) EXPECT_NEAR(solved(run, i).theta, at(solution, i).theta, 1e-9 * 1e-14 * i);
}

TEST(Taylor, ErrsNoMoreThanItsTolerance) {
    for (double tolerance : {1e-3, 1e-6, 1e-9, 1e-12, 1e-15}) {
        auto run = make_taylor({}, {2, 0}, tolerance);
        const auto want = at(make_exact(1, {2, 0}), 50);
        const auto got = solved(run, 50);
        // Errors of all steps, carried on for as long; rounding below.
        EXPECT_NEAR(got.theta, want.theta, 50 * tolerance + 1e-14) << tolerance;
    }
}

TEST(Taylor, FollowsTheClosedFormThroughEveryRegime) {
    for (State initial : {State{0.1, 0}, {2.5, 0.5}, {0, 1.999}, {1, -1.9}, {0, 2.5}, {0, -30}, {3, 1000}}) {
        auto run = make_taylor({}, initial);
        const auto solution = make_exact(1, initial);
        // Rounding of 1e-16 in energy moves the rate by as much over kappa', hence the angle by that times t.
        const double tolerance = 1e-14 / std::fmin(1, std::fabs(energy(1, initial) - 2));
        for (int i = 1; i <= 100; ++i) {
            const auto got = solved(run, i), want = at(solution, i);
            // Many turns are known as well as a double knows their sum.
            EXPECT_LE(angle_error(got.theta, got.turns, {want.theta, 0}, want.turns),
                      tolerance * i + 4e-15 * std::fabs(unwrapped(want)))
                << initial.omega << ' ' << i;
        }
    }
}

TEST(Taylor, KeepsTheEnergyOver1e5Units) {
    auto run = make_taylor({}, {1.5, 0});
    const double start = energy(1, {1.5, 0});
    Largest worst;
    while (!reaches(run, 1e5)) {
        step(run);
        worst(std::fabs(energy(1, {run.step.start.theta, run.step.start.omega}) - start));
    }
    // What 2e5 steps leave out, a few 1e-18 each and all alike.
    EXPECT_LE(worst.value, 1e-12);
}

TEST(Taylor, RowsDependNeitherOnBlocksNorOnBudgets) {
    Problem problem;
    problem.pendulum = {.beta = 0.5, .drive_amplitude = 1.5, .drive_frequency = 2.0 / 3};
    problem.initial = {0.2, 0};
    problem.method = Method::taylor;
    problem.schedule = make_schedule({0.01, 0.07, 100});
    const auto rows = all_rows(problem), others = all_rows(problem, 7, 1);
    ASSERT_EQ(rows.size(), 1429u);
    ASSERT_EQ(others.size(), rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        EXPECT_EQ(rows[i].theta, others[i].theta);
        EXPECT_EQ(rows[i].omega, others[i].omega);
        EXPECT_EQ(rows[i].turns, others[i].turns);
    }
    auto run = make_taylor(problem.pendulum, problem.initial);
    for (const auto& row : rows) EXPECT_EQ(solved(run, row.t).theta, row.theta);
}

TEST(Taylor, EndsOfStepsAreTheStartsOfTheNext) {
    auto run = make_taylor({.beta = 0.1, .torque = 0.05, .drive_amplitude = 1, .drive_frequency = 0.7}, {-1, 2});
    for (int i = 0; i < 1000; ++i) {
        const auto end = at(run, run.step.t + run.step.length);
        step(run);
        // The step's end lies within an ulp of the time asked for.
        EXPECT_LE(angle_error(end.theta, end.turns, {run.step.start.theta, 0}, run.step.start.turns),
                  1e-15 + 5 * ulp(run.step.t));
    }
}

TEST(Taylor, OfAnEndlessMotionIsNan) {
    Problem problem;
    problem.pendulum.torque = 1e300;
    problem.method = Method::taylor;
    problem.schedule = make_schedule({1, 1, 10});
    const auto rows = all_rows(problem);
    ASSERT_EQ(rows.size(), 11u);
    EXPECT_EQ(rows[0].theta, 0);
    for (std::size_t i = 1; i < rows.size(); ++i) EXPECT_TRUE(std::isnan(rows[i].theta));
}

TEST(Taylor, OfWhatIsNotFiniteIsNanEverywhere) {
    const double nan = std::nan(""), inf = HUGE_VAL;
    for (State initial : {State{nan, 0}, {0, nan}, {inf, 0}, {0, inf}}) {
        auto run = make_taylor({}, initial);
        EXPECT_TRUE(reaches(run, 1e9));
        EXPECT_TRUE(std::isnan(at(run, 1).theta));
    }
    EXPECT_TRUE(reaches(make_taylor({nan}, {1, 0}), 1));
    EXPECT_TRUE(reaches(make_taylor({1, 0, inf}, {1, 0}), 1));
}

using kernels::Chunk;
using kernels::chunk_size;
using kernels::TaylorChunk;

/// Members of all kinds side by side, some of them hopeless.
void put_members(Chunk& c) {
    std::mt19937 random(1);
    const auto uniform = [&](double from, double to) { return from + (to - from) * (static_cast<double>(random()) * 0x1p-32); };
    c = {};
    c.count = 61;
    for (int i = 0; i < chunk_size; ++i) {
        auto& [alpha, beta, torque, drive_amplitude, pivot_amplitude, drive_frequency, drive_phase] = c.parameters;
        c.motion.theta[i] = uniform(-3, 3);
        c.motion.omega[i] = uniform(-3, 3);
        c.tangent.theta[i] = 1;
        alpha[i] = uniform(0.1, 10);
        beta[i] = i % 3 == 0 ? 0 : uniform(0, 1);
        torque[i] = i % 5 == 1 ? uniform(-1, 1) : 0;
        drive_amplitude[i] = i % 2 == 0 ? uniform(0, 2) : 0;
        pivot_amplitude[i] = i % 7 == 3 ? uniform(-2, 2) : 0;
        drive_frequency[i] = uniform(0.1, 3);
        drive_phase[i] = uniform(-4, 4);
    }
    c.motion.theta[17] = c.motion.omega[17] = c.motion.turns[17] = std::nan("");
    c.parameters.torque[19] = 1e308;
}

bool same(double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) || (a != a && b != b);
}

void expect_members_as_alone(double tolerance) {
    Chunk start, c;
    put_members(start);
    c = start;
    static TaylorChunk steps;
    double t[chunk_size] = {};
    kernels::start_taylor(steps, c, tolerance, t);
    std::vector<Taylor> alone;
    for (int i = 0; i < c.count; ++i)
        alone.push_back(make_taylor(std::bit_cast<Pendulum>(kernels::load<double, kernels::Parameters>(c.parameters, i)),
                                    {c.motion.theta[i], c.motion.omega[i]}, tolerance));
    for (int row = 0; row < 40; ++row) {
        for (int i = 0; i < chunk_size; ++i) t[i] = row * 0.05 * (i + 1);
        while (!kernels::dispatch().taylor(c, steps, t, 5)) {
        }
        for (int i = 0; i < c.count; ++i) {
            const auto s = solved(alone[static_cast<std::size_t>(i)], t[i]);
            EXPECT_TRUE(same(c.motion.theta[i], s.theta) && same(c.motion.omega[i], s.omega) &&
                        same(c.motion.turns[i], s.turns))
                << tolerance << ' ' << row << ' ' << i;
        }
    }
    EXPECT_TRUE(std::isnan(c.motion.theta[17]) && std::isnan(c.motion.theta[19]));
    EXPECT_FALSE(std::isnan(c.motion.theta[16]) || std::isnan(c.motion.theta[20]));
}

TEST(Taylor, OfAMemberIsThatOfItselfAlone) {
    for (double tolerance : {1e-15, 1e-13, 1e-12, 1e-8, 1e-5, 1e-2}) expect_members_as_alone(tolerance);
}

TEST(Taylor, TangentsAreTheDifferencesOfNeighbours) {
    Chunk c;
    put_members(c);
    c.count = 16;
    static TaylorChunk steps;
    double t[chunk_size] = {};
    kernels::start_taylor(steps, c, 1e-15, t);
    Chunk ahead = c, behind = c;
    constexpr double h = 1e-5;
    for (int i = 0; i < c.count; ++i) {
        ahead.motion.theta[i] += h;
        behind.motion.theta[i] -= h;
        t[i] = 5;
    }
    while (!kernels::dispatch().taylor_tangent(c, steps, t, 5)) {
    }
    const auto solve_plainly = [&](Chunk& x) {
        double zero[chunk_size] = {};
        kernels::start_taylor(steps, x, 1e-15, zero);
        while (!kernels::dispatch().taylor(x, steps, t, 100)) {
        }
    };
    solve_plainly(ahead);
    solve_plainly(behind);
    for (int i = 0; i < c.count; ++i) {
        const double turn = 2 * pi * (ahead.motion.turns[i] - behind.motion.turns[i]);
        const double slope = (ahead.motion.theta[i] - behind.motion.theta[i] + turn) / (2 * h);
        // h^2 of the third derivative, which grows like the cube of the first; rounding 1e-14/h.
        const double slack = 1e-8 * (1 + std::pow(std::fabs(c.tangent.theta[i]) + std::fabs(c.tangent.omega[i]), 3));
        EXPECT_NEAR(c.tangent.theta[i], slope, slack) << i;
        EXPECT_NEAR(c.tangent.omega[i], (ahead.motion.omega[i] - behind.motion.omega[i]) / (2 * h), slack) << i;
    }
}

}  // namespace
