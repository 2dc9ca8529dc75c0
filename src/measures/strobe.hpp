// Members of an ensemble at successive strobe times, and the driver of every measure.
#pragma once

#include "ensemble/members.hpp"
#include "pendula/measure.hpp"

namespace pendula {

/// A chunk of members at a strobe time.
struct StrobedMembers : Members {
    kernels::Row frequency;   ///< of the strobe [rad/s]
    kernels::Row period;      ///< of the strobe [s]
    kernels::Row root_alpha;  ///< sqrt(alpha), the unit of d omega in the length of a displacement [s^-1]
    kernels::Row growth;      ///< the logarithm of the growth of the displacements, which are rescaled to length 1
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

/// The arguments of one call of `measure`.
struct MeasureCall {
    const Ensemble& ensemble;
    const Strobe& strobe;
    std::span<const std::span<double>> columns;

    double& result(std::size_t column, std::size_t row, std::size_t member) const noexcept {
        return columns[column][row * ensemble.size + member];
    }
};

/// Why a call of `measure` is refused, or no refusal.
Refusal check(Measure what, const MeasureCall& call, const Control& control) noexcept;

/// Runs one observer for every chunk of members, on several threads. An observer is constructed from the call and has
///     static constexpr bool has_tangent             whether displacements are integrated
///     bool start(StrobedMembers&)                   called after the transient
///     bool at_strobe(const StrobedMembers&, done)   called after each measured period; `done` is their number so far
///     void finish(const StrobedMembers&)            called at the end; writes the remaining results
/// If start or at_strobe returns false, the remaining periods are skipped.
template <class Observer>
Outcome observe(const MeasureCall& call, const Control& control) noexcept {
    const Strobe& strobe = call.strobe;
    const double units = static_cast<double>(call.ensemble.size) * (strobe.transient + strobe.periods);
    return for_each_piece(chunks_of(call.ensemble.size), units, control, [&](Thread& thread, std::size_t chunk) {
        const Propagation run{strobe, thread, Observer::has_tangent};
        StrobedMembers m;
        load_strobed(m, call.ensemble, chunk * kernels::chunk_size);
        if (!integrate_to_first_strobe(m, run)) return;
        const auto go_on = [&] {
            if (!integrate_to_next_strobe(m, run)) return false;
            thread.report(m.chunk.count);
            return true;
        };
        for (double done = 0; done < strobe.transient; ++done)
            if (!go_on()) return;
        Observer observer(call);
        double done = 0;
        for (bool goes_on = observer.start(m); goes_on && done < strobe.periods;) {
            if (!go_on()) return;
            goes_on = observer.at_strobe(m, ++done);
        }
        thread.report(m.chunk.count * (strobe.periods - done));
        observer.finish(m);
    });
}

/// A control for a part of a call: its progress runs from one fraction of the whole call to another. The given control must
/// outlive it.
inline Control part_of(const Control& control, double from, double to) noexcept {
    return {control.threads, [&control, from, to](double done) { return control.proceed(from + done * (to - from)); }};
}

Outcome measure_lyapunov(const MeasureCall& call, const Control& control) noexcept;
Outcome measure_attractors(const MeasureCall& call, const Control& control) noexcept;

}  // namespace pendula
