// Reduction of huge angles to a quarter turn (Payne & Hanek 1983). It is called for each lane of a pack separately.
#pragma once

namespace pendula::arithmetic {

/// The reduced angle and the quadrant: x = hi + lo + (pi/2) (quadrant + 4 n) for a whole number n.
struct HugeReduction {
    double hi;
    double lo;
    int quadrant;
};

/// The reduction of x with |x| >= 1. The error of hi + lo is below 2^-130, and |hi + lo| <= pi/4 (1 + 2^-50). An infinite x or
/// NaN gives NaN.
HugeReduction reduce_huge(double x) noexcept;

}  // namespace pendula::arithmetic
