#include "measures/averages.hpp"

#include "arithmetic/exponential.hpp"

namespace pendula {

using arithmetic::abs;
using arithmetic::floor;
using arithmetic::sqrt;

namespace {

/// A mean of n independent parts is within this many of its standard errors of the true mean in more than 95 % of the cases, if
/// the standard error comes from the scatter of eight parts or more: 2.36 by Student's distribution for eight parts.
constexpr double coverage = 2.5;

/// A bound of the rounding errors of a mean rotation, relative to it or to one turn.
constexpr double rounding = 0x1p-46;

double end_of(double part, double parts, double periods) noexcept { return floor((part + 1) * periods / parts); }

/// The variance of the mean of `n` means of windows of equal length.
double variance_of_mean(const double* mean, int n) noexcept {
    double centre = 0, sum = 0;
    for (int i = 0; i < n; ++i) centre += mean[i] / n;
    for (int i = 0; i < n; ++i) sum += (mean[i] - centre) * (mean[i] - centre);
    return sum / (n * (n - 1.0));
}

}  // namespace

void Windows::move_to(double done) noexcept {
    int first = 0;
    for (int level = 0, parts = 1; level < levels; ++level, first += parts, parts *= 2) {
        const double place = (done + 0.5) * parts / periods, part = floor(place);
        const double s = place - part;
        window[level] = first + static_cast<int>(part);
        weight[level] = s > 0 && s < 1 ? arithmetic::exp(-1 / (s * (1 - s))) : 0;
    }
}

void Averages::add(const Windows& windows, double done, double turns, double growth) noexcept {
    for (int level = 0; level < Windows::levels; ++level) {
        sum_[windows.window[level]] += windows.weight[level] * turns;
        weights_[windows.window[level]] += windows.weight[level];
    }
    least_ = turns < least_ ? turns : least_;
    most_ = turns > most_ ? turns : most_;
    while (block_ < blocks && done + 1 >= end_of(block_, blocks, windows.periods)) until_[block_++] = growth;
}

Estimate Averages::rotation(double periods) const noexcept {
    if (periods < 2 * 8) return {0.5 * (least_ + most_), 0.5 * (most_ - least_) + 1 / periods};
    double mean[Windows::count];
    for (int i = 0; i < Windows::count; ++i) mean[i] = sum_[i] / weights_[i];
    const double halves = variance_of_mean(mean + 1, 2), quarters = variance_of_mean(mean + 3, 4),
                 eighths = variance_of_mean(mean + 7, 8);
    // If longer windows agree much better than shorter ones, the mean converges faster than that of independent parts, and the
    // longest windows bound its error.
    const bool is_smooth = quarters < eighths / 64 && halves < eighths / 64;
    const double variance = is_smooth ? (halves > quarters ? halves : quarters) : (halves + 3 * quarters + 7 * eighths) / 11;
    return {mean[0], coverage * sqrt(variance) + rounding * (abs(mean[0]) + 1)};
}

double Averages::drift(double periods) const noexcept {
    return periods < 4 ? 0 : (sum_[2] / weights_[2] - sum_[1] / weights_[1]) / (0.5 * periods);
}

Estimate Averages::growth(double periods) const noexcept {
    const double total = until_[blocks - 1], mean = total / periods;
    double variance = 0, farthest = 0;
    for (int parts = blocks; parts >= 8; parts /= 2) {
        double sum = 0, before = 0, start = 0;
        for (int part = 0; part < parts; ++part) {
            const double end = end_of(part, parts, periods);
            const double until = until_[(part + 1) * blocks / parts - 1];
            const double departure = (until - before) - mean * (end - start);
            sum += departure * departure;
            before = until;
            start = end;
        }
        const double of_parts = sum * parts / (parts - 1.0) / (periods * periods);
        variance = of_parts > variance ? of_parts : variance;
    }
    for (int block = 0; block < blocks; ++block) {
        const double off = abs(until_[block] - mean * end_of(block, blocks, periods));
        farthest = off > farthest ? off : farthest;
    }
    // A growth that is no exponential, like that of ln(t) on a regular orbit, is seen as a bend of the curve.
    const double scatter = coverage * sqrt(variance), bend = (2 * farthest + 1) / periods;
    return {mean, scatter > bend ? scatter : bend};
}

}  // namespace pendula
