// What lets a kernel be written once for a double and for a pack of doubles: types, choice, bits, rounding.
//
// A pack is a vector of the compiler's own; + - * / and comparisons act lane by lane with the operators of the language, so
// that a kernel's text is the same for T = double and T = a pack, and so are its bits. Everything here and in the headers
// that build on it lives in a namespace named after the instruction set its unit is compiled for: otherwise the linker
// could keep, say, the AVX2 copy of a function for every processor.
#pragma once

#include <cstdint>

#ifndef PENDULA_ISA
#define PENDULA_ISA baseline
#endif

namespace pendula::arithmetic::inline PENDULA_ISA {

template <int width>
struct PackOf {
    typedef double Doubles __attribute__((vector_size(width * sizeof(double))));
};
template <int width>
using Pack = typename PackOf<width>::Doubles;

template <class T>
struct BitsOf {
    typedef std::int64_t type __attribute__((vector_size(sizeof(T))));
};
template <>
struct BitsOf<double> {
    using type = std::int64_t;
};
template <class T>
using Bits = typename BitsOf<T>::type;

template <class T>
using Mask = decltype(T{} < T{});

template <class T>
inline constexpr int lanes = sizeof(T) / sizeof(double);

template <class T>
inline double& lane(T& x, int i) {
    return reinterpret_cast<double*>(&x)[i];
}

template <class T>
inline double lane(const T& x, int i) {
    return reinterpret_cast<const double*>(&x)[i];
}

template <class T>
inline T splat(double x) {
    if constexpr (lanes<T> == 1)
        return x;
    else
        return x - T{};  // -0 stays -0
}

/// a where the mask holds, b elsewhere. Both are computed.
template <class T>
inline T select(Mask<T> mask, T a, T b) {
    return mask ? a : b;
}

template <class T>
inline bool any(Mask<T> mask) {
    if constexpr (lanes<T> == 1) {
        return mask;
    } else {
        std::int64_t all = 0;
        for (int i = 0; i < lanes<T>; ++i) all |= mask[i];
        return all != 0;
    }
}

template <class T>
inline Bits<T> bits(T x) {
    return __builtin_bit_cast(Bits<T>, x);
}

template <class T>
inline T from_bits(Bits<T> x) {
    return __builtin_bit_cast(T, x);
}

inline constexpr std::int64_t sign_bit = INT64_MIN;

template <class T>
inline T abs(T x) {
    return from_bits<T>(bits(x) & ~sign_bit);
}

/// |x| with the sign of s.
template <class T>
inline T copy_sign(T x, T s) {
    return from_bits<T>((bits(x) & ~sign_bit) | (bits(s) & sign_bit));
}

template <class T>
inline T sqrt(T x) {
    if constexpr (lanes<T> == 1) {
        return __builtin_sqrt(x);
    } else {
        T r;
        for (int i = 0; i < lanes<T>; ++i) r[i] = __builtin_sqrt(x[i]);
        return r;
    }
}

/// 1.5 * 2^52: added to |x| < 2^51 it leaves the whole number nearest to x in the low bits.
inline constexpr double rounder = 0x1.8p52;

/// The whole number nearest to x, ties to even; x itself from 2^51 on, where it has no fraction worth the name.
template <class T>
inline T round_even(T x) {
    return select(abs(x) < 0x1p51, (x + rounder) - rounder, x);
}

/// x * 2^n for a whole number n, as two products: exact unless the result underflows. |n| <= 2000.
template <class T>
inline T scale(T x, T n) {
    const T half = (n * 0.5 + rounder) - rounder;
    const auto power = [](T k) { return from_bits<T>((bits(k + (rounder + 1023.0))) << 52); };
    return x * power(half) * power(n - half);
}

}  // namespace pendula::arithmetic::inline PENDULA_ISA
