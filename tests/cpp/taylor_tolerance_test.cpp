// Taylor's method at every tolerance: what a step leaves out, what a run is off by, and how displacements follow.
#include <gtest/gtest.h>

#include <algorithm>
#include <complex>
#include <random>

#include "kernels/dispatch.hpp"
#include "pendula/pendula.hpp"
#include "reference_table.hpp"

namespace {

using namespace pendula;
using namespace reference;

Sample solved(Taylor& run, double t) {
    while (!reaches(run, t)) step(run);
    return at(run, t);
}

/// How far the angle turns at most from the start of the present step, at eight times of it, and the angle there.
double size_of(const Taylor& run) {
    const auto& [start, t, t_lo, unit, length, series, series_1_lo] = run.step;
    Largest size;
    size(std::fabs(start.theta));
    for (int i = 1; i <= 8; ++i) {
        const auto s = at(run, t + length * i / 8);
        size(std::fabs((s.theta - start.theta) + 2 * pi * (s.turns - start.turns)));
    }
    return size.value;
}

/// Steps from random states of pendulums with more and more forces. A quarter starts at rest and an eighth at the bottom, so
/// that the series are even or odd in time.
class RandomSteps {
  public:
    struct Problem {
        Pendulum pendulum;
        State initial;
    };

    Problem next(int kind) {
        Pendulum p{.alpha = std::exp(uniform(-3, 3))};
        if (kind >= 1) p.beta = half() ? uniform(0, 1) : 0;
        if (kind >= 1) p.torque = half() ? uniform(-2, 2) : 0;
        if (kind >= 2) {
            p.drive_amplitude = uniform(-2, 2);
            p.drive_frequency = std::exp(uniform(-2, 2));
            p.drive_phase = uniform(-3, 3);
        }
        if (kind >= 3) p.pivot_amplitude = uniform(-5, 5);
        State s{uniform(-3.14, 3.14), uniform(-4, 4)};
        if (half()) s.theta *= std::exp(uniform(-10, 0));
        if (half() && half()) s.omega = 0;
        if (half() && half() && half()) s = {0, uniform(-3, 3)};
        return {p, s};
    }

  private:
    std::mt19937 random_{1};

    double uniform(double from, double to) { return from + (to - from) * (static_cast<double>(random_()) * 0x1p-32); }
    bool half() { return random_() < 0x80000000u; }
};

TEST(TaylorTolerance, IsFiftyTimesWhatAStepLeavesOut) {
    RandomSteps steps;
    for (int kind = 0; kind < 4; ++kind) {
        for (double tolerance : {1e-11, 1e-10, 1e-8, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2}) {
            Largest worst;
            int above_a_hundredth = 0;
            constexpr int count = 1000;
            for (int i = 0; i < count; ++i) {
                const auto problem = steps.next(kind);
                const auto run = make_taylor(problem.pendulum, problem.initial, tolerance);
                const double end = run.step.length, size = size_of(run);
                if (size == 0) continue;
                // Steps at 1e-15 are held to 50 digits in taylor_test.cpp.
                auto finer = make_taylor(problem.pendulum, problem.initial);
                const auto got = at(run, end), want = solved(finer, end);
                const double off = angle_error(got.theta, got.turns, {want.theta, 0}, want.turns) / (tolerance * size);
                worst(off);
                above_a_hundredth += off > 0.01;
            }
            EXPECT_LE(worst.value, 0.02) << kind << ' ' << tolerance;
            EXPECT_LE(above_a_hundredth, count / 500) << kind << ' ' << tolerance;
        }
    }
}

TEST(TaylorTolerance, HoldsTheClosedFormAfterOneStep) {
    RandomSteps steps;
    for (double tolerance : {1e-10, 1e-8, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2}) {
        for (int i = 0; i < 1000; ++i) {
            const auto [pendulum, initial] = steps.next(0);
            const auto run = make_taylor(pendulum, initial, tolerance);
            const auto got = at(run, run.step.length), want = at(make_exact(pendulum.alpha, initial), run.step.length);
            // 1e-14 is the error of the closed form.
            EXPECT_LE(angle_error(got.theta, got.turns, {want.theta, 0}, want.turns), 0.01 * tolerance * size_of(run) + 1e-14)
                << tolerance << ' ' << initial.theta << ' ' << initial.omega;
        }
    }
}

TEST(TaylorTolerance, BoundsTheErrorsOfDrivenRuns) {
    for (double tolerance : {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13, 1e-14}) {
        Taylor run;
        bool is_chaotic = false;
        for (const Row& r : table("driven.txt")) {
            if (r.words[0] == "problem") {
                is_chaotic = r.words[1] == "chaotic";
                run = make_taylor({r[0], r[1], r[2], r[3], 0, r[4], r[5]}, {r[6], r[7]}, tolerance);
                continue;
            }
            // What some 100 steps leave out, a fiftieth at most, grows a hundredfold at most in regular motions, and a
            // thousandfold by t = 50 in chaotic ones. 120 and 900 are measured below 1e-3, where chaos is already far off.
            const double slack = is_chaotic ? 2000 * tolerance + 1e-12 : 200 * tolerance + 1e-13;
            const auto s = solved(run, r[0]);
            if (is_chaotic && tolerance == 1e-3) continue;
            EXPECT_LE(angle_error(s.theta, s.turns, r.value(1), 0), slack) << tolerance << ' ' << r[0];
            EXPECT_LE(error(s.omega, r.value(3)), slack) << tolerance << ' ' << r[0];
        }
    }
}

TEST(TaylorTolerance, TakesFewerStepsWhereItIsLooser) {
    const auto steps = [](double tolerance) {
        auto run = make_taylor({.beta = 0.5, .drive_amplitude = 1.15, .drive_frequency = 2.0 / 3}, {1.5, 0}, tolerance);
        int count = 0;
        for (; !reaches(run, 1000); ++count) step(run);
        return count;
    };
    // Within an order; where the order changes, more and shorter steps cost less.
    for (auto [first, last] : {std::pair{1e-15, 9e-13}, {1e-12, 9e-6}, {1e-5, 0.9}})
        for (double tolerance = first; 10 * tolerance <= last; tolerance *= 10)
            EXPECT_LT(steps(10 * tolerance), steps(tolerance)) << tolerance;
}

using kernels::Chunk;

/// A pendulum that stays at an angle, and its stiffness there, alpha cos(theta).
struct Resting {
    Pendulum pendulum;
    double theta;
    double stiffness() const { return pendulum.alpha * std::cos(theta); }
};

/// The displacement at time t that was (1, 0): a sum of exponentials with the eigenvalues of u'' = -stiffness u - beta u'.
kernels::Tangent<double> displacement(const Resting& at_rest, double t) {
    const double beta = at_rest.pendulum.beta;
    const auto root = std::sqrt(std::complex<double>(beta * beta / 4 - at_rest.stiffness()));
    const auto first = -beta / 2 + root, second = -beta / 2 - root;
    const auto a = -second / (first - second), b = first / (first - second);
    const auto grown = a * std::exp(first * t), shrunk = b * std::exp(second * t);
    return {(grown + shrunk).real(), (first * grown + second * shrunk).real()};
}

kernels::Tangent<double> displacement_by_taylor(const Resting& at_rest, double tolerance, double t) {
    Chunk c{};
    c.count = 1;
    for (double& alpha : c.parameters.alpha) alpha = 1;
    c.parameters.alpha[0] = at_rest.pendulum.alpha;
    c.parameters.beta[0] = at_rest.pendulum.beta;
    c.parameters.torque[0] = at_rest.pendulum.torque;
    c.motion.theta[0] = at_rest.theta;
    c.tangent.theta[0] = 1;
    static kernels::TaylorChunk steps;
    kernels::Row times{};
    kernels::start_taylor(steps, c, tolerance, times);
    times[0] = t;
    while (!kernels::dispatch().taylor_tangent(c, steps, times, 100)) {
    }
    return {c.tangent.theta[0], c.tangent.omega[0]};
}

TEST(TaylorTolerance, HoldsDisplacementsFromMotionsThatStandStill) {
    const auto balanced = [](double alpha, double beta, double torque, bool is_high) {
        const double low = std::asin(torque / alpha);
        return Resting{{.alpha = alpha, .beta = beta, .torque = torque}, is_high ? pi - low : low};
    };
    const Resting all[] = {balanced(15, 0.05, 0.05, false), balanced(15, 0.05, 0.05, true), balanced(1, 0, 0, false),
                           balanced(1, 4, 0, false),        balanced(2, 0.3, 1.9, false),   balanced(2, 0.3, 1.9, true),
                           balanced(0.01, 1, 0, false),     balanced(400, 0.5, 3, false)};
    for (const auto& at_rest : all) {
        for (double tolerance : {1e-15, 1e-12, 1e-8, 1e-5, 1e-3}) {
            const double rate = std::sqrt(std::fabs(at_rest.stiffness())) + at_rest.pendulum.beta;
            for (double t : {1 / rate, 5 / rate, 15 / rate}) {
                const auto got = displacement_by_taylor(at_rest, tolerance, t), want = displacement(at_rest, t);
                // A displacement that shrinks keeps the errors of its largest size, 1. A few steps a unit of 1/rate. The angle
                // is a rounding off, and that departure grows as displacements do.
                const double size = std::fmax(1, std::fabs(want.theta) + std::fabs(want.omega) / rate);
                const double slack = ((tolerance + 1e-14) * (1 + rate * t) + 1e-16 * size) * size;
                EXPECT_LE(std::fabs(got.theta - want.theta), slack) << at_rest.theta << ' ' << tolerance << ' ' << t;
                EXPECT_LE(std::fabs(got.omega - want.omega), slack * rate) << at_rest.theta << ' ' << tolerance << ' ' << t;
            }
        }
    }
}

TEST(TaylorTolerance, HoldsTheExponentsOfEigenvalues) {
    // Rates of growth over many periods of the slow eigenvalue, from displacements of whole periods of the fast turn.
    const Resting slow{{.alpha = 15, .beta = 0.05, .torque = 0.05}, std::asin(0.05 / 15)};
    const double turn = 2 * pi / std::sqrt(slow.stiffness() - 0.05 * 0.05 / 4), t = 20 * turn;
    EXPECT_NEAR(std::log(displacement_by_taylor(slow, 1e-15, t).theta) / t, -0.025, 1e-14);
    const Resting damped{{.alpha = 1, .beta = 2.5}, 0};
    // e^(-t/2) and e^(-2 t): the second is gone by t = 20, and the first has the coefficient 4/3.
    EXPECT_NEAR(std::log(displacement_by_taylor(damped, 1e-15, 20).theta * 3 / 4) / 20, -0.5, 1e-12);
}

}  // namespace
