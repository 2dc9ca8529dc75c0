// The kernels of Taylor's method for chunks. Like kernels.cpp this file is compiled once for each instruction set. Each lane of
// a pack has its own steps and its own target time.
#include "kernels/dispatch.hpp"
#include "kernels/packs.hpp"
#include "kernels/taylor_kernel.hpp"

namespace pendula::kernels::inline PENDULA_ISA {

namespace {

// One register wide: the series of a wider pack would need more memory.
using T = Pack<register_width>;

/// The target times of the lanes. The target of a lane without a member is the start of its own step: it is reached at once,
/// and no other lane waits for it.
T target_times(const Chunk& chunk, const TaylorChunk& steps, const Row& t, int i) {
    T target = load<T>(t, i);
    for (int j = chunk.count - i; j < lanes<T>; ++j) lane(target, j) = steps.step.t[i + j];
    return target;
}

/// Advances the lanes that have not reached their targets by one step. The other lanes compute their present step again, with
/// the same result.
template <int order, bool has_tangent>
void next_step(const TaylorPendulum<T>& p, double log2_fraction, const Mask<T>& goes_on, TaylorStep<T>& step,
               TangentStep<T>& tangent) {
    if constexpr (has_tangent)
        tangent.start = choose(goes_on, tangent_at<order>(tangent, step.unit, step.length), tangent.start);
    step.start = choose(goes_on, motion_at<order>(step, step.length), step.start);
    const auto t = end_of(step.t, step.t_lo, step.length);
    step.t = select<T>(goes_on, t.hi, step.t);
    step.t_lo = select<T>(goes_on, t.lo, step.t_lo);
    Series<T> C;
    expand<order>(p, step, C);
    T log2 = log2_length_of<order, T>(step, log2_fraction);
    if constexpr (has_tangent) {
        expand_tangent<order>(p, step.unit, C, tangent);
        // If the motion hardly changes, its series would allow steps that are too long for the displacement.
        log2 = smaller(log2, log2_length<order>(log2_fraction, tangent.u[0], tangent.u));
    }
    set_length<order>(step, log2);
}

/// Integrates the members i, i + 1, ... of one pack to their target times by at most `most` steps, and stores their states
/// there in the chunk. Returns false if more steps are needed.
template <int order, bool has_tangent>
bool advance_pack(Chunk& chunk, TaylorChunk& steps, const Row& t, int most, int i) {
    const auto p = taylor_pendulum(load<T, Parameters>(chunk.parameters, i));
    const T target = target_times(chunk, steps, t, i);
    auto step = load<T, TaylorStep>(steps.step, i);
    TangentStep<T> tangent{};
    if constexpr (has_tangent) tangent = load<T, TangentStep>(steps.tangent, i);
    int taken = 0;
    auto goes_on = ends_before(step, target);
    for (; taken < most && any<T>(goes_on); ++taken) {
        next_step<order, has_tangent>(p, steps.log2_fraction, goes_on, step, tangent);
        stop_endless(step, target);
        goes_on = ends_before(step, target);
    }
    if (taken > 0) store<T, TaylorStep>(steps.step, i, step);
    const T since = (target - step.t) - step.t_lo;
    store<T, Motion>(chunk.motion, i, motion_at<order>(step, since));
    if constexpr (has_tangent) {
        store<T, TangentStep>(steps.tangent, i, tangent);
        store<T, Tangent>(chunk.tangent, i, tangent_at<order>(tangent, step.unit, since));
    }
    return !any<T>(goes_on);
}

template <bool has_tangent>
bool advance_chunk(Chunk& chunk, TaylorChunk& steps, const Row& t, int most) {
    return with_order(steps.order, [&](auto order) {
        bool all_there = true;
        for (int i = 0; i < chunk.count; i += lanes<T>)
            all_there &= advance_pack<order.value, has_tangent>(chunk, steps, t, most, i);
        return all_there;
    });
}

}  // namespace

bool taylor(Chunk& chunk, TaylorChunk& steps, const Row& t, int most) { return advance_chunk<false>(chunk, steps, t, most); }

bool taylor_tangent(Chunk& chunk, TaylorChunk& steps, const Row& t, int most) {
    return advance_chunk<true>(chunk, steps, t, most);
}

}  // namespace pendula::kernels::inline PENDULA_ISA
