// The steps of `replay`. As kernels.cpp, this file is compiled once for each instruction set and uses no templates of std::.
#include "kernels/dispatch.hpp"
#include "kernels/equation.hpp"

namespace pendula::kernels::inline PENDULA_ISA {
namespace {

using T = Pack<replay_size>;

/// Rounds each lane to float.
template <class V>
V to_float(const V& x) {
    if constexpr (requires { x.a; }) {
        return {to_float(x.a), to_float(x.b)};
    } else {
        typedef float Floats __attribute__((vector_size(sizeof(V) / 2)));
        return __builtin_convertvector(__builtin_convertvector(x, Floats), V);
    }
}

/// A pack of floats, kept as doubles. An operation on doubles whose result is rounded to float gives what the operation on
/// floats gives, because a double has more than twice the bits of a float (Figueroa 1995).
struct Single {
    T value;
};
Single operator+(const Single& x, const Single& y) { return {to_float(x.value + y.value)}; }
Single operator-(const Single& x, const Single& y) { return {to_float(x.value - y.value)}; }
Single operator*(const Single& x, const Single& y) { return {to_float(x.value * y.value)}; }
Single operator/(const Single& x, double y) { return {to_float(x.value / y)}; }

T doubles(const T& x) { return x; }
T doubles(const Single& x) { return x.value; }

/// Doubles that are numbers of type N already.
template <class N>
N as(const T& x) {
    if constexpr (requires(N n) { n.value; })
        return {x};
    else
        return x;
}

/// Doubles as numbers of type N.
template <class N>
N rounded(const T& x) {
    if constexpr (requires(N n) { n.value; })
        return {to_float(x)};
    else
        return x;
}

template <class V>
V load(const double* from) {
    V x;
    if constexpr (requires { x.a; })
        x = {load<decltype(x.a)>(from), load<decltype(x.a)>(from + lanes<decltype(x.a)>)};
    else
        __builtin_memcpy(&x, from, sizeof x);
    return x;
}

void store(ReplayRow& to, const T& x) { __builtin_memcpy(to, &x, sizeof x); }

template <class N>
N at(const ReplayRow& from) {
    return as<N>(load<T>(from));
}

template <class N>
N chosen(const Mask<T>& mask, const N& x, const N& y) {
    return as<N>(select<T>(mask, doubles(x), doubles(y)));
}

/// f(x) of each program.
template <class N>
N force_of(const ReplayChunk& c, const N& x) {
    const T force = load<T>(c.force);
    const auto is = [&](Force f) { return force == static_cast<double>(f); };
    N f = x;
    if (c.has_polynomial) {
        const N cubic = x - x * x * x / 6.0;
        f = chosen(is(Force::cubic), cubic, f);
        f = chosen(is(Force::quintic), cubic + x * x * x * x * x / 120.0, f);
    }
    if (c.has_sine) {
        const auto is_sine = is(Force::sine), is_cosine = is(Force::cosine);
        const auto circle = sincos(select<T>(is_sine | is_cosine, doubles(x), T{}));
        f = chosen(is_sine, rounded<N>(circle.sin), f);
        f = chosen(is_cosine, rounded<N>(circle.cos), f);
    }
    return f;
}

template <class N>
void replay_steps(ReplayChunk& c, double first, int steps) {
    const std::size_t stages = c.stages;
    const auto& p = c.parameters;
    const Terms<N> terms{at<N>(p.alpha), at<N>(p.beta), at<N>(p.torque), at<N>(p.drive_amplitude), at<N>(p.pivot_amplitude)};
    N theta = at<N>(c.theta), omega = at<N>(c.omega);
    N v[stages_limit], a[stages_limit];
    for (int step = 0; step < steps; ++step) {
        for (std::size_t s = 0; s < stages; ++s) {
            const ReplayRow* const own = c.coefficients + s * (3 + 4 * stages);
            N x = at<N>(own[0]) * theta, w = at<N>(own[1]) * omega;
            if (s > 0) {
                N dx{}, dw{};
                for (std::size_t j = 0; j < s; ++j) {
                    const ReplayRow* const of_j = own + 3 + j;
                    dx = dx + (at<N>(of_j[0]) * v[j] + at<N>(of_j[stages]) * a[j]);
                    dw = dw + (at<N>(of_j[2 * stages]) * v[j] + at<N>(of_j[3 * stages]) * a[j]);
                }
                x = x + dx;
                w = w + dw;
            }
            N cosine = as<N>(splat<T>(1.0));
            if (c.is_driven) {
                const N t = rounded<N>(splat<T>(first + step)) * at<N>(c.dt);
                const N phase = at<N>(p.drive_frequency) * (t + at<N>(own[2])) + at<N>(p.drive_phase);
                cosine = rounded<N>(cos(doubles(phase)));
            }
            v[s] = w;
            a[s] = acceleration(terms, acting<Forcing::shaken>(terms, cosine), force_of(c, at<N>(c.scale) * x), w);
        }
        N d_theta{}, d_omega{};
        for (std::size_t j = 0; j < stages; ++j) {
            const ReplayRow* const of_j = c.sums + j;
            d_theta = d_theta + (at<N>(of_j[0]) * v[j] + at<N>(of_j[stages]) * a[j]);
            d_omega = d_omega + (at<N>(of_j[2 * stages]) * v[j] + at<N>(of_j[3 * stages]) * a[j]);
        }
        theta = theta + d_theta;
        omega = omega + d_omega;
    }
    store(c.theta, doubles(theta));
    store(c.omega, doubles(omega));
}

}  // namespace

void replay(ReplayChunk& chunk, double first, int steps) { replay_steps<T>(chunk, first, steps); }
void replay_single(ReplayChunk& chunk, double first, int steps) { replay_steps<Single>(chunk, first, steps); }

}  // namespace pendula::kernels::inline PENDULA_ISA
