// What kernels work on: structs of equal members, one value each for a pendulum, a pack of pendulums, or a chunk of an ensemble.
#pragma once

namespace pendula::kernels {

/// Members of a chunk: few enough for the first cache, and a multiple of every pack's width.
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

/// An angle and a velocity, with what rounding has kept out of their sums (Kahan).
template <class T>
struct Motion {
    T theta;  ///< in [-pi, pi)
    T omega;
    T turns;
    T theta_lo;  ///< what rounding has kept out of theta and omega
    T omega_lo;
};

/// A small displacement, which follows the linearised equation.
template <class T>
struct Tangent {
    T theta;
    T omega;
};

inline constexpr int taylor_coefficients = 26;

/// A step of Taylor's method: theta and omega from its start as polynomials in x = (time since)/unit. As TaylorPolynomial.
template <class T>
struct TaylorStep {
    Motion<T> start;
    T t, t_lo;  ///< at the start, in two doubles [s]
    T unit;     ///< a power of two near 1/rate, so that no coefficient overflows [s]
    T length;   ///< [s]; NaN once the motion is not finite
    T series[taylor_coefficients];  ///< of v = omega unit
    T series_1_lo;                  ///< what rounding has kept out of series[1]
};

/// A displacement at a step's start, and its theta as a polynomial in x.
template <class T>
struct TangentStep {
    Tangent<T> start;
    T u[taylor_coefficients];
};

/// Some members of an ensemble, padded to whole packs.
struct alignas(64) Chunk {
    int count = 0;  ///< members; the places behind them hold pendulums at rest
    Motion<Row> motion;
    Tangent<Row> tangent;
    Parameters<Row> parameters;
    bool is_resting[chunk_size];  ///< at rest on top: see `rests_on_top`
    Row resting_theta;            ///< of such a member, within its rounding -pi
    Row resting_turns;
};

/// A chunk on its way by Taylor's method: each member at a step of its own.
struct alignas(64) TaylorChunk {
    int order = 0;
    double log2_fraction = 0;
    TaylorStep<Row> step;
    TangentStep<Row> tangent;
};

/// Puts every member at the state of the chunk, at times t[i] [s].
void start_taylor(TaylorChunk& steps, const Chunk& chunk, double tolerance, const Row& t) noexcept;

}  // namespace pendula::kernels
