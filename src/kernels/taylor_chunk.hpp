// A chunk of an ensemble on its way by Taylor's method: each member at a step of its own.
#pragma once

#include "kernels/chunk.hpp"

namespace pendula::kernels {

inline constexpr int taylor_coefficients = 26;

/// The steps that members are at, as in pendula::Taylor. `start_taylor` begins them; the kernel goes on.
struct alignas(64) TaylorChunk {
    int order = 0;
    double log2_fraction = 0;

    double t[chunk_size];  ///< the step's start in two doubles
    double t_lo[chunk_size];
    double length[chunk_size];
    double unit[chunk_size];
    double theta[chunk_size];  ///< at the step's start, as in Chunk
    double omega[chunk_size];
    double turns[chunk_size];
    double theta_lo[chunk_size];
    double omega_lo[chunk_size];
    double tangent_theta[chunk_size];
    double tangent_omega[chunk_size];
    double series_1_lo[chunk_size];                          ///< what rounding has kept out of series[1]
    double series[taylor_coefficients][chunk_size];          ///< of omega
    double tangent_series[taylor_coefficients][chunk_size];  ///< of the displacement of theta
};

/// Puts every member at the state of the chunk, at times t[i] [s].
void start_taylor(TaylorChunk& steps, const Chunk& chunk, double tolerance, const double* t) noexcept;

}  // namespace pendula::kernels
