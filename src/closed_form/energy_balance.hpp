// Where a conservative pendulum stands between its regimes: shared by the analysis and the closed form.
#pragma once

#include "arithmetic/trigonometric.hpp"
#include "pendula/analysis.hpp"

namespace pendula {

/// Times are counted in 1/unit, unit a power of two near the larger of sqrt(alpha) and |omega|/2, so that no square
/// overflows, nor underflows where it matters.
struct EnergyBalance {
    using Number = arithmetic::DoubleDouble<double>;

    Regime regime;
    double unit;        ///< [s^-1]
    double alpha;       ///< [unit^2]
    Number sine;        ///< sin(theta/2)
    Number cosine;      ///< cos(theta/2)
    Number half_omega;  ///< omega/2 [unit]
    Number rise;        ///< kappa alpha = alpha sin^2(theta/2) + omega^2/4 [unit^2]
    Number gap;         ///< kappa' alpha = alpha cos^2(theta/2) - omega^2/4 [unit^2]
    Number root_alpha;  ///< [unit]
    Number frequency;   ///< 1/tau of an oscillation or a rotation [unit]
    Number speed;       ///< of an oscillation: omega/(2 sqrt(alpha))
    Number k;           ///< of an oscillation: sqrt(kappa) = sin(theta_max/2), relatively precise however small
};

/// alpha > 0 and finite, initial finite.
EnergyBalance balance_energy(double alpha, State initial) noexcept;

/// `analyze` from the balance; omega tells the sense.
Analysis analyze(const EnergyBalance& balance, double omega) noexcept;

/// Whether `analyze` has an answer.
bool is_legal(double alpha, State initial) noexcept;

}  // namespace pendula
