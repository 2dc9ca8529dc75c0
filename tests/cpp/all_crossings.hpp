// All crossings of one pendulum, as a test asks for them.
#pragma once

#include <vector>

#include "pendula/crossings.hpp"

namespace reference {

using namespace pendula;

inline std::vector<Crossing> all_crossings(const Pendulum& p, State initial, const Level& level, double until,
                                           double budget = 0x1p53) {
    auto search = make_crossings(p, initial, level);
    std::vector<Crossing> found;
    Crossing crossing;
    for (int calls = 0; calls < 100000; ++calls) {
        if (next_crossing(search, until, crossing, budget))
            found.push_back(crossing);
        else if (reaches(search.run, until))
            break;
    }
    return found;
}

}  // namespace reference
