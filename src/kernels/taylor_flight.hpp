// A pack of a chunk on its way by Taylor's method, each lane by steps of its own to a time of its own.
#pragma once

#include "kernels/taylor_chunk.hpp"
#include "kernels/taylor_kernel.hpp"

namespace pendula::kernels::inline PENDULA_ISA {

static_assert(taylor_coefficients == taylor_order_limit + 1);

template <class T>
inline T load_pack(const double* x) {
    T pack;
    __builtin_memcpy(&pack, x, sizeof pack);
    return pack;
}

template <class T>
inline void store_pack(double* x, const T& pack) {
    __builtin_memcpy(x, &pack, sizeof pack);
}

template <class T>
inline void load_series(Series<T>& series, const double (&from)[taylor_coefficients][chunk_size], int first) {
    for (int k = 0; k < taylor_coefficients; ++k) series[k] = load_pack<T>(from[k] + first);
}

template <class T>
inline void store_series(double (&to)[taylor_coefficients][chunk_size], int first, const Series<T>& series) {
    for (int k = 0; k < taylor_coefficients; ++k) store_pack(to[k] + first, series[k]);
}

template <class T>
inline TaylorStep<T> load_step(const TaylorChunk& c, int i) {
    const auto from = [i](const double* x) { return load_pack<T>(x + i); };
    TaylorStep<T> step{{from(c.theta), from(c.omega), from(c.turns), from(c.theta_lo), from(c.omega_lo)},
                       {from(c.t), from(c.t_lo)},
                       from(c.unit),
                       from(c.length),
                       {},
                       from(c.series_1_lo)};
    load_series(step.v, c.series, i);
    return step;
}

template <class T>
inline void store_step(TaylorChunk& c, int i, const TaylorStep<T>& step) {
    store_pack(c.t + i, step.t.hi);
    store_pack(c.t_lo + i, step.t.lo);
    store_pack(c.length + i, step.length);
    store_pack(c.unit + i, step.unit);
    store_pack(c.theta + i, step.start.theta);
    store_pack(c.omega + i, step.start.omega);
    store_pack(c.turns + i, step.start.turns);
    store_pack(c.theta_lo + i, step.start.theta_lo);
    store_pack(c.omega_lo + i, step.start.omega_lo);
    store_pack(c.series_1_lo + i, step.v1_lo);
    store_series(c.series, i, step.v);
}

/// The lanes' times of the padding are those that it is at, so that none waits for it.
template <class T>
inline T goals(const Chunk& chunk, const TaylorChunk& steps, const double* t, int i) {
    T goal = load_pack<T>(t + i);
    for (int j = chunk.count - i; j < lanes<T>; ++j) lane(goal, j) = steps.t[i + j];
    return goal;
}

/// The lanes that have not come to their goals go on by a step; the others expand the step that they are at once more.
template <bool has_tangent, class T>
inline void next_step(const TaylorPendulum<T>& p, TaylorReach reach, const Mask<T>& goes_on, TaylorStep<T>& step,
                      TangentStep<T>& tangent) {
    const Motion<T> end = motion_at(step, step.length);
    const auto t = step.t + step.length;
    if constexpr (has_tangent) tangent.start = choose(goes_on, tangent_at(tangent, step.unit, step.length), tangent.start);
    step.start = choose(goes_on, end, step.start);
    step.t = {select<T>(goes_on, t.hi, step.t.hi), select<T>(goes_on, t.lo, step.t.lo)};
    Series<T> C;
    expand(p, reach, step, C);
    if constexpr (has_tangent) expand_tangent(p, reach.order, step.unit, C, tangent);
}

/// Takes the pack at i to times t by at most so many steps, and then puts its state there into the chunk. False when they did
/// not do.
template <bool has_tangent, class T>
inline bool fly(Chunk& chunk, TaylorChunk& steps, const double* t, int most, int i) {
    const auto from = [i](const double* x) { return load_pack<T>(x + i); };
    const auto p = taylor_pendulum(from(chunk.alpha), from(chunk.beta), from(chunk.torque), from(chunk.drive_amplitude),
                                   from(chunk.drive_frequency), from(chunk.drive_phase));
    const TaylorReach reach{steps.order, steps.log2_fraction};
    const T goal = goals<T>(chunk, steps, t, i);
    auto step = load_step<T>(steps, i);
    TangentStep<T> tangent{};
    if constexpr (has_tangent) {
        tangent.start = {from(steps.tangent_theta), from(steps.tangent_omega)};
        load_series(tangent.u, steps.tangent_series, i);
    }
    int taken = 0;
    auto goes_on = ends_before(step, goal);
    for (; taken < most && any<T>(goes_on); ++taken) {
        next_step<has_tangent>(p, reach, goes_on, step, tangent);
        give_up_endless(step, goal);
        goes_on = ends_before(step, goal);
    }
    if (taken > 0) store_step(steps, i, step);
    const T since = (goal - step.t.hi) - step.t.lo;
    const auto m = motion_at(step, since);
    store_pack(chunk.theta + i, m.theta);
    store_pack(chunk.omega + i, m.omega);
    store_pack(chunk.turns + i, m.turns);
    store_pack(chunk.theta_lo + i, m.theta_lo);
    store_pack(chunk.omega_lo + i, m.omega_lo);
    if constexpr (has_tangent) {
        store_pack(steps.tangent_theta + i, tangent.start.theta);
        store_pack(steps.tangent_omega + i, tangent.start.omega);
        store_series(steps.tangent_series, i, tangent.u);
        const auto d = tangent_at(tangent, step.unit, since);
        store_pack(chunk.tangent_theta + i, d.theta);
        store_pack(chunk.tangent_omega + i, d.omega);
    }
    return !any<T>(goes_on);
}

}  // namespace pendula::kernels::inline PENDULA_ISA
