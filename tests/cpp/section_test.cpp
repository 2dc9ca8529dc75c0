// Sections: by the strobe at any phase of the drive, and by planes of theta and omega.
#include "flocks.hpp"
#include "pendula/analysis.hpp"
#include "pendula/angle.hpp"

namespace {

using namespace reference;

constexpr double half_pi = pi / 2;

/// x'' = -x'/2 - sin x + 1.1 sin(t/2) from (0.1, 0): the drive is a cosine with phase -pi/2.
Flock sine_driven() {
    return {.theta = {0.1}, .beta = {0.5}, .drive_amplitude = {1.1}, .drive_frequency = {0.5}, .drive_phase = {-half_pi}};
}

struct Section {
    std::vector<double> theta, omega, turns, t;

    Sample operator[](std::size_t i) const { return {t[i], theta[i], omega[i], turns[i]}; }
};

Section section(const Flock& flock, const Strobe& strobe, const Control& control = {}) {
    const auto c = measured(Measure::section, flock, strobe, control).columns;
    return {c[0], c[1], c[2], c[3]};
}

/// The states at t = 4 pi n, n = 0 to 3, by mpmath's odefun with 40 digits. The first one after the start is the published
/// (0.9918, -1.6428).
TEST(SectionByTheStrobe, AtThePhaseOfASineIsThePublishedOne) {
    const double want[][2] = {{0.1, 0},
                              {-5.2913901630042987785, -1.6428109520462349242},
                              {-12.358747167534102575, -1.7748034066470253181},
                              {-7.0603424255335559784, 0.57833692562976695152}};
    const auto points = section(sine_driven(), {.transient = 0, .periods = 4, .phase = -half_pi});
    for (std::size_t n = 0; n < 4; ++n) {
        EXPECT_NEAR(unwrapped(points[n]), want[n][0], 1e-13) << n;
        EXPECT_NEAR(points.omega[n], want[n][1], 1e-13) << n;
    }
    EXPECT_NEAR(points.theta[1], 0.9918, 5e-5);
    EXPECT_NEAR(points.omega[1], -1.6428, 5e-5);
}

TEST(SectionByTheStrobe, HasTimesThatAreProducts) {
    Flock flock{.theta = {0.1}, .beta = {0.2}, .drive_amplitude = {0.3}, .drive_frequency = {0.7}, .drive_phase = {0.4}};
    for (double phase : {0.4, -1.0, 3.0, 0.3}) {
        const auto points = section(flock, {.transient = 1000, .periods = 3, .method = Method::rk4, .phase = phase});
        const long double turn = 2 * std::acos(-1.0L), ahead = std::fmod(phase - 0.4L + 2 * turn, turn);
        for (std::size_t i = 0; i < 3; ++i) {
            const long double want = (turn * (1000 + static_cast<long double>(i)) + ahead) / 0.7L;
            EXPECT_NEAR(points.t[i], static_cast<double>(want), 2 * (std::nextafter(1e4, 2e4) - 1e4)) << phase;
        }
    }
}

TEST(SectionByTheStrobe, OfAPendulumWithoutAFrequencyBeginsAtTheStartAtAnyPhase) {
    for (double phase : {0.0, 1.0, -2.0}) {
        const auto points =
            section({.theta = {1}, .alpha = {4}, .drive_phase = {0.5}}, {.transient = 0, .periods = 3, .phase = phase});
        EXPECT_EQ(points.theta[0], 1);
        for (std::size_t i = 0; i < 3; ++i) EXPECT_DOUBLE_EQ(points.t[i], static_cast<double>(i) * pi);
    }
}

/// The crossings of theta = 1 (mod 2 pi) and of omega = -1/2 by mpmath's odefun with 30 digits: t, and omega or theta.
constexpr double through_theta[][2] = {{3.00145830343787147, 0.580012753442882812}, {7.02998526817545997, -1.11055334221460191},
                                       {12.5613760770088316, -1.64271487934530043}, {16.0839625020287408, 1.1448461620844497},
                                       {20.7667784065545546, -1.73550966107071607}, {24.7067638108439009, -1.88709910643706758},
                                       {28.4209259788642556, 1.32994600632344502}};
constexpr double through_omega[][2] = {{6.20745852260645351, 1.66259616594553057},
                                       {13.8417210899430537, -6.87073374385786671},
                                       {19.5290118405499549, -3.91836768949550799},
                                       {26.1057176881250895, -13.5362875570134155}};

// 1e-13 is the error of Taylor's method there; the least rate of change is 0.58.
TEST(SectionByAPlane, OfThetaIsThatOfMpmath) {
    const auto points = section(sine_driven(), {.transient = 0, .periods = 7, .plane = Plane::theta, .level = 1});
    for (std::size_t i = 0; i < 7; ++i) {
        EXPECT_NEAR(points.t[i], through_theta[i][0], 3e-13) << i;
        EXPECT_NEAR(points.omega[i], through_theta[i][1], 3e-13) << i;
        EXPECT_NEAR(points.theta[i], 1, 1e-15);
    }
    EXPECT_EQ(points.turns[2], -1);
    EXPECT_EQ(points.turns[5], -2);
}

TEST(SectionByAPlane, OfOmegaIsThatOfMpmath) {
    const auto points = section(sine_driven(), {.transient = 0, .periods = 4, .plane = Plane::omega, .level = -0.5});
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_NEAR(points.t[i], through_omega[i][0], 3e-13) << i;
        EXPECT_NEAR(unwrapped(points[i]), through_omega[i][1], 3e-13) << i;
        EXPECT_NEAR(points.omega[i], -0.5, 1e-15);
    }
}

TEST(SectionByAPlane, BeginsAfterTheTransientAndKeepsToItsDirection) {
    const auto later = section(sine_driven(), {.transient = 1,  // up to t = 4 pi
                                               .periods = 4,
                                               .plane = Plane::theta,
                                               .level = 1});
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(later.t[i], through_theta[i + 3][0], 1e-12) << i;
    const auto falling = section(
        sine_driven(), {.transient = 0, .periods = 4, .plane = Plane::theta, .level = 1, .direction = Direction::falling});
    const std::size_t falls[] = {1, 2, 4, 5};
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(falling.t[i], through_theta[falls[i]][0], 1e-12) << i;
    const auto rising = section(
        sine_driven(), {.transient = 0, .periods = 2, .plane = Plane::omega, .level = -0.5, .direction = Direction::rising});
    EXPECT_NEAR(rising.t[1], through_omega[3][0], 1e-12);
}

TEST(SectionByAPlane, OfAFreePendulumComesEachPeriod) {
    const double tau = analyze(1, {2, 0}).tau;
    const auto points =
        section({.theta = {2}}, {.transient = 0, .periods = 20, .plane = Plane::theta, .direction = Direction::rising});
    for (std::size_t i = 0; i < 20; ++i)
        EXPECT_NEAR(points.t[i], (0.75 + static_cast<double>(i)) * tau, 1e-13 * static_cast<double>(i + 1));
}

/// Members of every kind, among them one at rest on top, one that comes to rest, and one whose motion leaves the doubles.
Flock mixed() {
    Flock f{.theta = {}, .omega = {}, .beta = {}, .torque = {}, .drive_amplitude = {}, .drive_frequency = {0.5}};
    for (int i = 0; i < 70; ++i) {
        f.theta.push_back(i == 3 ? pi : 0.1 * i - 3);
        f.omega.push_back(i == 3 ? 0 : 0.03 * i);
        f.beta.push_back(i % 2 == 0 ? 0.3 : 0);
        f.torque.push_back(i == 5 ? 1e308 : i % 5 == 1 ? 0.2 : 0);
        f.drive_amplitude.push_back(i == 3 || i % 3 == 1 ? 0 : 0.8);
    }
    return f;
}

TEST(SectionByAPlane, HasTheSameBitsForAnyNumberOfThreadsAndAlone) {
    const Strobe strobe{.transient = 3, .periods = 5, .budget = 30, .phase = 0.3, .plane = Plane::theta, .level = 0.1};
    const Flock flock = mixed();
    const auto one = measured(Measure::section, flock, strobe, {.threads = 1});
    const auto three = measured(Measure::section, flock, strobe, {.threads = 3});
    const auto same = [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); };
    EXPECT_TRUE(same_bits(one, three));
    for (std::size_t i = 0; i < flock.size(); i += 7) {
        const Flock alone{.theta = {flock.theta[i]},
                          .omega = {flock.omega[i]},
                          .beta = {flock.beta[i]},
                          .torque = {flock.torque[i]},
                          .drive_amplitude = {flock.drive_amplitude[i]},
                          .drive_frequency = {0.5}};
        const auto points = section(alone, strobe);
        for (std::size_t row = 0; row < 5; ++row) EXPECT_TRUE(same(points.t[row], one["t"][row * flock.size() + i])) << i;
    }
}

TEST(SectionByAPlane, IsNaNWhereNoCrossingComesWithinTheBudget) {
    const Strobe strobe{.transient = 2, .periods = 40, .budget = 10, .plane = Plane::theta};
    const Flock flock = mixed();
    const auto points = section(flock, strobe);
    const double end = 12 * 4 * pi;  // of transient and budget
    for (std::size_t i = 0; i < flock.size(); ++i) {
        bool is_over = false;
        for (std::size_t row = 0; row < 40; ++row) {
            const double t = points.t[row * flock.size() + i];
            EXPECT_FALSE(is_over && !std::isnan(t));
            EXPECT_FALSE(t > end);
            is_over = std::isnan(t);
        }
        EXPECT_TRUE(std::isnan(points.t[i]) || (i != 3 && i != 5));
    }
    // Every half period of 7.42 s from a start at rest at 90 degrees.
    const auto free = section({.theta = {half_pi}}, {.transient = 0, .periods = 40, .budget = 2, .plane = Plane::theta});
    EXPECT_EQ(std::count_if(free.t.begin(), free.t.end(), [](double t) { return !std::isnan(t); }), 3);  // in 12.57 s
}

TEST(SectionByAPlane, IsRefusedWhereItCannotBeHad) {
    std::vector<double> rows(4);
    const auto refused = [&](const Strobe& strobe) {
        return std::string(measure(Measure::section, sine_driven().ensemble(), strobe, {rows, rows, rows, rows}).refusal.name);
    };
    EXPECT_EQ(refused({.periods = 4, .method = Method::rk4, .plane = Plane::theta}), "method");
    EXPECT_EQ(refused({.periods = 4, .plane = static_cast<Plane>(3)}), "plane");
    EXPECT_EQ(refused({.periods = 4, .plane = Plane::omega, .direction = static_cast<Direction>(-1)}), "direction");
    EXPECT_EQ(refused({.periods = 4, .plane = Plane::omega, .level = std::nan("")}), "level");
}

TEST(SectionByAPlane, StopsWhenTheCallerStopsIt) {
    std::vector<double> rows(100);
    const auto outcome =
        measure(Measure::section, sine_driven().ensemble(), {.budget = 1e12, .plane = Plane::omega, .level = 50},
                {rows, rows, rows, rows}, {.proceed = [](double) { return false; }});
    EXPECT_EQ(outcome.kind, Outcome::Kind::stopped);
}

}  // namespace
