#include "pendula/pendulum.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "pendula/validate.hpp"
#include "reference_table.hpp"

namespace {

using namespace pendula;

TEST(Acceleration, SumsTheTermsOfTheEquation) {
    const Pendulum p{2, 0.25, 0.5, 0.75, 3, 0.1};
    const double want = -2 * std::sin(0.7) - 0.25 * 1.5 + 0.5 + 0.75 * std::cos(3 * 1.25 + 0.1);
    EXPECT_NEAR(acceleration(p, {0.7, 1.5}, 1.25), want, 8 * reference::ulp(2.0));  // eight roundings of terms below 2
    EXPECT_EQ(acceleration({}, {0, 5}, 100), 0);
}

TEST(Energy, KeepsItsDigitsWhereTheAngleIsSmall) {
    EXPECT_NEAR(energy(3, {1e-9, 0}), 1.5e-18, 3 * reference::ulp(1.5e-18));  // 1 - cos would give 0
    EXPECT_NEAR(energy(3, {0, 2}), 2, 0);
    EXPECT_NEAR(energy(3, {3.141592653589793, 0}), 6, reference::ulp(6.0));
}

TEST(Validate, NamesArgumentValueAndWhatIsLegal) {
    EXPECT_EQ(complaint("alpha", -1, Rule::positive), "alpha must be positive and finite, got -1");
    EXPECT_EQ(complaint("beta", -0.1, Rule::not_negative), "beta must be finite and not negative, got -0.1");
    try {
        validate(Pendulum{.alpha = 1, .beta = -0.1});
        FAIL();
    } catch (const std::invalid_argument& e) {
        EXPECT_EQ(std::string(e.what()), complaint("beta", -0.1, Rule::not_negative));
    }
}

TEST(Validate, RefusesEveryParameterOutsideItsInterval) {
    const double inf = HUGE_VAL, nan = std::nan("");
    const Pendulum bad[] = {{0, 0, 0, 0, 0, 0},  {-1, 0, 0, 0, 0, 0},  {nan, 0, 0, 0, 0, 0}, {inf, 0, 0, 0, 0, 0},
                            {1, -1, 0, 0, 0, 0}, {1, nan, 0, 0, 0, 0}, {1, 0, inf, 0, 0, 0}, {1, 0, 0, nan, 1, 0},
                            {1, 0, 0, 1, 0, 0},  {1, 0, 0, 1, -1, 0},  {1, 0, 0, 0, -1, 0},  {1, 0, 0, 1, 1, inf}};
    for (const auto& p : bad) EXPECT_THROW(validate(p), std::invalid_argument);
    EXPECT_NO_THROW(validate(Pendulum{}));
    EXPECT_NO_THROW(validate(Pendulum{1, 0.1, -1, -1, 2, 3}));
}

TEST(Validate, RefusesProblemsNoMethodCanDo) {
    Problem p;
    p.initial = {1, 0};
    p.schedule = {0.1, 11, 10, 0.01};
    EXPECT_NO_THROW(validate(p));
    const auto refused = [](Problem q, auto change) {
        change(q);
        EXPECT_THROW(validate(q), std::invalid_argument);
    };
    refused(p, [](Problem& q) { q.initial.theta = NAN; });
    refused(p, [](Problem& q) { q.initial.omega = HUGE_VAL; });
    refused(p, [](Problem& q) { q.schedule.step = 0; });
    refused(p, [](Problem& q) { q.schedule.rows = 0x1p54; });
    refused(p, [](Problem& q) { q.method = Method::exact, q.pendulum.beta = 0.1; });
    refused(p, [](Problem& q) { q.method = Method::exact, q.pendulum.torque = 0.1; });
    refused(p, [](Problem& q) { q.method = Method::verlet, q.pendulum.beta = 0.1; });
}

}  // namespace
