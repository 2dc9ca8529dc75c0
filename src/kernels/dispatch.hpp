// The kernels of each instruction set, and the choice of one set at run time.
#pragma once

#include <cstddef>

#include "kernels/chunk.hpp"
#include "kernels/replay_chunk.hpp"
#include "pendula/exact.hpp"

namespace pendula::kernels {

/// The kernels of one instruction set. All sets give the same bits.
struct Kernels {
    const char* name;
    void (*exact)(const Exact& solution, std::size_t n, const double* t, double* theta, double* omega, double* turns);

    /// Integrates every member by `steps` steps of its own length h [s], from the time row_time + first h. `first` is a
    /// multiple of block_steps. rk4_tangent also integrates the displacements.
    void (*rk4)(Chunk& chunk, const Row& row_time, const Row& h, double first, int steps);
    void (*rk4_tangent)(Chunk& chunk, const Row& row_time, const Row& h, double first, int steps);

    /// Integrates every member by Taylor's method to its time t [s], which must not be before the start of its present step;
    /// the chunk then holds the states at these times. At most `most` steps are made for each pack. Returns false if a member
    /// needs more: the call must then be repeated. taylor_tangent also integrates the displacements.
    bool (*taylor)(Chunk& chunk, TaylorChunk& steps, const Row& t, int most);
    bool (*taylor_tangent)(Chunk& chunk, TaylorChunk& steps, const Row& t, int most);

    /// Makes `steps` steps of every program, of which `first` steps have been made. replay_single computes with floats; the
    /// numbers of its chunk are floats.
    void (*replay)(ReplayChunk& chunk, double first, int steps);
    void (*replay_single)(ReplayChunk& chunk, double first, int steps);
};

/// The kernels of the widest instruction set of this processor, or of the set that the environment variable PENDULA_ISA names
/// (baseline, avx2, avx512). The choice is made once.
const Kernels& dispatch() noexcept;

/// False if PENDULA_ISA is set and does not name an instruction set of this processor; an empty value names none.
bool is_choice_available() noexcept;

}  // namespace pendula::kernels
