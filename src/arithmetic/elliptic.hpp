// Carlson's symmetric integral and the nome: what the closed form needs besides the arithmetic-geometric mean.
#pragma once

#include "arithmetic/double_double.hpp"

namespace pendula::arithmetic::inline PENDULA_ISA {

/// One duplication: x, y, z -> (x + lambda)/4, …, which leaves R_F as it is and shrinks the spread by 4 (DLMF 19.36.1).
template <class N>
inline void duplicate(N& x, N& y, N& z) {
    const N a = sqrt(x), b = sqrt(y), c = sqrt(z);
    const N lambda = a * b + b * c + c * a;
    const auto quarter = [&lambda](N v) { return (v + lambda) * 0.25; };
    x = quarter(x);
    y = quarter(y);
    z = quarter(z);
}

/// R_F of arguments within a part in 500 of each other, over 1/sqrt(their mean): the first neglected terms are of the 8th
/// order in the spread, below 1e-20 (DLMF 19.36.1).
inline double carlson_series(double x, double y, double mean) {
    const double dx = 1.0 - x / mean;
    const double dy = 1.0 - y / mean;
    const double dz = -(dx + dy);
    const double e2 = dx * dy - dz * dz;
    const double e3 = dx * dy * dz;
    return 1.0 + (-e2 / 10.0 + e3 / 14.0 + e2 * e2 / 24.0 - 3.0 / 44.0 * e2 * e3 - 5.0 / 208.0 * e2 * e2 * e2 +
                  3.0 / 104.0 * e3 * e3 + e2 * e2 * e3 / 16.0);
}

/// R_F(x, y, z) for x, y, z >= 0, at most one of them zero, within 8 ulp (DLMF 19.16.1). From spreads of 1e-32 it takes 24
/// duplications. N is double, or double-double for a result within 3 ulp.
template <class N>
inline double carlson_rf(N x, N y, N z) {
    const auto rounded = [](auto v) {
        if constexpr (requires { v.hi; })
            return v.hi;
        else
            return v;
    };
    double a = 0, b = 0, c = 0;
    for (int i = 0; i < 24; ++i) {
        duplicate(x, y, z);
        a = rounded(x), b = rounded(y), c = rounded(z);
        if (abs(a - b) + abs(b - c) <= 2e-3 * c) break;
    }
    const double mean = rounded((x + y + z) * (1.0 / 3.0));
    return carlson_series(a, b, mean) / sqrt(mean);
}

/// The nome q of modulus k, from k^2 <= 1/2 and its complement k' (DLMF 19.5.6): within 4 ulp.
template <class T>
inline T nome(T k_squared, T complement) {
    const T root = sqrt(complement);
    const T sum = 1.0 + root;
    const T e = 0.5 * k_squared / ((1.0 + complement) * sum * sum);  // (1 - root)/(1 + root)/2 without its difference
    const T e4 = (e * e) * (e * e);
    return e * (1.0 + e4 * (2.0 + e4 * (15.0 + e4 * 150.0)));  // next: 1707 e^16 < 4e-19
}

}  // namespace pendula::arithmetic::inline PENDULA_ISA
