// Compiled once for each instruction set, with PENDULA_ISA its name. No std:: templates here: the linker may keep the copy of
// any unit for all.
#include "kernels/dispatch.hpp"
#include "kernels/exact_kernel.hpp"
#include "kernels/rk4_kernel.hpp"

#define PENDULA_NAME_OF(isa) #isa
#define PENDULA_NAME(isa) PENDULA_NAME_OF(isa)

namespace pendula::kernels::inline PENDULA_ISA {
namespace {

constexpr int width = 8;  // chunk_size is a multiple
using T = Pack<width>;

T load(const double* x) {
    T pack;
    __builtin_memcpy(&pack, x, sizeof pack);
    return pack;
}

void store(double* x, const T& pack) { __builtin_memcpy(x, &pack, sizeof pack); }

void exact(const Exact& solution, std::size_t n, const double* t, double* theta, double* omega, double* turns) {
    const Exact e = solution;  // which no store can change
    std::size_t i = 0;
    for (; i + width <= n; i += width) {
        const auto s = closed_form(e, load(t + i));
        store(theta + i, s.theta);
        store(omega + i, s.omega);
        store(turns + i, s.turns);
    }
    if (i == n) return;
    // The tail runs the same operations on a padded pack.
    const std::size_t bytes = (n - i) * sizeof(double);
    T time{};
    __builtin_memcpy(&time, t + i, bytes);
    const auto s = closed_form(e, time);
    __builtin_memcpy(theta + i, &s.theta, bytes);
    __builtin_memcpy(omega + i, &s.omega, bytes);
    __builtin_memcpy(turns + i, &s.turns, bytes);
}

template <bool has_tangent>
void rk4(Chunk& c, const double* row_time, const double* h, double first, int steps) {
    for (int i = 0; i < c.count; i += width) {
        const auto k = rk4_constants(load(c.alpha + i), load(c.beta + i), load(c.torque + i), load(c.drive_amplitude + i),
                                     load(c.drive_frequency + i), load(c.drive_phase + i), load(h + i));
        Motion<T> x{load(c.theta + i), load(c.omega + i), load(c.turns + i), load(c.theta_lo + i), load(c.omega_lo + i)};
        Tangent<T> tangent{load(c.tangent_theta + i), load(c.tangent_omega + i)};
        for (int done = 0; done < steps; done += block_steps) {
            const int left = steps - done;
            rk4_block<has_tangent>(k, two_sum(load(row_time + i), (first + done) * k.h), x, tangent,
                                   left < block_steps ? left : block_steps);
        }
        store(c.theta + i, x.theta);
        store(c.omega + i, x.omega);
        store(c.turns + i, x.turns);
        store(c.theta_lo + i, x.theta_lo);
        store(c.omega_lo + i, x.omega_lo);
        store(c.tangent_theta + i, tangent.theta);
        store(c.tangent_omega + i, tangent.omega);
    }
}

}  // namespace

// In taylor_kernels.cpp.
bool taylor(Chunk& chunk, TaylorChunk& steps, const double* t, int most);
bool taylor_tangent(Chunk& chunk, TaylorChunk& steps, const double* t, int most);

extern const Kernels kernels;
const Kernels kernels{PENDULA_NAME(PENDULA_ISA), exact, rk4<false>, rk4<true>, taylor, taylor_tangent};

}  // namespace pendula::kernels::inline PENDULA_ISA
