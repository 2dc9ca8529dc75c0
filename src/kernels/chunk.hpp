// The data of the kernels: structs whose members all have the same type T, which is a double for one pendulum, a pack for a
// pack of pendulums, or a Row for a chunk of an ensemble.
#pragma once

namespace pendula::kernels {

/// The number of pendulums in a chunk: few enough for the first-level cache, and a multiple of the width of every pack.
inline constexpr int chunk_size = 64;

/// One value for each member of a chunk.
using Row = double[chunk_size];

/// The parameters of the equation, in the order of `Pendulum`.
template <class T>
struct Parameters {
    T alpha;
    T beta;
    T torque;
    T drive_amplitude;
    T pivot_amplitude;
    T drive_frequency;
    T drive_phase;
};

/// A state during integration, as the public Motion. theta_lo and omega_lo are the rounding errors of the sums theta and omega,
/// kept for the next addition (Kahan).
template <class T>
struct Motion {
    T theta;  ///< in [-pi, pi)
    T omega;
    T turns;
    T theta_lo;  ///< the exact sums are theta + theta_lo and omega + omega_lo
    T omega_lo;
};

/// A small displacement from the motion. It follows the linearised equation.
template <class T>
struct Tangent {
    T theta;
    T omega;
};

inline constexpr int taylor_coefficients = 26;

/// A step of Taylor's method, as the public TaylorPolynomial: theta and omega as polynomials in x = (time since the start of
/// the step)/unit.
template <class T>
struct TaylorStep {
    Motion<T> start;
    T t, t_lo;                      ///< the start of the step, as the sum of two doubles [s]
    T unit;                         ///< a power of two near 1/rate, so that no coefficient overflows [s]
    T length;                       ///< [s]; NaN if the motion is not finite
    T series[taylor_coefficients];  ///< the coefficients of v = omega unit
    T series_1_lo;                  ///< the rounding error of series[1]: its value is series[1] + series_1_lo
};

/// The displacement at the start of a step, and the coefficients of its theta in powers of x.
template <class T>
struct TangentStep {
    Tangent<T> start;
    T u[taylor_coefficients];
};

/// Up to chunk_size members of an ensemble.
struct alignas(64) Chunk {
    int count = 0;  ///< number of members; the remaining places hold pendulums at rest, so that packs are full
    Motion<Row> motion;
    Tangent<Row> tangent;
    Parameters<Row> parameters;
    bool is_resting[chunk_size];  ///< see `rests_on_top`
    Row resting_theta;            ///< the angle and turns of a member that rests at the top
    Row resting_turns;
};

/// The steps of a chunk's members by Taylor's method. Each member has steps of its own.
struct alignas(64) TaylorChunk {
    int order = 0;
    double log2_fraction = 0;
    TaylorStep<Row> step;
    TangentStep<Row> tangent;
};

/// Makes for every member a step of length 0 at the state of the chunk and the time t[i] [s], from which the kernels continue.
void start_taylor(TaylorChunk& steps, const Chunk& chunk, double tolerance, const Row& t) noexcept;

}  // namespace pendula::kernels
