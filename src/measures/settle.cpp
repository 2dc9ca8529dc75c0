#include "measures/settle.hpp"

#include "arithmetic/pack.hpp"
#include "measures/averages.hpp"
#include "measures/orbit_search.hpp"
#include "pendula/angle.hpp"

namespace pendula {

using arithmetic::abs;
using arithmetic::floor;
using arithmetic::round_even;
using arithmetic::sqrt;
using kernels::chunk_size;

namespace {

constexpr double larger_of(double a, double b) noexcept { return a > b ? a : b; }

/// How far a rotation number is from the farthest ratio p/q with a denominator up to 64 that a motion seen for so many periods
/// may still be locked to; -1 if there is none. A motion that is locked but settles slowly creeps by at most one turn of
/// q times its angle, and looks quasi-periodic. So a ratio is ruled out only if q times the rotation has left it by more than
/// two turns, and by far more than its error.
double distance_of_lock(const Estimate& rotation, double periods) noexcept {
    constexpr double largest_denominator = 64, least_distance = 1e-6, turns = 2;
    const double reach = larger_of(16 * rotation.error, least_distance);
    double farthest = -1;
    for (double q = 1; q <= largest_denominator; ++q) {
        const double distance = abs(rotation.value - round_even(q * rotation.value) / q);
        if (distance <= larger_of(reach, turns / (q * periods))) farthest = larger_of(farthest, distance);
    }
    return farthest;
}

/// The arguments of one call.
struct SettleCall {
    const Ensemble& ensemble;
    const Strobe& strobe;
    std::span<double> history;
    const PutFate& put;

    double end_of_first_window() const noexcept { return strobe.transient + strobe.periods; }
};

/// A motion, followed at the times of the strobe.
struct Follower {
    OrbitSearch search;
    Averages averages;
    State last;
    double last_turns = 0;
    double growth_before = 0;       ///< of the displacement, up to the start of the window
    Estimate rotation{}, growth{};  ///< in a period
};

/// A chunk of driven members. Members whose fate is known leave it, and the last one takes their place.
struct Pursuit {
    const SettleCall& call;
    Thread& thread;
    StrobedMembers m{};
    Follower followers[chunk_size];
    Windows windows;
    double window_start;  ///< number of the period at which the present window starts
    double n = 0;         ///< periods done

    Pursuit(const SettleCall& of, Thread& by) noexcept
        : call(of), thread(by), windows(of.strobe.periods), window_start(of.strobe.transient) {}

    State state(int i) const noexcept { return {m.chunk.motion.theta[i], m.chunk.motion.omega[i]}; }

    void leave(int i, const Fate& fate) noexcept {
        call.put(m.number[i], fate);
        thread.report(larger_of(0, call.end_of_first_window() - n));
        const int last = m.chunk.count - 1;
        move_member(m, last, i);
        followers[i] = followers[last];
        m.chunk.count = last;
    }

    /// Settles the members without a drive, which need no strobe. Returns false if the call was stopped.
    bool settle_all_undriven() noexcept {
        for (int i = 0; i < m.chunk.count;) {
            const auto p = pendulum_of(call.ensemble, m.number[i]);
            if (is_driven(p)) {
                ++i;
                continue;
            }
            Fate fate;
            const auto initial = initial_state_of(call.ensemble, m.number[i]);
            if (!settle_undriven(p, initial, call.strobe, thread, fate)) return false;
            leave(i, fate);
        }
        return true;
    }

    void start() noexcept {
        for (int i = 0; i < m.chunk.count; ++i) {
            followers[i].search.begin(state(i), 0);
            remember(i);
        }
    }

    void remember(int i) noexcept {
        followers[i].last = state(i);
        followers[i].last_turns = m.chunk.motion.turns[i];
    }

    /// Looks at member i after a period, and lets it leave if its fate is known. Returns false if the call was stopped.
    bool look(int i, bool& has_left) noexcept {
        auto& f = followers[i];
        const auto now = state(i);
        const auto p = pendulum_of(call.ensemble, m.number[i]);
        has_left = true;
        if (!(now.theta - now.theta == 0 && now.omega - now.omega == 0)) return leave(i, {}), true;
        const auto result = f.search.look(now, n, p, call.strobe, thread);
        if (result == OrbitSearch::Result::stopped) return false;
        if (result == OrbitSearch::Result::settled) return leave(i, fate_on(f.search.orbit(), p)), true;
        has_left = false;
        if (n > window_start) {
            const double turns = (m.chunk.motion.turns[i] - f.last_turns) + (now.theta - f.last.theta) / (2 * pi);
            f.averages.add(windows, n - 1 - window_start, turns, m.growth[i] - f.growth_before);
            put_history(i);
        } else {
            f.growth_before = m.growth[i];
        }
        remember(i);
        return true;
    }

    /// Writes the rows of the history that are due after this period of the first window.
    void put_history(int i) const noexcept {
        const double rows = call.strobe.history_rows, periods = call.strobe.periods, done = n - window_start;
        if (call.history.empty() || window_start != call.strobe.transient) return;
        for (double row = floor((done - 1) * rows / periods); row < rows; ++row) {
            const double end = row < 0 ? 0 : floor((row + 1) * periods / rows);
            if (end > done) break;
            if (end == done)
                call.history[static_cast<std::size_t>(row) * call.ensemble.size + m.number[i]] =
                    (m.growth[i] - followers[i].growth_before) / done / m.period[i];
        }
    }

    /// Whether a torque has accelerated a motion without friction all the time, far beyond the speeds that the other forces
    /// make.
    bool runs_away(int i) const noexcept {
        const auto& p = m.chunk.parameters;
        if (p.beta[i] != 0 || p.torque[i] == 0) return false;
        const double gained = p.torque[i] * n * m.period[i], omega = m.chunk.motion.omega[i];
        const double other = sqrt(p.alpha[i] + abs(p.drive_amplitude[i]) + abs(p.pivot_amplitude[i]));
        return abs(gained) > 100 * other && abs(omega - gained) < 0.1 * abs(gained);
    }

    /// The kind of a motion at the end of a window, by its means.
    Kind kind_of(int i) const noexcept {
        const auto& f = followers[i];
        constexpr double converged = 1e-4;  // turns in a period
        if (runs_away(i)) return Kind::unbounded;
        if (f.growth.value > 3 * f.growth.error) return Kind::chaotic;
        const double contraction = m.chunk.parameters.beta[i] * m.period[i];
        const bool is_neutral = abs(f.growth.value) <= f.growth.error;
        const bool is_sharp =
            contraction == 0 || (f.growth.error < 0.2 * contraction && distance_of_lock(f.rotation, windows.periods) < 0);
        const bool is_curve = is_neutral && is_sharp && f.rotation.error < converged && !f.search.has_orbit();
        return is_curve ? Kind::quasi_periodic : Kind::unsettled;
    }

    /// Widens the errors of a motion that has not settled. What friction makes of it in the long run may still be far away: it
    /// may be locked, a drift may decay at the rate beta or beta/2, and the exponent ends between -beta/2 and 0.
    void allow_for_drift(Follower& f, int i) const noexcept {
        const double contraction = m.chunk.parameters.beta[i] * m.period[i];
        if (!(contraction > 0)) return;
        f.rotation.error += 2 * abs(f.averages.drift(windows.periods)) / contraction;
        f.rotation.error = larger_of(f.rotation.error, distance_of_lock(f.rotation, windows.periods));
        constexpr double relaxed = 16;  // contractions
        if (contraction * windows.periods > relaxed) return;
        const double high = larger_of(0, f.growth.value + f.growth.error);
        const double low = larger_of(0.5 * contraction, f.growth.error - f.growth.value);
        f.growth = {0.5 * (high - low), 0.5 * (high + low)};
    }

    Fate fate_by_means(int i, Kind kind) const noexcept {
        const auto& f = followers[i];
        const auto p = pendulum_of(call.ensemble, m.number[i]);
        Fate fate{.kind = kind, .end = state(i)};
        const double frequency = m.frequency[i], period = m.period[i];
        if (kind == Kind::unbounded) return set_exponent(fate, {0, 0}, p), fate;
        set_velocity(fate, {f.rotation.value * frequency, f.rotation.error * frequency}, frequency);
        set_exponent(fate, {f.growth.value / period, f.growth.error / period}, p);
        return fate;
    }

    /// Lets members leave whose means decide. The others go on with a window of twice the length, and the last one takes all
    /// that is left of the budget. So do chaotic motions with friction: chaos may be a long transient to a periodic orbit
    /// (Grebogi, Ott & Yorke, Physica D 7, 1983).
    void end_window() noexcept {
        const double left = call.strobe.budget - n, next = 2 * windows.periods;
        const bool is_last = left < windows.periods;
        for (int i = 0; i < m.chunk.count;) {
            auto& f = followers[i];
            f.rotation = f.averages.rotation(windows.periods);
            f.growth = f.averages.growth(windows.periods);
            const auto kind = kind_of(i);
            const bool may_settle = kind == Kind::unsettled || (kind == Kind::chaotic && m.chunk.parameters.beta[i] > 0);
            if (!may_settle || is_last) {
                if (kind == Kind::unsettled) allow_for_drift(f, i);
                leave(i, fate_by_means(i, kind));
                continue;
            }
            f.averages = {};
            f.growth_before = m.growth[i];
            ++i;
        }
        window_start = n;
        windows = Windows(left < 2 * next ? larger_of(left, 1) : next);
    }

    /// Follows the members until all have left, or the call was stopped.
    void run() noexcept {
        const Propagation first{call.strobe, thread, false};
        if (!settle_all_undriven() || m.chunk.count == 0 || !integrate_to_first_strobe(m, first)) return;
        start();
        const double growth_start = floor(0.5 * call.strobe.transient);
        while (m.chunk.count > 0) {
            if (!integrate_to_next_strobe(m, {call.strobe, thread, n >= growth_start})) return;
            ++n;
            if (n <= call.end_of_first_window()) thread.report(m.chunk.count);
            if (n > window_start) windows.move_to(n - 1 - window_start);
            for (int i = 0; i < m.chunk.count;) {
                bool has_left = false;
                if (!look(i, has_left)) return;
                if (!has_left) ++i;
            }
            if (n == window_start + windows.periods) end_window();
        }
    }
};

}  // namespace

Outcome settle(const Ensemble& ensemble, const Strobe& strobe, std::span<double> history, const Control& control,
               const PutFate& put) noexcept {
    const SettleCall call{ensemble, strobe, history, put};
    const double units = static_cast<double>(ensemble.size) * call.end_of_first_window();
    return for_each_piece(chunks_of(ensemble.size), units, control, [&](Thread& thread, std::size_t chunk) {
        Pursuit pursuit(call, thread);
        load_strobed(pursuit.m, ensemble, chunk * chunk_size);
        pursuit.run();
    });
}

void set_velocity(Fate& fate, Estimate velocity, double frequency) noexcept {
    fate.velocity = velocity;
    fate.rotation = {velocity.value / frequency, velocity.error / frequency};
}

void set_exponent(Fate& fate, Estimate exponent, const Pendulum& p) noexcept {
    fate.exponent = exponent;
    const bool is_point = fate.kind == Kind::fixed_point || fate.kind == Kind::periodic;
    const double sum = p.beta + exponent.value;
    if (is_point)
        fate.dimension = {0, 0};
    else if (p.beta == 0)
        fate.dimension = {2, 0};
    else if (fate.kind == Kind::rotating)
        fate.dimension = {1, 0};
    else if (fate.kind == Kind::quasi_periodic)
        fate.dimension = {1, exponent.error / p.beta};
    else if (fate.kind == Kind::chaotic)
        fate.dimension = {1 + exponent.value / sum, p.beta * exponent.error / (sum * sum)};
    else
        fate.dimension = {1, 1};
}

}  // namespace pendula
