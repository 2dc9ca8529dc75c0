// Ensembles of driven pendulums, and their measures as vectors.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include "pendula/measure.hpp"

namespace reference {

using namespace pendula;

/// Columns that an ensemble looks at; one value each until told otherwise.
struct Flock {
    std::vector<double> theta{0}, omega{0}, alpha{1}, beta{0}, torque{0}, drive_amplitude{0}, drive_frequency{0},
        drive_phase{0};

    std::size_t size() const {
        std::size_t most = 1;
        for (const auto* column : {&theta, &omega, &alpha, &beta, &torque, &drive_amplitude, &drive_frequency, &drive_phase})
            most = std::max(most, column->size());
        return most;
    }
    Ensemble ensemble() const {
        return {size(), theta, omega, alpha, beta, torque, drive_amplitude, drive_frequency, drive_phase};
    }
};

/// Baker & Gollub, Chaotic Dynamics, CUP 1996: friction 1/2, frequency 2/3, start (0.2, 0).
inline Flock published(std::vector<double> amplitudes) {
    return {.theta = {0.2}, .beta = {0.5}, .drive_amplitude = std::move(amplitudes), .drive_frequency = {2.0 / 3}};
}

struct Orbits {
    std::vector<double> period, rotation, theta, omega;
    OrbitValues values() { return {period.data(), rotation.data(), theta.data(), omega.data()}; }
};

inline Orbits orbits_of(const Flock& flock, const Strobe& strobe, double match = 1e-6) {
    const std::size_t n = flock.size();
    Orbits found{std::vector<double>(n), std::vector<double>(n), std::vector<double>(n), std::vector<double>(n)};
    EXPECT_TRUE(orbits(flock.ensemble(), strobe, match, {}, found.values()));
    return found;
}

inline std::vector<double> velocities_of(const Flock& flock, const Strobe& strobe, const Control& control = {}) {
    std::vector<double> velocity(flock.size());
    EXPECT_TRUE(mean_velocity(flock.ensemble(), strobe, control, velocity.data()));
    return velocity;
}

struct Exponents {
    std::vector<double> exponent, error, horizon, history;
};

inline Exponents exponents_of(const Flock& flock, const Strobe& strobe, std::size_t rows = 0, const Control& control = {}) {
    const std::size_t n = flock.size();
    Exponents found{std::vector<double>(n), std::vector<double>(n), std::vector<double>(n), std::vector<double>(rows * n)};
    EXPECT_TRUE(lyapunov(flock.ensemble(), strobe, control,
                         {found.exponent.data(), found.error.data(), found.horizon.data(), found.history.data(), rows}));
    return found;
}

struct Points {
    std::vector<double> theta, omega, turns;
};

inline Points section_of(const Flock& flock, const Strobe& strobe, const Control& control = {}) {
    const std::size_t n = flock.size() * static_cast<std::size_t>(strobe.periods);
    Points points{std::vector<double>(n), std::vector<double>(n), std::vector<double>(n)};
    EXPECT_TRUE(section(flock.ensemble(), strobe, control, {points.theta.data(), points.omega.data(), points.turns.data()}));
    return points;
}

inline std::vector<double> linspace(double first, double last, std::size_t n) {
    std::vector<double> values(n);
    for (std::size_t i = 0; i < n; ++i)
        values[i] = first + static_cast<double>(i) * ((last - first) / static_cast<double>(n - 1));
    return values;
}

inline bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

}  // namespace reference
