// Times as phases: a product with a rate in two doubles, and its whole and fractional part.
#pragma once

#include "arithmetic/double_double.hpp"

namespace pendula::kernels::inline PENDULA_ISA {

using namespace arithmetic;

/// The product t rate as a double-double: t is cut by its bits, so that no t overflows. Relative error 2^-104.
template <class T>
inline DoubleDouble<T> turned(T t, DoubleDouble<T> rate) {
    const auto r = split(rate.hi);
    const T t_hi = from_bits<T>(bits(t) & ~std::int64_t{0x7ffffff});
    const T t_lo = t - t_hi;
    const T p = t * rate.hi;
    const T rest = ((t_hi * r.hi - p) + t_hi * r.lo + t_lo * r.hi) + t_lo * r.lo;
    return {p, rest + t * rate.lo};
}

template <class T>
struct Phase {
    T whole;
    T fraction;  ///< in [-1/2, 1/2]
};

template <class T>
inline Phase<T> to_phase(DoubleDouble<T> x, T start) {
    const auto sum = two_sum(x.hi, start);
    const T whole = round_even(sum.hi);
    return {whole, (sum.hi - whole) + (sum.lo + x.lo)};
}

}  // namespace pendula::kernels::inline PENDULA_ISA
