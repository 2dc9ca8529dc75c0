#include "pendula/analysis.hpp"

#include <gtest/gtest.h>

#include "closed_form_errors.hpp"
#include "pendula/angle.hpp"

namespace {

using namespace pendula;
using reference::ulps;

constexpr double pi_rest = 0x1.1a62633145c07p-53;  // pi less the double nearest to it

std::string name(const reference::Case& c) {
    char text[200];
    std::snprintf(text, sizeof text, "%s alpha=%a theta=%a omega=%a", c.group.c_str(), c.alpha, c.initial.theta,
                  c.initial.omega);
    return text;
}

TEST(Analyze, TellsTheRegimeInEveryReferenceCase) {
    for (const auto& c : reference::closed_form())
        EXPECT_EQ(static_cast<int>(analyze(c.alpha, c.initial).regime), c.k) << name(c);
}

TEST(Analyze, IsWithin4UlpInEveryReferenceCase) {
    for (const auto& c : reference::closed_form()) {
        const auto a = analyze(c.alpha, c.initial);
        EXPECT_LE(ulps(a.theta_max, c.theta_max), 4) << name(c);
        EXPECT_LE(ulps(a.tau, c.tau), 4) << name(c);
    }
}

struct Named {
    double theta, omega;
    Regime regime;
    double theta_max, tau;  // tau = 0: any
};

// Where doubles only can be meant to be on the separatrix, they are.
TEST(Analyze, KnowsTheSpecialStates) {
    const double root2 = std::sqrt(2.0);
    const Named states[] = {
        {0, 0, Regime::oscillation, 0, 2 * pi},
        {pi, 0, Regime::separatrix, pi, 10},
        {-pi, 0, Regime::separatrix, pi, 10},
        {pi, -0.0, Regime::separatrix, pi, 10},
        {to_radians(180), 0, Regime::separatrix, pi, 10},
        {to_radians(540), 0, Regime::separatrix, pi, 10},
        {to_radians(-180 - 360 * 50), 0, Regime::separatrix, pi, 10},
        {to_radians(90), root2, Regime::separatrix, pi, 0},
        {to_radians(-90), -root2, Regime::separatrix, -pi, 0},
        {to_radians(120), 1, Regime::separatrix, pi, 0},
        {0, 2, Regime::separatrix, pi, 0},
        {0, -2, Regime::separatrix, -pi, 0},
        {3.14, 2 * std::cos(1.57), Regime::separatrix, pi, 10},
        {-3.14, -2 * std::cos(1.57), Regime::separatrix, -pi, 10},
        {0, 2 + 1e-14, Regime::rotation, pi, 0},
        {0, 2 - 1e-14, Regime::oscillation, 0, 0},
        {0, 1.999999895801368, Regime::oscillation, 0, 12 * pi},
        {pi, 1e-3, Regime::rotation, pi, 0},
        {3.14159, 0, Regime::oscillation, 3.14159, 0},
    };
    for (const auto& s : states) {
        const auto a = analyze(1, {s.theta, s.omega});
        EXPECT_EQ(a.regime, s.regime) << s.theta << ' ' << s.omega;
        if (s.regime != Regime::oscillation || s.omega == 0) {
            EXPECT_EQ(a.theta_max, s.theta_max) << s.theta << ' ' << s.omega;
        }
        // Figure 3.2's velocity is the assignment's, rounded to 16 digits for a period of six times 2 pi: six digits hold.
        if (s.tau != 0) {
            EXPECT_NEAR(a.tau, s.tau, 5e-6 * s.tau) << s.theta << ' ' << s.omega;
        }
    }
}

// Bits must agree: scaling by powers of two and reflection are exact.
TEST(Analyze, IsEvenInTheStateAndScalesWithAlpha) {
    for (const auto& c : reference::closed_form()) {
        if (c.k == 0 || c.group == "extreme" || c.group == "named" || c.group == "small") continue;
        const auto a = analyze(c.alpha, c.initial);
        const auto mirrored = analyze(c.alpha, {-c.initial.theta, -c.initial.omega});
        const auto faster = analyze(4 * c.alpha, {c.initial.theta, 2 * c.initial.omega});
        EXPECT_TRUE(a.theta_max == mirrored.theta_max && a.tau == mirrored.tau && a.regime == mirrored.regime) << name(c);
        EXPECT_TRUE(a.theta_max == faster.theta_max && a.tau == 2 * faster.tau && a.regime == faster.regime) << name(c);
    }
}

TEST(Analyze, GivesNaNOutsideItsDomain) {
    const double inf = HUGE_VAL, nan = std::nan("");
    const double bad[][3] = {{0, 1, 0},   {-1, 1, 0},  {inf, 1, 0},  {nan, 1, 0},
                             {1, inf, 0}, {1, nan, 0}, {1, 0, -inf}, {1, 0, nan}};
    for (const auto& b : bad) {
        const auto a = analyze(b[0], {b[1], b[2]});
        EXPECT_TRUE(std::isnan(a.theta_max) && std::isnan(a.tau)) << b[0] << ' ' << b[1] << ' ' << b[2];
        EXPECT_TRUE(std::isnan(series_terms(b[0], {b[1], b[2]}, 1e-7)));
    }
    for (double epsilon : {0.0, 1.0, -1.0, 2.0, nan}) EXPECT_TRUE(std::isnan(series_terms(1, {1, 0}, epsilon))) << epsilon;
}

TEST(AmplitudeOfPeriod, IsWithin2Ulp) {
    for (const auto& row : reference::table("amplitude.txt"))
        EXPECT_LE(ulps(amplitude_of_period(row[0], row[1]), row.value(2)), 2) << row[0] << ' ' << row[1];
}

TEST(AmplitudeOfPeriod, IsZeroForTheShortestPeriodAndPiForLongOnes) {
    EXPECT_EQ(amplitude_of_period(1, 2 * pi), 0);
    EXPECT_EQ(amplitude_of_period(4, pi), 0);
    for (double tau : {151.5, 1e3, 1e300}) EXPECT_EQ(amplitude_of_period(1, tau), pi) << tau;
    EXPECT_EQ(amplitude_of_period(1e300, 1e-140), pi);
}

TEST(AmplitudeOfPeriod, IsNaNOutsideItsDomain) {
    const double inf = HUGE_VAL, nan = std::nan("");
    const double bad[][2] = {{0, 7},  {-1, 7},   {inf, 7}, {nan, 7}, {1, 0},
                             {1, -7}, {1, 6.28}, {1, inf}, {1, nan}, {1, std::nextafter(2 * pi, 0)}};
    for (const auto& b : bad) EXPECT_TRUE(std::isnan(amplitude_of_period(b[0], b[1]))) << b[0] << ' ' << b[1];
}

TEST(CharacteristicTime, IsThePeriodOfTheMotionOfTheDriveOrOfSmallSwings) {
    const State initial{2, 0};
    EXPECT_EQ(characteristic_time({.alpha = 4}, initial), analyze(4, initial).tau);
    EXPECT_EQ(characteristic_time({.alpha = 4, .drive_frequency = 3}, initial), analyze(4, initial).tau);  // of no account
    for (const Pendulum& p : {Pendulum{.alpha = 4, .beta = 0.1}, Pendulum{.alpha = 4, .torque = 0.1}})
        EXPECT_LE(ulps(characteristic_time(p, initial), {pi, pi_rest}), 4);
    for (const Pendulum& p :
         {Pendulum{.drive_amplitude = 1, .drive_frequency = 0.5}, Pendulum{.pivot_amplitude = 1, .drive_frequency = 0.5},
          Pendulum{.beta = 1, .drive_amplitude = 1, .pivot_amplitude = 1, .drive_frequency = 0.5}})
        EXPECT_LE(ulps(characteristic_time(p, initial), {4 * pi, 4 * pi_rest}), 4);
}

TEST(RestsOnTop, HoldsWithFrictionAndAShakenPivotButNotWithAForce) {
    const State top{pi, 0};
    for (const Pendulum& p : {Pendulum{}, Pendulum{.beta = 1}, Pendulum{.pivot_amplitude = 5, .drive_frequency = 9}})
        EXPECT_TRUE(rests_on_top(p, top));
    for (const Pendulum& p : {Pendulum{.torque = 1e-9}, Pendulum{.drive_amplitude = 1e-9, .drive_frequency = 1}})
        EXPECT_FALSE(rests_on_top(p, top));
    EXPECT_FALSE(rests_on_top({}, {pi, 1e-9}));
    EXPECT_FALSE(rests_on_top({}, {0, 0}));
}

TEST(Series, AsksForTheTermsOfTheCut) {
    for (const auto& row : reference::table("series.txt")) {
        const auto want = row.value(4);
        const double got = series_terms(row[0], {row[1], row[2]}, row[3]);
        // The quotient is known to some 16 ulp; where that reaches a whole number, either neighbour is right.
        const double slack = 16 * reference::ulp(want.hi);
        EXPECT_GE(got, std::ceil(want.hi - slack)) << row[1] << ' ' << row[2];
        EXPECT_LE(got, std::ceil(want.hi + slack)) << row[1] << ' ' << row[2];
    }
    EXPECT_EQ(series_terms(1, {0, 2}, 1e-7), 0);
}

TEST(Series, AgreesWithTheMeanToItsEpsilon) {
    for (const auto& c : reference::closed_form()) {
        if (c.k == 0 || c.group == "extreme") continue;
        for (double epsilon : {1e-3, 1e-7, 1e-12}) {
            const double terms = series_terms(c.alpha, c.initial, epsilon);
            if (terms > 2e4) continue;
            Analysis a;
            ASSERT_TRUE(analyze_by_series(c.alpha, c.initial, epsilon, a).is_done());
            // n additions and three roundings a term.
            EXPECT_NEAR(a.tau, c.tau.hi, (epsilon + (terms * 4 + 8) * 1.2e-16) * c.tau.hi) << name(c);
        }
    }
}

TEST(Series, RefusesMoreThanABillionTerms) {
    const State upright{3.14159265, 0};
    EXPECT_GT(series_terms(1, upright, 1e-7), series_terms_limit);
    Analysis a;
    const auto outcome = analyze_by_series(1, upright, 1e-7, a);
    EXPECT_EQ(outcome.kind, Outcome::Kind::refused);
    EXPECT_EQ(outcome.refusal.reason, Refusal::Reason::too_many_terms);
    EXPECT_EQ(a.tau, 0);  // nothing was done
}

}  // namespace
