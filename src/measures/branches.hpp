// Branches of orbits over a parameter, and where they end.
#pragma once

#include "arithmetic/pack.hpp"
#include "measures/carry.hpp"
#include "measures/fate.hpp"

namespace pendula {

/// What a motion has settled on.
struct Settled {
    double value;  ///< of the swept parameter
    Kind kind;
    double period, rotation, error;
    State point;
};

/// Whether a motion ends on a fixed point, a periodic orbit or a limit cycle.
bool has_orbit(const Settled& on) noexcept;

/// The interval between two neighbours, while it is halved.
struct Cell {
    enum class Stage {
        halving,
        checking,  ///< whether the far end is off the branch if it is approached from the present near end
        beyond,    ///< whether the branch, which goes on up to the member, ends right there
        found,
        none,
    };
    std::size_t member;  ///< behind the jump
    Settled near, far, last;
    Settled behind;  ///< the nearest motion off the branch that agrees with the last one
    double first_distance = 0;
    int halvings = 0, returns = 0;
    bool near_has_moved = false;  ///< since the far end was measured
    Stage stage = Stage::halving;

    double middle() const noexcept { return 0.5 * near.value + 0.5 * far.value; }
    double error() const noexcept { return 0.5 * arithmetic::abs(far.value - near.value); }
    double trial() const noexcept { return stage == Stage::halving ? middle() : far.value; }
    bool is_active() const noexcept { return stage != Stage::found && stage != Stage::none; }
    void set_far(const Settled& trial) noexcept;
    bool is_narrow(double tolerance) const noexcept {
        return error() <= tolerance || middle() == near.value || middle() == far.value;
    }
};

/// Follows branches through intervals of the parameter `swept`.
class Branches {
  public:
    Branches(const Ensemble& ensemble, const Parameter& swept, double tolerance, const Strobe& strobe) noexcept
        : ensemble_(ensemble), swept_(swept), tolerance_(tolerance), strobe_(strobe) {}

    /// A member with another value of the parameter, at the phase of the strobe.
    Pendulum pendulum_at(std::size_t member, double value) const noexcept;

    /// Looks at the present interval, and decides how to go on.
    void proceed_with(Cell& cell, Thread& thread) const noexcept;

    /// Takes what the trial of a cell has settled on.
    void judge(Cell& cell, const Settled& trial, Thread& thread) const noexcept;

    /// Follows a branch of periodic orbits by Newton's method, which does not become slow where the branch ends. Returns false
    /// if that does not decide about the trial: in the first halvings, whose steps may be too long for Newton's method.
    bool try_newton(Cell& cell, Thread& thread) const noexcept;

    /// The smallest distance of a point of one orbit from the other. NaN if the call was stopped.
    double gap(const Settled& a, const Settled& b, std::size_t member, Thread& thread) const noexcept;

  private:
    bool advance_one_period(const Pendulum& pendulum, State& point, Thread& thread) const noexcept;
    double distance(const Settled& a, const Settled& b, std::size_t member, Thread& thread) const noexcept;
    bool is_on_branch(const Cell& cell, const Settled& trial, Thread& thread) const noexcept;
    bool has_least_period(const PeriodicOrbit& orbit, const Pendulum& pendulum, Thread& thread) const noexcept;
    bool is_one_branch(Cell& cell, Thread& thread) const noexcept;
    void halve(Cell& cell, const Settled& trial, Thread& thread) const noexcept;
    void check_far_end(Cell& cell, const Settled& trial, Thread& thread) const noexcept;
    void look_beyond(Cell& cell, const Settled& trial) const noexcept;

    const Ensemble& ensemble_;
    const Parameter& swept_;
    double tolerance_;
    const Strobe& strobe_;
};

}  // namespace pendula
