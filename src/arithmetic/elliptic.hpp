// Carlson's elliptic integral R_F, and the nome. The closed form needs both, besides the arithmetic-geometric mean.
#pragma once

#include "arithmetic/double_double.hpp"

namespace pendula::arithmetic::inline PENDULA_ISA {

/// One step of duplication: x, y, z become (x + lambda)/4, (y + lambda)/4, (z + lambda)/4. R_F does not change, and the
/// differences between the arguments become 4 times smaller (DLMF 19.36.1).
template <class N>
inline void duplicate(N& x, N& y, N& z) {
    const N a = sqrt(x), b = sqrt(y), c = sqrt(z);
    const N lambda = a * b + b * c + c * a;
    const auto quarter = [&lambda](N v) { return (v + lambda) * 0.25; };
    x = quarter(x);
    y = quarter(y);
    z = quarter(z);
}

/// R_F(x, y, z) sqrt(mean), where mean is the mean of x, y and z, for arguments within 1/500 of each other. The truncated terms
/// are of order 8 in the relative differences and below 1e-20 (DLMF 19.36.1).
inline double carlson_series(double x, double y, double mean) {
    const double dx = 1.0 - x / mean;
    const double dy = 1.0 - y / mean;
    const double dz = -(dx + dy);
    const double e2 = dx * dy - dz * dz;
    const double e3 = dx * dy * dz;
    return 1.0 + (-e2 / 10.0 + e3 / 14.0 + e2 * e2 / 24.0 - 3.0 / 44.0 * e2 * e3 - 5.0 / 208.0 * e2 * e2 * e2 +
                  3.0 / 104.0 * e3 * e3 + e2 * e2 * e3 / 16.0);
}

/// R_F(x, y, z) (DLMF 19.16.1) for x, y, z >= 0, of which at most one is zero. Within 8 ulp if N is double, and within 3 ulp if
/// N is double-double. If the positive arguments differ by a factor of at most 1e32, 10 duplications are enough; the loop
/// allows 24.
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

/// The nome q of a modulus k with k^2 <= 1/2, from k^2 and the complementary modulus k' (DLMF 19.5.6). Within 4 ulp.
template <class T>
inline T nome(T k_squared, T complement) {
    const T root = sqrt(complement);
    const T sum = 1.0 + root;
    const T e = 0.5 * k_squared / ((1.0 + complement) * sum * sum);  // (1 - root)/(1 + root)/2 without its cancellation
    const T e4 = (e * e) * (e * e);
    return e * (1.0 + e4 * (2.0 + e4 * (15.0 + e4 * 150.0)));  // the next term is below 1707 e^16 < 4e-19 of the sum
}

}  // namespace pendula::arithmetic::inline PENDULA_ISA
