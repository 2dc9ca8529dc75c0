// Like kernels.cpp, of which it is apart for its compiler flags: compiled once for each instruction set.
#include "kernels/dispatch.hpp"
#include "kernels/taylor_flight.hpp"

namespace pendula::kernels::inline PENDULA_ISA {

namespace {

// Not wider than a register: a series must stay near.
using T = Pack<register_width>;

template <bool has_tangent>
bool fly_chunk(Chunk& chunk, TaylorChunk& steps, const double* t, int most) {
    bool all_there = true;
    for (int i = 0; i < chunk.count; i += lanes<T>) all_there &= fly<has_tangent, T>(chunk, steps, t, most, i);
    return all_there;
}

}  // namespace

bool taylor(Chunk& chunk, TaylorChunk& steps, const double* t, int most) { return fly_chunk<false>(chunk, steps, t, most); }

bool taylor_tangent(Chunk& chunk, TaylorChunk& steps, const double* t, int most) {
    return fly_chunk<true>(chunk, steps, t, most);
}

}  // namespace pendula::kernels::inline PENDULA_ISA
