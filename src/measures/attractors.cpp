#include <algorithm>
#include <memory>
#include <new>

#include "arithmetic/pack.hpp"
#include "measures/strobe.hpp"
#include "pendula/angle.hpp"

namespace pendula {

using arithmetic::abs;
using arithmetic::round_even;
using kernels::chunk_size;

namespace {

constexpr int most_attractors = 256;  // for one set of parameters

/// The columns of the results, in the order of `attractors_columns`.
enum { label_column, kind_column, period_column, rotation_column, theta_column, omega_column };

bool precedes(State a, State b) noexcept { return a.theta < b.theta || (a.theta == b.theta && a.omega < b.omega); }

State state_at(const StrobedMembers& m, int i) noexcept { return {m.chunk.motion.theta[i], m.chunk.motion.omega[i]}; }

/// Brent's algorithm for cycles (BIT 20, 1980). The orbit is compared with a reference point, which is replaced by the present
/// point after 1, 2, 4, 8, ... periods. So a cycle that is reached late is found too, and always with its smallest period.
struct CycleSearch {
    double since = 0;   ///< number of the period at which the reference point was taken
    double period = 0;  ///< 0 until the orbit has returned to the reference point
    State start, least;
    double start_turns;
    double rotation;

    void begin(State at, double turns) noexcept {
        start = least = at;
        start_turns = turns;
    }

    void look(State at, double turns, double done, double match, double frequency) noexcept {
        if (period > 0) return;
        const double distance = wrap(at.theta - start.theta);
        if (abs(distance) <= match && abs(at.omega - start.omega) <= match * frequency) {
            period = done - since;
            rotation = round_even((turns - start_turns) + (at.theta - start.theta) / (2 * pi)) / period;
        } else if (done == (since == 0 ? 1 : 2 * since)) {
            since = done;
            begin(at, turns);
        } else if (precedes(at, least)) {
            least = at;
        }
    }
};

/// Finds the periodic orbits on which the members end. Labels are set afterwards.
struct OrbitObserver {
    static constexpr bool has_tangent = false;
    const MeasureCall& call;
    CycleSearch searches[chunk_size];
    kernels::Motion<kernels::Row> first;

    explicit OrbitObserver(const MeasureCall& of) noexcept : call(of) {}

    bool start(StrobedMembers& m) noexcept {
        first = m.chunk.motion;
        for (int i = 0; i < m.chunk.count; ++i) searches[i].begin(state_at(m, i), first.turns[i]);
        return true;
    }

    bool at_strobe(const StrobedMembers& m, double done) noexcept {
        bool is_settled = true;
        for (int i = 0; i < m.chunk.count; ++i) {
            searches[i].look(state_at(m, i), m.chunk.motion.turns[i], done, call.strobe.match, m.frequency[i]);
            is_settled = is_settled && searches[i].period > 0;
        }
        return !is_settled;
    }

    void finish(const StrobedMembers& m) noexcept {
        for (int i = 0; i < m.chunk.count; ++i) {
            const auto& s = searches[i];
            const auto last = state_at(m, i);
            const bool is_periodic = s.period > 0;
            const double turned = (m.chunk.motion.turns[i] - first.turns[i]) + (last.theta - first.theta[i]) / (2 * pi);
            const std::size_t member = m.number[i];
            call.result(label_column, 0, member) = 0;
            call.result(period_column, 0, member) = last.theta == last.theta ? s.period : last.theta;
            call.result(rotation_column, 0, member) = is_periodic ? s.rotation : turned / call.strobe.periods;
            call.result(theta_column, 0, member) = is_periodic ? s.least.theta : last.theta;
            call.result(omega_column, 0, member) = is_periodic ? s.least.omega : last.omega;
        }
    }
};

/// A periodic orbit on which some members end.
struct Attractor {
    double period;
    double rotation;
    State point;  ///< the point of the orbit with the smallest theta
    int number;
};

bool precedes(const Attractor& a, const Attractor& b) noexcept {
    if (a.period != b.period) return a.period < b.period;
    if (a.rotation != b.rotation) return a.rotation < b.rotation;
    return precedes(a.point, b.point);
}

/// Members with the same parameters and different initial states.
struct ParameterGroup {
    const MeasureCall& call;
    const std::size_t* members;
    std::size_t size;
    Thread& thread;

    double& result(int column, std::size_t i) const noexcept {
        return call.result(static_cast<std::size_t>(column), 0, members[i]);
    }

    /// The orbit of a member without a label, as a new attractor with this number.
    Attractor attractor_of(std::size_t i, int number) const noexcept {
        return {
            result(period_column, i), result(rotation_column, i), {result(theta_column, i), result(omega_column, i)}, number};
    }

    bool is_on(std::size_t i, const Attractor& a, State point, double frequency) const noexcept {
        const double match = call.strobe.match;
        return result(label_column, i) == 0 && result(period_column, i) == a.period &&
               result(rotation_column, i) == a.rotation && abs(wrap(result(theta_column, i) - point.theta)) <= match &&
               abs(result(omega_column, i) - point.omega) <= match * frequency;
    }

    /// Follows the attractor of member `exemplar` for one period, and sets the label of every member whose point lies on it.
    /// Returns false if the call was stopped.
    bool collect(Attractor& a, std::size_t exemplar) const noexcept {
        Ensemble alone{.size = 1, .theta = a.point.theta, .omega = a.point.omega};
        for (const auto& parameter : parameters)
            if (parameter.value) alone.*parameter.column = (call.ensemble.*parameter.column)[members[exemplar]];
        alone.drive_phase = 0.0;  // the point belongs to a time at which the phase of the drive is 0
        StrobedMembers m;
        load_strobed(m, alone, 0);
        const Propagation run{call.strobe, thread, false};
        for (double done = 0; done < a.period; ++done) {
            if (done > 0 && !integrate_to_next_strobe(m, run)) return false;
            const auto point = done == 0 ? a.point : state_at(m, 0);
            if (precedes(point, a.point)) a.point = point;
            for (std::size_t i = exemplar; i < size; ++i)
                if (is_on(i, a, point, m.frequency[0])) result(label_column, i) = a.number;
        }
        return true;
    }

    /// Labels all members: numbers the attractors in the order in which they are found, and then renumbers them in the order of
    /// their properties.
    void label() const noexcept {
        Attractor found[most_attractors];
        int count = 0;
        for (std::size_t i = 0; i < size && count < most_attractors; ++i) {
            if (result(label_column, i) != 0 || !(result(period_column, i) > 0)) continue;
            found[count] = attractor_of(i, count + 1);
            if (size == 1) {
                result(label_column, i) = 1;
                return;
            }
            if (!collect(found[count++], i)) return;
        }
        std::sort(found, found + count, [](const Attractor& a, const Attractor& b) { return precedes(a, b); });
        int rank[most_attractors + 1] = {};
        for (int i = 0; i < count; ++i) rank[found[i].number] = i + 1;
        for (std::size_t i = 0; i < size; ++i) result(label_column, i) = rank[static_cast<int>(result(label_column, i))];
    }
};

/// An order of members by their parameters only: members that differ in their initial states compare equal.
bool has_lesser_parameters(const Ensemble& ensemble, std::size_t a, std::size_t b) noexcept {
    for (const auto& parameter : parameters) {
        if (!parameter.value) continue;
        const double of_a = (ensemble.*parameter.column)[a], of_b = (ensemble.*parameter.column)[b];
        if (of_a != of_b) return of_a < of_b;
    }
    return false;
}

/// Lists the members so that those with the same parameters are adjacent, and lists where each group starts. Returns the number
/// of groups.
std::size_t group_by_parameters(const Ensemble& ensemble, std::size_t* members, std::size_t* starts) noexcept {
    for (std::size_t i = 0; i < ensemble.size; ++i) members[i] = i;
    std::sort(members, members + ensemble.size, [&](std::size_t a, std::size_t b) {
        if (has_lesser_parameters(ensemble, a, b)) return true;
        return !has_lesser_parameters(ensemble, b, a) && a < b;
    });
    std::size_t groups = 0;
    for (std::size_t i = 0; i < ensemble.size; ++i)
        if (i == 0 || has_lesser_parameters(ensemble, members[i - 1], members[i])) starts[groups++] = i;
    starts[groups] = ensemble.size;
    return groups;
}

}  // namespace

Outcome measure_attractors(const MeasureCall& call, const Control& control) noexcept {
    constexpr double share_of_orbits = 0.9;  // share of the time that progress assigns to finding the orbits
    const std::size_t size = call.ensemble.size;
    const std::unique_ptr<std::size_t[]> members(new (std::nothrow) std::size_t[size]),
        starts(new (std::nothrow) std::size_t[size + 1]);
    if (!members || !starts) return Refusal{.reason = Refusal::Reason::memory, .name = "ensemble"};
    if (const auto outcome = observe<OrbitObserver>(call, part_of(control, 0, share_of_orbits)); !outcome.is_done())
        return outcome;
    const std::size_t groups = group_by_parameters(call.ensemble, members.get(), starts.get());
    return for_each_piece(groups, static_cast<double>(size), part_of(control, share_of_orbits, 1),
                          [&](Thread& thread, std::size_t group) {
                              const std::size_t first = starts[group], count = starts[group + 1] - first;
                              ParameterGroup{call, members.get() + first, count, thread}.label();
                              thread.report(static_cast<double>(count));
                          });
}

}  // namespace pendula
