// Euler, Verlet and Runge-Kutta: each step against 50 digits, their orders, symmetries and conserved quantities.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "pendula/actividad3.hpp"
#include "pendula/angle.hpp"
#include "rk4_rounding.hpp"

namespace {

using namespace pendula;
using namespace reference;

const std::map<std::string, Method> methods{{"euler", Method::euler}, {"verlet", Method::verlet}, {"rk4", Method::rk4}};

TEST(Methods, FollowTheirFormulasStepByStep) {
    for (const auto& r : stepped()) {
        if (r.is_long()) continue;
        const double theta_ulp = ulp(std::fabs(r.initial.theta) + std::fabs(r.initial.omega) * r.h);
        const double omega_ulp = ulp(std::fabs(r.initial.omega) + r.alpha * r.h * std::min(1.0, std::fabs(r.initial.theta)));
        for (const auto& c : r.checkpoints) {
            const auto s = after(methods.at(r.method), r.alpha, r.initial, r.h, c.steps);
            // A few roundings a step, each carried on by the motion: errors of omega grow into theta with the time, and back.
            const double time = r.h * c.steps;
            const double theta_slack = 4 * c.steps * (theta_ulp + omega_ulp * time);
            const double omega_slack = 4 * c.steps * (omega_ulp + theta_ulp * r.alpha * time);
            EXPECT_LE(angle_error(s.theta, s.turns, c.theta, 0), theta_slack) << r.method << ' ' << r.h << ' ' << c.steps;
            EXPECT_LE(error(s.omega, c.omega), omega_slack) << r.method << ' ' << r.h << ' ' << c.steps;
        }
    }
}

TEST(Rk4, RoundsNoWorseThanThePlainFormulasOverAMillionSteps) {
    for (const auto& r : stepped()) {
        if (!r.is_long()) continue;
        const auto rounding = rounding_of(r);
        EXPECT_LE(rounding.own, rounding.plain) << r.initial.theta << ' ' << r.initial.omega;
    }
}

double error_at_one(Method method, double steps) {
    const State initial{1.5, 0.3};
    const auto s = after(method, 1, initial, 1 / steps, steps), want = at(make_exact(1, initial), 1.0);
    return std::hypot(s.theta - want.theta, s.omega - want.omega);
}

/// Steps at which the error is far above rounding and the next order is below a tenth of it.
double order(Method method, double steps) { return std::log2(error_at_one(method, steps) / error_at_one(method, 2 * steps)); }

TEST(Euler, ConvergesAtOrder1) { EXPECT_NEAR(order(Method::euler, 256), 1, 0.1); }
TEST(Verlet, ConvergesAtOrder2) { EXPECT_NEAR(order(Method::verlet, 64), 2, 0.1); }
TEST(Rk4, ConvergesAtOrder4) { EXPECT_NEAR(order(Method::rk4, 32), 4, 0.1); }

TEST(Verlet, KeepsItsEnergyOver1e5Periods) {
    const State initial{2, 0};
    const double tau = analyze(1, initial).tau;
    const auto rows = all_rows(stepwise(Method::verlet, 1, initial, tau / 64, 23, std::ceil(64.0 / 23 * 1e5)));
    Largest early, late;
    for (const auto& s : rows) (s.t < 1e3 * tau ? early : late)(std::fabs(energy(1, {s.theta, s.omega}) - energy(1, initial)));
    EXPECT_GT(early.value, 1e-5);                // it does swing within a period
    EXPECT_LE(late.value, 1.001 * early.value);  // and no drift: a random walk of 1e7 roundings is below 1e-12
}

TEST(Methods, AreOddToTheBit) {
    for (const auto& [name, method] : methods) {
        const auto rows = all_rows(stepwise(method, 2, {0.7, 1.3}, 0.01, 3, 500));
        const auto mirrored = all_rows(stepwise(method, 2, {-0.7, -1.3}, 0.01, 3, 500));
        ASSERT_EQ(rows.size(), 501u) << name;
        for (std::size_t i = 0; i < rows.size(); ++i)
            EXPECT_TRUE(rows[i].theta == -mirrored[i].theta && rows[i].omega == -mirrored[i].omega) << name << ' ' << i;
    }
}

TEST(Verlet, IsReversible) {
    const auto there = after(Method::verlet, 1, {1, 0.5}, 0.01, 1000);
    const auto back = after(Method::verlet, 1, {there.theta, -there.omega}, 0.01, 1000);
    // 2,000 steps of a few half ulp, carried on for 20 s.
    EXPECT_NEAR(back.theta, 1, 2000 * 20 * 2.2e-16);
    EXPECT_NEAR(back.omega, -0.5, 2000 * 20 * 2.2e-16);
}

TEST(Rk4, OfTheAssignmentIsTheStepOfTheSolver) {
    double theta = 1, omega = 0.5;
    actividad3::RungeKutta(9.81, theta, omega, 0, 0.01);
    const auto s = after(Method::rk4, 9.81, {1, 0.5}, 0.01, 1);
    EXPECT_EQ(theta, s.theta);
    EXPECT_EQ(omega, s.omega);
}

TEST(Rk4, KeepsUpWithTheClosedFormOverManyTurns) {
    const State initial{0, 3};
    const double tau = analyze(1, initial).tau;
    const auto rows = all_rows(stepwise(Method::rk4, 1, initial, tau / 500, 1100, 500));
    const auto solution = make_exact(1, initial);
    EXPECT_GT(rows.back().turns, 1000);
    // A step errs by h^5/120 where h is 2 pi/500 of a turn: 500 of them by 1.3e-9 a turn.
    for (const auto& s : rows) {
        const auto want = at(solution, s.t);
        EXPECT_LE(angle_error(s.theta, s.turns, {want.theta, 0}, want.turns), 1.3e-9 * (1 + s.turns)) << s.t;
    }
}

}  // namespace
