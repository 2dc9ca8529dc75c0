// Means along an orbit that has not settled on a periodic one, and their errors.
#pragma once

#include "measures/fate.hpp"

namespace pendula {

/// The measured periods as 1, 2, 4 and 8 windows. Means are weighted by exp(-1/(s (1 - s))), where s runs from 0 to 1 in a
/// window: on a quasi-periodic orbit they converge faster than any power of the length (Das, Saiki, Sander & Yorke,
/// Nonlinearity 30, 2017).
struct Windows {
    static constexpr int levels = 4, count = 15;  ///< window 0; windows 1 and 2; 3 to 6; 7 to 14

    double periods;
    int window[levels] = {};     ///< of the present period, on each level
    double weight[levels] = {};  ///< of the present period

    explicit Windows(double measured) noexcept : periods(measured) {}
    /// Sets the windows and the weights of period number `done`, from 0.
    void move_to(double done) noexcept;
};

/// The means of one motion: rotation and growth of displacements.
class Averages {
  public:
    static constexpr int blocks = 32;  ///< of growth

    /// Adds a period with so many turns, at the end of which the displacement has grown by a factor exp(growth).
    void add(const Windows& windows, double done, double turns, double growth) noexcept;

    /// Turns in a period.
    Estimate rotation(double periods) const noexcept;
    /// The change of the rotation from one half of the periods to the other, divided by the time between them: turns in a
    /// period, per period.
    double drift(double periods) const noexcept;
    /// The logarithm of the growth in a period.
    Estimate growth(double periods) const noexcept;

  private:
    double sum_[Windows::count] = {}, weights_[Windows::count] = {};
    double until_[blocks] = {};  ///< the growth up to the end of each block
    int block_ = 0;
    double least_ = __builtin_inf(), most_ = -__builtin_inf();  ///< turns in a single period
};

}  // namespace pendula
