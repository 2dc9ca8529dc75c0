// Lyapunov exponents: analytic values, identities, and errors that are what they say.
#include <complex>
#include <random>

#include "ensemble/members.hpp"
#include "flocks.hpp"
#include "pendula/angle.hpp"

namespace {

using namespace reference;

constexpr double inf = INFINITY;

TEST(Lyapunov, OfPeriodicOrbitsAwayFromBifurcationsIsMinusHalfTheFriction) {
    const auto found = exponents_of(published({0.9, 1.35}), {100, 400, 200});
    for (int i : {0, 1}) {
        EXPECT_NEAR(found.exponent[i], -0.25, 3 * found.error[i]);
        EXPECT_NEAR(found.exponent[i], -0.25, 0.001);
        EXPECT_EQ(found.horizon[i], inf);
    }
}

TEST(Lyapunov, OfTaylorIsThatOfRk4) {
    const auto flock = published({0.9, 1.07, 1.35, 1.47});
    const auto rk4 = exponents_of(flock, {100, 100, 500});
    const auto taylor = exponents_of(flock, {.transient = 100, .periods = 100, .method = Method::taylor});
    for (int i = 0; i < 4; ++i) EXPECT_NEAR(taylor.exponent[i], rk4.exponent[i], 1e-6);
}

TEST(Lyapunov, OfChaosIsPositiveAndItsHorizonThatOfADoublesRounding) {
    const auto found = exponents_of(published({1.15, 1.5}), {100, 500, 200});
    for (int i : {0, 1}) {
        EXPECT_GT(found.exponent[i], 10 * found.error[i]);
        EXPECT_EQ(found.horizon[i], 52 * std::log(2.0) / found.exponent[i]);
    }
}

TEST(Lyapunov, StandardErrorIsTheSpreadOverDifferentStarts) {
    Flock flock = published({1.5});
    constexpr int starts = 256;
    flock.theta = linspace(-1, 1, starts);
    const auto found = exponents_of(flock, {50, 1000, 100});
    double mean = 0, spread = 0, stated = 0;
    for (double x : found.exponent) mean += x / starts;
    for (double x : found.exponent) spread += (x - mean) * (x - mean) / (starts - 1);
    for (double x : found.error) stated += x * x / starts;
    EXPECT_NEAR(std::sqrt(stated / spread), 1,
                0.15);  // the spread is uncertain by 4.4 %, and blocks of 31 periods remember a little
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
    const auto found = exponents_of({.theta = {pi}, .alpha = {9.81}, .beta = {0.3}}, {0, 2, 100}, 2);
    const double expected = -0.15 + std::sqrt(0.15 * 0.15 + 9.81);
    EXPECT_NEAR(found.exponent[0], expected, 1e-15 * expected);
    EXPECT_EQ(found.history, (std::vector<double>{found.exponent[0], found.exponent[0]}));
    EXPECT_EQ(found.error[0], 0);
}

TEST(Lyapunov, IsKnownForDrivesSoSlowThatAPeriodShrinksDisplacementsOutOfRange) {
    for (const auto method : {Method::rk4, Method::taylor}) {
        const Flock flock{.theta = {0.1}, .beta = {1}, .drive_amplitude = {0.1}, .drive_frequency = {0.001}};
        EXPECT_NEAR(exponents_of(flock, {0, 2, 40000, method}).exponent[0], -0.5, 0.001);
    }
}

TEST(Lyapunov, IsKnownWhereAFewStepsGrowOutOfTheRangeOfSquares) {
    // Gravity turns round for half of a slow period; a coarse step then multiplies the displacement by up to 14.
    const Pendulum p{.pivot_amplitude = -10, .drive_frequency = 0.001};
    Flock flock{.theta = {0}, .drive_frequency = {0.001}};
    flock.pivot_amplitude = {-10};
    const Strobe coarse{.transient = 0, .periods = 2, .steps_per_period = fewest_steps(p)};
    const Strobe fine{.transient = 0, .periods = 2, .method = Method::taylor};
    const double exact_growth = exponents_of(flock, fine).exponent[0];
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
    EXPECT_NEAR(exponents_of(flock, coarse).exponent[0], growth, 0.001);  // the change of z within a step is left out
}

TEST(Lyapunov, HistoryEndsAtTheExponentAndFollowsThePeriods) {
    const auto flock = published({0.9, 1.15});
    const auto whole = exponents_of(flock, {10, 50, 100}, 7);
    EXPECT_EQ(whole.history[12], whole.exponent[0]);
    EXPECT_EQ(whole.history[13], whole.exponent[1]);
    const auto part = exponents_of(flock, {10, 21, 100});  // floor(3 50/7)
    EXPECT_EQ(whole.history[5], part.exponent[1]);
}

TEST(Lyapunov, HasNoErrorFromASinglePeriod) {
    const auto found = exponents_of(published({0.9}), {10, 1, 100});
    EXPECT_FALSE(std::isnan(found.exponent[0]));
    EXPECT_TRUE(std::isnan(found.error[0]));
}

}  // namespace
