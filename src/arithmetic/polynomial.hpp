// Polynomials with constant coefficients by Estrin's scheme, which has shorter chains of dependent operations than Horner's.
#pragma once

#include "arithmetic/pack.hpp"

namespace pendula::arithmetic::inline PENDULA_ISA {

/// The sum of c[i] x^(i - first) for first <= i < last.
template <int first, int last, int n, class T>
inline T estrin_part(T x, const T* squarings, const double (&c)[n]) {
    constexpr int count = last - first;
    if constexpr (count == 1) {
        return splat<T>(c[first]);
    } else if constexpr (count == 2) {
        return c[first] + c[first + 1] * x;
    } else {
        constexpr int level = count > 16 ? 4 : count > 8 ? 3 : count > 4 ? 2 : 1;  // largest power of two below count
        constexpr int middle = first + (1 << level);
        return estrin_part<first, middle>(x, squarings, c) + squarings[level] * estrin_part<middle, last>(x, squarings, c);
    }
}

/// c[0] + c[1] x + … + c[n-1] x^(n-1), n <= 32.
template <int n, class T>
inline T polynomial(T x, const double (&c)[n]) {
    constexpr int levels = n > 16 ? 5 : n > 8 ? 4 : n > 4 ? 3 : n > 2 ? 2 : 1;
    T squarings[levels];
    squarings[0] = x;
    for (int i = 1; i < levels; ++i) squarings[i] = squarings[i - 1] * squarings[i - 1];
    return estrin_part<0, n>(x, squarings, c);
}

}  // namespace pendula::arithmetic::inline PENDULA_ISA
