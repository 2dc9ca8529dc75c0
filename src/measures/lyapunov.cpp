#include "arithmetic/exponential.hpp"
#include "measures/strobe.hpp"

namespace pendula {

using arithmetic::sqrt;
using kernels::Row;

namespace {

constexpr int most_blocks = 32;
constexpr double nan = __builtin_nan("");
constexpr double infinity = __builtin_inf();
constexpr double log_of_2_to_52 = 0x1.205966f2b4f12p+5;

/// The larger exponent of the pendulum at rest at the top, where displacements obey x'' = alpha x - beta x'.
double exponent_on_top(const Pendulum& p) noexcept {
    const double half = 0.5 * p.beta;
    return p.alpha / (half + sqrt(half * half + p.alpha));
}

/// Measures the mean growth of displacements, in blocks whose variance gives the error.
struct LyapunovObserver {
    static constexpr bool has_tangent = true;
    const MeasureCall& call;
    int blocks;
    int block = 0;           ///< the present block
    std::size_t row = 0;     ///< the next row of the history
    Row until[most_blocks];  ///< the growth up to the end of each block

    explicit LyapunovObserver(const MeasureCall& of) noexcept
        : call(of), blocks(of.strobe.periods < most_blocks ? static_cast<int>(of.strobe.periods) : most_blocks) {}

    /// The number of periods up to the end of a part, if the measured periods are divided into `parts` parts.
    double end_of(double part, double parts) const noexcept {
        return arithmetic::floor((part + 1) * call.strobe.periods / parts);
    }

    bool start(StrobedMembers& m) noexcept {
        for (double& growth : m.growth) growth = 0;
        return true;
    }

    bool at_strobe(const StrobedMembers& m, double done) noexcept {
        const double rows = call.strobe.history_rows;
        for (; static_cast<double>(row) < rows && end_of(static_cast<double>(row), rows) <= done; ++row)
            for (int i = 0; i < m.chunk.count; ++i) call.result(9, row, m.number[i]) = m.growth[i] / done / m.period[i];
        if (done >= end_of(block, blocks)) {
            for (int i = 0; i < m.chunk.count; ++i) until[block][i] = m.growth[i];
            ++block;
        }
        return true;
    }

    /// The variance of the mean growth per period, from the deviations of the blocks from that mean. The lengths of two blocks
    /// differ by at most one period.
    double variance(int i, double mean) const noexcept {
        double sum = 0, end = 0, grown = 0;
        for (int b = 0; b < blocks; ++b) {
            const double departure = (until[b][i] - grown) - mean * (end_of(b, blocks) - end);
            sum += departure * departure;
            end = end_of(b, blocks);
            grown = until[b][i];
        }
        return blocks > 1 ? sum * blocks / (blocks - 1.0) / (end * end) : nan;
    }

    void put(std::size_t member, double exponent, double error) const noexcept {
        const bool is_known = exponent - exponent == 0;
        call.result(0, 0, member) = is_known ? exponent : nan;
        call.result(1, 0, member) = is_known ? error : nan;
        call.result(2, 0, member) = !is_known ? nan : exponent > 0 ? log_of_2_to_52 / exponent : infinity;
    }

    void finish(const StrobedMembers& m) noexcept {
        for (int i = 0; i < m.chunk.count; ++i) {
            const std::size_t member = m.number[i];
            const auto p = pendulum_of(call.ensemble, member);
            if (m.chunk.is_resting[i] && p.pivot_amplitude == 0) {
                const double exponent = exponent_on_top(p);
                put(member, exponent, 0);
                for (std::size_t j = 0; j < rows_of(lyapunov_columns[9], call.strobe); ++j)
                    call.result(9, j, member) = exponent;
                continue;
            }
            const double mean = m.growth[i] / call.strobe.periods;
            put(member, mean / m.period[i], sqrt(variance(i, mean)) / m.period[i]);
        }
    }
};

}  // namespace

Outcome measure_lyapunov(const MeasureCall& call, const Control& control) noexcept {
    return observe<LyapunovObserver>(call, control);
}

}  // namespace pendula
