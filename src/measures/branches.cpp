#include "measures/branches.hpp"

#include "pendula/angle.hpp"

namespace pendula {

using arithmetic::abs;

namespace {

/// Rest is an orbit of period 1.
bool is_closed(const Settled& on) noexcept { return on.kind == Kind::fixed_point || on.kind == Kind::periodic; }

/// Whether two motions agree in what cannot change along a branch. The rotation of a periodic orbit is a ratio of whole
/// numbers, rounded.
bool agree(const Settled& a, const Settled& b) noexcept {
    constexpr double rounding = 0x1p-40;
    if (!is_closed(a) || !is_closed(b)) return a.kind == b.kind;
    return a.period == b.period && abs(a.rotation - b.rotation) < rounding;
}

/// The distance of two states, in theta [rad] and omega/frequency.
double apart(State a, State b, double frequency) noexcept {
    const double x = abs(wrap(a.theta - b.theta)), y = abs(a.omega - b.omega) / frequency;
    return x > y ? x : y;
}

/// One pendulum.
Ensemble ensemble_of(const Pendulum& pendulum, const State& initial) noexcept {
    Ensemble alone{.size = 1, .theta = initial.theta, .omega = initial.omega};
    for (const auto& parameter : parameters)
        if (parameter.value) alone.*parameter.column = pendulum.*parameter.value;
    return alone;
}

}  // namespace

bool has_orbit(const Settled& on) noexcept { return is_closed(on) || on.kind == Kind::rotating; }

void Cell::set_far(const Settled& trial) noexcept {
    far = trial;
    if (agree(trial, last)) behind = trial;
}

Pendulum Branches::pendulum_at(std::size_t member, double value) const noexcept {
    Pendulum pendulum = pendulum_of(ensemble_, member);
    pendulum.*swept_.value = value;
    pendulum.drive_phase = strobe_.phase;
    return pendulum;
}

bool Branches::advance_one_period(const Pendulum& pendulum, State& point, Thread& thread) const noexcept {
    StrobedMembers m;
    load_strobed(m, ensemble_of(pendulum, point), 0);
    if (!integrate_to_next_strobe(m, {strobe_, thread, false})) return false;
    point = {m.chunk.motion.theta[0], m.chunk.motion.omega[0]};
    return true;
}

double Branches::gap(const Settled& a, const Settled& b, std::size_t member, Thread& thread) const noexcept {
    const bool is_longer = a.kind == Kind::periodic && (b.kind != Kind::periodic || a.period > b.period);
    const Settled &orbit = is_longer ? a : b, &other = is_longer ? b : a;
    const Pendulum pendulum = pendulum_at(member, orbit.value);
    const double frequency = strobe_frequency(pendulum);
    const double period = orbit.kind == Kind::periodic ? orbit.period : 1;
    State point = orbit.point;
    double least = __builtin_inf();
    for (double done = 0; done < period; ++done) {
        if (done > 0 && !advance_one_period(pendulum, point, thread)) return nan;
        const double distance = apart(point, other.point, frequency);
        least = distance < least ? distance : least;
    }
    return least;
}

/// How far apart two motions that agree are: their orbits, or the rotations of quasi-periodic motions, as far as these are
/// known. Other motions do not say on which branch they are.
double Branches::distance(const Settled& a, const Settled& b, std::size_t member, Thread& thread) const noexcept {
    if (has_orbit(a)) return gap(a, b, member, thread);
    if (a.kind != Kind::quasi_periodic) return 0;
    const double difference = abs(a.rotation - b.rotation) - (a.error + b.error);
    return difference > 0 ? difference : 0;
}

bool Branches::is_on_branch(const Cell& cell, const Settled& trial, Thread& thread) const noexcept {
    if (!agree(cell.near, trial)) return false;
    if (!agree(cell.near, cell.behind)) return true;
    return distance(cell.near, trial, cell.member, thread) <= distance(trial, cell.behind, cell.member, thread);
}

/// Whether an orbit does not close before its period.
bool Branches::has_least_period(const PeriodicOrbit& orbit, const Pendulum& pendulum, Thread& thread) const noexcept {
    const double frequency = strobe_frequency(pendulum), same = 0x1p-26 + 4 * orbit.error;
    State point = orbit.point;
    for (double done = 1; done < orbit.period; ++done) {
        if (!advance_one_period(pendulum, point, thread)) return false;
        if (apart(point, orbit.point, frequency) <= same) return false;
    }
    return true;
}

bool Branches::try_newton(Cell& cell, Thread& thread) const noexcept {
    constexpr int long_halvings = 6;
    constexpr double reach = 0.25;
    const Settled& near = cell.near;
    const Pendulum pendulum = pendulum_at(cell.member, cell.trial());
    if (!is_driven(pendulum) || !is_closed(near)) return false;
    PeriodicOrbit orbit;
    if (!refine_within(pendulum, near.point, near.period, reach, strobe_, thread, orbit)) return false;
    Settled trial{cell.trial(), Kind::unsettled, 0, nan, nan, {}};
    if (orbit.is_found && orbit.exponent[0] <= orbit.exponent_error && has_least_period(orbit, pendulum, thread)) {
        const Fate fate = fate_on(orbit, pendulum);
        trial = {trial.value, fate.kind, fate.period, fate.rotation.value, fate.rotation.error, fate.end};
    }
    if (!agree(near, trial) && cell.halvings < long_halvings) return false;
    judge(cell, trial, thread);
    return true;
}

/// Decides whether two motions that agree are the ends of one branch, as far as the halvings tell: its ends approach each
/// other at least as the square root of the length of the interval, a jump stays.
bool Branches::is_one_branch(Cell& cell, Thread& thread) const noexcept {
    const double noise = has_orbit(cell.near) ? 16 * strobe_.match : 0;
    const double now = distance(cell.near, cell.far, cell.member, thread);
    if (cell.halvings == 0) cell.first_distance = now;
    return !(now > noise) || (cell.halvings > 0 && now <= cell.first_distance / 4);
}

void Branches::proceed_with(Cell& cell, Thread& thread) const noexcept {
    constexpr int least_halvings = 5;  // the fifth leaves less than a quarter of a square root
    const bool do_agree = agree(cell.near, cell.far);
    cell.stage = Cell::Stage::halving;
    if (do_agree && is_one_branch(cell, thread))
        cell.stage = Cell::Stage::none;
    else if (cell.is_narrow(tolerance_) && (!do_agree || cell.halvings >= least_halvings || cell.error() == 0))
        cell.stage = cell.near_has_moved ? Cell::Stage::checking : Cell::Stage::found;
}

void Branches::halve(Cell& cell, const Settled& trial, Thread& thread) const noexcept {
    cell.near_has_moved = is_on_branch(cell, trial, thread);
    if (cell.near_has_moved)
        cell.near = trial;
    else
        cell.set_far(trial);
    ++cell.halvings;
    proceed_with(cell, thread);
}

/// A branch may end exactly at the member, as that of rest does where the torque is alpha. So the search goes on to an interval
/// behind the member that is narrow enough, if the parameter may have such values.
void Branches::look_beyond(Cell& cell, const Settled& trial) const noexcept {
    const double step = trial.value > cell.near.value ? 1.5 * tolerance_ : -1.5 * tolerance_;
    cell.near = trial;
    cell.far.value = trial.value + step;
    const bool is_legal = cell.far.value != trial.value && !check(pendulum_at(cell.member, cell.far.value));
    cell.stage = is_legal ? Cell::Stage::beyond : Cell::Stage::none;
}

/// Ends the search if the far end is off the branch also from the present near end; else goes on behind it.
void Branches::check_far_end(Cell& cell, const Settled& trial, Thread& thread) const noexcept {
    constexpr int most_returns = 8;
    if (!is_on_branch(cell, trial, thread)) {
        cell.set_far(trial);
        cell.stage = Cell::Stage::found;
    } else if (cell.stage == Cell::Stage::beyond || ++cell.returns > most_returns) {
        cell.stage = Cell::Stage::none;
    } else if (cell.far.value == cell.last.value) {
        look_beyond(cell, trial);
    } else {
        cell.near = trial;
        cell.far = cell.behind = cell.last;
        cell.near_has_moved = true;
        proceed_with(cell, thread);
    }
}

void Branches::judge(Cell& cell, const Settled& trial, Thread& thread) const noexcept {
    cell.stage == Cell::Stage::halving ? halve(cell, trial, thread) : check_far_end(cell, trial, thread);
}

}  // namespace pendula
