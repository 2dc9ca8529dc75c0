// Compiled once for each instruction set, with PENDULA_ISA its name. No std:: templates here: the linker may keep the copy of
// any unit for all.
#include "kernels/exact_kernel.hpp"

#include "kernels/dispatch.hpp"

#define PENDULA_NAME_OF(isa) #isa
#define PENDULA_NAME(isa) PENDULA_NAME_OF(isa)

namespace pendula::kernels::inline PENDULA_ISA {
namespace {

constexpr int width = 8;

/// Calls body(first, count, pack-sized copies) over blocks of `width`; a tail runs the same operations on a padded pack.
void exact(const Exact& e, std::size_t n, const double* t, double* theta, double* omega, double* turns) {
    using T = Pack<width>;
    for (std::size_t i = 0; i < n; i += width) {
        const std::size_t count = n - i < width ? n - i : width;
        T time{};
        __builtin_memcpy(&time, t + i, count * sizeof(double));
        const auto s = closed_form(e, time);
        __builtin_memcpy(theta + i, &s.theta, count * sizeof(double));
        __builtin_memcpy(omega + i, &s.omega, count * sizeof(double));
        __builtin_memcpy(turns + i, &s.turns, count * sizeof(double));
    }
}

}  // namespace

extern const Kernels kernels;
const Kernels kernels{PENDULA_NAME(PENDULA_ISA), exact};

}  // namespace pendula::kernels::inline PENDULA_ISA
