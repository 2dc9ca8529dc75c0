// What carried sweeps and the search for jumps share.
#pragma once

#include "measures/strobe.hpp"

namespace pendula {

/// Lets a member start from the state in which its neighbour ended, at the phase of the strobe; a state that is NaN changes
/// nothing. A state at rest is moved by 2^-26 rad: no more than one rounding of a parameter moves a fixed point near the value
/// at which it vanishes, since there its angle depends on the parameter by a square root.
void continue_from(State end, const Strobe& strobe, Pendulum& pendulum, State& initial) noexcept;

/// Why a call of `measure_carried` is refused, or no refusal.
Refusal check_carried(Measure what, const MeasureCall& call, std::size_t line, const Control& control) noexcept;

}  // namespace pendula
