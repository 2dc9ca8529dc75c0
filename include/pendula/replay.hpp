// Programs that integrate the pendulum by explicit one-step methods, right or wrong, as numbers; and their states after given
// numbers of steps.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "pendula/control.hpp"
#include "pendula/pendulum.hpp"

namespace pendula {

/// What a program has in the place of the sine, as a function of x.
enum class Force { sine, cosine, linear, cubic, quintic };  // sin x, cos x, x, x - x^3/6, x - x^3/6 + x^5/120

/// The names of the forces, in the order of the enumerators.
inline constexpr const char* force_names[] = {"sine", "cosine", "linear", "cubic", "quintic"};

/// The largest number of stages of a program.
inline constexpr std::size_t stages_limit = 8;

/// A program of S stages. It makes a step from the state (theta, omega) at the time t = (number of steps made) dt:
///     for s = 0, ..., S - 1, with sums over j < s:
///         x    = g[s] theta + sum of P[s][j] v[j] + Q[s][j] a[j]
///         v[s] = q[s] omega + sum of R[s][j] v[j] + U[s][j] a[j]
///         a[s] = -(alpha + pivot_amplitude cos(phase)) f(scale x) - beta v[s] + torque + drive_amplitude cos(phase),
///                phase = drive_frequency (t + c[s]) + drive_phase;
///     then, with sums over all j:
///         theta = theta + sum of b[j] v[j] + d[j] a[j]
///         omega = omega + sum of e[j] v[j] + k[j] a[j].
/// The coefficients contain the length of the step: those of the Euler method are g = q = 1, c = 0, b = k = dt, d = e = 0.
/// Terms whose coefficient is 0 are added too. No number needs to be finite, or in the interval of a parameter.
struct Program {
    State initial;
    Pendulum pendulum;
    Force force = Force::sine;  ///< f
    double scale = 1;
    double dt = 0;                         ///< [s]
    std::size_t stages = 0;                ///< S, from 1 to stages_limit
    std::span<const double> coefficients;  ///< for each stage g, q, c and the S numbers each of P, Q, R, U: S (3 + 4 S)
    std::span<const double> sums;          ///< the S numbers each of b, d, e, k
    std::span<const std::int64_t> steps;   ///< row j is the state after steps[j] steps, >= 0, not decreasing, up to 2^53
    bool is_single = false;                ///< computes with floats: each number and each result of an operation is rounded
};

/// The arrays that receive the rows: programs x rows values each, program by program. theta is not wrapped.
struct ReplayRows {
    std::span<double> theta, omega;
};

/// Computes the rows of every program. All programs have the same number of stages and the same number of rows.
///
/// A program's bits do not depend on the other programs, the number of threads or the instruction set
/// (tests/cpp/replay_test.cpp, tests/python/test_replay.py). Once its theta or omega is not finite, both are NaN in its rows,
/// and no more steps are made. The whole call is refused if the number of stages, the length of an array, a force or a number
/// of steps is not legal. Memory is 8 bytes for each program, besides the rows.
Outcome replay(std::span<const Program> programs, const ReplayRows& rows, const Control& control = {}) noexcept;

}  // namespace pendula
