// The order of Taylor's method and the length of its steps, by the tolerance.
//
// The length follows from the tolerance as in Jorba & Zou, Experimental Mathematics 14 (2005), 3.2: the last coefficients give
// the radius of convergence, and the last term is kept below the tolerance. Their order, -ln(tolerance)/2 + 1, is the best one
// if products of series are the only cost of a step. Here the sines, the time and the length of a step cost the same for every
// order, so that higher orders with longer steps are faster: 25 instead of 19 for a tolerance of 1e-15, 21 instead of 11 for
// 1e-8.
#pragma once

#include "arithmetic/exponential.hpp"
#include "kernels/taylor_series.hpp"

namespace pendula::kernels::inline PENDULA_ISA {

/// The orders that are used; all are odd. The cost of a time never rises with the tolerance (bench/taylor_bench.cpp).
inline constexpr int taylor_order_limit = taylor_coefficients - 1;
inline constexpr int taylor_middle_order = 21;  // from a tolerance of 1e-12
inline constexpr int taylor_low_order = 17;     // from a tolerance of 1e-5

/// An order as a type. Making it a compile-time constant saves a third of the time.
template <int n>
struct Order {
    static constexpr int value = n;
};

/// The result of `act` for one of the orders that are used.
template <class Act>
inline auto with_order(int order, const Act& act) {
    if (order == taylor_order_limit) return act(Order<taylor_order_limit>{});
    if (order == taylor_middle_order) return act(Order<taylor_middle_order>{});
    return act(Order<taylor_low_order>{});
}

/// The order and the relative length of the steps.
struct StepControl {
    int order;
    double log2_fraction;  ///< log2 of the step length divided by the radius of convergence
};

/// The order and length for a tolerance in (0, 1). A tolerance below 2^-52, the precision of a double, gives those of 2^-52.
inline StepControl step_control(double tolerance) {
    const int order = tolerance < 1e-12 ? taylor_order_limit : tolerance < 1e-5 ? taylor_middle_order : taylor_low_order;
    const double bounded = tolerance < 0x1p-52 ? 0x1p-52 : tolerance;
    // With the last term below these parts of the tolerance, what a step leaves out is below a fiftieth of it
    // (tests/cpp/taylor_tolerance_test.cpp). At the smallest tolerance that is as small as the rounding error, which
    // compensated summation keeps far below 1e-16 for each step.
    const double part = order == taylor_order_limit ? 0x1p-7 : 0x1p-6;
    return {order, log(bounded * part) * inverse_ln2[0] / order};
}

/// An approximation of log2 |x| + 1023, linear between powers of two, which is at most 0.09 too small. 0 for x = 0.
template <class T>
inline T log2_by_lines(T x) {
    return (from_bits<T>(((bits(x) & ~sign_bit) >> 20) + bits(splat<T>(rounder))) - rounder) * 0x1p-32;
}

/// 2^x with a relative error below 0.1 % for |x| < 1000.
template <class T>
inline T exp2_by_cubic(T x) {
    const T n = (x + rounder) - rounder;
    const T f = x - n;
    return scale(1.0 + f * (0.6931 + f * (0.2402 + f * 0.0555)), n);
}

template <class T>
inline T larger(T a, T b) {
    return select(a > b, a, b);
}

template <class T>
inline T smaller(T a, T b) {
    return select(a < b, a, b);
}

/// log2 of the length of a step in its unit, as the coefficients of a series allow it. The sizes of `start` and of v[0], v[1]
/// and v[2] are those of the quantity and of its change in a step.
///
/// Where the motion is nearly even or odd in time, every other coefficient is near 0, and one of the others may be so by
/// chance: the last two may be small, but not the last four. For steps of up to a fifth (2^-2.27) of the radius two are enough.
template <int order, class T>
inline T log2_length(double log2_fraction, T start, const Series<T>& v) {
    const T size = log2_by_lines(larger(larger(abs(start), abs(v[0])), larger(abs(v[1]), abs(v[2]))));
    const auto radius = [&](int k) { return (size - log2_by_lines(v[k])) * (1.0 / k); };
    T least = smaller(radius(order), radius(order - 1));
    if (order < taylor_order_limit || log2_fraction > -2.27)
        least = smaller(least, smaller(radius(order - 2), radius(order - 3)));
    return least + log2_fraction;
}

/// The length in its unit. At most 8: as |omega| unit < 2, the initial velocity turns the angle by less than 16 rad.
template <class T>
inline T length_from_log2(T log2) {
    return exp2_by_cubic(smaller(log2, splat<T>(3.0)));
}

}  // namespace pendula::kernels::inline PENDULA_ISA
