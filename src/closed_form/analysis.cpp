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

/// minus d K/d ln k', of the complete elliptic integral K as a function of the complementary modulus k', from k^2 and k':
/// between pi/4 at k' = 1 and 1 at k' = 0. It is K (1 - sum)/k^2 - K with sum = k^2/2 + c_1^2 + 2 c_2^2 + 4 c_3^2 + ... of the
/// differences in the arithmetic-geometric mean (DLMF 19.8.6), where K - E = K sum.
double slope(double k_squared, double complement, double integral) noexcept {
    double a = 0.5 * (1 + complement), g = sqrt(complement);  // the first round
    double difference = 0.5 * k_squared / (1 + complement);   // (1 - k')/2
    double sum = 0;
    for (double weight = 1; difference > 1e-9 * a; weight *= 2) {
        sum += weight * (difference / k_squared) * difference;
        const double mean = 0.5 * (a + g);
        g = sqrt(a * g);
        difference = difference * difference / (4 * mean);
        a = mean;
    }
    return integral * (0.5 - sum);
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

double amplitude_of_period(double alpha, double tau) noexcept {
    if (!satisfies(Rule::positive, alpha) || !satisfies(Rule::positive, tau)) return __builtin_nan("");
    const double unit = power_of_two_below(sqrt(alpha));
    const auto root = sqrt(Number{alpha / unit / unit, 0});
    const double scaled_tau = tau * unit;
    if (scaled_tau < (two_pi / root).hi) return __builtin_nan("");
    if (scaled_tau > 160) return pi;  // root >= 1, so that K > 40
    const auto integral = root * (0.25 * scaled_tau);
    const auto quarter_turn = scaled(two_pi, 0.25);
    const auto above = integral - quarter_turn;
    if (above.hi <= 0) return 0;
    // K = (pi/2)(1 + k^2/4 + 9 k^4/64 + 25 k^6/256 + ...) (DLMF 19.5.1), inverted; below 1e-6 the next term is below 1e-18.
    const double x = (above / quarter_turn).hi;
    const double small = 4 * x * (1 - x * (2.25 - 3.875 * x));
    if (x < 1e-6) return 2 * atan2(sqrt(small), sqrt(1 - small));
    const Number one{1, 0};
    const double far = 16 * exp(-2 * integral.hi);  // K = ln(4/k') + ... (DLMF 19.12.1)
    auto square = x < 0.3 ? one - Number{small, 0} : Number{far, 0};
    auto rest = one - square;
    // K is nearly linear in ln k', so that Newton's method doubles the digits from the start.
    for (int iteration = 0; iteration < 6; ++iteration) {
        const auto excess = quarter_turn / agm(one, sqrt(square)) - integral;
        const double step = 2 * excess.hi / slope(rest.hi, sqrt(square.hi), integral.hi);
        const double factor = abs(step) < 0.1 ? step * (1 + 0.5 * step) : exp(step) - 1;
        if (rest.hi < 0.5) {
            rest = rest - square * factor;
            square = one - rest;
        } else {
            square = square + square * factor;
            rest = one - square;
        }
    }
    return 2 * atan2(sqrt(rest).hi, sqrt(square).hi);
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
