#include "arithmetic/pack.hpp"
#include "pendula/angle.hpp"
#include "strobe.hpp"

namespace pendula {

using arithmetic::abs;
using arithmetic::round_even;
using kernels::chunk_size;

namespace {

bool precedes(State a, State b) noexcept { return a.theta < b.theta || (a.theta == b.theta && a.omega < b.omega); }

/// Brent's search for cycles (BIT 20, 1980): a point to come back to, taken anew after 1, 2, 4, 8, ... periods, so that an
/// orbit that settles late is found as well, with its smallest period.
struct Search {
    double since = 0;   ///< periods done when the point to come back to was taken
    double period = 0;  ///< 0 until it has come back
    State start, least, first;
    double start_turns, first_turns;
    double rotation;

    void begin(State at, double turns) noexcept {
        start = least = at;
        start_turns = turns;
    }

    void look(State at, double turns, double done, double match, double frequency) noexcept {
        if (period > 0) return;
        const double way = wrap(at.theta - start.theta);
        if (abs(way) <= match && abs(at.omega - start.omega) <= match * frequency) {
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

State state(const kernels::Chunk& c, int i) noexcept { return {c.theta[i], c.omega[i]}; }

/// One call of `orbits`, as its pieces see it: a chunk each.
struct Orbits {
    const Ensemble& ensemble;
    const Strobe& strobe;
    double match;
    const OrbitValues& values;

    bool search(Strobed& m, Search* searches, const Way& way) const noexcept {
        for (double done = 1; done <= strobe.periods; ++done) {
            if (!go_to_next_strobe(m, way)) return false;
            bool is_settled = true;
            for (int i = 0; i < m.chunk.count; ++i) {
                searches[i].look(state(m.chunk, i), m.chunk.turns[i], done, match, m.frequency[i]);
                is_settled = is_settled && searches[i].period > 0;
            }
            if (!is_settled) continue;
            way.progress.report(m.chunk.count * (strobe.periods - done));
            return true;
        }
        return true;
    }

    void put(const Strobed& m, const Search& s, int i, std::size_t member) const noexcept {
        const auto last = state(m.chunk, i);
        const bool is_periodic = s.period > 0;
        const double turned = (m.chunk.turns[i] - s.first_turns) + (last.theta - s.first.theta) / (2 * pi);
        values.period[member] = last.theta == last.theta ? s.period : last.theta;
        values.rotation[member] = is_periodic ? s.rotation : turned / strobe.periods;
        values.theta[member] = is_periodic ? s.least.theta : last.theta;
        values.omega[member] = is_periodic ? s.least.omega : last.omega;
    }

    void operator()(Progress& progress, std::size_t first, bool is_caller) const noexcept {
        const Way way{strobe, progress, is_caller, false};
        Strobed m;
        Search searches[chunk_size];
        load(m, ensemble, first);
        if (!go_to_first_strobe(m, way) || !go_through_transient(m, way)) return;
        for (int i = 0; i < m.chunk.count; ++i) {
            searches[i].begin(state(m.chunk, i), m.chunk.turns[i]);
            searches[i].first = searches[i].start;
            searches[i].first_turns = searches[i].start_turns;
        }
        if (!search(m, searches, way)) return;
        for (int i = 0; i < m.chunk.count; ++i) put(m, searches[i], i, first + static_cast<std::size_t>(i));
    }
};

/// Numbers that have been given out so far, and to whom.
struct Labels {
    const Strobe& strobe;
    double match;
    double frequency;
    std::size_t size;
    const OrbitValues& values;
    int* label;

    bool is_on(std::size_t member, const Attractor& a, State point) const noexcept {
        return label[member] == 0 && values.period[member] == a.period && values.rotation[member] == a.rotation &&
               abs(wrap(values.theta[member] - point.theta)) <= match &&
               abs(values.omega[member] - point.omega) <= match * frequency;
    }

    /// Follows the attractor for a period, and gives its number to all members whose points it passes.
    void collect(Attractor& a, int number, Strobed& m) const noexcept {
        const Control nobody;
        Progress progress(nobody, 0);
        const Way way{strobe, progress, false, false};
        for (double done = 0; done < a.period; ++done) {
            const auto point = done == 0 ? a.point : state(m.chunk, 0);
            if (precedes(point, a.point)) a.point = point;
            for (std::size_t member = a.exemplar; member < size; ++member) {
                if (!is_on(member, a, point)) continue;
                label[member] = number;
                ++a.members;
            }
            go_to_next_strobe(m, way);
        }
    }
};

bool precedes(const Attractor& a, const Attractor& b) noexcept {
    if (a.period != b.period) return a.period < b.period;
    if (a.rotation != b.rotation) return a.rotation < b.rotation;
    return precedes(a.point, b.point);
}

/// Sorts what is found and says where each has gone to.
void sort(Attractor* found, int count, int* rank) noexcept {
    int from[attractors_limit];
    for (int i = 0; i < count; ++i) {
        const Attractor a = found[i];
        int at = i;
        for (; at > 0 && precedes(a, found[at - 1]); --at) {
            found[at] = found[at - 1];
            from[at] = from[at - 1];
        }
        found[at] = a;
        from[at] = i;
    }
    for (int i = 0; i < count; ++i) rank[from[i]] = i + 1;
}

}  // namespace

bool orbits(const Ensemble& ensemble, const Strobe& strobe, double match, const Control& control,
            const OrbitValues& values) noexcept {
    return for_each_chunk(ensemble, strobe, control, Orbits{ensemble, strobe, match, values});
}

std::size_t label_attractors(const Pendulum& pendulum, const Strobe& strobe, double match, std::size_t size,
                             const OrbitValues& values, int* label, Attractor* found) noexcept {
    const auto& p = pendulum;
    const double no_phase = 0;  // at a strobe
    const auto one = [](const double& value) { return std::span(&value, 1); };
    const Labels labels{strobe, match, strobe_frequency(p), size, values, label};
    for (std::size_t member = 0; member < size; ++member) label[member] = 0;
    int count = 0;
    for (std::size_t member = 0; member < size && count < static_cast<int>(attractors_limit); ++member) {
        if (label[member] != 0 || !(values.period[member] > 0)) continue;
        Attractor& a = found[count++];
        a = {values.period[member], values.rotation[member], {values.theta[member], values.omega[member]}, 0, member};
        Strobed m;
        const Ensemble alone{1,
                             one(a.point.theta),
                             one(a.point.omega),
                             one(p.alpha),
                             one(p.beta),
                             one(p.torque),
                             one(p.drive_amplitude),
                             one(p.drive_frequency),
                             one(no_phase)};
        load(m, alone, 0);
        labels.collect(a, count, m);
    }
    int rank[attractors_limit];
    sort(found, count, rank);
    for (std::size_t member = 0; member < size; ++member)
        if (label[member] != 0) label[member] = rank[label[member] - 1];
    return static_cast<std::size_t>(count);
}

}  // namespace pendula
