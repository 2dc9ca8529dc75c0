// Double-double arithmetic: a number is the unevaluated sum hi + lo of two doubles with |lo| <= ulp(hi)/2, which gives about
// 106 bits. Algorithms: Muller et al., Handbook of Floating-Point Arithmetic, 4.4, 5.1 and 14.1. Error bounds: Joldes, Muller &
// Popescu 2017.
#pragma once

#include "arithmetic/pack.hpp"

namespace pendula::arithmetic::inline PENDULA_ISA {

template <class T>
struct DoubleDouble {
    T hi{};
    T lo{};
};

/// a + b exactly.
template <class T>
inline DoubleDouble<T> two_sum(T a, T b) {
    const T s = a + b;
    const T bb = s - a;
    return {s, (a - (s - bb)) + (b - bb)};
}

/// a + b exactly. Requires |a| >= |b| or a = 0.
template <class T>
inline DoubleDouble<T> fast_two_sum(T a, T b) {
    const T s = a + b;
    return {s, b - (s - a)};
}

/// a exactly as the sum of two doubles of at most 26 bits each (Veltkamp). Requires |a| < 2^996.
template <class T>
inline DoubleDouble<T> split(T a) {
    const T c = a * 134217729.0;  // 2^27 + 1
    const T hi = c - (c - a);
    return {hi, a - hi};
}

/// a * b exactly (Dekker). Requires |a|, |b| < 2^996, and no part of the product below 2^-1074.
template <class T>
inline DoubleDouble<T> two_prod(T a, T b) {
    const T p = a * b;
    const auto x = split(a);
    const auto y = split(b);
    return {p, ((x.hi * y.hi - p) + x.hi * y.lo + x.lo * y.hi) + x.lo * y.lo};
}

template <class T>
inline DoubleDouble<T> operator-(DoubleDouble<T> a) {
    return {-a.hi, -a.lo};
}

/// a + b with a relative error of at most 3 * 2^-106, also if leading digits cancel.
template <class T>
inline DoubleDouble<T> operator+(DoubleDouble<T> a, DoubleDouble<T> b) {
    const auto s = two_sum(a.hi, b.hi);
    const auto t = two_sum(a.lo, b.lo);
    const auto v = fast_two_sum(s.hi, s.lo + t.hi);
    return fast_two_sum(v.hi, t.lo + v.lo);
}

template <class T>
inline DoubleDouble<T> operator-(DoubleDouble<T> a, DoubleDouble<T> b) {
    return a + -b;
}

template <class T>
inline DoubleDouble<T> operator+(DoubleDouble<T> a, T b) {
    const auto s = two_sum(a.hi, b);
    return fast_two_sum(s.hi, a.lo + s.lo);
}

/// a * b with a relative error of at most 5 * 2^-106.
template <class T>
inline DoubleDouble<T> operator*(DoubleDouble<T> a, DoubleDouble<T> b) {
    const auto p = two_prod(a.hi, b.hi);
    return fast_two_sum(p.hi, p.lo + (a.hi * b.lo + a.lo * b.hi));
}

template <class T>
inline DoubleDouble<T> operator*(DoubleDouble<T> a, T b) {
    const auto p = two_prod(a.hi, b);
    return fast_two_sum(p.hi, p.lo + a.lo * b);
}

/// a times a power of two, exactly.
template <class T>
inline DoubleDouble<T> scaled(DoubleDouble<T> a, T power) {
    return {a.hi * power, a.lo * power};
}

/// a/b with a relative error of at most 10 * 2^-106.
template <class T>
inline DoubleDouble<T> operator/(DoubleDouble<T> a, DoubleDouble<T> b) {
    const T q = a.hi / b.hi;
    const auto rest = a - b * q;
    return fast_two_sum(q, (rest.hi + rest.lo) / b.hi);
}

/// The square root, by one step of Newton's method (Karp & Markstein 1997). Relative error about 2^-104. 0 gives 0.
template <class T>
inline DoubleDouble<T> sqrt(DoubleDouble<T> a) {
    const T root = sqrt(a.hi);
    const auto rest = a - two_prod(root, root);
    const T correction = select(root > 0.0, (rest.hi + rest.lo) / (2.0 * root), T{});
    return fast_two_sum(root, correction);
}

/// The arithmetic-geometric mean of a >= b > 0 (DLMF 19.8). Relative error about 2^-100 for b/a >= 1e-32. One round turns a
/// relative difference d of a and b into about d^2/8: when d is 2^-52, the last mean is within 2^-107. That takes at most 10
/// rounds for b/a >= 1e-32; callers have b/a > 1e-16.
inline DoubleDouble<double> agm(DoubleDouble<double> a, DoubleDouble<double> b) {
    for (int round = 0; round < 10 && a.hi - b.hi > 0x1p-52 * a.hi; ++round) {
        const auto mean = scaled(a + b, 0.5);
        b = sqrt(a * b);
        a = mean;
    }
    return scaled(a + b, 0.5);
}

}  // namespace pendula::arithmetic::inline PENDULA_ISA
