// Members of an ensemble in chunks, for `solve` and `measure`.
#pragma once

#include "ensemble/run.hpp"
#include "kernels/dispatch.hpp"

namespace pendula {

/// A chunk of members, and their numbers in the ensemble.
struct Members {
    kernels::Chunk chunk;
    std::size_t number[kernels::chunk_size];
};

/// Loads a chunk: the members order[first], order[first + 1], ..., or the members first, first + 1, ... if there is no order.
void load_members(Members& members, const Ensemble& ensemble, std::size_t first, const std::size_t* order = nullptr) noexcept;

/// Restores the states of members that rest at the top, after a kernel has integrated them like the others.
void restore_resting(kernels::Chunk& chunk) noexcept;

/// Copies the motion and the displacement of member i of a chunk to place j of another, or of the same one.
void copy_motion(const kernels::Chunk& from, int i, kernels::Chunk& to, int j) noexcept;

/// Integrates all members of a chunk to their times t [s] by Taylor's method. Returns false if the call was stopped.
bool taylor_to(kernels::Chunk& chunk, kernels::TaylorChunk& steps, const kernels::Row& t, bool has_tangent,
               Thread& thread) noexcept;

/// Integrates members by the Runge-Kutta method from their start times [s] over their lengths of time [s], by `steps` steps
/// each. Calls `between()` after every `most` steps (a multiple of block_steps) and at the end. Returns false if the call was
/// stopped.
template <class Between>
bool rk4_over(kernels::Chunk& chunk, const kernels::Row& start, const kernels::Row& length, double steps, bool has_tangent,
              int most, Thread& thread, const Between& between) noexcept {
    const auto advance = has_tangent ? kernels::dispatch().rk4_tangent : kernels::dispatch().rk4;
    kernels::Row h;
    for (int i = 0; i < kernels::chunk_size; ++i) h[i] = length[i] / steps;
    for (double done = 0; done < steps; done += most) {
        if (!thread.goes_on()) return false;
        const double left = steps - done;
        advance(chunk, start, h, done, left < most ? static_cast<int>(left) : most);
        between();
    }
    return true;
}

/// The number of chunks for this many members.
constexpr std::size_t chunks_of(std::size_t members) noexcept {
    return (members + kernels::chunk_size - 1) / kernels::chunk_size;
}

/// Refuses a call with an illegal PENDULA_ISA or control, or with a column of the wrong length. Does not check the members.
Refusal check_call(const Ensemble& ensemble, const Control& control) noexcept;

/// Refuses an array that is null or has fewer than `least` values. `name` is its name.
Refusal check_length(std::span<const double> values, double least, const char* name) noexcept;

}  // namespace pendula
