// Errors of analysis and closed form over tests/data/closed_form.txt and late.txt, shared by the tests and by measure_errors.
#pragma once

#include <algorithm>
#include <vector>

#include "pendula/exact.hpp"
#include "reference_table.hpp"

namespace reference {

struct Instant {
    double t;
    Value theta, omega;
    double turns;
};

struct Case {
    std::string group;
    double alpha;
    pendula::State initial;
    int k;
    Value theta_max, tau;
    std::vector<Instant> instants;

    double largest_omega() const {  // 2 sqrt(alpha kappa), without the square of a large velocity
        return std::max(std::hypot(initial.omega, 2 * std::sqrt(alpha) * std::sin(initial.theta / 2)), 5e-324);
    }
    /// Small oscillations are measured against their amplitude.
    double scale() const { return std::min(1.0, std::fabs(theta_max.hi) > 0 ? std::fabs(theta_max.hi) : 1.0); }
};

inline std::vector<Case> closed_form(const char* file = "closed_form.txt") {
    std::vector<Case> cases;
    for (const Row& row : table(file)) {
        if (row.words.at(0) == "case")
            cases.push_back(
                {row.words.at(1), row[0], {row[1], row[2]}, static_cast<int>(row[3]), row.value(4), row.value(6), {}});
        else
            cases.back().instants.push_back({row[0], row.value(1), row.value(3), row[5]});
    }
    return cases;
}

/// An angle's error where -pi and pi, both allowed, are one.
inline double theta_error(const pendula::Sample& s, const Instant& want) {
    return angle_error(s.theta, s.turns, want.theta, want.turns);
}

/// Errors at one instant, of theta over the scale of the motion and of omega over its maximum.
struct Relative {
    double theta, omega;
    double largest() const { return std::max(theta, omega); }
};

inline Relative error_at(const Case& c, const pendula::Exact& solution, const Instant& instant) {
    const auto s = pendula::at(solution, instant.t);
    return {theta_error(s, instant) / c.scale(), error(s.omega, instant.omega) / c.largest_omega()};
}

/// The error that `at` states for omega on the separatrix. It decays as exp(-|zeta|), so that an error of zeta is a relative
/// error of omega. A denormal omega is rounded to whole units of 2^-1074 besides.
inline double stated_tail_error(const Case& c, const Instant& i) {
    const double sense = c.initial.omega < 0 ? -1 : 1;
    const double start = std::asinh(std::tan(c.initial.theta / 2));
    const double zeta = std::fabs(start + sense * std::sqrt(c.alpha) * i.t);
    return (4 + 3 * zeta + 6 * std::fabs(start)) * 0x1p-53 * std::fabs(i.omega.hi) + 0x1p-1074;
}

inline bool is_late(const Case& c, const Instant& i) { return std::fabs(i.t) > 31 * c.tau.hi; }

}  // namespace reference
