// Members of an ensemble at successive strobe times, and the driver of every measure.
#pragma once

#include "ensemble/members.hpp"
#include "pendula/measure.hpp"

namespace pendula {

/// A chunk of members at a strobe time.
struct StrobedMembers : Members {
    kernels::Row frequency;               ///< of the strobe [rad/s]
    kernels::Row period;                  ///< of the strobe [s]
    kernels::Row root_alpha;              ///< sqrt(alpha), the unit of d omega in the length of a displacement [s^-1]
    kernels::Row growth;                  ///< the logarithm of the growth of the displacements, which are rescaled to length 1
    kernels::Row first;                   ///< the time of the first strobe [s]
    bool has_phase[kernels::chunk_size];  ///< drive_frequency is not 0, so that the strobe has a phase
};

/// How members are integrated to the next strobe time, and by which thread.
struct Propagation {
    const Strobe& strobe;
    Thread& thread;
    bool has_tangent;
};

/// Loads members first, first + 1, ... at t = 0.
void load_strobed(StrobedMembers& members, const Ensemble& ensemble, std::size_t first) noexcept;

/// Integrates members to the first strobe time, without their displacements. This function and the next return false if the
/// call was stopped.
bool integrate_to_first_strobe(StrobedMembers& members, const Propagation& run) noexcept;

/// Integrates members to the next strobe time, and their displacements if has_tangent is true.
bool integrate_to_next_strobe(StrobedMembers& members, const Propagation& run) noexcept;

/// The time of strobe number n of member i [s], to the last digit.
double time_of_strobe(const StrobedMembers& members, int i, double n) noexcept;

/// Replaces a member by another one of the chunk.
void move_member(StrobedMembers& members, int from, int to) noexcept;

/// The arguments of one call of `measure`.
struct MeasureCall {
    const Ensemble& ensemble;
    const Strobe& strobe;
    std::span<const std::span<double>> columns;

    double& result(std::size_t column, std::size_t row, std::size_t member) const noexcept {
        return columns[column][row * ensemble.size + member];
    }

    /// Whether a column is wanted: details may be left out.
    bool has(std::size_t column) const noexcept { return column < columns.size() && !columns[column].empty(); }

    void set(std::size_t column, std::size_t row, std::size_t member, double value) const noexcept {
        if (has(column)) result(column, row, member) = value;
    }

    /// Sets the first columns of a member, which have one row each.
    template <std::size_t n>
    void put(std::size_t member, const double (&values)[n]) const noexcept {
        for (std::size_t column = 0; column < n; ++column) set(column, 0, member, values[column]);
    }
};

/// Why a call of `measure` is refused, or no refusal.
Refusal check(Measure what, const MeasureCall& call, const Control& control) noexcept;

/// A control for a part of a call: its progress runs from one fraction of the whole call to another. The given control must
/// outlive it.
inline Control part_of(const Control& control, double from, double to) noexcept {
    return {control.threads, [&control, from, to](double done) { return control.proceed(from + done * (to - from)); }};
}

Outcome measure_section(const MeasureCall& call, const Control& control) noexcept;
Outcome measure_attractors(const MeasureCall& call, const Control& control) noexcept;

}  // namespace pendula
