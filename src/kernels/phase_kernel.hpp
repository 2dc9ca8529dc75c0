// Times as phases: the whole and the fractional part of a product with a rate.
#pragma once

#include "arithmetic/double_double.hpp"

namespace pendula::kernels::inline PENDULA_ISA {

using namespace arithmetic;

/// The leading 26 bits of x, so that products of two such are exact; by its bits, so that no x overflows.
template <class T>
inline T leading_bits(T x) {
    return from_bits<T>(bits(x) & ~std::int64_t{0x7ffffff});
}

/// A rate, cut for exact products.
template <class T>
struct Rate {
    T leading;
    T rest;
    T whole;
};

template <class T>
inline Rate<T> to_rate(DoubleDouble<T> rate) {
    const T leading = leading_bits(rate.hi);
    return {leading, (rate.hi - leading) + rate.lo, rate.hi};
}

template <class T>
struct Phase {
    T whole;
    T fraction;  ///< in [-1/2, 1/2]
};

/// start + t rate, |start| <= 1. The fraction's error is below 2^-53 times its own size, where start and the product's first
/// 52 bits leave a small one, plus 2^-79 |t rate|: a 2^-26th of what one ulp of t moves it.
template <class T>
inline Phase<T> phase_at(T t, Rate<T> rate, T start) {
    const T t_leading = leading_bits(t);
    const T product = t_leading * rate.leading;
    const T rest = t_leading * rate.rest + (t - t_leading) * rate.whole;
    const T whole = round_even(product + (rest + start));
    return {whole, ((product - whole) + start) + rest};
}

/// The product t rate as a double-double, with a relative error of 2^-104.
template <class T>
inline DoubleDouble<T> turned(T t, DoubleDouble<T> rate) {
    const auto r = split(rate.hi);
    const T t_leading = leading_bits(t), t_rest = t - t_leading;
    const T p = t * rate.hi;
    const T rest = ((t_leading * r.hi - p) + t_leading * r.lo + t_rest * r.hi) + t_rest * r.lo;
    return {p, rest + t * rate.lo};
}

}  // namespace pendula::kernels::inline PENDULA_ISA
