// The search for a periodic orbit on which a motion settles.
#pragma once

#include "measures/fate.hpp"

namespace pendula {

/// Brent's algorithm for cycles (BIT 20, 1980) proposes a period: the motion is compared with a reference state, which is
/// replaced by the present one after 1, 2, 4, 8, ... periods. When the motion comes back to the reference to within `near`,
/// Newton's method looks for the periodic orbit. If it is stable, the motion has settled once its distance from the orbit is
/// below `match`, or 16 times smaller than when the orbit was found.
class OrbitSearch {
  public:
    enum class Result { goes_on, settled, stopped };

    void begin(State at, double n) noexcept;
    bool has_orbit() const noexcept { return has_orbit_; }
    const PeriodicOrbit& orbit() const noexcept { return orbit_; }

    /// Looks at the state after n periods.
    Result look(State at, double n, const Pendulum& p, const Strobe& strobe, Thread& thread) noexcept;

  private:
    Result approach(State at, double n, double frequency, double match) noexcept;
    Result find(State at, double n, bool is_exact, const Pendulum& p, const Strobe& strobe, Thread& thread) noexcept;
    bool reduce(const Pendulum& p, const Strobe& strobe, Thread& thread) noexcept;
    Result give_up(State at, double n) noexcept;

    State reference_;
    double since_ = 0;  ///< number of the period at which the reference was taken
    double near_ = 1e-4;
    bool has_orbit_ = false;
    PeriodicOrbit orbit_;
    double due_ = 0;  ///< number of the next period at which the motion passes the point of the orbit
    double first_distance_ = 0;
};

}  // namespace pendula
