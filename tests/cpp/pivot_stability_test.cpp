// A vertically shaken pivot: the stability of the upright and of the hanging state against Floquet theory.
#include "flocks.hpp"
#include "pendula/pendula.hpp"
#include "reference_table.hpp"

namespace {

using namespace reference;

/// Members at rest, and their exponents.
struct Resting : Flock {
    Resting() { theta.clear(), alpha.clear(), beta.clear(), pivot_amplitude.clear(), drive_frequency.clear(); }

    void add(double angle, double stiffness, double friction, double amplitude, double rate) {
        theta.push_back(angle);
        alpha.push_back(stiffness);
        beta.push_back(friction);
        pivot_amplitude.push_back(amplitude);
        drive_frequency.push_back(rate);
    }

    static constexpr double periods = 1000;

    Table exponents(Method method) const { return exponent_of(*this, {.method = method}); }
};

/// Exponents of what rests at an angle are those of Floquet's theory.
void expect_exponents_of_floquet(const std::string& kind, double theta, Method method) {
    Resting members;
    const auto rows = table("pivot_stability.txt", kind.c_str());
    for (const Row& r : rows) members.add(theta, r[0], r[1], r[2], r[3]);
    ASSERT_GE(rows.size(), 4u);
    const auto found = members.exponents(method);
    // Of rk4 h^4/120 of the rate of a displacement, where h is 1/1000 of a period and of up to 9/2 radians.
    const double slack = method == Method::taylor ? 0 : 1e-9;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        EXPECT_NEAR(found["exponent"][i], rows[i][4], found["error"][i] + slack) << kind << ' ' << i;
        EXPECT_LE(found["error"][i], 1e-9) << kind << ' ' << i;
        EXPECT_EQ(found.kind(i), Kind::fixed_point) << kind << ' ' << i;
    }
}

TEST(ShakenPivot, ExponentsAtTheBottomAreThoseOfFloquet) {
    expect_exponents_of_floquet("hanging", 0, Method::rk4);
    expect_exponents_of_floquet("hanging", 0, Method::taylor);
}

TEST(ShakenPivot, ExponentsOnTopAreThoseOfFloquet) {
    expect_exponents_of_floquet("top", pi, Method::rk4);
    expect_exponents_of_floquet("top", pi, Method::taylor);
}

TEST(ShakenPivot, TheHangingStateIsUnstableInMathieusTongue) {
    for (Method method : {Method::rk4, Method::taylor}) {
        Resting members;
        std::vector<double> signs;
        for (const Row& r : table("pivot_stability.txt", "tongue")) {
            for (double departure : {-0.001, 0.001}) {
                members.add(0, r[0], r[1], r[2], r[3] * (1 + departure));
                signs.push_back(departure);
                members.add(0, r[0], r[1], r[2], r[5] * (1 + departure));
                signs.push_back(-departure);
            }
        }
        const auto found = members.exponents(method);
        for (std::size_t i = 0; i < signs.size(); ++i) {
            if (signs[i] > 0) {
                EXPECT_GT(found["exponent"][i], 1e-3) << i;
            } else if (members.beta[i] > 0) {
                EXPECT_LT(found["exponent"][i], -1e-3) << i;
            } else {
                // A displacement that turns on an ellipse, whose axes are as 1 to 10 so near to the boundary.
                EXPECT_LT(std::fabs(found["exponent"][i]),
                          std::log(10.0) / (Resting::periods * 2 * pi / members.drive_frequency[i]))
                    << i;
            }
        }
    }
}

TEST(ShakenPivot, FrictionClosesMathieusTongueBelowAThreshold) {
    const auto rows = table("pivot_stability.txt", "threshold");
    ASSERT_EQ(rows.size(), 1u);
    const Row& r = rows[0];
    Resting members;
    for (double factor : {0.999, 1.001}) members.add(0, r[0], r[1], r[2] * factor, r[4]);
    const auto found = members.exponents(Method::taylor);
    // Near the threshold the exponent is (P - threshold)/4 to first order.
    EXPECT_NEAR(found["exponent"][0], -0.001 * r[2] / 4, 1e-7);
    EXPECT_NEAR(found["exponent"][1], 0.001 * r[2] / 4, 1e-7);
}

/// The largest departure from the top in 100 units of time of one that starts with 1e-6.
double departure_from_top(double alpha, double beta, double pivot, double frequency) {
    auto run =
        make_taylor({.alpha = alpha, .beta = beta, .pivot_amplitude = pivot, .drive_frequency = frequency}, {pi - 1e-6, 0});
    Largest largest;
    for (const double end = 100 / std::sqrt(alpha); !reaches(run, end); step(run))
        largest(std::fabs(wrap(run.step.start.theta - pi)));
    return largest.value;
}

TEST(ShakenPivot, HoldsThePendulumUpBetweenTwoAmplitudes) {
    for (const Row& r : table("pivot_stability.txt", "upright")) {
        const auto departure = [&](double pivot) { return departure_from_top(r[0], r[1], pivot, r[2]); };
        const double lowest = r[3], highest = r[5];
        // Within 1 % of the limits a departure that does not die beats, by a factor of 1.4 at the lowest and of 13 at the
        // highest; one that grows does so by at least e^(0.14 - beta/2) a unit of time.
        EXPECT_LE(departure(1.01 * lowest), 2e-6) << r[2];
        EXPECT_GE(departure(0.99 * lowest), 0.05) << r[2];
        EXPECT_LE(departure(0.99 * highest), 2e-5) << r[2];
        EXPECT_GE(departure(1.01 * highest), 0.05) << r[2];
    }
}

}  // namespace
