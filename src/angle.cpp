#include "pendula/angle.hpp"

#include "arithmetic/arctangent.hpp"
#include "arithmetic/trigonometric.hpp"

namespace pendula {

using namespace arithmetic;

namespace {

/// The sum as an angle in [-pi, pi). A sum that rounds to `pi` gives the double below it.
double round_into_interval(DoubleDouble<double> theta) noexcept {
    const double sum = theta.hi + theta.lo;
    return sum >= pi ? last_below_pi : sum < -pi ? -pi : sum;
}

}  // namespace

double to_radians(double degrees) noexcept {
    const DoubleDouble<double> factor{pi_over_180_dd[0], pi_over_180_dd[1]};
    const double power = abs(degrees) > 0x1p900 ? 0x1p-200 : 1.0;  // the splitting of a larger number would overflow
    return (factor * (degrees * power)).hi / power;
}

double wrap(double theta) noexcept {
    if (theta == pi) return -pi;
    if (theta >= -pi && theta < pi) return theta;
    const auto r = reduce_to_quarter_turn(theta);
    int quarter = static_cast<int>(r.quadrant & 3);
    if (quarter == 3) quarter = -1;
    if (quarter == 2 && r.hi >= 0) quarter = -2;
    const DoubleDouble<double> start{quarter * pi_over_2_dd[0], quarter * pi_over_2_dd[1]};
    return round_into_interval(start + DoubleDouble<double>{r.hi, r.lo});
}

Angle split_turns(double theta) noexcept {
    const double wrapped = wrap(theta);
    return {wrapped, round_even((theta - wrapped) * inverse_two_pi_dd[0])};
}

double phase(double s, double r) noexcept {
    if (s >= 1) return pi / 2;
    if (s <= -1) return -pi / 2;
    const double cosine = sqrt((1 - s) * (1 + s));
    return atan2(s, r >= 0 ? cosine : -cosine);
}

}  // namespace pendula
