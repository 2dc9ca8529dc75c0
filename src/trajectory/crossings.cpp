#include "pendula/crossings.hpp"

#include "checks.hpp"
#include "pendula/analysis.hpp"
#include "pendula/angle.hpp"
#include "trajectory/period.hpp"
#include "trajectory/scalar.hpp"

namespace pendula {

using namespace arithmetic;

namespace {

constexpr int most_terms = kernels::taylor_order_limit + 1;

/// A polynomial on [0, 1].
struct Polynomial {
    double a[most_terms];
    int terms;
};

/// A value and its rate of change.
struct Linear {
    double value;
    double rate;
};

Linear at(const Polynomial& p, double x) noexcept {
    Linear sum{};
    for (int k = p.terms - 1; k >= 0; --k) sum = {sum.value * x + p.a[k], sum.rate * x + sum.value};
    return sum;
}

Polynomial derivative(const Polynomial& p) noexcept {
    Polynomial d{{}, p.terms - 1};
    for (int k = 0; k < d.terms; ++k) d.a[k] = (k + 1) * p.a[k + 1];
    return d;
}

/// The point between `low` and `high` where a function from points to `Linear` changes its sign, by Newton's method. A
/// bisection replaces a step that leaves the bracket or is not shorter than half the last one.
///
/// Ends with a step shorter than 2^-30 of `length`, the length of the Taylor step: the next one would be shorter than 2^-60 of
/// it, divided by the distance d from the extremum as a fraction of `length`, and rounding errors of the function move the
/// point by some 2^-53/d. Where rounding errors prevent that, bisection ends at adjacent doubles.
template <class Function>
double change_between(double low, double high, bool is_rising, double length, const Function& function) noexcept {
    double x = 0.5 * (low + high), last = high - low;
    for (int iteration = 0; iteration < 128; ++iteration) {
        const Linear f = function(x);
        if (f.value == 0) return x;
        ((f.value < 0) == is_rising ? low : high) = x;
        const double by_newton = x - f.value / f.rate;
        if (abs(by_newton - x) <= 0x1p-30 * length) return by_newton < low ? low : by_newton > high ? high : by_newton;
        const bool is_good = by_newton > low && by_newton < high && abs(by_newton - x) < 0.5 * last;
        const double next = is_good ? by_newton : 0.5 * (low + high);
        last = abs(next - x);
        x = next;
    }
    return x;
}

int sign_changes(const Polynomial& p, double (&points)[most_terms]) noexcept;

/// Pieces of [0, 1], in ascending order, on each of which a polynomial keeps its sign or is monotone.
struct Pieces {
    static constexpr int most = 40;
    double ends[most];
    int count = 0;

    /// Divides an interval in halves until a bound proves that p is such on each: with |p''| <= bend, p departs from its value
    /// in the middle by at most half (|p'| + half bend/2), and p' by at most half bend. Returns false if the pieces become too
    /// short, which happens near a point where p and p' are almost 0.
    bool divide(const Polynomial& p, double bend, double low, double high) noexcept {
        constexpr double shortest = 0x1p-7;
        const double middle = 0.5 * (low + high), half = 0.5 * (high - low);
        const auto f = at(p, middle);
        if (abs(f.value) > half * (abs(f.rate) + 0.5 * half * bend) || abs(f.rate) > half * bend) {
            ends[count++] = high;
            return count < most;
        }
        return half > shortest && divide(p, bend, low, middle) && divide(p, bend, middle, high);
    }

    /// Where the halves do not succeed, the pieces end where the derivative changes its sign.
    explicit Pieces(const Polynomial& p) noexcept {
        double bend = 0;
        for (int k = 2; k < p.terms; ++k) bend += k * (k - 1) * abs(p.a[k]);
        if (divide(p, bend, 0, 1)) return;
        double points[most_terms];
        count = sign_changes(derivative(p), points);
        for (int i = 0; i < count; ++i) ends[i] = points[i];
        ends[count++] = 1;
    }
};

/// The points of (0, 1) where p changes its sign, in ascending order. On each piece p changes its sign at most once. The
/// recursion through `Pieces` ends at a derivative with |a[0]| > sum |a[k]|, which keeps its sign on [0, 1], or at a constant.
int sign_changes(const Polynomial& p, double (&points)[most_terms]) noexcept {
    double others = 0;
    for (int k = 1; k < p.terms; ++k) others += abs(p.a[k]);
    if (others == 0 || abs(p.a[0]) > others) return 0;
    const Pieces pieces(p);
    int count = 0;
    double low = 0, value = p.a[0];
    for (int i = 0; i < pieces.count && count < most_terms - 1; ++i) {
        const double next = at(p, pieces.ends[i]).value;
        if ((value < 0 && next > 0) || (value > 0 && next < 0))
            points[count++] = change_between(low, pieces.ends[i], value < 0, 1, [&](double x) { return at(p, x); });
        if (next == 0) continue;  // p keeps the sign that it had before this point
        low = pieces.ends[i];
        value = next;
    }
    return count;
}

/// The crossed quantity minus the level in the middle of the present turn.
double departure(const Crossings& search, const auto& m) noexcept {
    if (search.level.crossed == Crossed::omega) return (two_sum(m.omega, -search.at) + m.omega_lo).hi;
    return (two_sum(m.theta, -search.at) + m.theta_lo).hi;
}

/// Twice the level if the crossed quantity is exactly on it; 2 m + 1 if it is between the levels m and m + 1. The difference of
/// two angles of [-pi, pi) is less than a turn.
double side_of(const Crossings& search, const auto& m) noexcept {
    const double d = departure(search, m);
    const double sign = d > 0 ? 1 : d < 0 ? -1 : 0;
    return search.level.crossed == Crossed::theta ? 2 * (m.turns - search.turns) + sign : sign;
}

bool is_even(double side) noexcept { return side == 2 * round_even(0.5 * side); }

/// The difference between the crossed quantity and the level m = side/2, and its rate of change, some time after the start of
/// the step.
Linear from_level(const Crossings& search, double since, double side) noexcept {
    const auto m = motion_at(search.run, since);
    if (search.level.crossed == Crossed::theta) {
        const auto turns = DoubleDouble<double>{two_pi_dd[0], two_pi_dd[1]} * ((m.turns - search.turns) - 0.5 * side);
        return {(turns + two_sum(m.theta, -search.at) + m.theta_lo).hi, m.omega};
    }
    const auto& step = search.run.step;
    const double x = since / step.unit;
    double slope = 0;
    for (int k = search.run.order; k > 0; --k) slope = slope * x + k * step.series[k];
    return {departure(search, m), slope / (step.unit * step.unit)};
}

/// Whether a bound on the change during the step proves that no level is reached. `v` is omega times the unit over the step.
bool is_out_of_reach(const Crossings& search, const Polynomial& v) noexcept {
    constexpr double margin = 0x1p-40;  // for rounding errors
    const auto& step = search.run.step;
    const double distance = abs(departure(search, step.start));
    double change = 0;
    if (search.level.crossed == Crossed::omega) {
        for (int k = 1; k < v.terms; ++k) change += abs(v.a[k]);
        return distance > change / step.unit * (1 + margin) + margin * (abs(step.start.omega) + abs(search.at));
    }
    for (int k = 0; k < v.terms; ++k) change += abs(v.a[k]) * (1.0 / (k + 1));
    const double to_next = two_pi_dd[0] - distance;
    return (distance < to_next ? distance : to_next) > change * (step.length / step.unit) * (1 + margin) + margin;
}

/// Divides the step at the points where the derivative of the crossed quantity changes its sign. A step that reaches no level
/// has no parts.
void cut_step(Crossings& search) noexcept {
    const Taylor& run = search.run;
    const double length = run.step.length;
    search.cut = search.cut_count = 0;
    if (!(length < __builtin_inf())) return;
    Polynomial v{{}, run.order + 1};
    const double x = length / run.step.unit;
    double power = 1;
    for (int k = 0; k < v.terms; ++k, power *= x) v.a[k] = run.step.series[k] * power;
    if (!is_even(search.side) && !search.is_upon && is_out_of_reach(search, v)) return;
    double points[most_terms];
    search.cut_count = sign_changes(search.level.crossed == Crossed::theta ? v : derivative(v), points);
    for (int i = 0; i < search.cut_count; ++i) search.cuts[i] = points[i] * length;
    search.cuts[search.cut_count++] = length;
}

Sample sample_at(const Taylor& run, double since) noexcept {
    const auto m = motion_at(run, since);
    return {(DoubleDouble<double>{run.step.t, run.step.t_lo} + since).hi, m.theta, m.omega, m.turns};
}

/// Searches the present part of the step. Returns true and the crossing if the next level is crossed there at a time up to
/// `until`. If the crossing is later, returns false; if there is none, moves on to the next part and returns false.
bool crosses(Crossings& search, double until, Crossing& crossing) noexcept {
    const double end = search.cuts[search.cut], side = side_of(search, motion_at(search.run, end));
    if (is_even(search.side) && side != search.side)
        search.side += side > search.side ? 1 : -1;  // leaves the level of the start
    if (!is_even(search.side) && abs(side - search.side) > 1) {
        const bool is_rising = side > search.side;
        const double level = search.side + (is_rising ? 1 : -1);
        const double start = search.cut == 0 ? 0 : search.cuts[search.cut - 1];
        const double length = search.run.step.length;
        const auto difference = [&](double since) { return from_level(search, since, level); };
        crossing = {
            search.is_upon ? search.upon : sample_at(search.run, change_between(start, end, is_rising, length, difference)),
            is_rising};
        if (crossing.sample.t > until) return false;
        search.side += is_rising ? 2 : -2;
        search.is_upon = false;
        return true;
    }
    const bool is_upon = is_even(side) && side != search.side;
    if (is_upon && !search.is_upon) search.upon = sample_at(search.run, end);
    search.is_upon = is_upon;
    ++search.cut;
    return false;
}

/// The trajectory of a pendulum that rests, as one step without end.
void rest(TaylorPolynomial& step) noexcept {
    for (double& term : step.series) term = 0;
    step.series_1_lo = 0;
    step.length = __builtin_inf();
}

}  // namespace

Crossings make_crossings(const Pendulum& pendulum, State initial, const Level& level, double tolerance, double t) noexcept {
    Crossings search;
    const bool is_legal = level.crossed >= Crossed::theta && level.crossed <= Crossed::omega &&
                          level.direction >= Direction::both && level.direction <= Direction::falling &&
                          satisfies(Rule::finite, level.at);
    search.run = make_taylor(pendulum, initial, is_legal ? tolerance : __builtin_nan(""), t);
    search.level = level;
    search.at = level.crossed == Crossed::theta ? wrap(level.at) : level.at;
    if (is_legal && rests_on_top(pendulum, initial)) rest(search.run.step);
    search.turns = search.run.step.start.turns;
    search.side = side_of(search, search.run.step.start);
    cut_step(search);
    return search;
}

bool next_crossing(Crossings& search, double until, Crossing& crossing, double step_budget) noexcept {
    while (search.run.step.length == search.run.step.length) {
        while (search.cut < search.cut_count) {
            const int cut = search.cut;
            if (crosses(search, until, crossing)) {
                const Direction direction = crossing.is_rising ? Direction::rising : Direction::falling;
                if (search.level.direction == Direction::both || search.level.direction == direction) return true;
            } else if (search.cut == cut) {
                return false;  // the next crossing is later than `until`
            }
        }
        if (!needs_step_to(search.run, until) || --step_budget < 0) return false;
        step(search.run);
        cut_step(search);
    }
    return false;
}

Outcome measured_period(const Pendulum& pendulum, State initial, double until, double tolerance, double& period,
                        const Control& control) noexcept {
    if (const auto refusal = check(pendulum, initial)) return refusal;
    if (const auto refusal = check(pendulum, Method::taylor, tolerance)) return refusal;
    if (const auto refusal = check_rule("until", until, Rule::not_negative)) return refusal;
    MeasuredPeriod measured(pendulum, initial, tolerance);
    while (measured.goes_on(until))
        if (!control.proceed(measured.search.run.step.t / until)) return Outcome::Kind::stopped;
    period = measured.period();
    return {};
}

}  // namespace pendula
