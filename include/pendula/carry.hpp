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

/// Where the branch of a carried sweep ends before a member.
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
     {"what becomes of the member's motion", "qué es del movimiento del miembro"},
     ResultColumn::Rows::one,
     false,
     kind_names},
};

/// Locates the jumps of a carried sweep over the parameter `swept`, in which alone the members of a line differ: where the
/// branch of a member's neighbour, followed in short steps, ends before the member. That is
///
/// - where the kind changes, or the period or the rotation of a periodic orbit. Rest counts as an orbit of period 1. The orbit
///   need not jump there: the gap is small where a period doubles.
/// - where the two orbits, or the rotations of two quasi-periodic motions, agree in these but are apart, and stay so however
///   short the step. A jump is told from an orbit that moves if it is larger than a third of that motion between the members.
///
/// The interval is halved until half its width, `error`, is at most `tolerance`, both in the unit of the parameter. A stable
/// periodic orbit of a driven pendulum is followed by Newton's method. All other motions, and the first halvings, start from
/// the last state on the branch, and are followed as in a measure. At the near end of the interval the branch is there, at the
/// far end it was not found. Of several jumps between two members one is found. If the branch goes on up to the member, it is
/// followed to one and a half tolerances behind it, because it may end exactly there. If it does not end there, the member left
/// it only because the step of the sweep is long, and there is no jump.
///
/// The columns: value and error; the smallest distance of a point of the orbit before from the nearest orbit found behind, in
/// theta [rad] and omega/frequency, NaN if one of them is no orbit; the kind before; the kind of the member. NaN for members
/// without a jump.
///
/// The error covers the end of a branch at rest and of a limit cycle without a drive, and the saddle-node of an orbit to 1e-11
/// more. A doubled period is followed down to within 1e-8 (tests/cpp/jumps_test.cpp). Where the motion before is
/// quasi-periodic, chaotic or unsettled, the error covers the place where the measure finds another kind: settling is slow near
/// such places, so that it depends on periods and budget.
///
/// Refused like `measure_carried` with Measure::attractors; if `swept` is an initial value or drive_phase; for a `tolerance`
/// that is not positive (the refusal names it jump_tolerance, since `strobe` has one too). Memory is about 500 bytes for each
/// member.
Outcome locate_jumps(const Ensemble& ensemble, std::size_t line, Carry carry, const Parameter& swept, double tolerance,
                     const Strobe& strobe, const Results& results, const Control& control = {}) noexcept;

}  // namespace pendula
