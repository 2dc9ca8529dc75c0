#include "measures/settle.hpp"

#include "arithmetic/pack.hpp"
#include "measures/averages.hpp"
#include "pendula/angle.hpp"

namespace pendula {

using arithmetic::abs;
using arithmetic::floor;
using arithmetic::sqrt;
using kernels::chunk_size;

namespace {

constexpr double larger_of(double a, double b) noexcept { return a > b ? a : b; }

/// The distance of two states, in theta [rad] and omega/frequency.
double distance(State a, State b, double frequency) noexcept {
    return larger_of(abs(wrap(a.theta - b.theta)), abs(a.omega - b.omega) / frequency);
}

/// The arguments of one call.
struct SettleCall {
    const Ensemble& ensemble;
    const Strobe& strobe;
    std::span<double> history;
    const PutFate& put;

    double end_of_first_window() const noexcept { return strobe.transient + strobe.periods; }
};

/// The search for a periodic orbit on which a motion settles.
///
/// Brent's algorithm for cycles (BIT 20, 1980) proposes a period: the motion is compared with a reference state, which is
/// replaced by the present one after 1, 2, 4, 8, ... periods. When the motion comes back to the reference to within `near`,
/// Newton's method looks for the periodic orbit. If it is stable, the motion has settled once its distance from the orbit is
/// below `match`, or 16 times smaller than when the orbit was found.
class OrbitSearch {
  public:
    enum class Result { goes_on, settled, stopped };

    void begin(State at, double n) noexcept {
        reference_ = at;
        since_ = n;
        has_orbit_ = false;
    }
    bool has_orbit() const noexcept { return has_orbit_; }
    const PeriodicOrbit& orbit() const noexcept { return orbit_; }

    /// Looks at the state after n periods.
    Result look(State at, double n, const Pendulum& p, const Strobe& strobe, Thread& thread) noexcept {
        const double frequency = strobe_frequency(p);
        if (has_orbit_) return approach(at, n, frequency, strobe.match);
        const double d = distance(at, reference_, frequency);
        const double period = n - since_;
        // Without friction nothing is approached; but a state may return exactly, as one at rest does.
        if (period <= longest_period && (d == 0 || (p.beta > 0 && d <= near_))) return find(at, n, d == 0, p, strobe, thread);
        if (n == (since_ == 0 ? 1 : 2 * since_)) begin(at, n);
        return Result::goes_on;
    }

  private:
    static constexpr double longest_period = 1024, reach = 0.5, farthest = 0.1;

    Result approach(State at, double n, double frequency, double match) noexcept {
        if (n < due_) return Result::goes_on;
        due_ = n + orbit_.period;
        const double d = distance(at, orbit_.point, frequency);
        if (d <= match || d <= first_distance_ / 16) return Result::settled;
        if (d > 4 * first_distance_) give_up(at, n);
        return Result::goes_on;
    }

    Result find(State at, double n, bool is_exact, const Pendulum& p, const Strobe& strobe, Thread& thread) noexcept {
        if (!refine_within(p, at, n - since_, reach, strobe, thread, orbit_)) return Result::stopped;
        if (!reduce(p, strobe, thread)) return Result::stopped;
        const double frequency = strobe_frequency(p);
        first_distance_ = distance(at, orbit_.point, frequency);
        if (orbit_.is_found && is_exact && first_distance_ <= strobe.match) return Result::settled;
        if (!orbit_.is_found || !orbit_.is_stable || first_distance_ > farthest) return give_up(at, n);
        has_orbit_ = true;
        due_ = n;
        return approach(at, n, frequency, strobe.match);
    }

    /// Replaces the orbit by the same one with its least period, which may be a divisor. Returns false if the call was stopped.
    bool reduce(const Pendulum& p, const Strobe& strobe, Thread& thread) noexcept {
        for (double divisor = 1; orbit_.is_found && 2 * divisor <= orbit_.period; ++divisor) {
            if (orbit_.period / divisor != floor(orbit_.period / divisor)) continue;
            PeriodicOrbit shorter;
            if (!refine_within(p, orbit_.point, divisor, reach, strobe, thread, shorter)) return false;
            const double same = 0x1p-30 + 4 * (orbit_.error + shorter.error);
            if (!shorter.is_found || distance(shorter.point, orbit_.point, strobe_frequency(p)) > same) continue;
            orbit_ = shorter;
            return true;
        }
        return true;
    }

    Result give_up(State at, double n) noexcept {
        near_ *= 0.125;
        begin(at, n);
        return Result::goes_on;
    }

    State reference_;
    double since_ = 0;  ///< number of the period at which the reference was taken
    double near_ = 1e-4;
    bool has_orbit_ = false;
    PeriodicOrbit orbit_;
    double due_ = 0;  ///< number of the next period at which the motion passes the point of the orbit
    double first_distance_ = 0;
};

/// A motion, followed at the times of the strobe.
struct Follower {
    OrbitSearch search;
    Averages averages;
    State last;
    double last_turns = 0;
    double growth_before = 0;  ///< of the displacement, up to the start of the window
    Estimate rotation{}, growth{};
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

    /// The kind of a motion at the end of a window, by its means.
    Kind kind_of(int i) const noexcept {
        const auto& f = followers[i];
        constexpr double converged = 1e-4;  // turns in a period
        if (f.growth.value > 3 * f.growth.error) return Kind::chaotic;
        const double contraction = m.chunk.parameters.beta[i] * m.period[i];
        const bool is_neutral = abs(f.growth.value) <= f.growth.error;
        const bool is_sharp = contraction == 0 || f.growth.error < 0.2 * contraction;
        return is_neutral && is_sharp && f.rotation.error < converged && !f.search.has_orbit() ? Kind::quasi_periodic
                                                                                               : Kind::unsettled;
    }

    Fate fate_by_means(int i, Kind kind) const noexcept {
        const auto& f = followers[i];
        const auto p = pendulum_of(call.ensemble, m.number[i]);
        Fate fate{.kind = kind, .end = state(i)};
        const double frequency = m.frequency[i], period = m.period[i];
        set_velocity(fate, {f.rotation.value * frequency, f.rotation.error * frequency}, frequency);
        set_exponent(fate, {f.growth.value / period, f.growth.error / period}, p);
        return fate;
    }

    /// Lets members leave whose means decide. The others go on with a window of twice the length, up to the budget. So do
    /// chaotic motions with friction: chaos may be a long transient to a periodic orbit (Grebogi, Ott & Yorke, Physica D 7,
    /// 1983).
    void end_window() noexcept {
        const double left = call.strobe.budget - n;
        const bool is_last = left < windows.periods;
        for (int i = 0; i < m.chunk.count;) {
            auto& f = followers[i];
            f.rotation = f.averages.rotation(windows.periods);
            f.growth = f.averages.growth(windows.periods);
            const auto kind = kind_of(i);
            const bool may_settle = kind == Kind::unsettled || (kind == Kind::chaotic && m.chunk.parameters.beta[i] > 0);
            if (!may_settle || is_last) {
                leave(i, fate_by_means(i, kind));
                continue;
            }
            f.averages = {};
            f.growth_before = m.growth[i];
            ++i;
        }
        window_start = n;
        windows = Windows(2 * windows.periods < left ? 2 * windows.periods : larger_of(left, 1));
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
