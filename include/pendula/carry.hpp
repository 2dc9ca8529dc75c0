// Carried sweeps: measures along a line of parameters, where each member starts from the state in which its neighbour ended.
#pragma once

#include "pendula/measure.hpp"

namespace pendula {

/// In which order the members of a line are measured.
enum class Carry { up, down };
inline constexpr const char* carry_names[] = {"up", "down"};

/// Computes a measure of every member, like `measure`. The members form lines of `line` neighbours each: member k of line i is
/// number i line + k of the ensemble. The first member of a line (the last one, for Carry::down) starts from its own initial
/// state at its own drive_phase. Every other member starts from the state that its neighbour reached (columns theta and omega
/// of the results), at the phase of the strobe.
///
/// Lines run in parallel; the bits do not depend on the threads. Refused like `measure`, and if the size of the ensemble is not
/// a multiple of `line`.
Outcome measure_carried(Measure what, const Ensemble& ensemble, std::size_t line, Carry carry, const Strobe& strobe,
                        const Results& results, const Control& control = {}) noexcept;

/// Where a carried branch ends: between `value` - error and `value` + error of the swept parameter.
struct Jump {
    std::size_t member = 0;  ///< the first member behind the jump, in the order of the sweep
    double value = 0;        ///< of the parameter
    double error = 0;        ///< half the width of the interval that contains the jump
    Kind before = Kind::unsettled, after = Kind::unsettled;
};

}  // namespace pendula
