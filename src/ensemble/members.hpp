// Members of an ensemble as chunks: what solving and measuring share.
#pragma once

#include "ensemble/run.hpp"
#include "kernels/dispatch.hpp"

namespace pendula {

/// A chunk of members and which they are.
struct Members {
    kernels::Chunk chunk;
    std::size_t number[kernels::chunk_size];  ///< in the ensemble
};

/// Loads the members that `order` lists from place `first` on, or, without an order, members first, first + 1, ...
void load_members(Members& members, const Ensemble& ensemble, std::size_t first, const std::size_t* order = nullptr) noexcept;

/// Puts members that rest on top back where they rest, after a kernel has moved them like the others.
void hold_resting(kernels::Chunk& chunk) noexcept;

/// Leaves a member as it was before.
void keep_member(kernels::Chunk& now, const kernels::Chunk& before, int i) noexcept;

/// A chunk's run by Taylor's method until it is done or stopped: all members to their times.
bool taylor_to(kernels::Chunk& chunk, kernels::TaylorChunk& steps, const kernels::Row& t, bool has_tangent,
               Thread& thread) noexcept;

/// Takes members by Runge-Kutta over lengths of time [s] from their start times, by `steps` steps each; calls `between()` after
/// each group of at most `most` steps (a multiple of a block). False when stopped.
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

constexpr std::size_t chunks_of(std::size_t members) noexcept {
    return (members + kernels::chunk_size - 1) / kernels::chunk_size;
}

/// Why a call on an ensemble cannot be made, whatever its members are: PENDULA_ISA, control, lengths of columns.
Refusal check_call(const Ensemble& ensemble, const Control& control) noexcept;

/// Whether `name` is an array of `least` values or more.
Refusal check_length(std::span<const double> values, double least, const char* name) noexcept;

}  // namespace pendula
