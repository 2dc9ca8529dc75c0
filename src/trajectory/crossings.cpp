#include "pendula/crossings.hpp"

#include "checks.hpp"
#include "trajectory/scalar.hpp"

namespace pendula {

using namespace arithmetic;

namespace {

constexpr int most_terms = kernels::taylor_order_limit + 1;

/// A polynomial on [0, 1].
struct Polynomial {
    double a[most_terms];
    int terms;

    double operator()(double x) const noexcept {
        double sum = 0;
        for (int k = terms - 1; k >= 0; --k) sum = sum * x + a[k];
        return sum;
    }
};

Polynomial derivative(const Polynomial& p) noexcept {
    Polynomial d{{}, p.terms - 1};
    for (int k = 0; k < d.terms; ++k) d.a[k] = (k + 1) * p.a[k + 1];
    return d;
}

/// True if |a[0]| > sum |a[k]|, so that p has no zero on [0, 1].
bool keeps_its_sign(const Polynomial& p) noexcept {
    double others = 0;
    for (int k = 1; k < p.terms; ++k) others += abs(p.a[k]);
    return abs(p.a[0]) > others;
}

/// The point between `low` and `high` where p, which is monotone there, changes its sign. By bisection: after 64 halvings the
/// points are adjacent doubles.
double change_between(const Polynomial& p, double low, double high) noexcept {
    const bool rises = p(low) < 0;
    for (int i = 0; i < 64; ++i) {
        const double middle = 0.5 * (low + high);
        ((p(middle) < 0) == rises ? low : high) = middle;
    }
    return high;
}

/// The points of (0, 1) where p changes its sign, in ascending order. Between two sign changes of its derivative p is monotone
/// and changes its sign at most once. The sign changes of the derivative are found by recursion. It ends at a polynomial with
/// |a[0]| > sum |a[k]|, which keeps its sign on [0, 1], or at a constant.
int sign_changes(const Polynomial& p, double (&points)[most_terms]) noexcept {
    if (p.terms < 2 || keeps_its_sign(p)) return 0;
    double cuts[most_terms];
    int cut_count = sign_changes(derivative(p), cuts);
    cuts[cut_count++] = 1;
    int count = 0;
    double low = 0, value = p.a[0];
    for (int i = 0; i < cut_count; ++i) {
        const double next = p(cuts[i]);
        if ((value < 0 && next > 0) || (value > 0 && next < 0)) points[count++] = change_between(p, low, cuts[i]);
        if (next == 0) continue;  // p keeps the sign that it had before this point
        low = cuts[i];
        value = next;
    }
    return count;
}

/// Divides the step at the points where the derivative of the crossed quantity changes its sign.
void cut_step(Crossings& search) noexcept {
    const Taylor& run = search.run;
    Polynomial v{{}, run.order + 1};
    const double x = run.step.length / run.step.unit;
    double power = 1;
    for (int k = 0; k < v.terms; ++k, power *= x) v.a[k] = run.step.series[k] * power;
    double points[most_terms];
    search.cut_count = sign_changes(search.crossed == Crossed::theta ? v : derivative(v), points);
    for (int i = 0; i < search.cut_count; ++i) search.cuts[i] = points[i] * run.step.length;
    search.cuts[search.cut_count++] = run.step.length;
    search.cut = 0;
}

/// Twice the level if the crossed quantity is exactly on it; 2 m + 1 if it is between the levels m and m + 1.
double side_of(Crossed crossed, const auto& m) noexcept {
    const double x = crossed == Crossed::theta ? m.theta : m.omega;
    const double sign = x > 0 ? 1 : x < 0 ? -1 : 0;
    return crossed == Crossed::theta ? 2 * m.turns + sign : sign;
}

/// The difference between the crossed quantity and the level, and its rate of change.
struct Departure {
    double value;
    double rate;
};

Departure departure(const Crossings& search, double since, double level) noexcept {
    const auto m = motion_at(search.run, since);
    if (search.crossed == Crossed::theta) return {(2 * m.turns - level) * two_pi_dd[0] * 0.5 + (m.theta + m.theta_lo), m.omega};
    const auto& step = search.run.step;
    const double x = since / step.unit;
    const double slope = kernels::with_order(search.run.order, [&](auto order) {
        return kernels::tail_of_series<1, order.value>(step.series, x, [](double a, int k) { return a * k; });
    });
    return {m.omega + m.omega_lo, slope / (step.unit * step.unit)};
}

/// The time at which the level is crossed, between two times of the step, by safeguarded Newton iteration: Newton steps
/// alternate with bisections, and a Newton step that leaves the bracket is replaced by a bisection. After 128 iterations the
/// ends of the bracket are adjacent doubles.
double time_of_crossing(const Crossings& search, double low, double high, double level) noexcept {
    const bool rises = side_of(search.crossed, motion_at(search.run, low)) < level;
    double since = 0.5 * (low + high);
    for (int iteration = 0; iteration < 128; ++iteration) {
        const auto d = departure(search, since, level);
        if (d.value == 0) return since;
        ((d.value < 0) == rises ? low : high) = since;
        const double next = since - d.value / d.rate;
        if (abs(next - since) <= 0x1p-54 * search.run.step.length) return since;
        since = iteration % 2 == 0 && next > low && next < high ? next : 0.5 * (low + high);
    }
    return since;
}

Sample sample_at(const Taylor& run, double since) noexcept {
    const auto m = motion_at(run, since);
    return {(DoubleDouble<double>{run.step.t, run.step.t_lo} + since).hi, m.theta, m.omega, m.turns};
}

/// Searches the present part of the step. Returns true and the crossing if the next level is crossed there at a time up to
/// `until`. If the crossing is later, returns false; if there is none, moves on to the next part and returns false.
bool crosses(Crossings& search, double until, Crossing& crossing) noexcept {
    const double end = search.cuts[search.cut], side = side_of(search.crossed, motion_at(search.run, end));
    const bool is_even = side == 2 * round_even(0.5 * side);
    if (search.side != 0 && abs(side - search.side) > 1) {
        const bool is_rising = side > search.side;
        const double level = search.side + (is_rising ? 1 : -1);
        const double start = search.cut == 0 ? 0 : search.cuts[search.cut - 1];
        crossing = {search.is_upon ? search.upon : sample_at(search.run, time_of_crossing(search, start, end, level)),
                    is_rising};
        if (crossing.sample.t > until) return false;
        search.side += is_rising ? 2 : -2;
        search.is_upon = false;
        return true;
    }
    if (is_even && !search.is_upon) search.upon = sample_at(search.run, end);
    search.is_upon = is_even;
    if (!is_even) search.side = side;
    ++search.cut;
    return false;
}

}  // namespace

Crossings make_crossings(const Pendulum& pendulum, State initial, Crossed crossed, double tolerance, double t) noexcept {
    Crossings search;
    search.run = make_taylor(pendulum, initial, tolerance, t);
    search.crossed = crossed;
    const double side = side_of(crossed, search.run.step.start);
    if (side != 2 * round_even(0.5 * side)) search.side = side;
    cut_step(search);
    return search;
}

bool next_crossing(Crossings& search, double until, Crossing& crossing, double step_budget) noexcept {
    while (search.run.step.length == search.run.step.length) {
        while (search.cut < search.cut_count) {
            const int cut = search.cut;
            if (crosses(search, until, crossing)) return true;
            if (search.cut == cut) return false;  // the next crossing is later than `until`
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
    constexpr double steps_between_looks = 256;
    auto search = make_crossings(pendulum, initial, Crossed::theta, tolerance);
    Crossing first, next;
    constexpr int crossings_between_looks = 64;  // some steps each
    double crossings = 0, periods = 0, last = 0;
    for (int until_look = crossings_between_looks;;) {
        if (next_crossing(search, until, next, steps_between_looks)) {
            if (++crossings == 1) first = next;
            if (crossings > 1 && next.is_rising == first.is_rising) {
                ++periods;
                last = next.sample.t;
            }
            if (--until_look > 0) continue;
        } else if (reaches(search.run, until)) {
            period = periods > 0 ? (last - first.sample.t) / periods : __builtin_nan("");
            return {};
        }
        until_look = crossings_between_looks;
        if (!control.proceed(search.run.step.t / until)) return Outcome::Kind::stopped;
    }
}

}  // namespace pendula
