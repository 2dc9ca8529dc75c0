#include "pendula/angle.hpp"

#include <gtest/gtest.h>

#include "pendula/pendulum.hpp"
#include "stated_errors.hpp"

namespace {

using namespace pendula;
using reference::table;

TEST(Angles, StayWithinTheirStatedErrors) {
    for (const auto& f : reference::angle_errors()) EXPECT_LE(f.measured, f.stated) << f.name << ", " << f.domain;
}

TEST(Wrap, StaysInTheIntervalForEveryDouble) {
    for (const auto& row : table("angle.txt", "wrap")) {
        const double got = wrap(row[0]);
        EXPECT_TRUE(got >= -pi && got < pi) << row[0];
    }
}

TEST(Wrap, KeepsItsFixedPoints) {
    EXPECT_EQ(wrap(-pi), -pi);
    EXPECT_EQ(wrap(pi), -pi);
    EXPECT_EQ(wrap(std::nextafter(pi, 0)), std::nextafter(pi, 0));
    EXPECT_TRUE(std::signbit(wrap(-0.0)));
    EXPECT_EQ(wrap(5e-324), 5e-324);
    for (double x : {static_cast<double>(NAN), HUGE_VAL, -HUGE_VAL}) EXPECT_TRUE(std::isnan(wrap(x)));
}

TEST(Wrap, IsIdempotent) {
    for (const auto& row : table("angle.txt", "wrap")) EXPECT_EQ(wrap(wrap(row[0])), wrap(row[0])) << row[0];
}

TEST(SplitTurns, CountsExactlyUpTo1e15) {
    for (const auto& row : table("angle.txt", "wrap")) {
        if (std::fabs(row[0]) > 1e15) continue;
        const Angle got = split_turns(row[0]);
        EXPECT_EQ(got.theta, wrap(row[0]));
        // A turn more belongs to -pi given for pi.
        EXPECT_LE(reference::angle_error(got.theta, got.turns, row.value(1), row[3]), reference::ulp(pi)) << row[0];
    }
}

TEST(SplitTurns, IsUndoneByUnwrapped) {
    for (const auto& row : table("angle.txt", "wrap")) {
        if (std::fabs(row[0]) > 1e15) continue;
        const Angle a = split_turns(row[0]);
        // 1 ulp of theta, at most 4.4e-16, and the rounding of the sum.
        EXPECT_NEAR(unwrapped({0, a.theta, 0, a.turns}), row[0], 4.5e-16 + reference::ulp(row[0])) << row[0];
    }
}

TEST(ToRadians, TakesHalfTurnsToPi) {
    EXPECT_EQ(to_radians(180), pi);
    EXPECT_EQ(to_radians(-90), -pi / 2);
    EXPECT_TRUE(std::isnan(to_radians(NAN)));
}

TEST(Phase, CountsZeroAsPositiveAndStopsAtOne) {
    EXPECT_EQ(phase(0.5, 0.0), phase(0.5, 1.0));
    EXPECT_EQ(phase(0.5, -0.0), phase(0.5, 1.0));
    for (double r : {-1.0, 0.0, 1.0})
        for (double s : {1.0, 1.5, HUGE_VAL}) {
            EXPECT_EQ(phase(s, r), pi / 2);
            EXPECT_EQ(phase(-s, r), -pi / 2);
        }
    EXPECT_TRUE(std::isnan(phase(NAN, 1)));
}

}  // namespace
