// The fate of pendulums without a drive and a shaken pivot.
//
// With friction the flow on the cylinder of theta and omega is two-dimensional: a motion ends at a fixed point, or on the limit
// cycle that rotates in the direction of the torque. There is at most one such cycle (Andronov, Vitt & Khaikin, Theory of
// Oscillators, 1966, VII).
//
// The energy E = omega^2/2 - alpha cos(theta) - torque theta never increases. So a motion whose energy is below that of the
// saddle over which it would have to pass stays in its well and ends at rest.
//
// Let K = omega^2/2 at theta = 0 (mod 2 pi). A turn in the direction of the torque maps K to K'. By Liouville's theorem dK'/dK
// = exp(-beta T), where T is the time of the turn, so K' - K is a convex, decreasing function of K, whose zero is the limit
// cycle. It is found by Newton's method. A motion that makes one whole turn ends on the cycle if there is one. Its multipliers
// are 1 and exp(-beta T), and its exponents 0 and -beta.
#include "arithmetic/arctangent.hpp"
#include "arithmetic/exponential.hpp"
#include "measures/fate.hpp"
#include "pendula/analysis.hpp"
#include "pendula/angle.hpp"
#include "trajectory/scalar.hpp"

namespace pendula {

using namespace arithmetic;

namespace {

constexpr double ulp_of_one = 0x1p-52;

/// The relative excess of energy (see `Slope`) that rounding of the angles may make of 0.
constexpr double excess_of_rounding = 0x1p-46;

/// A pendulum with friction or torque, mirrored if necessary so that the torque is not negative, and its saddle.
struct Slope {
    Pendulum p;
    double saddle;  ///< the angle pi - asin(torque/alpha) of the saddle; NaN if there is none
    double curve;   ///< sqrt(alpha^2 - torque^2), the curvature of the potential at the equilibria [s^-2]

    explicit Slope(const Pendulum& of) noexcept : p(of) {
        p.torque = abs(p.torque);
        curve = sqrt((p.alpha - p.torque) * (p.alpha + p.torque));
        saddle = has_rest(p) ? pi - atan2(p.torque, curve) : nan;
    }

    /// Whether the motion is certain to end at rest. If torque = alpha, the equilibria have merged at x = theta - saddle = 0,
    /// where x'' = alpha (1 - cos x) - beta x'. There the region 0 <= x' <= (alpha/beta) x^2, -beta^2/(4 alpha) <= x < 0 is
    /// never left, and x < 0 creeps to 0.
    bool is_trapped(double theta, double omega) const noexcept {
        if (excess(theta, omega) < -excess_of_rounding) return true;
        const double x = theta - saddle;
        if (p.torque == p.alpha && omega == 0 && abs(x) <= ulp_of_one) return true;  // released there, to the last bit
        return p.torque == p.alpha && omega >= 0 && x < -0x1p-40 && x >= -1 && 4 * p.alpha * abs(x) <= p.beta * p.beta &&
               p.beta * omega <= p.alpha * x * x;
    }

    /// The energy above that of the saddle next to the state in the direction of the torque, divided by a bound of its
    /// terms. Below 0 the motion cannot pass the saddle. NaN without a saddle.
    double excess(double theta, double omega) const noexcept {
        const double x = theta < saddle ? theta : theta - 2 * pi;
        const double kinetic = 0.5 * omega * omega, work = p.torque * (saddle - x);
        const double rise = 2 * p.alpha * sin(0.5 * (x + saddle)) * sin(0.5 * (x - saddle));
        return ((kinetic + work) + rise) / (kinetic + abs(work) + abs(rise) + p.alpha * 0x1p-40);
    }
};

/// A passage of theta = 2 pi level in the direction of the torque.
struct Passage {
    double t = nan, omega = 0, level = 0;
};

/// A whole turn in the direction of the torque.
struct Turn {
    double period = nan;     ///< T [s]
    double kinetic = 0;      ///< K at the start
    double next = 0;         ///< K' at the end
    double slope_bound = 0;  ///< a bound of |dT/dK| = |integral of exp(-beta t)/omega^2 dt|
};

/// How following a motion ended.
enum class Ending { turned, rests, out_of_budget, stopped, lost };

/// A motion, followed in steps of Taylor's method.
struct Run {
    const Slope& slope;
    double& steps_left;
    Thread& thread;
    Taylor taylor;
    Passage last{};
    Turn turn{};

    Run(const Slope& of, State from, double& steps, Thread& by) noexcept
        : slope(of), steps_left(steps), thread(by), taylor(make_taylor(of.p, from)) {}

    /// The time in the present step at which theta = 2 pi level, by Newton's method within a bracket.
    double time_of(double level) const noexcept {
        double low = 0, high = taylor.step.length, since = 0.5 * high;
        for (int i = 0; i < 100; ++i) {
            const auto m = motion_at(taylor, since);
            const double ahead = (m.turns - level) * 2 * pi + m.theta + m.theta_lo;
            if (ahead == 0) break;
            (ahead < 0 ? low : high) = since;
            const double next = since - ahead / m.omega;
            if (abs(next - since) <= 0x1p-53 * high) break;
            since = i % 4 < 3 && next > low && next < high ? next : 0.5 * (low + high);
        }
        return since;
    }

    /// Enters a passage. Returns whether a whole turn ends with it.
    bool pass(double level) noexcept {
        const double since = time_of(level);
        const auto m = motion_at(taylor, since);
        const Passage now{(DoubleDouble<double>{taylor.step.t, taylor.step.t_lo} + since).hi, m.omega, level};
        const bool is_turn = last.omega > 0 && now.level == last.level + 1 && m.omega > 0;
        if (is_turn) {
            turn.period = now.t - last.t;
            turn.kinetic = 0.5 * last.omega * last.omega;
            turn.next = 0.5 * now.omega * now.omega;
        }
        last = now;
        return is_turn;
    }

    void add_to_slope(const TaylorPolynomial& step) noexcept {
        const double since = step.t - last.t;
        if (since == since && step.start.omega != 0)
            turn.slope_bound += exp(-slope.p.beta * since) * step.length / (step.start.omega * step.start.omega);
    }

    /// Goes on to the end of the next whole turn, or until the motion is known to end at rest.
    Ending next_turn() noexcept {
        turn.slope_bound = 0;
        for (double n = 0;; ++n) {
            const auto& step_now = taylor.step;
            if (!(step_now.length == step_now.length)) return Ending::lost;
            if (slope.is_trapped(step_now.start.theta, step_now.start.omega)) return Ending::rests;
            if (--steps_left < 0) return Ending::out_of_budget;
            if (n >= 256) {
                n = 0;
                if (!thread.goes_on()) return Ending::stopped;
            }
            add_to_slope(step_now);
            const auto end = motion_at(taylor, step_now.length);
            const auto side = [](const auto& m) { return m.turns + (m.theta >= 0 ? 0.5 : -0.5); };
            const double from = side(step_now.start), to = side(end);
            bool is_turn = false;
            for (double level = from + 0.5; level < to; ++level) is_turn = pass(level);
            if (to < from) last = {};  // the motion turns back
            step(taylor);
            if (is_turn) return Ending::turned;
        }
    }
};

double least_of(double a, double b) noexcept { return a < b ? a : b; }

/// 1 - exp(-x) for x >= 0.
double decay(double x) noexcept { return x < 0x1p-20 ? x * (1 - 0.5 * x) : 1 - exp(-x); }

/// Refines a turn to the limit cycle by Newton's method. Returns rests if the method meets a motion that makes no whole turn:
/// then nothing is known yet.
Ending find_cycle(const Slope& slope, Turn& turn, double& steps_left, Thread& thread) noexcept {
    double before = __builtin_inf();
    for (int i = 0; i < 64; ++i) {
        const double change = (turn.next - turn.kinetic) / decay(slope.p.beta * turn.period);
        const double size = abs(change);
        if (size <= 0x1p-50 * turn.kinetic || (size >= 0.5 * before && size <= 0x1p-20 * turn.kinetic)) break;
        before = size;
        if (!(turn.kinetic + change > 0)) return Ending::rests;
        Run run(slope, {0, sqrt(2 * (turn.kinetic + change))}, steps_left, thread);
        run.last = {0, run.taylor.step.start.omega, 0};
        if (const auto how = run.next_turn(); how != Ending::turned) return how;
        turn = run.turn;
    }
    return Ending::turned;
}

/// The mean velocity on the limit cycle. The error is that of Newton's method, whose last change is an estimate of it, and that
/// of rounding: a few units in the last place of the energy and of the angles of the passages.
Estimate velocity_of(const Turn& turn, const Slope& slope) noexcept {
    const double noise = 0x1p-47 * (turn.kinetic + 2 * pi * slope.p.torque);
    const double off = (abs(turn.next - turn.kinetic) + noise) / decay(slope.p.beta * turn.period);
    const double late = 0x1p-50 / sqrt(2 * turn.kinetic) + 0x1p-49 * turn.period;
    const double velocity = 2 * pi / turn.period;
    return {velocity, velocity * (2 * turn.slope_bound * off + 2 * late) / turn.period};
}

Fate resting(const Slope& slope, double sign) noexcept {
    Fate fate{.kind = Kind::fixed_point, .end = {sign * atan2(slope.p.torque, slope.curve), 0}, .period = 1};
    set_velocity(fate, {0, 0}, 1);
    // Where both eigenvalues nearly agree, rounding of the root is their error.
    const double half = 0.5 * slope.p.beta, root = sqrt(slope.curve), square = (half - root) * (half + root);
    const double exponent = 0 - (square > 0 ? slope.curve / (half + sqrt(square)) : half);
    const double noise = 0x1p-51 * (half + root) * half;
    const double error = square > noise ? noise / sqrt(square) * (abs(exponent) / half) : square > -noise ? 2 * sqrt(noise) : 0;
    set_exponent(fate, {exponent, error + 0x1p-50 * abs(exponent)}, slope.p);
    return fate;
}

/// A rotation whose limit cycle was found.
Fate rotating(const Slope& slope, const Turn& turn, double sign, double frequency) noexcept {
    Fate fate{.kind = Kind::rotating, .end = {0, sign * sqrt(2 * turn.kinetic)}};
    auto velocity = velocity_of(turn, slope);
    fate.period = turn.period * frequency / (2 * pi);
    velocity.value *= sign;
    set_velocity(fate, velocity, frequency);
    set_exponent(fate, {0, 0}, slope.p);
    return fate;
}

/// What is certain at the end of the budget. By the energy of a turn, 2 pi torque = beta times the integral of omega^2, the
/// mean velocity of a limit cycle is at most torque/beta. It is also at most that of the last turn, if this was faster.
Fate undecided(const Run& run, double sign, double frequency) noexcept {
    const auto& p = run.slope.p;
    const auto& now = run.taylor.step;
    double most = p.torque / p.beta;
    if (run.turn.next < run.turn.kinetic) most = least_of(most, 2 * pi / run.turn.period);
    const bool must_rotate = !has_rest(p);
    Fate fate{.kind = must_rotate ? Kind::rotating : Kind::unsettled, .end = {sign * now.start.theta, sign * now.start.omega}};
    set_velocity(fate, {0.5 * sign * most, 0.5 * most}, frequency);
    const double lowest = must_rotate ? 0 : -0.5 * p.beta;
    set_exponent(fate, {0.5 * lowest, -0.5 * lowest}, p);
    return fate;
}

/// Follows a motion with friction and torque to its end. Newton's method is tried after the turns 1, 2, 4, 8, ...
bool settle_on_slope(const Pendulum& p, State initial, const Strobe& strobe, Thread& thread, Fate& fate) noexcept {
    constexpr double steps_per_period_of_budget = 500;
    const Slope slope(p);
    const double sign = p.torque < 0 ? -1 : 1, frequency = strobe_frequency(p);
    double steps_left = steps_per_period_of_budget * strobe.budget;
    Run run(slope, {sign * initial.theta, sign * initial.omega}, steps_left, thread);
    for (double turns = 0, due = 1;;) {
        auto how = run.next_turn();
        if (how == Ending::turned) {
            if (++turns < due) continue;
            due *= 2;
            Turn cycle = run.turn;
            how = find_cycle(slope, cycle, steps_left, thread);
            if (how == Ending::turned) return fate = rotating(slope, cycle, sign, frequency), true;
            if (how == Ending::rests) continue;
        }
        if (how == Ending::rests) fate = resting(slope, sign);
        if (how == Ending::out_of_budget) fate = undecided(run, sign, frequency);
        return how != Ending::stopped;
    }
}

/// Without friction the energy decides.
Fate frictionless(const Pendulum& p, State initial) noexcept {
    const Slope slope(p);
    const double sign = p.torque < 0 ? -1 : 1;
    const Angle angle = split_turns(initial.theta);
    const double excess = slope.excess(wrap(sign * angle.theta), sign * initial.omega);
    Fate fate{.kind = Kind::unsettled, .end = {angle.theta, initial.omega}};
    if (excess < -excess_of_rounding) {
        fate.kind = Kind::conservative;
        set_velocity(fate, {0, 0}, 1);
    } else if (excess > excess_of_rounding || slope.p.torque > p.alpha) {
        fate.kind = Kind::unbounded;
    }
    if (fate.kind != Kind::unsettled) set_exponent(fate, {0, 0}, p);
    return fate;
}

/// By the closed form.
Fate conservative(const Pendulum& p, State initial) noexcept {
    const auto analysis = analyze(p.alpha, initial);
    Fate fate{.kind = Kind::conservative, .end = {wrap(initial.theta), initial.omega}};
    if (analysis.theta_max == 0) fate.kind = Kind::fixed_point, fate.period = 1;
    const bool is_rotation = analysis.regime == Regime::rotation;
    const double velocity = is_rotation ? (initial.omega < 0 ? -1 : 1) * 2 * pi / analysis.tau : 0;
    set_velocity(fate, {velocity, 0x1p-49 * abs(velocity)}, sqrt(p.alpha));
    const double exponent = analysis.regime == Regime::separatrix ? sqrt(p.alpha) : 0;
    set_exponent(fate, {exponent, ulp_of_one * exponent}, p);
    return fate;
}

/// At rest on top: displacements obey x'' = alpha x - beta x'.
Fate on_top(const Pendulum& p) noexcept {
    const double half = 0.5 * p.beta, exponent = p.alpha / (half + sqrt(half * half + p.alpha));
    Fate fate{.kind = Kind::fixed_point, .end = {-pi, 0}, .period = 1};
    set_velocity(fate, {0, 0}, 1);
    set_exponent(fate, {exponent, 4 * ulp_of_one * exponent}, p);
    return fate;
}

}  // namespace

bool settle_undriven(const Pendulum& p, State initial, const Strobe& strobe, Thread& thread, Fate& fate) noexcept {
    fate = {};
    if (rests_on_top(p, initial)) return fate = on_top(p), true;
    if (is_conservative(p)) return fate = conservative(p, initial), true;
    if (p.beta == 0) return fate = frictionless(p, initial), true;
    if (p.torque == 0) return fate = resting(Slope(p), 1), true;
    return settle_on_slope(p, initial, strobe, thread, fate);
}

}  // namespace pendula
