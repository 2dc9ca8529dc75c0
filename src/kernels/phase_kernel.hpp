// The phase that a time amounts to: start + t rate, as a whole number and a fraction.
#pragma once

#include "arithmetic/double_double.hpp"

namespace pendula::kernels::inline PENDULA_ISA {

using namespace arithmetic;

/// x cut to its leading 26 bits: a product of two such numbers is exact. The cut is made in the bits of x, so that no x
/// overflows, as the multiplication in `split` may.
template <class T>
inline T leading_bits(T x) {
    return from_bits<T>(bits(x) & ~std::int64_t{0x7ffffff});
}

/// A rate in two parts, the first of 26 bits, beside the double nearest to it.
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

/// start + t rate for |start| <= 1. The product of the leading parts is exact; the rest is 2^-26 of it and is rounded once or
/// twice. So the error of the fraction is some 2^-79 |t rate|, beside a rounding of the fraction itself.
template <class T>
inline Phase<T> phase_at(T t, Rate<T> rate, T start) {
    const T t_leading = leading_bits(t);
    const T product = t_leading * rate.leading;
    const T rest = t_leading * rate.rest + (t - t_leading) * rate.whole;
    const T whole = round_even(product + (rest + start));
    return {whole, ((product - whole) + start) + rest};
}

/// A phase up to 2^53, `fours` + whole + fraction. `fours` is a multiple of 4, so that the small number `whole` tells even from
/// odd also where the sum has no bit to spare.
template <class T>
struct LatePhase {
    T fours;
    T whole;
    T fraction;  ///< in [-1/2, 1/2]
};

/// start + t rate for |start| <= 1 and |t rate| <= 2^53. Both factors are cut in two, and each of the three larger products is
/// exact and leaves its whole part before the sum. So the error of the fraction is at most 2^-103 |t rate|, beside a rounding
/// of the fraction itself.
template <class T>
inline LatePhase<T> late_phase_at(T t, DoubleDouble<T> rate, T start) {
    constexpr double rounder_to_fours = 4 * rounder;
    const T t_leading = leading_bits(t), t_rest = t - t_leading;
    const T leading = leading_bits(rate.hi), rest = rate.hi - leading;
    const T product = t_leading * leading;
    const T fours = (product + rounder_to_fours) - rounder_to_fours;
    const T cross = t_leading * rest, other_cross = t_rest * leading;
    const T cross_whole = round_even(cross), other_whole = round_even(other_cross);
    const auto small = DoubleDouble<T>{product - fours, T{}} + (cross - cross_whole) + (other_cross - other_whole) +
                       (t_rest * rest + t * rate.lo) + start;
    const T whole = round_even(small.hi);
    return {fours, (cross_whole + other_whole) + whole, (small.hi - whole) + small.lo};
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
