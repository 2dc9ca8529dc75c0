// Ensembles of driven pendulums, and their measures as vectors.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include "pendula/validate.hpp"

namespace reference {

using namespace pendula;

/// Columns that an ensemble looks at; one value each until told otherwise.
struct Flock {
    std::vector<double> theta{0}, omega{0}, alpha{1}, beta{0}, torque{0}, drive_amplitude{0}, pivot_amplitude{0},
        drive_frequency{0}, drive_phase{0};

    std::size_t size() const {
        std::size_t most = 1;
        for (const auto* column :
             {&theta, &omega, &alpha, &beta, &torque, &drive_amplitude, &pivot_amplitude, &drive_frequency, &drive_phase})
            most = std::max(most, column->size());
        return most;
    }
    Ensemble ensemble() const {
        return {size(), theta, omega, alpha, beta, torque, drive_amplitude, pivot_amplitude, drive_frequency, drive_phase};
    }
};

/// Baker & Gollub, Chaotic Dynamics, CUP 1996: friction 1/2, frequency 2/3, start (0.2, 0).
inline Flock published(std::vector<double> amplitudes) {
    return {.theta = {0.2}, .beta = {0.5}, .drive_amplitude = std::move(amplitudes), .drive_frequency = {2.0 / 3}};
}

/// All columns of a measure, in its order.
inline std::vector<std::vector<double>> measured(Measure what, const Flock& flock, const Strobe& strobe,
                                                 const Control& control = {}) {
    std::vector<std::vector<double>> columns;
    std::vector<std::span<double>> results;
    for (const auto& column : measures[static_cast<std::size_t>(what)].columns)
        columns.emplace_back(rows_of(column, strobe) * flock.size());
    results.assign(columns.begin(), columns.end());
    const auto outcome = measure(what, flock.ensemble(), strobe, std::span<const std::span<double>>(results), control);
    EXPECT_TRUE(outcome.is_done()) << describe(outcome.refusal);
    return columns;
}

struct Orbits {
    std::vector<double> label, period, rotation, theta, omega;
};

inline Orbits orbits_of(const Flock& flock, const Strobe& strobe) {
    auto c = measured(Measure::attractors, flock, strobe);
    return {c[0], c[1], c[2], c[3], c[4]};
}

inline std::vector<double> velocities_of(const Flock& flock, const Strobe& strobe, const Control& control = {}) {
    return measured(Measure::mean_velocity, flock, strobe, control)[0];
}

struct Exponents {
    std::vector<double> exponent, error, horizon, history;
};

inline Exponents exponents_of(const Flock& flock, const Strobe& strobe, double rows = 0, const Control& control = {}) {
    Strobe with_rows = strobe;
    with_rows.history_rows = rows;
    auto c = measured(Measure::lyapunov, flock, with_rows, control);
    return {c[0], c[1], c[2], c[3]};
}

struct Points {
    std::vector<double> theta, omega, turns;
};

inline Points section_of(const Flock& flock, const Strobe& strobe, const Control& control = {}) {
    auto c = measured(Measure::section, flock, strobe, control);
    return {c[0], c[1], c[2]};
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
