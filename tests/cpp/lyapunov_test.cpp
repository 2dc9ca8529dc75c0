// Lyapunov exponents: analytic values, identities, and errors that cover the truth.
#include <complex>
#include <random>

#include "ensemble/members.hpp"
#include "flocks.hpp"
#include "pendula/angle.hpp"

namespace {

using namespace reference;

constexpr double inf = INFINITY;

TEST(Lyapunov, OfPeriodicOrbitsAwayFromBifurcationsIsMinusHalfTheFriction) {
    for (const auto& strobe : {Strobe{}, by_rk4(100, 400, 200)}) {
        const auto found = exponent_of(published({0.9, 1.35}), strobe);
        for (int i : {0, 1}) {
            EXPECT_NEAR(found["exponent"][i], -0.25, found["error"][i]);
            EXPECT_LT(found["error"][i], 1e-13);
            EXPECT_EQ(found["horizon"][i], inf);
            EXPECT_EQ(found["dimension"][i], 0);
        }
    }
}

TEST(Lyapunov, OfTaylorIsThatOfRk4) {
    const auto flock = published({0.9, 1.07, 1.35, 1.47});
    const auto rk4 = exponent_of(flock, by_rk4(100, 400, 500)), taylor = exponent_of(flock, {});
    for (int i : {0, 1, 2, 3}) {
        EXPECT_NEAR(taylor["exponent"][i], rk4["exponent"][i], 1e-6);
        EXPECT_EQ(taylor.kind(i), Kind::periodic);
        EXPECT_EQ(rk4.kind(i), Kind::periodic);
    }
}

TEST(Lyapunov, OfChaosIsThatOfManyOtherMotions) {
    // By NumPy: 96 motions of 700 periods, rk4 with 250 steps, with the standard error of their mean.
    const struct {
        double amplitude, exponent, error;
    } cases[] = {{1.15, 0.0995, 0.0006}, {1.5, 0.1124, 0.0003}};
    for (const auto& c : cases) {
        const auto found = exponent_of(published({c.amplitude}), {.budget = 3000});
        EXPECT_EQ(found.kind(0), Kind::chaotic);
        EXPECT_NEAR(found["exponent"][0], c.exponent, found["error"][0] + 2 * c.error);
    }
}

TEST(Lyapunov, OfChaosIsPositiveAndItsHorizonThatOfADoublesRounding) {
    const auto found = exponent_of(published({1.15, 1.5}), by_rk4(100, 1000, 200));
    for (int i : {0, 1}) {
        const double exponent = found["exponent"][i], error = found["error"][i];
        EXPECT_EQ(found.kind(i), Kind::chaotic);
        EXPECT_GT(exponent, 4 * error);
        EXPECT_EQ(found["horizon"][i], 52 * std::log(2.0) / exponent);
        EXPECT_EQ(found["second"][i], -0.5 - exponent);
        EXPECT_NEAR(found["dimension"][i], 1 + exponent / (0.5 + exponent), 1e-15);
    }
}

TEST(Lyapunov, OfChaosIsWithinItsErrorOfTheTruth) {
    Flock flock = published({1.5});
    constexpr int starts = 256;
    flock.theta = linspace(-1, 1, starts);
    const auto found = exponent_of(flock, by_rk4(50, 1000, 100));
    double mean = 0, spread = 0, stated = 0;
    for (double x : found["exponent"]) mean += x / starts;  // 16 times closer to the truth than a single one
    int covered = 0;
    for (int i = 0; i < starts; ++i) {
        const double off = found["exponent"][i] - mean, error = found["error"][i];
        spread += off * off / (starts - 1);
        stated += error * error / starts;
        covered += std::abs(off) <= error;
    }
    EXPECT_GE(covered, 0.95 * starts);
    EXPECT_LT(std::sqrt(stated / spread), 4);  // two standard errors would do
}

TEST(Lyapunov, SumOfBothIsMinusTheFriction) {
    // Liouville: the determinant of the tangent map shrinks like exp(-beta t).
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> uniform(0, 1);
    Flock flock{{}, {}, {}, {}, {}, {}, {}, {}, {}};
    for (int i = 0; i < kernels::chunk_size; ++i) {
        flock.theta.push_back(6 * uniform(random) - 3);
        flock.omega.push_back(4 * uniform(random) - 2);
        flock.alpha.push_back(0.5 + uniform(random));
        flock.beta.push_back(uniform(random));
        flock.torque.push_back(2 * uniform(random) - 1);
        flock.drive_amplitude.push_back(2 * uniform(random));
        flock.pivot_amplitude.push_back(2 * uniform(random));
        flock.drive_frequency.push_back(0.5 + uniform(random));
        flock.drive_phase.push_back(6 * uniform(random));
    }
    const double time = 4;
    constexpr kernels::Row start = {};
    kernels::Row h;
    std::fill(std::begin(h), std::end(h), time / 4000);
    Members one, other;
    load_members(one, flock.ensemble(), 0);
    load_members(other, flock.ensemble(), 0);
    for (int i = 0; i < kernels::chunk_size; ++i) {
        other.chunk.tangent.theta[i] = 0;
        other.chunk.tangent.omega[i] = 1;
    }
    kernels::dispatch().rk4_tangent(one.chunk, start, h, 0, 4000);
    kernels::dispatch().rk4_tangent(other.chunk, start, h, 0, 4000);
    const auto &a = one.chunk.tangent, &b = other.chunk.tangent;
    for (int i = 0; i < kernels::chunk_size; ++i)
        EXPECT_NEAR(std::log(a.theta[i] * b.omega[i] - a.omega[i] * b.theta[i]) / time, -flock.beta[i], 1e-9) << i;
}

TEST(Lyapunov, AtRestOnTopIsThatOfTheSaddle) {
    const auto found = exponent_of({.theta = {pi}, .alpha = {9.81}, .beta = {0.3}}, {.periods = 2, .history_rows = 2});
    const double expected = -0.15 + std::sqrt(0.15 * 0.15 + 9.81);
    EXPECT_NEAR(found["exponent"][0], expected, 1e-15 * expected);
    EXPECT_LE(found["error"][0], 1e-15 * expected);
    EXPECT_EQ(found["history"], (std::vector<double>{found["exponent"][0], found["exponent"][0]}));
    EXPECT_EQ(found.kind(0), Kind::fixed_point);
}

TEST(Lyapunov, IsKnownForDrivesSoSlowThatAPeriodShrinksDisplacementsOutOfRange) {
    const Flock flock{.theta = {0.1}, .beta = {1}, .drive_amplitude = {0.1}, .drive_frequency = {0.001}};
    for (const auto& strobe : {by_taylor(0, 2), by_rk4(0, 2, 40000)})
        EXPECT_NEAR(exponent_of(flock, strobe)["exponent"][0], -0.5, 0.001);
}

TEST(Lyapunov, IsKnownWhereAFewStepsGrowOutOfTheRangeOfSquares) {
    // Gravity turns round for half of a slow period; a coarse step then multiplies the displacement by up to 14.
    const Pendulum p{.pivot_amplitude = -10, .drive_frequency = 0.001};
    Flock flock{.theta = {0}, .drive_frequency = {0.001}};
    flock.pivot_amplitude = {-10};
    const auto coarse = by_rk4(0, 2, fewest_steps(p)), fine = by_taylor(0, 2);
    const double exact_growth = exponent_of(flock, fine)["exponent"][0];
    EXPECT_NEAR(exact_growth, 1.0757, 1e-4);
    // Where the drive is this slow, each step multiplies the displacement by |1 + z + z^2/2 + z^3/6 + z^4/24|, z^2 = (10 cos -
    // 1) h^2.
    const double h = 2 * pi / p.drive_frequency / coarse.steps_per_period;
    double growth = 0;
    constexpr int phases = 20000;
    for (int i = 0; i < phases; ++i) {
        const auto z = std::sqrt(std::complex<double>(10 * std::cos(2 * pi * (i + 0.5) / phases) - 1)) * h;
        growth += std::log(std::abs(1.0 + z * (1.0 + z / 2.0 * (1.0 + z / 3.0 * (1.0 + z / 4.0))))) / phases / h;
    }
    EXPECT_NEAR(exponent_of(flock, coarse)["exponent"][0], growth, 0.001);  // the change of z within a step is left out
}

TEST(Lyapunov, HistoryEndsAtTheExponentAndFollowsThePeriods) {
    const auto flock = published({0.9, 1.15});  // periodic, chaotic
    auto strobe = by_rk4(10, 50, 100);
    strobe.history_rows = 7;
    const auto whole = exponent_of(flock, strobe), part = exponent_of(flock, by_rk4(10, 21, 100));  // floor(3 50/7)
    EXPECT_EQ(whole["history"][12], whole["exponent"][0]);
    EXPECT_EQ(whole["history"][13], whole["exponent"][1]);
    EXPECT_EQ(whole["history"][5], part["exponent"][1]);
}

TEST(Lyapunov, OfASinglePeriodIsWithinItsError) {
    const auto found = exponent_of(published({1.5}), by_rk4(100, 1, 100));
    EXPECT_NEAR(found["exponent"][0], 0.1124, found["error"][0]);
}

}  // namespace
