// The kernels of each instruction set, and the choice among them at run time.
#pragma once

#include <cstddef>

#include "pendula/exact.hpp"

namespace pendula::kernels {

/// What one instruction set offers; every set gives the same bits.
struct Kernels {
    const char* name;
    void (*exact)(const Exact& solution, std::size_t n, const double* t, double* theta, double* omega, double* turns);
};

/// The widest set that this processor has, or the one that the environment variable PENDULA_ISA names (baseline, avx2,
/// avx512) where it is had. Decided once.
const Kernels& dispatch() noexcept;

}  // namespace pendula::kernels
