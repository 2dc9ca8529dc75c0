// The kernels of each instruction set, and the choice among them at run time.
#pragma once

#include <cstddef>

#include "kernels/chunk.hpp"
#include "kernels/taylor_chunk.hpp"
#include "pendula/exact.hpp"

namespace pendula::kernels {

/// What one instruction set offers; every set gives the same bits.
struct Kernels {
    const char* name;
    void (*exact)(const Exact& solution, std::size_t n, const double* t, double* theta, double* omega, double* turns);

    /// Steps of every member, of its own length h, from the time row_time + first h. `first` is a whole number of blocks. The
    /// second moves tangent vectors as well.
    void (*rk4)(Chunk& chunk, const double* row_time, const double* h, double first, int steps);
    void (*rk4_tangent)(Chunk& chunk, const double* row_time, const double* h, double first, int steps);

    /// Steps of Taylor's method of every member up to its time t, which may not be before the step that it is at; then the
    /// chunk has the states there. At most so many steps: false when some member needs more, and the call is to be repeated.
    /// The second moves tangent vectors as well.
    bool (*taylor)(Chunk& chunk, TaylorChunk& steps, const double* t, int most);
    bool (*taylor_tangent)(Chunk& chunk, TaylorChunk& steps, const double* t, int most);
};

/// The widest set that this processor has, or the one that the environment variable PENDULA_ISA names (baseline, avx2,
/// avx512). Decided once.
const Kernels& dispatch() noexcept;

/// False where PENDULA_ISA is set, be it to nothing, and names no set that this processor has.
bool is_choice_met() noexcept;

}  // namespace pendula::kernels
