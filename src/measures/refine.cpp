// Newton's method on the strobe map, with the monodromy matrix from two displacements.
#include "arithmetic/exponential.hpp"
#include "checks.hpp"
#include "measures/fate.hpp"
#include "measures/strobe.hpp"
#include "pendula/analysis.hpp"
#include "pendula/angle.hpp"
#include "pendula/version.hpp"

namespace pendula {

using namespace arithmetic;

namespace {

/// A vector of the plane of theta and omega/sqrt(alpha).
struct Vector {
    double x = 0, y = 0;

    double length() const noexcept { return sqrt(x * x + y * y); }
};

/// One evaluation of the map over a whole orbit.
struct Return {
    Vector miss;       ///< the point after the orbit minus the point before it, without whole turns
    double turns = 0;  ///< whole turns
    double scale = 0;  ///< the monodromy matrix is exp(scale) times the columns, whose lengths are 1 or less
    Vector column[2];
    double excess = 1;  ///< the largest growth of a displacement on the way, divided by the larger one of exp(scale) and 1
};

/// Puts a pendulum on two places of a chunk, with the two displacements of length 1.
void load_twice(StrobedMembers& m, const Pendulum& p, State at, double phase) noexcept {
    Ensemble twice{.size = 2, .theta = at.theta, .omega = at.omega};
    Pendulum strobed = p;
    strobed.drive_phase = phase;
    for (const auto& parameter : parameters)
        if (parameter.value) twice.*parameter.column = strobed.*parameter.value;
    load_strobed(m, twice, 0);
    m.chunk.tangent.theta[1] = 0;
    m.chunk.tangent.omega[1] = m.root_alpha[1];
}

/// Follows the orbit from a point for `period` periods of the strobe. Returns false if the call was stopped.
bool follow(const Pendulum& p, State from, double period, const Strobe& strobe, Thread& thread, Return& r) noexcept {
    StrobedMembers m;
    load_twice(m, p, from, strobe.phase);
    const auto& motion = m.chunk.motion;
    const double turns = motion.turns[0];
    double largest = 0;
    for (double done = 0; done < period; ++done) {
        if (!integrate_to_next_strobe(m, {strobe, thread, true})) return false;
        for (int i = 0; i < 2; ++i) largest = m.growth[i] > largest ? m.growth[i] : largest;
    }
    const double angle = wrap(motion.theta[0] - wrap(from.theta));
    r.miss = {angle, (motion.omega[0] - from.omega) / m.root_alpha[0]};
    r.turns = round_even((motion.turns[0] - turns) + (motion.theta[0] - wrap(from.theta) - angle) / (2 * pi));
    r.scale = m.growth[0] > m.growth[1] ? m.growth[0] : m.growth[1];
    r.excess = exp(r.scale > 0 ? largest - r.scale : largest);
    for (int i = 0; i < 2; ++i) {
        const double factor = exp(m.growth[i] - r.scale);
        r.column[i] = {factor * m.chunk.tangent.theta[i], factor * m.chunk.tangent.omega[i] / m.root_alpha[i]};
    }
    return true;
}

/// The solution of (M - 1) d = -miss, and a bound on how much the inverse enlarges an error made on the way.
struct Correction {
    Vector step;
    double stretch;
};

Correction correction(const Return& r) noexcept {
    // Both M and 1 are divided by the larger one of exp(scale) and 1, so that nothing overflows.
    const double shrink = r.scale > 0 ? exp(-r.scale) : 1, factor = r.scale > 0 ? 1 : exp(r.scale);
    const double a = factor * r.column[0].x - shrink, b = factor * r.column[1].x;
    const double c = factor * r.column[0].y, d = factor * r.column[1].y - shrink;
    const double determinant = a * d - b * c, size = sqrt(a * a + b * b + c * c + d * d);
    const double inverse = shrink / determinant;
    return {{(b * r.miss.y - d * r.miss.x) * inverse, (c * r.miss.x - a * r.miss.y) * inverse},
            r.excess * size / abs(determinant)};
}

/// Floquet's larger exponent, from the trace and the determinant of the columns.
double exponent_of(double trace, double determinant, double scale, double time) noexcept {
    const double half = 0.5 * abs(trace), square = half * half - determinant;
    const double modulus = square > 0 ? half + sqrt(square) : sqrt(determinant);
    return (scale + arithmetic::log(modulus)) / time;
}

/// The multipliers and exponents.
void set_multipliers(PeriodicOrbit& o, const Return& r, const Pendulum& p, double noise) noexcept {
    const double time = o.period * 2 * pi / strobe_frequency(p);
    const Vector &u = r.column[0], &v = r.column[1];
    const double trace = u.x + v.y, determinant = exp(-p.beta * time - 2 * r.scale), factor = exp(r.scale);
    o.trace = factor * trace;
    o.determinant = exp(-p.beta * time);
    o.mismatch = abs((u.x * v.y - u.y * v.x) - determinant) / (abs(u.x * v.y) + abs(u.y * v.x));
    const double half = 0.5 * trace, square = half * half - determinant;
    const double first = square < 0 ? half : half + (half < 0 ? -sqrt(square) : sqrt(square));
    o.multiplier[0] = factor * first;
    o.multiplier[1] = square < 0 ? factor * half : exp(-p.beta * time - r.scale) / first;
    o.imaginary = square < 0 ? factor * sqrt(-square) : 0;
    o.exponent[0] = square < 0 ? -0.5 * p.beta : exponent_of(trace, determinant, r.scale, time);
    o.exponent[1] = -p.beta - o.exponent[0];
    // The trace is wrong by the rounding of the displacements, and because the point is not exactly on the orbit.
    const double length = u.length() + v.length();
    const double moved = o.error > 0 ? 4 * o.error * length * r.excess * exp(r.scale > 0 ? r.scale : 0) : 0;
    const double wrong = (noise * o.period + o.mismatch) * (abs(u.x) + abs(v.y) + length) + moved;
    const double least = abs(trace) > wrong ? abs(trace) - wrong : 0;
    const double above = exponent_of(abs(trace) + wrong, determinant, r.scale, time) - o.exponent[0];
    const double below = o.exponent[0] - exponent_of(least, determinant, r.scale, time);
    // Real multipliers are products over the steps of Taylor's method, some one for each 1/sqrt(alpha), and each is rounded.
    const double steps = square < 0 ? 0 : sqrt(p.alpha + abs(p.pivot_amplitude));  // a second
    o.exponent_error = (above > below ? above : below) + 0x1p-50 * (abs(o.exponent[0]) + p.beta + steps);
    o.is_stable = o.exponent[0] + o.exponent_error < 0;
}

/// Whether a state is an equilibrium of a shaken pendulum to the last bit.
bool is_at_rest(const Pendulum& p, State at) noexcept {
    return at.omega == 0 && p.torque == 0 && p.drive_amplitude == 0 && (at.theta == 0 || rests_on_top(p, at));
}

/// A relative error of a step of the map: of rounding, or of the tolerance.
double noise_of(const Strobe& strobe) noexcept {
    const bool is_loose = strobe.method == Method::taylor && strobe.tolerance > 0x1p-50;
    return is_loose ? 4 * strobe.tolerance : 0x1p-48;
}

}  // namespace

bool refine_within(const Pendulum& p, State guess, double period, double reach, const Strobe& strobe, Thread& thread,
                   PeriodicOrbit& orbit) noexcept {
    constexpr int most_iterations = 32;
    orbit = {.period = period};
    const double root_alpha = sqrt(p.alpha), noise = noise_of(strobe);
    State at = guess;
    Vector moved;
    double before = __builtin_inf();
    for (int i = 0; i < most_iterations; ++i) {
        Return r;
        if (!follow(p, at, period, strobe, thread, r)) return false;
        const bool is_closed = r.miss.x == 0 && r.miss.y == 0;
        auto newton = correction(r);
        if (is_closed) newton.step = {};
        if (is_closed && is_at_rest(p, at)) newton.stretch = 0;
        const double size = newton.step.length(), scale = 1 + abs(at.omega) / root_alpha;
        if (!(size - size == 0)) return true;
        if (size <= 0x1p-50 * scale || (size >= 0.5 * before && size < 0x1p-24 * scale)) {
            if (r.turns == 0 && !is_driven(p) && !has_rest(p)) return true;
            orbit.is_found = true;
            orbit.point = {wrap(at.theta + newton.step.x), at.omega + newton.step.y * root_alpha};
            orbit.error = size + newton.stretch * noise * period * scale;
            orbit.turns = r.turns;
            set_multipliers(orbit, r, p, noise);
            return true;
        }
        before = size;
        moved = {moved.x + newton.step.x, moved.y + newton.step.y};
        if (moved.length() > reach) return true;
        at = {wrap(at.theta + newton.step.x), at.omega + newton.step.y * root_alpha};
    }
    return true;
}

Outcome refine(const Pendulum& p, State guess, const Strobe& strobe, PeriodicOrbit& orbit, const Control& control) noexcept {
    constexpr double no_limit = __builtin_inf();
    if (!instruction_set()) return Refusal{.reason = Refusal::Reason::instruction_set, .name = "PENDULA_ISA"};
    if (const auto refusal = check(p, guess)) return refusal;
    if (const auto refusal = check(p, strobe)) return refusal;
    return for_each_piece(1, strobe.orbit_period, control, [&](Thread& thread, std::size_t) {
        (void)refine_within(p, guess, strobe.orbit_period, no_limit, strobe, thread, orbit);
    });
}

Fate fate_on(const PeriodicOrbit& o, const Pendulum& p) noexcept {
    const bool has_rest = p.drive_amplitude == 0 && p.torque == 0 && o.turns == 0 && o.period == 1;
    constexpr double near = 0x1p-30;
    const double frequency = strobe_frequency(p);
    Fate fate{.kind = Kind::periodic, .end = o.point, .period = o.period};
    if (has_rest && abs(o.point.omega) < near * frequency) {
        const double theta = abs(o.point.theta);
        if (theta < near) fate.kind = Kind::fixed_point, fate.end = {0, 0};
        if (theta > pi - near) fate.kind = Kind::fixed_point, fate.end = {-pi, 0};
    }
    set_velocity(fate, {o.turns * frequency / o.period, 0}, frequency);
    set_exponent(fate, {o.exponent[0], o.exponent_error}, p);
    return fate;
}

}  // namespace pendula
