// The unit of work of an ensemble: some members as arrays, small enough for the first cache, padded to whole packs.
#pragma once

#include "pendula/pendulum.hpp"

namespace pendula::kernels {

/// A multiple of every pack's width.
inline constexpr int chunk_size = 64;

struct alignas(64) Chunk {
    int count = 0;  ///< members; the places behind them hold pendulums at rest

    double theta[chunk_size];  ///< in [-pi, pi)
    double omega[chunk_size];
    double turns[chunk_size];
    double theta_lo[chunk_size];  ///< what rounding has kept out of theta and omega
    double omega_lo[chunk_size];

    double tangent_theta[chunk_size];  ///< a small displacement, carried by the linearised equation
    double tangent_omega[chunk_size];

    double alpha[chunk_size];
    double beta[chunk_size];
    double torque[chunk_size];
    double drive_amplitude[chunk_size];
    double drive_frequency[chunk_size];
    double drive_phase[chunk_size];
};

}  // namespace pendula::kernels
