// Rounding errors of RK4 over a million steps against 57 digits, beside those of the formulas written plainly.
#pragma once

#include <cmath>
#include <vector>

#include "reference_table.hpp"
#include "trajectories.hpp"

namespace reference {

/// States of one method after some steps, from tests/data/steps.txt.
struct Checkpoint {
    double steps;
    Value theta, omega;
};

struct Stepped {
    std::string method;
    double alpha;
    pendula::State initial;
    double h;
    std::vector<Checkpoint> checkpoints;
    bool is_long() const { return checkpoints.back().steps > 1000; }
};

inline std::vector<Stepped> stepped() {
    std::vector<Stepped> all;
    for (const auto& row : table("steps.txt")) {
        if (row.words.at(0) == "problem")
            all.push_back({row.words.at(1), row[0], {row[1], row[2]}, row[3], {}});
        else
            all.back().checkpoints.push_back({row[0], row.value(1), row.value(3)});
    }
    return all;
}

/// (3.10) as a student writes it.
inline void plain_rk4(double alpha, double& theta, double& omega, double h) {
    const double xa = omega * h, wa = -alpha * std::sin(theta) * h;
    const double xb = (omega + wa / 2) * h, wb = -alpha * std::sin(theta + xa / 2) * h;
    const double xc = (omega + wb / 2) * h, wc = -alpha * std::sin(theta + xb / 2) * h;
    const double xd = (omega + wc) * h, wd = -alpha * std::sin(theta + xc) * h;
    theta += xa / 6 + xb / 3 + xc / 3 + xd / 6;
    omega += wa / 6 + wb / 3 + wc / 3 + wd / 6;
}

/// Largest distances in (theta, omega/sqrt(alpha)) at the checkpoints.
struct Rounding {
    double own, plain;
};

inline Rounding rounding_of(const Stepped& r) {
    Largest own, plain;
    double theta = r.initial.theta, omega = r.initial.omega, done = 0;
    const double root = std::sqrt(r.alpha);
    for (const auto& c : r.checkpoints) {
        for (; done < c.steps; ++done) plain_rk4(r.alpha, theta, omega, r.h);
        const auto s = after(pendula::Method::rk4, r.alpha, r.initial, r.h, c.steps);
        own(std::hypot(angle_error(s.theta, s.turns, c.theta, 0), error(s.omega, c.omega) / root));
        plain(std::hypot(error(theta, c.theta), error(omega, c.omega) / root));
    }
    return {own.value, plain.value};
}

}  // namespace reference
