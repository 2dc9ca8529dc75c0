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

inline constexpr ResultColumn jump_columns[] = {
    {"value", "", "", {"where the branch ends", "dónde acaba la rama"}},
    {"error", "", "", {"half the width of the interval of value", "la mitad de la anchura del intervalo de value"}},
    {"gap", "", "1", {"distance between the states before and behind", "distancia entre los estados de antes y después"}},
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

}  // namespace pendula
