#include "arithmetic/exponential.hpp"
#include "pendula/analysis.hpp"
#include "strobe.hpp"

namespace pendula {

using kernels::chunk_size;

namespace {

constexpr int most_blocks = 32;
constexpr double nan = __builtin_nan("");
constexpr double infinity = __builtin_inf();
constexpr double log_of_2_to_52 = 0x1.205966f2b4f12p+5;

/// What a measurement gathers.
struct Growth {
    int blocks;
    double ends[most_blocks];               ///< periods measured by the end of each block
    double until[most_blocks][chunk_size];  ///< growth by then
};

/// The variance of the mean growth a period, from the blocks' departures from it. Blocks differ in length by one period at
/// most.
double variance(const Growth& g, int i, double mean) noexcept {
    double sum = 0, end = 0, grown = 0;
    for (int b = 0; b < g.blocks; ++b) {
        const double departure = (g.until[b][i] - grown) - mean * (g.ends[b] - end);
        sum += departure * departure;
        end = g.ends[b];
        grown = g.until[b][i];
    }
    return g.blocks > 1 ? sum * g.blocks / (g.blocks - 1.0) / (end * end) : nan;
}

/// Of a pendulum at rest on top, whose displacements obey x'' = alpha x - beta x'.
double exponent_on_top(const Pendulum& p) noexcept {
    const double half = 0.5 * p.beta;
    return p.alpha / (half + arithmetic::sqrt(half * half + p.alpha));
}

void put(const LyapunovValues& values, std::size_t at, double exponent, double error) noexcept {
    const bool is_known = exponent - exponent == 0;
    values.exponent[at] = is_known ? exponent : nan;
    values.error[at] = is_known ? error : nan;
    values.horizon[at] = !is_known ? nan : exponent > 0 ? log_of_2_to_52 / exponent : infinity;
}

double floor(double x) noexcept {
    const double whole = arithmetic::round_even(x);
    return whole > x ? whole - 1 : whole;
}

/// One call, as its pieces see it: a chunk each.
struct Measurement {
    const Ensemble& ensemble;
    const Strobe& strobe;
    const LyapunovValues& values;

    /// Periods measured by the end of one of so many parts.
    double end_of(double part, double parts) const noexcept { return floor((part + 1) * strobe.periods / parts); }

    std::size_t place(std::size_t row, std::size_t member) const noexcept { return row * ensemble.size + member; }

    void put_history(const Strobed& m, std::size_t first, double done, std::size_t& row) const noexcept {
        const auto rows = static_cast<double>(values.rows);
        for (; row < values.rows && end_of(static_cast<double>(row), rows) <= done; ++row)
            for (int i = 0; i < m.chunk.count; ++i)
                values.history[place(row, first + static_cast<std::size_t>(i))] = m.growth[i] / done / m.period[i];
    }

    bool measure(Strobed& m, Growth& g, const Way& way, std::size_t first) const noexcept {
        for (double& growth : m.growth) growth = 0;
        int block = 0;
        std::size_t row = 0;
        for (double done = 1; done <= strobe.periods; ++done) {
            if (!go_to_next_strobe(m, way)) return false;
            put_history(m, first, done, row);
            if (done < g.ends[block]) continue;
            for (int i = 0; i < m.chunk.count; ++i) g.until[block][i] = m.growth[i];
            ++block;
        }
        return true;
    }

    void put_on_top(std::size_t member) const noexcept {
        const double exponent = exponent_on_top(pendulum_of(ensemble, member));
        put(values, member, exponent, 0);
        for (std::size_t row = 0; row < values.rows; ++row) values.history[place(row, member)] = exponent;
    }

    void operator()(Progress& progress, std::size_t first, bool is_caller) const noexcept {
        const Way way{strobe, progress, is_caller, true};
        Strobed m;
        Growth g;
        g.blocks = strobe.periods < most_blocks ? static_cast<int>(strobe.periods) : most_blocks;
        for (int b = 0; b < g.blocks; ++b) g.ends[b] = end_of(b, g.blocks);
        load(m, ensemble, first);
        if (!go_to_first_strobe(m, way) || !go_through_transient(m, way) || !measure(m, g, way, first)) return;
        for (int i = 0; i < m.chunk.count; ++i) {
            const std::size_t member = first + static_cast<std::size_t>(i);
            const double mean = m.growth[i] / strobe.periods;
            put(values, member, mean / m.period[i], arithmetic::sqrt(variance(g, i, mean)) / m.period[i]);
            if (rests_on_top(pendulum_of(ensemble, member), state_of(ensemble, member))) put_on_top(member);
        }
    }
};

}  // namespace

bool lyapunov(const Ensemble& ensemble, const Strobe& strobe, const Control& control, const LyapunovValues& values) noexcept {
    return for_each_chunk(ensemble, strobe, control, Measurement{ensemble, strobe, values});
}

}  // namespace pendula
