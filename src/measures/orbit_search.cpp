#include "measures/orbit_search.hpp"

#include "arithmetic/pack.hpp"
#include "pendula/angle.hpp"

namespace pendula {

using arithmetic::abs;
using arithmetic::floor;

namespace {

constexpr double longest_period = 1024;  ///< in periods of the strobe
constexpr double reach = 0.5;            ///< of Newton's method, from the motion
constexpr double farthest = 0.1;         ///< from the motion to an orbit on which it may settle

/// The distance of two states, in theta [rad] and omega/frequency.
double distance(State a, State b, double frequency) noexcept {
    const double theta = abs(wrap(a.theta - b.theta)), omega = abs(a.omega - b.omega) / frequency;
    return theta > omega ? theta : omega;
}

}  // namespace

void OrbitSearch::begin(State at, double n) noexcept {
    reference_ = at;
    since_ = n;
    has_orbit_ = false;
}

OrbitSearch::Result OrbitSearch::look(State at, double n, const Pendulum& p, const Strobe& strobe, Thread& thread) noexcept {
    const double frequency = strobe_frequency(p);
    if (has_orbit_) return approach(at, n, frequency, strobe.match);
    const double d = distance(at, reference_, frequency);
    const double period = n - since_;
    // Without friction nothing is approached; but a state may return exactly, as one at rest does.
    if (period <= longest_period && (d == 0 || (p.beta > 0 && d <= near_))) return find(at, n, d == 0, p, strobe, thread);
    if (n == (since_ == 0 ? 1 : 2 * since_)) begin(at, n);
    return Result::goes_on;
}

OrbitSearch::Result OrbitSearch::approach(State at, double n, double frequency, double match) noexcept {
    if (n < due_) return Result::goes_on;
    due_ = n + orbit_.period;
    const double d = distance(at, orbit_.point, frequency);
    if (d <= match || d <= first_distance_ / 16) return Result::settled;
    if (d > 4 * first_distance_) give_up(at, n);
    return Result::goes_on;
}

OrbitSearch::Result OrbitSearch::find(State at, double n, bool is_exact, const Pendulum& p, const Strobe& strobe,
                                      Thread& thread) noexcept {
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
bool OrbitSearch::reduce(const Pendulum& p, const Strobe& strobe, Thread& thread) noexcept {
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

OrbitSearch::Result OrbitSearch::give_up(State at, double n) noexcept {
    near_ *= 0.125;
    begin(at, n);
    return Result::goes_on;
}

}  // namespace pendula
