// This file is compiled once for each instruction set; PENDULA_ISA is its name. It uses no templates of std::, because the
// linker may keep one copy of such a template, with the instructions of any of these units, for the whole library.
#include "kernels/dispatch.hpp"
#include "kernels/exact_kernel.hpp"
#include "kernels/packs.hpp"
#include "kernels/rk4_kernel.hpp"

#define PENDULA_NAME_OF(isa) #isa
#define PENDULA_NAME(isa) PENDULA_NAME_OF(isa)

namespace pendula::kernels::inline PENDULA_ISA {
namespace {

constexpr int width = 8;  // a divisor of chunk_size
using T = Pack<width>;

/// Computes the samples at late times again, by `late_closed_form`.
void recompute_late(const Exact& e, std::size_t n, const double* t, double* theta, double* omega, double* turns) {
    const double ordinary = ordinary_time(e);
    using Register = Pack<register_width>;  // a Twin of two would be kept in memory
    Mask<Register> is_late{};
    std::size_t i = 0;
    for (; i + register_width <= n; i += register_width) {
        Register time;
        __builtin_memcpy(&time, t + i, sizeof time);
        is_late = is_late | (abs(time) > ordinary);
    }
    bool is_any_late = any<Register>(is_late);
    for (; i < n; ++i) is_any_late |= abs(t[i]) > ordinary;
    if (!is_any_late) return;
    for (i = 0; i < n; ++i) {
        if (!(abs(t[i]) > ordinary)) continue;
        const auto s = late_closed_form(e, t[i]);
        theta[i] = s.theta;
        omega[i] = s.omega;
        turns[i] = s.turns;
    }
}

void exact(const Exact& solution, std::size_t n, const double* t, double* theta, double* omega, double* turns) {
    const Exact e = solution;  // a copy, which the stores below cannot change
    // `bytes` returns a constant for every pack but the last; otherwise each load and store would be a function call.
    const auto sample = [&](std::size_t from, auto bytes) {
        T time{};
        __builtin_memcpy(&time, t + from, bytes());
        const auto s = closed_form(e, time);
        __builtin_memcpy(theta + from, &s.theta, bytes());
        __builtin_memcpy(omega + from, &s.omega, bytes());
        __builtin_memcpy(turns + from, &s.turns, bytes());
    };
    std::size_t i = 0;
    for (; i + width <= n; i += width) sample(i, [] { return sizeof(T); });
    if (i < n) sample(i, [&] { return (n - i) * sizeof(double); });  // the tail runs the same operations on a padded pack
    recompute_late(e, n, t, theta, omega, turns);
}

template <bool has_tangent>
void rk4(Chunk& c, const Row& row_time, const Row& h, double first, int steps) {
    for (int i = 0; i < c.count; i += width) {
        const T step = load<T>(h, i);
        if (!any<T>(step != 0.0)) continue;
        const auto k = rk4_constants(load<T, Parameters>(c.parameters, i), step);
        const T start = load<T>(row_time, i);
        auto x = load<T, Motion>(c.motion, i);
        auto tangent = load<T, Tangent>(c.tangent, i);
        for (int done = 0; done < steps; done += block_steps) {
            const int left = steps - done;
            rk4_block<has_tangent>(k, two_sum(start, (first + done) * k.h), x, tangent,
                                   left < block_steps ? left : block_steps);
        }
        store<T, Motion>(c.motion, i, x);
        if constexpr (has_tangent) store<T, Tangent>(c.tangent, i, tangent);
    }
}

}  // namespace

// Defined in taylor_kernels.cpp.
bool taylor(Chunk& chunk, TaylorChunk& steps, const Row& t, int most);
bool taylor_tangent(Chunk& chunk, TaylorChunk& steps, const Row& t, int most);

// Defined in replay_kernels.cpp.
void replay(ReplayChunk& chunk, double first, int steps);
void replay_single(ReplayChunk& chunk, double first, int steps);

extern const Kernels kernels;
const Kernels kernels{PENDULA_NAME(PENDULA_ISA), exact, rk4<false>, rk4<true>, taylor, taylor_tangent, replay, replay_single};

}  // namespace pendula::kernels::inline PENDULA_ISA
