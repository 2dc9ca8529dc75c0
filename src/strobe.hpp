// Members of an ensemble on their way from strobe to strobe: what every measure is made from.
#pragma once

#include "flock.hpp"
#include "pendula/measure.hpp"

namespace pendula {

struct Strobed {
    kernels::Chunk chunk;
    double frequency[kernels::chunk_size];   ///< of the strobe [rad/s]
    double period[kernels::chunk_size];      ///< [s]
    double root_alpha[kernels::chunk_size];  ///< unit of d omega beside d theta [s^-1]
    double growth[kernels::chunk_size];  ///< ln of how much tangent vectors have grown; they themselves are kept at length 1
};

/// How and for whom a chunk is on its way.
struct Way {
    const Strobe& strobe;
    Progress& progress;
    bool is_caller;
    bool has_tangent;
};

/// Loads members as `load` of a chunk does, at t = 0. A drive without a frequency makes NaN.
void load(Strobed& members, const Ensemble& ensemble, std::size_t first) noexcept;

/// Takes members to the first strobe, without their tangent vectors. False when stopped, like all below.
bool go_to_first_strobe(Strobed& members, const Way& way) noexcept;

bool go_to_next_strobe(Strobed& members, const Way& way) noexcept;

/// To the strobe after the transient.
bool go_through_transient(Strobed& members, const Way& way) noexcept;

/// Calls measure(progress, first, is_caller) for the first member of every chunk, on several threads, and returns whether
/// all ran to the end.
template <class Measure>
bool for_each_chunk(const Ensemble& ensemble, const Strobe& strobe, const Control& control, const Measure& measure) noexcept {
    Progress progress(control, static_cast<double>(ensemble.size) * (strobe.transient + strobe.periods));
    struct Call {
        Progress& progress;
        const Measure& measure;
    } call{progress, measure};
    const auto work = [](void* context, std::size_t piece, bool is_caller) {
        const auto& c = *static_cast<const Call*>(context);
        if (c.progress.proceeds(is_caller)) c.measure(c.progress, piece * kernels::chunk_size, is_caller);
    };
    for_each_piece(chunks_of(ensemble.size), control.threads, progress, work, &call);
    return progress.proceeds(true);
}

}  // namespace pendula
