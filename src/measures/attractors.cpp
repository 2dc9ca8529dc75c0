#include <algorithm>
#include <memory>
#include <new>

#include "arithmetic/pack.hpp"
#include "measures/settle.hpp"
#include "pendula/angle.hpp"

namespace pendula {

using arithmetic::abs;

namespace {

constexpr int most_attractors = 256;  // for one set of parameters

/// The columns of the results, in the order of `attractors_columns`.
enum { label_column, kind_column, period_column, rotation_column, theta_column, omega_column };

/// An angle for comparisons: one just below pi counts as one just above -pi, so that rounding does not decide.
double place_of(double theta) noexcept { return theta > pi - 0x1p-30 ? theta - 2 * pi : theta; }

bool precedes(State a, State b) noexcept {
    const double of_a = place_of(a.theta), of_b = place_of(b.theta);
    return of_a < of_b || (of_a == of_b && a.omega < b.omega);
}

/// An orbit on which some members end.
struct Attractor {
    double kind;
    double period;
    double rotation;
    State point;  ///< the point of the orbit with the smallest theta
    int number;
    std::size_t exemplar;  ///< the first member on it
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
        return {result(kind_column, i),
                result(period_column, i),
                result(rotation_column, i),
                {result(theta_column, i), result(omega_column, i)},
                number,
                i};
    }

    /// Whether the orbit of a member passes a point of the attractor. The period of a limit cycle is measured; that of other
    /// orbits is a whole number.
    bool is_on(std::size_t i, const Attractor& a, State point, double frequency) const noexcept {
        const double match = call.strobe.match;
        const bool is_cycle = a.kind == static_cast<double>(Kind::rotating);
        return result(label_column, i) == 0 && result(kind_column, i) == a.kind &&
               (is_cycle || (result(period_column, i) == a.period && result(rotation_column, i) == a.rotation)) &&
               abs(wrap(result(theta_column, i) - point.theta)) <= match &&
               abs(result(omega_column, i) - point.omega) <= match * frequency;
    }

    /// Follows the attractor of member `exemplar` for one period, and sets the label of every member whose point lies on it.
    /// Returns false if the call was stopped.
    bool collect(Attractor& a, std::size_t exemplar) const noexcept {
        Ensemble alone{.size = 1, .theta = a.point.theta, .omega = a.point.omega};
        for (const auto& parameter : parameters)
            if (parameter.value) alone.*parameter.column = (call.ensemble.*parameter.column)[members[exemplar]];
        alone.drive_phase = call.strobe.phase;  // the point belongs to a time of the strobe
        StrobedMembers m;
        load_strobed(m, alone, 0);
        const Propagation run{call.strobe, thread, false};
        const bool is_cycle = a.kind == static_cast<double>(Kind::rotating);
        for (double done = 0; done < (is_cycle ? 1 : a.period); ++done) {
            if (done > 0 && !integrate_to_next_strobe(m, run)) return false;
            const State point = done == 0 ? a.point : State{m.chunk.motion.theta[0], m.chunk.motion.omega[0]};
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
            if (!collect(found[count++], i)) return;
        }
        std::sort(found, found + count, [](const Attractor& a, const Attractor& b) { return precedes(a, b); });
        int rank[most_attractors + 1] = {};
        for (int i = 0; i < count; ++i) rank[found[i].number] = i + 1;
        for (std::size_t i = 0; i < size; ++i) {
            const int label = rank[static_cast<int>(result(label_column, i))];
            result(label_column, i) = label;
            if (label == 0) continue;
            const auto& a = found[label - 1];
            result(period_column, i) = a.period;
            result(rotation_column, i) = a.rotation;
            result(theta_column, i) = a.point.theta;
            result(omega_column, i) = a.point.omega;
            for (std::size_t detail = omega_column + 1; detail < std::size(attractors_columns); ++detail)
                if (call.has(detail)) call.result(detail, 0, members[i]) = call.result(detail, 0, members[a.exemplar]);
        }
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
    const auto put = [&](std::size_t member, const Fate& fate) {
        const bool is_lost = fate.kind == Kind::lost;
        const double values[] = {0,
                                 static_cast<double>(fate.kind),
                                 is_lost ? nan : fate.period,
                                 fate.rotation.value,
                                 fate.end.theta,
                                 fate.end.omega,
                                 fate.rotation.error,
                                 fate.exponent.value,
                                 fate.exponent.error};
        call.put(member, values);
    };
    if (const auto outcome = settle(call.ensemble, call.strobe, {}, part_of(control, 0, share_of_orbits), put);
        !outcome.is_done())
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
