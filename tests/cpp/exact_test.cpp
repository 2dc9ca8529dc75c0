#include "pendula/exact.hpp"

#include <gtest/gtest.h>

#include <cstring>

#include "closed_form_errors.hpp"
#include "pendula/angle.hpp"

namespace {

using namespace pendula;
using reference::closed_form;
using reference::error_at;
using reference::is_late;

std::string name(const reference::Case& c, double t) {
    char text[220];
    std::snprintf(text, sizeof text, "%s alpha=%a theta=%a omega=%a t=%a", c.group.c_str(), c.alpha, c.initial.theta,
                  c.initial.omega, t);
    return text;
}

/// The angle between two samples, turns counted.
double between(const Sample& a, const Sample& b) { return reference::angle_error(a.theta, a.turns, {b.theta, 0}, b.turns); }

TEST(Exact, IsWithin1em14To30Tau) {
    for (const auto& c : closed_form()) {
        const auto solution = make_exact(c.alpha, c.initial);
        for (const auto& i : c.instants)
            if (!is_late(c, i)) {
                EXPECT_LE(error_at(c, solution, i).largest(), 1e-14) << name(c, i.t);
            }
    }
}

TEST(Exact, IsWithin1em13To1e6Tau) {
    for (const auto& c : closed_form()) {
        const auto solution = make_exact(c.alpha, c.initial);
        for (const auto& i : c.instants)
            if (is_late(c, i)) {
                EXPECT_LE(error_at(c, solution, i).largest(), 1e-13) << name(c, i.t);
            }
    }
}

/// The rows of a group of late.txt, with the solution of each.
template <class Visit>
void for_each_late(const char* group, Visit visit) {
    for (const auto& c : closed_form("late.txt")) {
        if (c.group != group) continue;
        const auto solution = make_exact(c.alpha, c.initial);
        for (const auto& i : c.instants) visit(c, solution, i);
    }
}

TEST(Exact, IsWithin1em13To2To52TauAwayFromTheSeparatrix) {
    for_each_late("clear", [](const auto& c, const auto& solution, const auto& i) {
        EXPECT_LE(error_at(c, solution, i).largest(), 1e-13) << name(c, i.t);
    });
}

// A phase that is off by 2^-41 of a period moves the angle by at most 8K 2^-41 = 7e-11, since K < 20. Where the latest time is
// 2^20 tau it may be off by 2^-102 2^20 (1 + x) periods with x < 2^47.2, which is some 1e-9.
TEST(Exact, IsWithin1em9ToItsLatestTimeNearTheSeparatrix) {
    for_each_late("near", [](const auto& c, const auto& solution, const auto& i) {
        EXPECT_LE(error_at(c, solution, i).largest(), 1e-9) << name(c, i.t);
    });
}

TEST(Exact, DecaysOnTheSeparatrixDownTo0) {
    for_each_late("separatrix", [](const auto& c, const auto& solution, const auto& i) {
        const Sample s = at(solution, i.t);
        EXPECT_LE(reference::theta_error(s, i), 1e-14) << name(c, i.t);
        EXPECT_LE(reference::error(s.omega, i.omega), reference::stated_tail_error(c, i)) << name(c, i.t);
    });
}

TEST(Exact, HasAnAnswerToItsLatestTimeAndNaNBeyond) {
    const double factors[] = {1, -1};
    for (const char* table : {"closed_form.txt", "late.txt"})
        for (const auto& c : closed_form(table)) {
            const auto solution = make_exact(c.alpha, c.initial);
            const double latest = latest_time(solution);
            if (c.k == 0) {
                EXPECT_EQ(latest, std::numeric_limits<double>::max()) << name(c, latest);
            } else {
                EXPECT_GE(latest, 0x1p20 * solution.analysis.tau) << name(c, latest);
                EXPECT_LE(latest, 0x1p52 * solution.analysis.tau) << name(c, latest);
            }
            for (double sign : factors) {
                const Sample last = at(solution, sign * latest), beyond = at(solution, sign * std::nextafter(latest, HUGE_VAL));
                EXPECT_TRUE(last.theta >= -pi && last.theta < pi) << name(c, latest);
                EXPECT_LE(std::fabs(last.omega), c.largest_omega() * (1 + 1e-14)) << name(c, latest);
                EXPECT_TRUE(std::isnan(beyond.theta) && std::isnan(beyond.omega)) << name(c, latest);
            }
        }
}

TEST(Exact, StaysInTheInterval) {
    for (const auto& c : closed_form()) {
        const auto solution = make_exact(c.alpha, c.initial);
        for (const auto& i : c.instants) {
            const double theta = at(solution, i.t).theta;
            EXPECT_TRUE(theta >= -pi && theta < pi) << name(c, i.t);
        }
    }
}

/// All NaNs are one.
bool have_same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0 || (std::isnan(a) && std::isnan(b)); }

TEST(Exact, GivesTheSameBitsForManySamplesAsForOne) {
    for (const auto& c : closed_form()) {
        const auto solution = make_exact(c.alpha, c.initial);
        double t[37], theta[37], omega[37], turns[37];
        // Ordinary and late times side by side, and some beyond the latest.
        for (int i = 0; i < 37; ++i) t[i] = c.tau.hi * (0.37 * i * i - 100) * (i % 5 == 2 ? 0x1p30 : i % 9 == 4 ? 0x1p46 : 1);
        for (std::size_t n : {std::size_t{1}, std::size_t{5}, std::size_t{37}}) {
            at(solution, n, t, theta, omega, turns);
            for (std::size_t i = 0; i < n; ++i) {
                const Sample one = at(solution, t[i]), many{t[i], theta[i], omega[i], turns[i]};
                for (auto member : {&Sample::theta, &Sample::omega, &Sample::turns}) {
                    ASSERT_TRUE(have_same_bits(one.*member, many.*member)) << name(c, t[i]);
                }
            }
        }
    }
}

// The bound of theta and omega, 1e-14 of the scale each, on both sides.
TEST(Exact, IsOddAndReversible) {
    for (const auto& c : closed_form()) {
        if (c.initial.omega == 0 && c.k == 0) continue;  // at rest on top both stay, on their own side
        const auto solution = make_exact(c.alpha, c.initial);
        const auto mirrored = make_exact(c.alpha, {-c.initial.theta, -c.initial.omega});
        const auto reversed = make_exact(c.alpha, {c.initial.theta, -c.initial.omega});
        for (const auto& i : c.instants) {
            if (is_late(c, i)) continue;
            const Sample s = at(solution, i.t), m = at(mirrored, i.t), r = at(reversed, -i.t);
            EXPECT_LE(between(s, {i.t, -m.theta, -m.omega, -m.turns}), 2e-14 * c.scale()) << name(c, i.t);
            EXPECT_LE(std::fabs(s.omega + m.omega), 2e-14 * c.largest_omega()) << name(c, i.t);
            EXPECT_LE(between(s, r), 2e-14 * c.scale()) << name(c, i.t);
            EXPECT_LE(std::fabs(s.omega + r.omega), 2e-14 * c.largest_omega()) << name(c, i.t);
        }
    }
}

TEST(Exact, ConservesEnergy) {
    for (const auto& c : closed_form()) {
        const double largest = c.largest_omega();
        if (!(largest < 1e150 && largest > 1e-140)) continue;  // squares overflow, or lose bits
        const auto solution = make_exact(c.alpha, c.initial);
        for (const auto& i : c.instants) {
            if (is_late(c, i)) continue;
            const auto s = at(solution, i.t);
            // dE = alpha sin(theta) dtheta + omega domega, errors of 1e-14 of the scale; E itself rounds a few times.
            const double bound = 1.2e-14 * (c.alpha * c.scale() * c.scale() + largest * largest);
            EXPECT_NEAR(energy(c.alpha, {s.theta, s.omega}), largest * largest / 2, bound) << name(c, i.t);
        }
    }
}

TEST(Exact, IsPeriodic) {
    for (const auto& c : closed_form()) {
        if (c.k == 0) continue;
        const auto solution = make_exact(c.alpha, c.initial);
        const double t = 0.3 * c.tau.hi;
        const Sample s = at(solution, t);
        Sample later = at(solution, t + c.tau.hi);
        if (c.k == 1) later.turns -= c.initial.omega > 0 ? 1 : -1;
        // tau and the sum of times are within half an ulp of 1.3 tau; the rest is the bound of theta twice.
        const double slack = 2 * reference::ulp(c.tau.hi) * c.largest_omega();
        EXPECT_LE(between(s, later), 2e-14 * c.scale() + slack) << name(c, t);
    }
}

TEST(Exact, StartsWhereItIsPut) {
    for (const auto& c : closed_form()) {
        const Sample s = at(make_exact(c.alpha, c.initial), 0);
        const Angle start = split_turns(c.initial.theta);
        EXPECT_LE(between(s, {0, start.theta, 0, start.turns}), 1e-14 * c.scale() + reference::ulp(start.theta)) << name(c, 0);
        if (c.k != 0) {
            EXPECT_NEAR(s.omega, c.initial.omega, 1e-14 * c.largest_omega()) << name(c, 0);
        }
    }
}

TEST(Exact, StaysOnTopForEver) {
    const auto rising = make_exact(1, {0, -2});
    for (double t : {50.0, 1e3, 1e10, 1e300}) {
        EXPECT_EQ(at(rising, t).theta, -pi);
        EXPECT_EQ(at(rising, t).turns, 0);
        EXPECT_EQ(at(rising, -t).theta, 0x1.921fb54442d17p+1);  // the last double below pi
        EXPECT_EQ(at(rising, t).omega == 0, t > 800);
    }
    // Here t rate_lo, by itself, would overflow.
    EXPECT_EQ(at(make_exact(0x1p1000, {0, 0x1p501}), 1e308).omega, 0);
    for (double theta : {pi, -pi, 3 * pi})
        for (double t : {0.0, 1e3, -1e9}) {
            const Sample s = at(make_exact(1, {theta, 0}), t);
            const Angle start = split_turns(theta);
            EXPECT_LE(between(s, {0, start.theta, 0, start.turns}), reference::ulp(theta)) << theta << ' ' << t;
            EXPECT_EQ(s.omega, 0);
        }
}

TEST(Exact, RestsAtTheBottom) {
    for (double t : {0.0, 1.0, -1e6}) {
        const Sample s = at(make_exact(9.8, {0, 0}), t);
        EXPECT_EQ(s.theta, 0);
        EXPECT_EQ(s.omega, 0);
        EXPECT_EQ(sinusoid(make_exact(9.8, {0, 0}), t), 0);
    }
}

TEST(Exact, IsASinusoidWhereItIsSmall) {
    for (double amplitude : {1e-5, 1e-9, 1e-100}) {
        const auto solution = make_exact(4, {amplitude, 0});
        for (double t : {0.3, 1.0, 2.2, 17.0}) {
            // The next term is amplitude^2/16 of the phase; 1e-14 is the bound of the closed form.
            const double slack = amplitude * (2e-14 + amplitude * amplitude * (1 + t));
            EXPECT_NEAR(at(solution, t).theta, amplitude * std::cos(2 * t), slack);
            EXPECT_NEAR(sinusoid(solution, t), amplitude * std::cos(2 * t), slack);
        }
        for (double t : {1e7, -3e11, 1e15}) {  // the period is that of the amplitude: only the third harmonic is left out
            const double slack = amplitude * (2e-13 + amplitude * amplitude);
            EXPECT_NEAR(sinusoid(solution, t), at(solution, t).theta, slack);
        }
        EXPECT_TRUE(std::isnan(sinusoid(solution, 2 * latest_time(solution))));
    }
}

TEST(Sinusoid, HasTheStatesAngleAndDirectionAtZero) {
    for (const auto& c : closed_form()) {
        const auto solution = make_exact(c.alpha, c.initial);
        if (c.k != -1) {
            EXPECT_TRUE(std::isnan(sinusoid(solution, 0.1 * c.tau.hi)));
            continue;
        }
        const double amplitude = c.theta_max.hi, start = wrap(c.initial.theta), step = 1e-3 * c.tau.hi;
        if (amplitude == 0) continue;
        // phi0 near +-pi/2 knows theta0 only to sqrt(ulp) squared: a few ulp of the amplitude.
        EXPECT_NEAR(sinusoid(solution, 0), start, 8 * reference::ulp(amplitude)) << name(c, 0);
        if (std::fabs(start) < 0.9 * amplitude) {
            EXPECT_EQ(sinusoid(solution, step) > sinusoid(solution, -step), c.initial.omega >= 0) << name(c, 0);
        }
    }
}

TEST(Exact, GivesNaNOutsideItsDomain) {
    const double bad[][3] = {{0, 1, 0}, {-1, 1, 0}, {HUGE_VAL, 1, 0}, {1, NAN, 0}, {1, 0, HUGE_VAL}};
    for (const auto& b : bad) {
        const Sample s = at(make_exact(b[0], {b[1], b[2]}), 1);
        EXPECT_TRUE(std::isnan(s.theta) && std::isnan(s.omega)) << b[0] << ' ' << b[1] << ' ' << b[2];
    }
}

}  // namespace
