#include "pendula/analysis.hpp"

#include "arithmetic/arctangent.hpp"
#include "arithmetic/exponential.hpp"
#include "checks.hpp"
#include "closed_form/energy_balance.hpp"
#include "pendula/angle.hpp"

namespace pendula {

using namespace arithmetic;
using Number = EnergyBalance::Number;

namespace {

/// The largest power of two <= |x|, for x != 0, normal or denormal.
double power_of_two_below(double x) noexcept {
    const double normal = abs(x) < 0x1p-1022 ? x * 0x1p54 : x;
    const double power = from_bits<double>(bits(normal) & 0x7ff0000000000000);
    return abs(x) < 0x1p-1022 ? power * 0x1p-54 : power;
}

double ulp(double x) noexcept {
    const double power = power_of_two_below(x);
    return x == 0 ? 0x1p-1074 : power < 0x1p-1022 ? 0x1p-1074 : power * 0x1p-52;
}

/// A bound on the change of the gap when theta, omega and alpha change by one unit in the last place, to first and second
/// order.
double change_by_one_ulp(const EnergyBalance& b, double theta_ulp, double omega_ulp) noexcept {
    const double alpha_ulp = power_of_two_below(b.alpha) * 0x1p-52;  // as for a normal number, also if alpha is denormal
    const double sine = b.sine.hi, cosine = b.cosine.hi;
    const double first =
        b.alpha * abs(sine * cosine) * theta_ulp + abs(b.half_omega.hi) * omega_ulp + cosine * cosine * alpha_ulp;
    const double second = 0.25 * b.alpha * abs(cosine * cosine - sine * sine) * theta_ulp * theta_ulp +
                          0.25 * omega_ulp * omega_ulp + abs(sine * cosine) * theta_ulp * alpha_ulp;
    return first + second;
}

/// The time (3.5) from theta to 0.999 theta_max, or 10/sqrt(alpha) at rest or beyond that angle. The difference of the two
/// asinh(tan(.)) in (3.5) is computed as a single one, asinh((sin A - sin B)/(cos A cos B)), without cancellation close to
/// 0.999 theta_max.
double separatrix_time(const EnergyBalance& b, double omega) noexcept {
    const double root = sqrt(b.alpha) * b.unit;
    const Number mark_sine{mark_sine_dd[0], mark_sine_dd[1]};
    const Number mark_cosine{mark_cosine_dd[0], mark_cosine_dd[1]};
    const auto sine = omega < 0 ? -b.sine : b.sine;
    const auto argument = (mark_sine - sine) / (mark_cosine * b.cosine);
    return omega == 0 || argument.hi <= 0 ? 10 / root : asinh(argument.hi) / root;
}

const Number two_pi{two_pi_dd[0], two_pi_dd[1]};

void set_oscillation(EnergyBalance& b) noexcept {
    b.frequency = agm(b.root_alpha, sqrt(b.gap)) / two_pi;
    b.speed = b.half_omega / b.root_alpha;
    const double largest = abs(b.sine.hi) > abs(b.speed.hi) ? abs(b.sine.hi) : abs(b.speed.hi);
    const double power = power_of_two_below(largest > 0x1p-1000 ? largest : 0x1p-1000);
    const auto s = scaled(b.sine, 1 / power);
    const auto w = scaled(b.speed, 1 / power);
    b.k = scaled(sqrt(s * s + w * w), power);
}

/// r of (3.8), and 1 - r^2.
struct SeriesModulus {
    double r;
    double complement;
};

SeriesModulus series_modulus(const EnergyBalance& b, double alpha) noexcept {
    if (b.regime == Regime::oscillation) return {b.k.hi, b.gap.hi / b.alpha};
    return {sqrt(alpha) / b.unit / sqrt(b.rise.hi), -(b.gap / b.rise).hi};
}

Analysis nothing() noexcept { return {Regime::oscillation, __builtin_nan(""), __builtin_nan("")}; }

}  // namespace

bool is_legal(double alpha, State initial) noexcept { return !check(Pendulum{.alpha = alpha}, initial); }

EnergyBalance balance_energy(double alpha, State initial) noexcept {
    EnergyBalance b{};
    const double root = sqrt(alpha);
    const double half = 0.5 * abs(initial.omega);
    b.unit = power_of_two_below(root > half ? root : half);
    b.alpha = alpha / b.unit / b.unit;
    const double omega = initial.omega / b.unit;
    const auto angle = sincos_double_double(0.5 * initial.theta);
    b.sine = angle.sin;
    b.cosine = angle.cos;
    b.half_omega = {0.5 * omega, 0};
    const auto kinetic = two_prod(b.half_omega.hi, b.half_omega.hi);
    b.rise = b.sine * b.sine * b.alpha + kinetic;
    b.gap = b.cosine * b.cosine * b.alpha - kinetic;
    const double change = change_by_one_ulp(b, ulp(initial.theta), ulp(initial.omega) / b.unit);
    b.regime = abs(b.gap.hi) <= change ? Regime::separatrix : b.gap.hi > 0 ? Regime::oscillation : Regime::rotation;
    b.root_alpha = sqrt(Number{b.alpha, 0});
    if (b.regime == Regime::oscillation) set_oscillation(b);
    if (b.regime == Regime::rotation) b.frequency = scaled(agm(sqrt(b.rise), sqrt(-b.gap)) / two_pi, 2.0);
    return b;
}

Analysis analyze(const EnergyBalance& b, double omega) noexcept {
    if (b.regime == Regime::separatrix) return {b.regime, omega < 0 ? -pi : pi, separatrix_time(b, omega)};
    const double tau = (Number{1, 0} / b.frequency).hi / b.unit;
    if (b.regime == Regime::rotation) return {b.regime, pi, tau};
    const double complement = sqrt(b.gap / Number{b.alpha, 0}).hi;
    return {b.regime, 2 * atan2(b.k.hi, complement), tau};
}

Analysis analyze(double alpha, State initial) noexcept {
    return is_legal(alpha, initial) ? analyze(balance_energy(alpha, initial), initial.omega) : nothing();
}

double characteristic_time(const Pendulum& p, State initial) noexcept {
    if (is_conservative(p)) return analyze(p.alpha, initial).tau;
    if (!is_legal(p.alpha, initial)) return nothing().tau;
    return 2 * pi / (is_driven(p) ? p.drive_frequency : sqrt(p.alpha));
}

bool rests_on_top(const Pendulum& p, State initial) noexcept {
    if (p.torque != 0 || p.drive_amplitude != 0 || initial.omega != 0) return false;
    return analyze(p.alpha, initial).regime == Regime::separatrix;
}

double series_terms(double alpha, State initial, double epsilon) noexcept {
    if (!is_legal(alpha, initial) || !(epsilon > 0 && epsilon < 1)) return __builtin_nan("");
    const auto b = balance_energy(alpha, initial);
    if (b.regime == Regime::separatrix) return 0;
    const auto [r, complement] = series_modulus(b, alpha);
    const double log_r_squared = r < 0.5 ? 2 * log(r) : log1p(-complement);
    const double terms = (log(epsilon) + log(complement)) / log_r_squared;
    return terms > 0 ? ceiling(terms) : 0;
}

Outcome analyze_by_series(double alpha, State initial, double epsilon, Analysis& analysis, const Control& control) noexcept {
    if (const auto refusal = check(Pendulum{.alpha = alpha}, initial)) return refusal;
    if (const auto refusal = check_rule("epsilon", epsilon, Rule::fraction)) return refusal;
    const double last = series_terms(alpha, initial, epsilon);
    if (last > series_terms_limit)
        return Refusal{.reason = Refusal::Reason::too_many_terms, .value = last, .most = series_terms_limit};
    analysis = analyze(alpha, initial);
    if (analysis.regime == Regime::separatrix) return {};
    constexpr double terms_between_looks = 1 << 20;
    const auto b = balance_energy(alpha, initial);
    const double r = series_modulus(b, alpha).r;
    double term = 1, sum = 1, n = 1;
    while (n <= last) {
        if (!control.proceed(n / last)) return Outcome::Kind::stopped;
        for (const double end = n + terms_between_looks; n <= last && n < end; ++n) {
            const double factor = (2 * n - 1) / (2 * n);
            term *= (factor * r) * (factor * r);
            sum += term;
        }
    }
    const double root = sqrt(b.regime == Regime::oscillation ? b.alpha : b.rise.hi) * b.unit;
    analysis.tau = (b.regime == Regime::oscillation ? 2 * pi : pi) / root * sum;
    return {};
}

}  // namespace pendula
