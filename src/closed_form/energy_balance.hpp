// The energies of a conservative pendulum relative to the bottom and to the top, for the analysis and the closed form.
#pragma once

#include "arithmetic/trigonometric.hpp"
#include "pendula/analysis.hpp"

namespace pendula {

/// Frequencies are in a unit that is a power of two near the larger of sqrt(alpha) and |omega|/2, so that no square overflows,
/// and none that matters underflows.
struct EnergyBalance {
    using Number = arithmetic::DoubleDouble<double>;

    Regime regime;
    double unit;        ///< [s^-1]
    double alpha;       ///< [unit^2]
    Number sine;        ///< sin(theta/2)
    Number cosine;      ///< cos(theta/2)
    Number half_omega;  ///< omega/2 [unit]
    Number rise;        ///< energy above the bottom: kappa alpha = alpha sin^2(theta/2) + omega^2/4 [unit^2]
    Number gap;         ///< energy missing to the top: kappa' alpha = alpha cos^2(theta/2) - omega^2/4 [unit^2]
    Number root_alpha;  ///< [unit]
    Number frequency;   ///< 1/tau for an oscillation or a rotation [unit]
    Number speed;       ///< omega/(2 sqrt(alpha)), for an oscillation only
    Number k;           ///< sqrt(kappa) = sin(theta_max/2), for an oscillation only, with full relative precision if small
};

/// The energies of a pendulum. alpha > 0 and finite, initial finite.
EnergyBalance balance_energy(double alpha, State initial) noexcept;

/// `analyze` from the energies; omega gives the direction.
Analysis analyze(const EnergyBalance& balance, double omega) noexcept;

/// Whether the arguments of `analyze` are in their intervals.
bool is_legal(double alpha, State initial) noexcept;

}  // namespace pendula
