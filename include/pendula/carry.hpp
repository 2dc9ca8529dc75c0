// Carried sweeps: measures along a line of parameters, where each member starts from the state in which its neighbour ended.
#pragma once

#include "pendula/measure.hpp"

namespace pendula {

/// In which order the members of a line are measured.
enum class Carry { up, down };
inline constexpr const char* carry_names[] = {"up", "down"};

/// Computes a measure of every member, like `measure`. The members form lines of `line` neighbours each: member k of line i is
/// number i line + k of the ensemble. The first member of a line (the last one, for Carry::down) starts from its own initial
/// state at its own drive_phase. Every other member starts from the state that its neighbour reached (columns theta and omega,
/// of a section the last row), at the phase of the strobe. If this state is NaN, since the motion was lost or no orbit was
/// found, the member starts like the first one.
///
/// A pendulum at rest stays where it is, even where that is unstable, but no real pendulum does. So a state with omega = 0 is
/// carried with theta moved by 2^-26 rad.
///
/// Lines run in parallel; the bits do not depend on the threads or the other lines (tests/cpp/carry_test.cpp). Refused like
/// `measure`, if the size of the ensemble is not a multiple of `line`, and for a section by a plane, whose points do not belong
/// to a phase of the strobe. Besides the results, memory is one row of the parameters and of the results for each line.
Outcome measure_carried(Measure what, const Ensemble& ensemble, std::size_t line, Carry carry, const Strobe& strobe,
                        const Results& results, const Control& control = {}) noexcept;

/// Where the branch of a carried sweep ends. All columns are NaN for members that have no jump before them.
inline constexpr ResultColumn jump_columns[] = {
    {"value", "", "", {"where the branch ends", "dónde acaba la rama"}},
    {"error", "", "", {"half the width of the interval of value", "la mitad de la anchura del intervalo de value"}},
    {"gap", "", "1", {"distance of the orbits before and behind", "distancia entre las órbitas de antes y después"}},
    {"before",
     "",
     "1",
     {"what becomes of the motion before", "qué es del movimiento antes"},
     ResultColumn::Rows::one,
     false,
     kind_names},
    {"after",
     "",
     "1",
     {"what becomes of the motion behind", "qué es del movimiento después"},
     ResultColumn::Rows::one,
     false,
     kind_names},
};

/// Locates the jumps of a carried sweep over the parameter `swept`, in which alone the members of a line differ: where the
/// orbit of a member's neighbour, carried on in short steps, ends before the member. It does so
///
/// - where the kind changes, or the period or rotation of a periodic orbit. A state need not jump there: at the doubling of a
///   period, or where the rotation locks, the gap is small;
/// - where orbits that agree in these are apart, and stay so however short the step. They are told from an orbit that moves by
///   at least a third of its motion between the two members.
///
/// The interval is halved, each time from the last state on the branch, until its half-width `error` is at most `tolerance`, in
/// the unit of the parameter. On one side the branch was followed, on the other it was not found. Of several jumps between two
/// neighbours one is found. Where the branch goes on up to the member, which left it only since the grid's step is long, there
/// is no jump. The gap is the smallest distance of a point of one orbit from the other, in theta [rad] and omega/frequency; NaN
/// for kinds without an orbit.
///
/// The interval holds the place where the settled kind changes. Settling is slow near the end of a branch. The end found can be
/// early by what `budget` leaves unsettled; then `after` is `unsettled`. Tested: tests/cpp/jumps_test.cpp.
///
/// Refused like `measure_carried` with Measure::attractors, for a parameter that is not one of the pendulum's or is
/// drive_phase, and for a tolerance that is not positive.
Outcome locate_jumps(const Ensemble& ensemble, std::size_t line, Carry carry, const Parameter& swept, double tolerance,
                     const Strobe& strobe, const Results& results, const Control& control = {}) noexcept;

}  // namespace pendula
