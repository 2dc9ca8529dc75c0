// The Taylor coefficients of the motion of a pendulum, computed two orders at a time.
//
// With time in a unit, let v = omega unit, C = alpha unit^2 cos(theta), S = alpha unit^2 sin(theta) and drag = beta unit. Then
//     v' = -S - drag v + torque + drive,    S' = v C,    C' = -v S.
// Without a drive this is v'' = -v C - drag v' and C' = v v' + drag v^2 - torque v. Then one of the two products of series is v
// v' = (v^2/2)', a square, which needs half as many multiplications.
//
// The sum of the products of an order starts with the middle terms and ends with the outer ones, so that only its last terms
// depend on the order before. Two orders are computed together because they use the same coefficients: the pairs of factors
// differ by one index.
//
// Each series is a function of its own that is not inlined. In one piece with the rest of a step, compilers order its thousand
// operations less well: with a drive a step then takes a tenth longer.
#pragma once

#include "arithmetic/double_double.hpp"
#include "kernels/equation.hpp"

namespace pendula::kernels::inline PENDULA_ISA {

using namespace arithmetic;

/// The coefficients of powers of time; 0 above the order.
template <class T>
using Series = T[taylor_coefficients];

/// The terms of the equation during a step, in the unit of time.
template <class T>
struct TaylorTerms {
    Terms<T> k;
    T drive;        ///< drive cos(phase) at the start of the step
    T drive_slope;  ///< its derivative
    T pull;         ///< pull + pivot cos(phase) at the start of the step
    T pivot;        ///< pivot cos(phase) at the start of the step
    T pull_slope;   ///< the derivative of pull and of pivot
    T square_frequency;
};

/// The coefficients k and k + 1 of a product.
template <class T>
struct TwoOrders {
    T first;
    T second;
};

template <class T>
inline T pair_of(const Series<T>& x, const Series<T>& y, int j, int k) {
    return x[j] * y[k - j] + x[k - j] * y[j];
}

/// The coefficients k and k + 1 of x^2/2, for even k >= 2.
template <int k, class T>
inline TwoOrders<T> half_square(const Series<T>& x) {
    constexpr int middle = k / 2;
    T far = x[middle + 1];
    TwoOrders<T> sum{0.5 * (x[middle] * x[middle]), x[middle] * far};
    for (int j = middle - 1; j >= 0; --j) {
        sum.first = sum.first + x[j] * far;
        far = x[k + 1 - j];
        sum.second = sum.second + x[j] * far;
    }
    return sum;
}

/// The coefficients k and k + 1 of x y without the outermost pair of products in each, for even k >= 2.
template <int k, class T>
inline TwoOrders<T> inner_product(const Series<T>& x, const Series<T>& y) {
    constexpr int middle = k / 2;
    T far_x = x[middle + 1], far_y = y[middle + 1];
    TwoOrders<T> sum{x[middle] * y[middle], x[middle] * far_y + far_x * y[middle]};
    for (int j = middle - 1; j >= 1; --j) {
        sum.first = sum.first + (x[j] * far_y + far_x * y[j]);
        far_x = x[k + 1 - j];
        far_y = y[k + 1 - j];
        sum.second = sum.second + (x[j] * far_y + far_x * y[j]);
    }
    return sum;
}

/// v[n] without a drive, from the coefficient n - 2 of v C and from before = v[n-1].
template <Forcing forcing, class T>
inline T undriven_coefficient(const TaylorTerms<T>& f, T product, T before, int n) {
    const T fall = product * (-1.0 / ((n - 1) * n));
    if constexpr (forcing == Forcing::none)
        return fall;
    else
        return fall - (f.k.drag * before) * (1.0 / n);
}

/// C[n] without a drive, from the coefficients n and n - 1 of v^2/2 and from v_before = v[n-1].
template <Forcing forcing, class T>
inline T undriven_cosine(const TaylorTerms<T>& f, T half_square, T half_square_before, T v_before, int n) {
    if constexpr (forcing == Forcing::none)
        return half_square;
    else
        return half_square + (2.0 * f.k.drag * half_square_before - f.k.torque * v_before) * (1.0 / n);
}

/// Computes C[k], C[k+1], v[k+2] and v[k+3], and all further coefficients up to `order`.
template <Forcing forcing, int order, int k, class T>
[[gnu::always_inline]] inline void undriven_orders(const TaylorTerms<T>& f, T half_square_before, Series<T>& v, Series<T>& C) {
    const auto half = half_square<k>(v);
    C[k] = undriven_cosine<forcing>(f, half.first, half_square_before, v[k - 1], k);
    C[k + 1] = undriven_cosine<forcing>(f, half.second, half.first, v[k], k + 1);
    const auto product = inner_product<k>(v, C);
    v[k + 2] = undriven_coefficient<forcing>(f, product.first + pair_of(v, C, 0, k), v[k + 1], k + 2);
    v[k + 3] = undriven_coefficient<forcing>(f, product.second + pair_of(v, C, 0, k + 1), v[k + 2], k + 3);
    if constexpr (k + 3 < order) undriven_orders<forcing, order, k + 2>(f, half.second, v, C);
}

/// Computes v up to `order` from v[0] and v[1], and C up to `order` - 2 from C[0], without a drive.
template <Forcing forcing, int order, class T>
[[gnu::noinline]] inline void undriven_series(const TaylorTerms<T>& f, Series<T>& v, Series<T>& C) {
    const T half = 0.5 * (v[0] * v[0]), next_half = v[0] * v[1];
    C[1] = undriven_cosine<forcing>(f, next_half, half, v[0], 1);
    v[2] = undriven_coefficient<forcing>(f, v[0] * C[0], v[1], 2);
    v[3] = undriven_coefficient<forcing>(f, pair_of(v, C, 0, 1), v[2], 3);
    undriven_orders<forcing, order, 2>(f, next_half, v, C);
}

/// The series of a driven motion: those of an undriven one, and S and the drive.
template <class T>
struct DrivenSeries {
    Series<T>& v;
    Series<T>& C;
    Series<T> S;
    Series<T> drive;
};

/// Computes order n of S, C and the drive, and v[n+1], from the coefficients n - 1 of v C and v S.
template <class T>
inline void driven_coefficient(const TaylorTerms<T>& f, T v_cosine, T v_sine, int n, DrivenSeries<T>& x) {
    x.S[n] = v_cosine * (1.0 / n);
    x.C[n] = v_sine * (-1.0 / n);
    if (n > 1) x.drive[n] = (x.drive[n - 2] * f.square_frequency) * (-1.0 / ((n - 1) * n));
    x.v[n + 1] = (x.drive[n] - x.S[n] - f.k.drag * x.v[n]) * (1.0 / (n + 1));
}

template <int order, int k, class T>
[[gnu::always_inline]] inline void driven_orders(const TaylorTerms<T>& f, DrivenSeries<T>& x) {
    const auto cosine = inner_product<k>(x.v, x.C);
    const auto sine = inner_product<k>(x.v, x.S);
    driven_coefficient(f, cosine.first + pair_of(x.v, x.C, 0, k), sine.first + pair_of(x.v, x.S, 0, k), k + 1, x);
    driven_coefficient(f, cosine.second + pair_of(x.v, x.C, 0, k + 1), sine.second + pair_of(x.v, x.S, 0, k + 1), k + 2, x);
    if constexpr (k + 3 < order) driven_orders<order, k + 2>(f, x);
}

/// Computes v up to `order` from v[0] and v[1], and C up to `order` - 1 from C[0] and S[0], with a drive.
template <int order, class T>
[[gnu::noinline]] inline void driven_series(const TaylorTerms<T>& f, T sine, Series<T>& v, Series<T>& C) {
    DrivenSeries<T> x{v, C, {}, {}};
    x.S[0] = sine;
    x.drive[0] = f.drive;
    x.drive[1] = f.drive_slope;
    driven_coefficient(f, v[0] * C[0], v[0] * sine, 1, x);
    driven_coefficient(f, pair_of(v, C, 0, 1), pair_of(v, x.S, 0, 1), 2, x);
    driven_orders<order, 2>(f, x);
}

/// The coefficient n of x y.
template <int n, class T>
inline T product_coefficient(const Series<T>& x, const Series<T>& y) {
    T sum = n % 2 == 0 ? x[n / 2] * y[n / 2] : pair_of(x, y, n / 2, n);
    for (int j = n / 2 - 1; j >= 0; --j) sum = sum + pair_of(x, y, j, n);
    return sum;
}

/// The series of a motion with a shaken pivot, with or without a drive. Here sine and cosine are those of theta, and pull =
/// alpha unit^2 plus the term of the pivot:
///     v' = drive + torque - pull sine - drag v,    sine' = v cosine,    cosine' = -v sine,    C = pull cosine.
template <class T>
struct ShakenSeries {
    Series<T>& v;
    Series<T>& C;
    Series<T> sine, cosine, drive, pull;
};

/// Computes order n of sine, cosine, drive, pull and C, and v[n+1], and all further coefficients: v up to `order`, C up to
/// `order` - 1.
template <int order, int n, class T>
[[gnu::always_inline]] inline void shaken_orders(const TaylorTerms<T>& f, ShakenSeries<T>& x) {
    x.sine[n] = product_coefficient<n - 1>(x.v, x.cosine) * (1.0 / n);
    x.cosine[n] = product_coefficient<n - 1>(x.v, x.sine) * (-1.0 / n);
    if constexpr (n > 1) {
        x.drive[n] = (x.drive[n - 2] * f.square_frequency) * (-1.0 / ((n - 1) * n));
        x.pull[n] = ((n == 2 ? f.pivot : x.pull[n - 2]) * f.square_frequency) * (-1.0 / ((n - 1) * n));
    }
    x.C[n] = product_coefficient<n>(x.pull, x.cosine);
    x.v[n + 1] = (x.drive[n] - product_coefficient<n>(x.pull, x.sine) - f.k.drag * x.v[n]) * (1.0 / (n + 1));
    if constexpr (n + 1 < order) shaken_orders<order, n + 1>(f, x);
}

/// Computes v up to `order` from v[0] and v[1], and C up to `order` - 1, with a shaken pivot.
template <int order, class T>
[[gnu::noinline]] inline void shaken_series(const TaylorTerms<T>& f, SinCos<T> angle, Series<T>& v, Series<T>& C) {
    ShakenSeries<T> x{v, C, {}, {}, {}, {}};
    x.sine[0] = angle.sin;
    x.cosine[0] = angle.cos;
    x.drive[0] = f.drive;
    x.drive[1] = f.drive_slope;
    x.pull[0] = f.pull;
    x.pull[1] = f.pull_slope;
    C[0] = x.pull[0] * x.cosine[0];
    shaken_orders<order, 1>(f, x);
}

/// Computes u[k+2], u[k+3] and all further coefficients up to `order` of the linearised motion u' = w, w' = -C u - drag w.
template <int order, int k, class T>
[[gnu::always_inline]] inline void tangent_orders(T drag, const Series<T>& C, Series<T>& u) {
    const auto product = inner_product<k>(u, C);
    const auto coefficient = [&](T sum, int n) { return sum * (-1.0 / ((n - 1) * n)) - (drag * u[n - 1]) * (1.0 / n); };
    u[k + 2] = coefficient(product.first + pair_of(u, C, 0, k), k + 2);
    u[k + 3] = coefficient(product.second + pair_of(u, C, 0, k + 1), k + 3);
    if constexpr (k + 3 < order) tangent_orders<order, k + 2>(drag, C, u);
}

/// Computes u up to `order` from u[0] and u[1].
template <int order, class T>
[[gnu::noinline]] inline void tangent_series(T drag, const Series<T>& C, Series<T>& u) {
    u[2] = -0.5 * (u[0] * C[0] + drag * u[1]);
    u[3] = pair_of(u, C, 0, 1) * (-1.0 / 6.0) - (drag * u[2]) * (1.0 / 3.0);
    tangent_orders<order, 2>(drag, C, u);
}

}  // namespace pendula::kernels::inline PENDULA_ISA
