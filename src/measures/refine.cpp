// Newton's method on the strobe map, with the monodromy matrix from two displacements.
#include "arithmetic/exponential.hpp"
#include "checks.hpp"
#include "measures/fate.hpp"
#include "measures/strobe.hpp"
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
    Vector miss;        ///< the point after the orbit minus the point before it, without whole turns
    double turns = 0;   ///< whole turns
    Vector column[2];   ///< of the monodromy matrix
    double growth = 0;  ///< the largest growth of a displacement on the way, a factor >= 1
};

constexpr double largest_logarithm = 600;  // of a growth: its square stays in the range of doubles

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
    r.growth = largest < largest_logarithm ? exp(largest) : nan;
    for (int i = 0; i < 2; ++i) {
        const double factor = exp(m.growth[i]);
        r.column[i] = {factor * m.chunk.tangent.theta[i], factor * m.chunk.tangent.omega[i] / m.root_alpha[i]};
    }
    return true;
}

/// The solution of (M - 1) d = -miss, and a bound on how much the inverse enlarges an error.
struct Correction {
    Vector step;
    double stretch;
};

Correction correction(const Return& r) noexcept {
    const double a = r.column[0].x - 1, b = r.column[1].x, c = r.column[0].y, d = r.column[1].y - 1;
    const double determinant = a * d - b * c;
    const double size = sqrt(a * a + b * b + c * c + d * d);
    return {{(b * r.miss.y - d * r.miss.x) / determinant, (c * r.miss.x - a * r.miss.y) / determinant},
            size / abs(determinant)};
}

/// Floquet's larger exponent from the trace and the determinant of the monodromy matrix, where `rate` is that of the
/// contraction, ln(determinant)/time.
double exponent_of(double trace, double determinant, double rate, double time) noexcept {
    const double half = 0.5 * abs(trace), square = half * half - determinant;
    return square > 0 ? log(half + sqrt(square)) / time : 0.5 * rate;
}

/// The multipliers and exponents.
void set_multipliers(PeriodicOrbit& o, const Return& r, const Pendulum& p, double noise) noexcept {
    const double time = o.period * 2 * pi / strobe_frequency(p);
    const Vector &u = r.column[0], &v = r.column[1];
    const double size = abs(u.x * v.y) + abs(u.y * v.x);
    o.trace = u.x + v.y;
    o.determinant = exp(-p.beta * time);
    o.mismatch = abs((u.x * v.y - u.y * v.x) - o.determinant) / size;
    const double half = 0.5 * o.trace, square = half * half - o.determinant;
    if (square >= 0) {
        o.multiplier[0] = half + (half < 0 ? -sqrt(square) : sqrt(square));
        o.multiplier[1] = o.determinant / o.multiplier[0];
        o.imaginary = 0;
    } else {
        o.multiplier[0] = o.multiplier[1] = half;
        o.imaginary = sqrt(-square);
    }
    o.exponent[0] = exponent_of(o.trace, o.determinant, -p.beta, time);
    o.exponent[1] = -p.beta - o.exponent[0];
    // The trace is wrong by the rounding of the displacements, and because the point is not exactly on the orbit.
    const double length = u.length() + v.length();
    const double wrong = (noise * o.period * r.growth + o.mismatch) * (abs(u.x) + abs(v.y)) + 4 * o.error * length * r.growth;
    const double above = exponent_of(abs(o.trace) + wrong, o.determinant, -p.beta, time) - o.exponent[0];
    const double least = abs(o.trace) > wrong ? abs(o.trace) - wrong : 0;
    const double below = o.exponent[0] - exponent_of(least, o.determinant, -p.beta, time);
    o.exponent_error = (above > below ? above : below) + 0x1p-50 * (abs(o.exponent[0]) + p.beta);
    o.is_stable = o.exponent[0] + o.exponent_error < 0;
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
        const auto newton = is_closed ? Correction{{}, 0} : correction(r);
        const double size = newton.step.length(), scale = 1 + abs(at.omega) / root_alpha;
        if (!(size - size == 0) || !(r.growth - r.growth == 0)) return true;
        if (size <= 0x1p-50 * scale || (size >= 0.5 * before && size < 0x1p-24 * scale)) {
            orbit.is_found = true;
            orbit.point = {wrap(at.theta + newton.step.x), at.omega + newton.step.y * root_alpha};
            orbit.error = size + (is_closed ? 1 : newton.stretch) * noise * period * scale * r.growth;
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
