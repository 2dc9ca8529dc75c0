// Reduction of huge angles (Payne & Hanek 1983): the one function that packs call lane by lane.
#pragma once

namespace pendula::arithmetic {

/// x = hi + lo + (pi/2) (quadrant + 4 n).
struct HugeReduction {
    double hi;
    double lo;
    int quadrant;
};

/// Reduces |x| >= 1. The error of hi + lo is below 2^-130, its size at most pi/4 (1 + 2^-50). Infinite x gives NaN.
HugeReduction reduce_huge(double x) noexcept;

}  // namespace pendula::arithmetic
