// Carlson's symmetric integral and the nome: what the closed form needs besides the arithmetic-geometric mean.
#pragma once

#include "arithmetic/pack.hpp"

namespace pendula::arithmetic::inline PENDULA_ISA {

/// R_F(x, y, z) for x, y, z >= 0, at most one of them zero, within 4 ulp (DLMF 19.16.1, 19.36.1).
/// Duplication shrinks the spread by 4 a round once it is moderate; from spreads of 1e-32 that takes 24 rounds.
template <class T>
inline T carlson_rf(T x, T y, T z) {
    constexpr int rounds = 24;
    for (int i = 0; i < rounds; ++i) {
        const T a = sqrt(x), b = sqrt(y), c = sqrt(z);
        const T lambda = a * b + b * c + c * a;
        x = 0.25 * (x + lambda);
        y = 0.25 * (y + lambda);
        z = 0.25 * (z + lambda);
        if (!any<T>(abs(x - y) + abs(y - z) > 2e-3 * z)) break;
    }
    const T mean = (x + y + z) * (1.0 / 3.0);
    const T dx = 1.0 - x / mean;
    const T dy = 1.0 - y / mean;
    const T dz = -(dx + dy);
    const T e2 = dx * dy - dz * dz;
    const T e3 = dx * dy * dz;
    // The first neglected terms are of the 8th order in the spread: below 1e-20.
    const T series = 1.0 + (-e2 / 10.0 + e3 / 14.0 + e2 * e2 / 24.0 - 3.0 / 44.0 * e2 * e3 - 5.0 / 208.0 * e2 * e2 * e2 +
                            3.0 / 104.0 * e3 * e3 + e2 * e2 * e3 / 16.0);
    return series / sqrt(mean);
}

/// The nome q of modulus k, from k^2 <= 1/2 and its complement k' (DLMF 20.9.2, 22.2): within 4 ulp.
template <class T>
inline T nome(T k_squared, T complement) {
    const T root = sqrt(complement);
    const T sum = 1.0 + root;
    const T e = 0.5 * k_squared / ((1.0 + complement) * sum * sum);  // (1 - root)/(1 + root)/2 without its difference
    const T e4 = (e * e) * (e * e);
    return e * (1.0 + e4 * (2.0 + e4 * (15.0 + e4 * 150.0)));  // next: 1707 e^16 < 4e-19
}

}  // namespace pendula::arithmetic::inline PENDULA_ISA
