// Programs of `replay` as the kernels take them.
#pragma once

#include <cstddef>

#include "kernels/chunk.hpp"
#include "pendula/replay.hpp"

namespace pendula::kernels {

/// The number of programs in a chunk: one pack. Coefficients of more would not fit in the first-level cache.
inline constexpr int replay_size = 8;

/// One value for each program of a chunk.
using ReplayRow = double[replay_size];

/// Up to replay_size programs with the same number of stages. The arrays are those of `Program`. The remaining places hold
/// zeros and states of NaN.
struct alignas(64) ReplayChunk {
    std::size_t stages = 0;
    bool has_sine = false;        ///< a force is a sine or a cosine
    bool has_polynomial = false;  ///< a force is a part of the sine's series
    bool is_driven = false;       ///< a program has a drive or a shaken pivot; the others have frequency and phase 0
    ReplayRow theta, omega;
    Parameters<ReplayRow> parameters;
    ReplayRow force;  ///< the number of the enumerator
    ReplayRow scale, dt;
    ReplayRow coefficients[stages_limit * (3 + 4 * stages_limit)];
    ReplayRow sums[4 * stages_limit];
};

}  // namespace pendula::kernels
