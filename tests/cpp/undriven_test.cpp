// What becomes of pendulums without a drive: limit cycles against 20 digits, rest, and what the energy decides.
#include "flocks.hpp"
#include "pendula/angle.hpp"

namespace {

using namespace reference;

struct Cycle {
    double beta, torque, omega, velocity;
};

// Mean velocities from 30 digits: Newton's method on the return map of omega(theta), by its Taylor series of order 30 (mpmath).
// For friction from 100 on, the solution of omega omega' = torque - beta omega - sin(theta) as a trigonometric polynomial.
constexpr Cycle cycles[] = {
    {100, 1.5, 0, 0.011180339935244700858},     {300, 1.5, 0, 0.0037267799626961340678},
    {10, 1.01, 2.101, 0.014177621433098481763}, {0.2, 0.26, 3.3, 0.89329135549231817367},
    {0.1, 0.5, 3, 4.9959955911387178478},       {1, 1.1, 0, 0.79854801023519374395},
    {1, 1.001, 0, 0.53060098070107181517},      {1, 1.00001, 0, 0.52651465191689028571},
    {0.5, 0.8, 3, 1.4714852844334025184},       {2, 1.1, 0, 0.23414188452596217577},
    {5, 1.001, 0, 0.0089471221091912433735},    {1000, 1.5, 0, 0.0011180339887503723057},
};

TEST(Undriven, LimitCyclesHaveTheirVelocityWithinATinyError) {
    Flock flock{.omega = {}, .beta = {}, .torque = {}};
    for (const auto& c : cycles) {
        flock.omega.push_back(c.omega);
        flock.beta.push_back(c.beta);
        flock.torque.push_back(c.torque);
    }
    const auto found = velocity_of(flock, {});
    for (std::size_t i = 0; i < flock.size(); ++i) {
        const double v = cycles[i].velocity, error = found["error"][i];
        EXPECT_NEAR(found["mean_velocity"][i], v, error + 2 * 0x1p-52 * v) << cycles[i].beta;
        EXPECT_LT(error, 1e-9 * v) << cycles[i].beta;
        EXPECT_EQ(found.kind(i), Kind::rotating) << cycles[i].beta;
        EXPECT_EQ(found["theta"][i], 0);
    }
}

TEST(Undriven, LimitCyclesScaleWithTheSquareRootOfTheStiffness) {
    const auto v = velocity_of({.omega = {3, 6, 12}, .alpha = {1, 4, 16}, .beta = {0.1, 0.2, 0.4}, .torque = {0.5, 2, 8}},
                               {})["mean_velocity"];
    EXPECT_EQ(v[1], 2 * v[0]);  // powers of 2 round nothing
    EXPECT_EQ(v[2], 4 * v[0]);
}

TEST(Undriven, MirroredPendulumsHaveTheMirroredResults) {
    Flock flock{.theta = {0.5}, .omega = {}, .beta = {}, .torque = {}};
    for (double beta : {0.1, 1.0, 5.0})
        for (double torque : {0.3, 0.9, 1.0001, 2.0})
            for (double omega : {-8.0, 0.0, 3.0}) {
                flock.beta.push_back(beta);
                flock.torque.push_back(torque);
                flock.omega.push_back(omega);
            }
    auto mirrored = flock;
    for (auto* column : {&mirrored.theta, &mirrored.torque, &mirrored.omega})
        for (double& x : *column) x = -x;
    const auto one = velocity_of(flock, {}), other = velocity_of(mirrored, {});
    for (std::size_t i = 0; i < flock.size(); ++i) {
        for (const char* odd : {"mean_velocity", "theta", "omega"}) EXPECT_EQ(one[odd][i], -other[odd][i]) << odd << ' ' << i;
        for (const char* even : {"error", "kind"}) EXPECT_EQ(one[even][i], other[even][i]) << even << ' ' << i;
    }
}

TEST(Undriven, ThatComeToRestHaveNoVelocityAndTheEigenvaluesOfTheirEquilibrium) {
    // A focus and a node: the roots of s^2 + beta s + sqrt(alpha^2 - torque^2).
    const struct {
        double alpha, beta, torque, exponent;
    } cases[] = {{1, 0.1, 0, -0.05},
                 {4, 0.5, 2.4, -0.25},
                 {1, 3, 0, -1.5 + std::sqrt(2.25 - 1)},
                 {1, 3, 0.6, -1.5 + std::sqrt(2.25 - 0.8)},
                 {1, 3, -0.6, -1.5 + std::sqrt(2.25 - 0.8)},
                 {1, 100, 0.6, -0.00800064010242048459}};  // -50 + sqrt(2500 - 0.8), by mpmath
    for (const auto& c : cases) {
        const Flock flock{
            .theta = {0.4, -0.5}, .omega = {0.1, -0.2}, .alpha = {c.alpha}, .beta = {c.beta}, .torque = {c.torque}};
        const auto velocity = velocity_of(flock, {}), found = exponent_of(flock, {});
        for (int i : {0, 1}) {
            EXPECT_EQ(velocity["mean_velocity"][i], 0);
            EXPECT_EQ(velocity["error"][i], 0);
            EXPECT_EQ(velocity.kind(i), Kind::fixed_point);
            EXPECT_NEAR(velocity["theta"][i], std::asin(c.torque / c.alpha), 1e-15);
            EXPECT_NEAR(found["exponent"][i], c.exponent, found["error"][i] + 4e-16);  // roundings of the formula above
            EXPECT_LE(found["error"][i], 1e-14 * std::abs(c.exponent));
            EXPECT_EQ(found["second"][i], -c.beta - found["exponent"][i]);
            EXPECT_EQ(found["dimension"][i], 0);
        }
    }
}

TEST(Undriven, ExponentsWhereTwoEigenvaluesMeetAreWithinTheirErrors) {
    // -1 - x + sqrt(2 x + x^2) for friction 2 + 2 x.
    const Flock flock{.theta = {0.5}, .beta = {2, 2 + 0x1p-30, 2 - 0x1p-30, 2 + 0x1p-51}};
    const double x = 0x1p-31,
                 exponents[] = {-1, -1 - x + 0x1p-15 * (1 + 0x1p-33), -1 + x, -1 - 0x1p-52 + 0x1p-25 * std::sqrt(0.5)};
    const auto found = exponent_of(flock, {});
    for (int i : {0, 1, 2, 3}) {
        EXPECT_NEAR(found["exponent"][i], exponents[i], found["error"][i]) << i;
        EXPECT_LE(found["error"][i], 1e-7) << i;
    }
    EXPECT_LE(found["error"][1], 1e-10);
}

TEST(Undriven, LimitCyclesHaveTheExponents0AndMinusTheFriction) {
    const auto found = exponent_of({.omega = {3}, .beta = {0.1}, .torque = {0.5}}, {.history_rows = 2});
    EXPECT_EQ(found["exponent"][0], 0);
    EXPECT_EQ(found["error"][0], 0);
    EXPECT_EQ(found["second"][0], -0.1);
    EXPECT_EQ(found["dimension"][0], 1);
    EXPECT_EQ(found["horizon"][0], HUGE_VAL);
    EXPECT_EQ(found["history"], (std::vector<double>{0, 0}));
}

TEST(Undriven, FastRotationsOfHardlyAnyFrictionHaveTheVelocityOfTheirEnergyBalance) {
    const auto found = velocity_of({.omega = {100, -100}, .beta = {1e-3}, .torque = {0.1}}, {});
    // The energy of a turn: torque times the mean of omega is beta times the mean of omega^2, and omega varies by
    // cos(theta)/100.
    for (int i : {0, 1}) EXPECT_NEAR(found["mean_velocity"][i], 100 - 5e-7, found["error"][i] + 1e-10);
}

TEST(Undriven, JustAboveTheSaddleNodeTurnAsTheSquareRootLawSays) {
    const std::vector<double> above{1e-4, 1e-5, 1e-6, 1e-7};
    Flock flock{.beta = {5}, .torque = {}};
    for (double x : above) flock.torque.push_back(1 + x);
    const auto found = velocity_of(flock, {});
    for (std::size_t i = 0; i < above.size(); ++i) {
        // In the bottleneck beta theta' = torque - sin(theta): a passage takes 2 pi beta/sqrt(torque^2 - 1).
        const double law = std::sqrt(flock.torque[i] * flock.torque[i] - 1) / 5;
        EXPECT_NEAR(found["mean_velocity"][i] / law, 1, 0.03 * std::sqrt(above[i] / 1e-4)) << above[i];
    }
    // With less friction the limit cycle does not vanish at the saddle-node: by mpmath, as above.
    flock.beta = {1};
    flock.torque = {1 + 1e-5};
    EXPECT_NEAR(velocity_of(flock, {})["mean_velocity"][0], 0.52651465191689028571, 1e-10);
}

TEST(Undriven, VelocitiesThatTheBudgetDoesNotDecideAreWithinTheirError) {
    const struct {
        double beta, torque, omega, velocity;
    } cases[] = {
        {1, 1 + 1e-11, 0, 0.5264730447},    // it comes out of the bottleneck only after 1e6 s, and then rotates fast: as above
        {1, -1 - 1e-11, 0, -0.5264730447},  // mirrored
        {5, 1 + 1e-11, 0, 8.944e-7},        // sqrt(torque^2 - 1)/beta
        {0.001, 1.1, -1000, 1100},          // turns backward yet; torque/beta
        {10, 1.01, 2.101, 0.0141776},      {0.2, 0.26, 3.3, 0.893291},
    };
    for (const auto& c : cases)
        for (double budget : {1, 10, 100}) {
            const auto found = velocity_of({.omega = {c.omega}, .beta = {c.beta}, .torque = {c.torque}},
                                           {.transient = 0, .periods = 1, .budget = budget});
            EXPECT_NEAR(found["mean_velocity"][0], c.velocity, found["error"][0] + 1e-4 * std::abs(c.velocity)) << c.beta;
            if (std::abs(c.torque) > 1) {
                EXPECT_EQ(found.kind(0), Kind::rotating) << c.beta;
            }
        }
}

TEST(Undriven, WithoutFrictionTheEnergyDecidesWhetherATorqueAcceleratesThemForEver) {
    // The saddle of torque 0.5 is at 5 pi/6; from the bottom it takes omega^2/2 = 1 + sqrt(3)/2 - 5 pi/12 to reach it.
    const double limit = std::sqrt(2 + std::sqrt(3) - 5 * pi / 6);
    const Flock flock{.omega = {0, 0.99 * limit, 1.01 * limit, -0.99 * limit, -1.01 * limit, 0},
                      .torque = {0.5, 0.5, 0.5, 0.5, 0.5, 1.5}};
    for (double sign : {1.0, -1.0}) {
        auto mirrored = flock;
        for (auto* column : {&mirrored.omega, &mirrored.torque})
            for (double& x : *column) x *= sign;
        const auto velocity = velocity_of(mirrored, {}), found = exponent_of(mirrored, {});
        for (int i : {0, 1, 3}) {
            EXPECT_EQ(velocity["mean_velocity"][i], 0) << i;
            EXPECT_EQ(velocity["error"][i], 0) << i;
            EXPECT_EQ(velocity.kind(i), Kind::conservative) << i;
            EXPECT_EQ(found["exponent"][i], 0) << i;
        }
        for (int i : {2, 4, 5}) {
            EXPECT_TRUE(std::isnan(velocity["mean_velocity"][i])) << i;
            EXPECT_TRUE(std::isnan(velocity["error"][i])) << i;
            EXPECT_EQ(velocity.kind(i), Kind::unbounded) << i;
        }
    }
}

TEST(Undriven, ConservativeMotionsHaveTheVelocityAndTheExponentsOfTheClosedForm) {
    const Flock flock{.theta = {1, 0, 0, 0, 0, 0, pi}, .omega = {0, 3, -3, 4, -4, 0, 0}, .alpha = {1, 1, 1, 4, 4, 1, 4}};
    const auto velocity = velocity_of(flock, {}), found = exponent_of(flock, {});
    // With omega = 3 at the bottom: 3 pi/(2 K(k)), k = 2/3, by mpmath.
    const double rotation = 2.60400819053094028869642744872;
    const double velocities[] = {0, rotation, -rotation, 0, 0, 0, 0};
    const double exponents[] = {0, 0, 0, 2, 2, 0, 2};  // sqrt(alpha) on the separatrix and on top
    for (int i = 0; i < 7; ++i) {
        EXPECT_NEAR(velocity["mean_velocity"][i], velocities[i], velocity["error"][i]) << i;
        EXPECT_NEAR(found["exponent"][i], exponents[i], found["error"][i]) << i;
        EXPECT_LE(found["error"][i], 1e-14) << i;
        EXPECT_EQ(velocity.kind(i), i < 5 ? Kind::conservative : Kind::fixed_point) << i;
    }
}

TEST(Undriven, RestingOnTopStayThereWhateverTheFriction) {
    const Flock flock{.theta = {pi, -pi, 3 * pi}, .alpha = {4}, .beta = {3}};
    const auto velocity = velocity_of(flock, {}), found = exponent_of(flock, {});
    for (int i : {0, 1, 2}) {
        EXPECT_EQ(velocity["mean_velocity"][i], 0);
        EXPECT_EQ(velocity["error"][i], 0);
        EXPECT_EQ(velocity.kind(i), Kind::fixed_point);
        EXPECT_EQ(velocity["theta"][i], -pi);
        EXPECT_NEAR(found["exponent"][i], 1, found["error"][i]);  // the root of s^2 + 3 s - 4
    }
}

}  // namespace
