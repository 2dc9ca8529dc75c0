// Members of an ensemble on their way from strobe to strobe, and the driver of every measure.
#pragma once

#include "ensemble/members.hpp"
#include "pendula/measure.hpp"

namespace pendula {

/// A chunk of members at a strobe.
struct StrobedMembers : Members {
    kernels::Row frequency;   ///< of the strobe [rad/s]
    kernels::Row period;      ///< [s]
    kernels::Row root_alpha;  ///< unit of d omega beside d theta [s^-1]
    kernels::Row growth;  ///< ln of how much tangent vectors have grown; they themselves are kept at length 1
};

/// How members get to the next strobe, and on which thread.
struct Way {
    const Strobe& strobe;
    Thread& thread;
    bool has_tangent;
};

/// Loads members first, first + 1, ... at t = 0.
void load_strobed(StrobedMembers& members, const Ensemble& ensemble, std::size_t first) noexcept;

/// Takes members to the first strobe, without their tangent vectors. False when stopped, like all below.
bool go_to_first_strobe(StrobedMembers& members, const Way& way) noexcept;

bool go_to_next_strobe(StrobedMembers& members, const Way& way) noexcept;

/// One call of `measure`, as observers see it.
struct MeasureCall {
    const Ensemble& ensemble;
    const Strobe& strobe;
    std::span<const std::span<double>> columns;

    double& result(std::size_t column, std::size_t row, std::size_t member) const noexcept {
        return columns[column][row * ensemble.size + member];
    }
};

/// Runs an observer of every chunk of members, on several threads. An observer is made from the call and has
///     static constexpr bool has_tangent             whether tangent vectors are needed
///     bool start(StrobedMembers&)                   after the transient
///     bool at_strobe(const StrobedMembers&, done)   after each of the periods measured, `done` of them by now
///     void finish(const StrobedMembers&)            writes what is left to write
/// where false says that nothing more is to be seen.
template <class Observer>
Outcome observe(const MeasureCall& call, const Control& control) noexcept {
    const Strobe& strobe = call.strobe;
    const double units = static_cast<double>(call.ensemble.size) * (strobe.transient + strobe.periods);
    return for_each_piece(chunks_of(call.ensemble.size), units, control, [&](Thread& thread, std::size_t chunk) {
        const Way way{strobe, thread, Observer::has_tangent};
        StrobedMembers m;
        load_strobed(m, call.ensemble, chunk * kernels::chunk_size);
        if (!go_to_first_strobe(m, way)) return;
        const auto go_on = [&] {
            if (!go_to_next_strobe(m, way)) return false;
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

/// A part of a call, whose progress goes from one fraction of the whole to another. The control given has to outlive it.
inline Control part_of(const Control& control, double from, double to) noexcept {
    return {control.threads, [&control, from, to](double done) { return control.proceed(from + done * (to - from)); }};
}

Outcome measure_lyapunov(const MeasureCall& call, const Control& control) noexcept;
Outcome measure_attractors(const MeasureCall& call, const Control& control) noexcept;

}  // namespace pendula
