// The period of one pendulum from its crossings, in pieces between which a call may look for cancellation.
#pragma once

#include "pendula/crossings.hpp"

namespace pendula {

/// The state of `measured_period`.
struct MeasuredPeriod {
    Crossings search;
    Crossing first;
    double crossings = 0, periods = 0, last = 0;

    MeasuredPeriod(const Pendulum& pendulum, State initial, double tolerance) noexcept
        : search(make_crossings(pendulum, initial, Crossed::theta, tolerance)) {}

    /// Searches on, for some hundred microseconds. Returns false at the end of the search.
    bool goes_on(double until) noexcept {
        constexpr double steps = 256;
        constexpr int most_crossings = 64;  // some steps each
        Crossing next;
        for (int i = 0; i < most_crossings; ++i) {
            if (!next_crossing(search, until, next, steps)) return !reaches(search.run, until);
            if (++crossings == 1) first = next;
            if (crossings == 1 || next.is_rising != first.is_rising) continue;
            ++periods;
            last = next.sample.t;
        }
        return true;
    }

    double period() const noexcept {
        const bool is_lost = search.run.step.length != search.run.step.length;
        return periods > 0 && !is_lost ? (last - first.sample.t) / periods : __builtin_nan("");
    }
};

}  // namespace pendula
