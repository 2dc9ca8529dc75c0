#include "pendula/exact.hpp"

#include "arithmetic/elliptic.hpp"
#include "arithmetic/exponential.hpp"
#include "closed_form/energy_balance.hpp"
#include "kernels/dispatch.hpp"
#include "kernels/exact_kernel.hpp"
#include "pendula/angle.hpp"

namespace pendula {

using namespace arithmetic;
using Number = EnergyBalance::Number;
using kernels::ordinary_periods;

namespace {

/// The theta functions of nome q as cubics in x = sin^2 z (DLMF 20.2): theta1 = 2 q^(1/4) sin z first(x),
/// theta2 = 2 q^(1/4) cos z second(x), theta3 = third(x), theta4 = fourth(x). q <= e^-pi: the next terms are below 1e-21.
struct ThetaSeries {
    double first[4];
    double second[4];
    double third[4];
    double fourth[4];
};

ThetaSeries theta_series(double q) noexcept {
    const double q2 = q * q, q4 = q2 * q2, q6 = q4 * q2, q9 = q6 * q2 * q, q12 = q6 * q6;
    ThetaSeries s{{1 - 3 * q2 + 5 * q6 - 7 * q12, 4 * q2 - 20 * q6 + 56 * q12, 16 * q6 - 112 * q12, 64 * q12},
                  {1 + q2 + q6 + q12, -4 * q2 - 12 * q6 - 24 * q12, 16 * q6 + 80 * q12, -64 * q12},
                  {},
                  {}};
    const double odd[4] = {2 * q + 2 * q9, -4 * q - 36 * q9, 96 * q9, -64 * q9};
    const double even[4] = {1 + 2 * q4, -16 * q4, 16 * q4, 0};
    for (int i = 0; i < 4; ++i) {
        s.third[i] = even[i] + odd[i];
        s.fourth[i] = even[i] - odd[i];
    }
    return s;
}

void set(double (&to)[4], const double (&from)[4], double factor) noexcept {
    for (int i = 0; i < 4; ++i) to[i] = factor * from[i];
}

/// The cubics of sn, cn, dn by which the angle and its speed are written, with k of the motion's modulus and k' its
/// complement; `speed` is the largest speed. Trigonometric for k^2 <= 1/2, else by Jacobi's imaginary transformation.
void set_cubics(Exact& e, double k, double complement, double speed) noexcept {
    const bool is_rotation = e.analysis.regime == Regime::rotation;
    const bool is_hyperbolic = k * k > 0.5;
    const auto s = is_hyperbolic ? theta_series(nome(complement * complement, k)) : theta_series(nome(k * k, complement));
    const double second = s.second[0], third = s.third[0], fourth = s.fourth[0];  // at x = 0
    if (is_rotation) {
        set(e.angle_num, s.first, is_hyperbolic ? third / second : 1 / sqrt(complement));
        set(e.angle_den, is_hyperbolic ? s.fourth : s.second, 1);
        set(e.speed_num, s.third, speed * (is_hyperbolic ? second : fourth) / third);
        set(e.speed_den, is_hyperbolic ? s.second : s.fourth, 1);
    } else {
        set(e.angle_num, s.first, (is_hyperbolic ? sqrt(k) : k / sqrt(complement)) * third / second);
        set(e.angle_den, s.third, 1);
        set(e.speed_num, is_hyperbolic ? s.fourth : s.second, speed * (is_hyperbolic ? second / fourth : fourth / second));
        set(e.speed_den, is_hyperbolic ? s.second : s.fourth, 1);
    }
    if (is_hyperbolic) {
        const auto mean = [](double x) { return agm(Number{1, 0}, Number{x, 0}).hi; };
        e.stretch = pi * mean(k) / mean(complement);  // pi K/K'
    }
}

void set_rate(Exact& e, Number rate, double unit) noexcept {
    e.rate_hi = rate.hi * unit;
    e.rate_lo = rate.lo * unit;
}

/// The rate's relative error is at most 2^-103 (1 + x) with x = alpha cos^2(theta/2)/(|gap| 2K), as measured against ball
/// arithmetic: near the separatrix the gap is a difference of nearly equal numbers. The rounding of rate t included, the phase
/// is off by 2^-102 (1 + x) t/tau periods at most. The latest time is where that is 2^-41, but at least `ordinary_periods`, and
/// at most 2^52 periods: a double counts no more half periods.
void set_latest(Exact& e, const EnergyBalance& b) noexcept {
    const double cosine = b.cosine.hi;
    // 2K is sqrt(alpha) tau/2 for an oscillation, and more than that for a rotation.
    const double x = 2 * b.frequency.hi * b.root_alpha.hi * (cosine * cosine / abs(b.gap.hi));
    const double periods = 0x1p61 / (1 + x);
    e.latest = e.analysis.tau * (periods > 0x1p52 ? 0x1p52 : periods > ordinary_periods ? periods : ordinary_periods);
}

void set_separatrix(Exact& e, const EnergyBalance& b) noexcept {
    const double sense = e.initial.omega < 0 ? -1 : 1;
    const bool is_at_rest = e.initial.omega == 0;
    e.phase = asinh(b.sine.hi / b.cosine.hi);
    if (is_at_rest) {  // on top, where the interval has -pi only
        e.phase = -abs(e.phase);
        e.turns = round_even((e.initial.theta + pi) * inverse_two_pi_dd[0]);
    }
    e.stretch = 1;
    e.latest = 0x1.fffffffffffffp1023;
    set_rate(e, is_at_rest ? Number{} : scaled(b.root_alpha, sense), b.unit);
    e.angle_num[0] = e.angle_den[0] = e.speed_den[0] = 1;
    e.speed_num[0] = is_at_rest ? 0 : 2 * sense * b.root_alpha.hi * b.unit;
}

/// F(phi)/K by Carlson's integral, s and c of phi, dn^2 = 1 - k^2 s^2. Past F = K/2 by the way left to K, c R_F(k'^2 s^2, k'^2,
/// dn^2), which shrinks towards the turning point and past it counts on. Near the separatrix, where K is large, the integral's
/// relative error counts, and it is taken in double-double.
double initial_phase(double s, double c, double dn_squared, double complement) noexcept {
    const double sense = s < 0 ? -1 : 1;
    const double inverse_quarter = agm(Number{1, 0}, Number{complement, 0}).hi / (0.5 * pi);
    const auto integral = [complement](double x, double y, double z) {
        return complement < 0.01 ? carlson_rf(Number{x, 0}, Number{y, 0}, Number{z, 0}) : carlson_rf(x, y, z);
    };
    if (s * s * complement > c * c) {
        const double k2 = complement * complement;
        return sense - sense * c * integral(k2 * s * s, k2, dn_squared) * inverse_quarter;
    }
    const double passed = s * integral(c * c, dn_squared, 1.0) * inverse_quarter;
    return c >= 0 ? passed : 2 * sense - passed;
}

void set_oscillation(Exact& e, const EnergyBalance& b) noexcept {
    const double complement = sqrt(b.gap / Number{b.alpha, 0}).hi;
    set_rate(e, scaled(b.frequency, 2.0), b.unit);
    set_latest(e, b);
    set_cubics(e, b.k.hi, complement, 2 * (b.k * b.root_alpha).hi * b.unit);
    if (b.k.hi == 0) return;
    // The angle's own half turn has its cosine >= 0; the angle as given may lie in the other half.
    const double side = b.cosine.hi < 0 ? -1 : 1;
    const double s = side * (b.sine / b.k).hi;
    const double c = (b.speed / b.k).hi;
    e.phase = 0.5 * initial_phase(s, c, b.cosine.hi * b.cosine.hi, complement);
}

void set_rotation(Exact& e, const EnergyBalance& b) noexcept {
    const double sense = e.initial.omega < 0 ? -1 : 1;
    const double k = sqrt(Number{b.alpha, 0} / b.rise).hi;
    const double complement = sqrt(-b.gap / b.rise).hi;
    const double dn = (b.half_omega / sqrt(b.rise)).hi;
    const double side = b.cosine.hi < 0 ? -1 : 1;
    set_rate(e, scaled(b.frequency, sense), b.unit);
    set_latest(e, b);
    set_cubics(e, k, complement, 2 * sense * sqrt(b.rise).hi * b.unit);
    e.phase = 0.5 * initial_phase(side * b.sine.hi, abs(b.cosine.hi), dn * dn, complement);
}

}  // namespace

Exact make_exact(double alpha, State initial) noexcept {
    Exact e{};
    e.initial = initial;
    if (!is_legal(alpha, initial)) {
        e.analysis = analyze(alpha, initial);
        e.phase = e.rate_hi = e.turns = e.speed_num[0] = e.latest = __builtin_nan("");
        return e;
    }
    const auto b = balance_energy(alpha, initial);
    e.analysis = analyze(b, initial.omega);
    e.turns = initial.theta == pi ? 0 : split_turns(initial.theta).turns;  // `pi` lies below pi
    if (e.analysis.regime == Regime::separatrix) set_separatrix(e, b);
    if (e.analysis.regime == Regime::oscillation) set_oscillation(e, b);
    if (e.analysis.regime == Regime::rotation) set_rotation(e, b);
    return e;
}

double latest_time(const Exact& solution) noexcept { return solution.latest; }

Sample at(const Exact& solution, double t) noexcept {
    const bool is_late = abs(t) > kernels::ordinary_time(solution);
    const auto s = is_late ? kernels::late_closed_form(solution, t) : kernels::closed_form(solution, t);
    return {t, s.theta, s.omega, s.turns};
}

void at(const Exact& solution, std::size_t n, const double* t, double* theta, double* omega, double* turns) noexcept {
    kernels::dispatch().exact(solution, n, t, theta, omega, turns);
}

double sinusoid(const Exact& solution, double t) noexcept {
    if (solution.analysis.regime != Regime::oscillation) return __builtin_nan("");
    const double amplitude = solution.analysis.theta_max;
    if (amplitude == 0) return 0;
    const bool is_late = abs(t) > kernels::ordinary_time(solution);
    const auto rate = kernels::to_rate(Number{solution.rate_hi, solution.rate_lo});
    const auto p = is_late ? kernels::late_phase(solution, 0.0, t) : kernels::phase_at(t, rate, 0.0);
    const double start = pendula::phase(wrap(solution.initial.theta) / amplitude, solution.initial.omega);
    return amplitude * kernels::alternate(sin(pi * p.fraction + start), p.whole);
}

}  // namespace pendula
