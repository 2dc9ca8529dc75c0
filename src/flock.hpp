// Members of an ensemble as chunks: shared by `solve` for ensembles and by the measures.
#pragma once

#include "kernels/dispatch.hpp"
#include "parallel.hpp"

namespace pendula {

/// The pendulum and the initial state of a member.
Pendulum pendulum_of(const Ensemble& ensemble, std::size_t member) noexcept;
State state_of(const Ensemble& ensemble, std::size_t member) noexcept;

/// One value each or one for all.
inline double value_of(std::span<const double> column, std::size_t member) noexcept {
    return column[column.size() == 1 ? 0 : member];
}

constexpr std::size_t chunks_of(std::size_t members) noexcept {
    return (members + kernels::chunk_size - 1) / kernels::chunk_size;
}

/// Loads the members first, first + 1, … of an ensemble. One that is not legal starts as NaN.
void load(kernels::Chunk& chunk, const Ensemble& ensemble, std::size_t first) noexcept;

}  // namespace pendula
