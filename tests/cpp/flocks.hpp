// Ensembles of driven pendulums, and their measures as vectors.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <ostream>
#include <stdexcept>
#include <vector>

#include "pendula/validate.hpp"

namespace pendula {
inline void PrintTo(Kind kind, std::ostream* out) { *out << kind_names[static_cast<int>(kind)]; }
}  // namespace pendula

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

/// The results of a measure, by the names of its columns.
class Table {
  public:
    std::vector<std::vector<double>> columns;  ///< in the order of the measure

    explicit Table(Measure what)
        : columns(measures[static_cast<std::size_t>(what)].columns.size()), info_(&measures[static_cast<std::size_t>(what)]) {}

    const std::vector<double>& operator[](const char* name) const {
        for (std::size_t i = 0; i < columns.size(); ++i)
            if (std::strcmp(info_->columns[i].name, name) == 0) return columns[i];
        throw std::out_of_range(name);
    }
    Kind kind(std::size_t member) const { return static_cast<Kind>((*this)["kind"][member]); }

  private:
    const MeasureInfo* info_;
};

/// A table that run(ensemble, results) fills.
template <class Run>
Table filled(Measure what, const Flock& flock, const Strobe& strobe, const Run& run) {
    Table table(what);
    std::vector<std::span<double>> results;
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        table.columns[i].resize(rows_of(measures[static_cast<std::size_t>(what)].columns[i], strobe) * flock.size());
        results.emplace_back(table.columns[i]);
    }
    const Outcome outcome = run(flock.ensemble(), std::span<const std::span<double>>(results));
    EXPECT_TRUE(outcome.is_done()) << describe(outcome.refusal);
    return table;
}

inline Table measured(Measure what, const Flock& flock, const Strobe& strobe, const Control& control = {}) {
    return filled(what, flock, strobe,
                  [&](const Ensemble& e, const Results& r) { return measure(what, e, strobe, r, control); });
}

inline Table section_of(const Flock& flock, const Strobe& strobe, const Control& control = {}) {
    return measured(Measure::section, flock, strobe, control);
}
inline Table velocity_of(const Flock& flock, const Strobe& strobe, const Control& control = {}) {
    return measured(Measure::mean_velocity, flock, strobe, control);
}
inline Table exponent_of(const Flock& flock, const Strobe& strobe, const Control& control = {}) {
    return measured(Measure::lyapunov, flock, strobe, control);
}
inline Table attractors_of(const Flock& flock, const Strobe& strobe, const Control& control = {}) {
    return measured(Measure::attractors, flock, strobe, control);
}

/// Strobes that go on for the transient and the measured periods, and no more.
inline Strobe by_rk4(double transient, double periods, double steps) {
    return {.transient = transient,
            .periods = periods,
            .steps_per_period = steps,
            .method = Method::rk4,
            .budget = transient + periods};
}
inline Strobe by_taylor(double transient, double periods) {
    return {.transient = transient, .periods = periods, .budget = transient + periods};
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
inline bool same_bits(const Table& a, const Table& b) {
    return std::ranges::equal(a.columns, b.columns, [](const auto& one, const auto& other) { return same_bits(one, other); });
}

}  // namespace reference
