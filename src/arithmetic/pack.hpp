// Types and functions by which one text of a kernel serves a double and a pack of doubles: selection by a mask, bits, rounding.
//
// A pack is a vector type of the compiler. + - * / and comparisons act on each lane, with the operators of the language. So a
// kernel has the same text and the same bits for T = double and for T = a pack. Everything here, and in the headers that build
// on this one, is in a namespace with the name of the instruction set for which its translation unit is compiled. Without these
// namespaces the linker could keep one copy of a function, say the one for AVX2, for every processor.
#pragma once

#include <cstdint>

#include "arithmetic/strict.hpp"

#ifndef PENDULA_ISA
#define PENDULA_ISA baseline
#endif

namespace pendula::arithmetic::inline PENDULA_ISA {

/// Two packs that are treated as one pack of twice the width. The operations on its halves are independent and can overlap.
/// (Compilers keep a vector type that is wider than a register in memory; they keep the halves of a Twin in registers.)
template <class V>
struct Twin {
    V a;
    V b;
};

#define PENDULA_TWIN_OPERATOR(op)                                  \
    template <class V>                                             \
    inline auto operator op(const Twin<V>& x, const Twin<V>& y) {  \
        return Twin<decltype(x.a op y.a)>{x.a op y.a, x.b op y.b}; \
    }                                                              \
    template <class V, class S>                                    \
    inline auto operator op(const Twin<V>& x, S y)                 \
        requires(sizeof(S) <= 8)                                   \
    {                                                              \
        return Twin<decltype(x.a op y)>{x.a op y, x.b op y};       \
    }                                                              \
    template <class V, class S>                                    \
    inline auto operator op(S x, const Twin<V>& y)                 \
        requires(sizeof(S) <= 8)                                   \
    {                                                              \
        return Twin<decltype(x op y.a)>{x op y.a, x op y.b};       \
    }
PENDULA_TWIN_OPERATOR(+)
PENDULA_TWIN_OPERATOR(-)
PENDULA_TWIN_OPERATOR(*)
PENDULA_TWIN_OPERATOR(/)
PENDULA_TWIN_OPERATOR(<)
PENDULA_TWIN_OPERATOR(<=)
PENDULA_TWIN_OPERATOR(>)
PENDULA_TWIN_OPERATOR(>=)
PENDULA_TWIN_OPERATOR(==)
PENDULA_TWIN_OPERATOR(!=)
PENDULA_TWIN_OPERATOR(&)
PENDULA_TWIN_OPERATOR(|)
PENDULA_TWIN_OPERATOR(^)
PENDULA_TWIN_OPERATOR(<<)
PENDULA_TWIN_OPERATOR(>>)
#undef PENDULA_TWIN_OPERATOR

template <class V>
inline Twin<V> operator-(const Twin<V>& x) {
    return {-x.a, -x.b};
}

template <class V>
inline Twin<V> operator!(const Twin<V>& x) {
    return {!x.a, !x.b};
}

/// The number of doubles in a register.
#if defined(__AVX512F__)
inline constexpr int register_width = 8;
#elif defined(__AVX__)
inline constexpr int register_width = 4;
#else
inline constexpr int register_width = 2;
#endif

template <int width>
struct PackOf {
    using type = Twin<typename PackOf<width / 2>::type>;
};
template <int width>
    requires(width <= register_width)
struct PackOf<width> {
    typedef double type __attribute__((vector_size(width * sizeof(double))));
};
template <int width>
using Pack = typename PackOf<width>::type;

template <class T>
struct BitsOf {
    typedef std::int64_t type __attribute__((vector_size(sizeof(T))));
};
template <>
struct BitsOf<double> {
    using type = std::int64_t;
};
template <class V>
struct BitsOf<Twin<V>> {
    using type = Twin<typename BitsOf<V>::type>;
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
        return x - T{};  // -0 stays -0, which x + T{} would make 0
}

/// a in the lanes where the mask is true, b in the others. Both are computed.
template <class T>
inline T select(const Mask<T>& mask, const T& a, const T& b) {
    if constexpr (requires { mask.a; })
        return {select<decltype(a.a)>(mask.a, a.a, b.a), select<decltype(a.a)>(mask.b, a.b, b.b)};
    else
        return mask ? a : b;
}

template <class T>
inline bool any(const Mask<T>& mask) {
    if constexpr (requires { mask.a; }) {
        return any<decltype(T::a)>(mask.a | mask.b);
    } else if constexpr (lanes<T> == 1) {
        return mask;
    } else {
        std::int64_t all = 0;
        for (int i = 0; i < lanes<T>; ++i) all |= mask[i];
        return all != 0;
    }
}

// A Twin is converted half by half: a cast of the whole would go through memory.
template <class T>
inline Bits<T> bits(const T& x) {
    if constexpr (requires { x.a; })
        return {bits(x.a), bits(x.b)};
    else
        return __builtin_bit_cast(Bits<T>, x);
}

template <class T>
inline T from_bits(const Bits<T>& x) {
    if constexpr (requires { x.a; })
        return {from_bits<decltype(T::a)>(x.a), from_bits<decltype(T::b)>(x.b)};
    else
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
        for (int i = 0; i < lanes<T>; ++i) lane(x, i) = __builtin_sqrt(lane(x, i));
        return x;
    }
}

/// 1.5 * 2^52. Added to x with |x| < 2^51 it gives a double whose low bits are the whole number nearest to x.
inline constexpr double rounder = 0x1.8p52;

/// The whole number nearest to x, ties to even. x itself for |x| >= 2^51; from 2^52 on every double is whole.
template <class T>
inline T round_even(T x) {
    return select(abs(x) < 0x1p51, (x + rounder) - rounder, x);
}

/// The largest whole number <= x.
template <class T>
inline T floor(T x) {
    const T whole = round_even(x);
    return whole - select(whole > x, splat<T>(1.0), T{});
}

/// The smallest whole number >= x.
template <class T>
inline T ceiling(T x) {
    return -floor(-x);
}

/// x * 2^n for a whole number n, |n| <= 2000, by two products. Exact unless the result underflows.
template <class T>
inline T scale(T x, T n) {
    const T half = (n * 0.5 + rounder) - rounder;
    const auto power = [](T k) { return from_bits<T>((bits(k + (rounder + 1023.0))) << 52); };
    return x * power(half) * power(n - half);
}

}  // namespace pendula::arithmetic::inline PENDULA_ISA
