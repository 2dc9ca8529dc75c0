#include "strobe.hpp"

#include "arithmetic/exponential.hpp"
#include "kernels/rk4_kernel.hpp"
#include "pendula/angle.hpp"

namespace pendula {

using arithmetic::sqrt;
using kernels::Chunk;
using kernels::chunk_size;

namespace {

constexpr double nan = __builtin_nan("");
constexpr double two_pi = 2 * pi;

void renormalise(Strobed& m) noexcept {
    Chunk& c = m.chunk;
    for (int i = 0; i < c.count; ++i) {
        const double d_omega = c.tangent_omega[i] / m.root_alpha[i];
        const double length = sqrt(c.tangent_theta[i] * c.tangent_theta[i] + d_omega * d_omega);
        m.growth[i] += arithmetic::log(length);
        c.tangent_theta[i] /= length;
        c.tangent_omega[i] /= length;
    }
}

/// Takes members over their lengths [s] from their times `start` [s], by rk4.
bool take_steps(Strobed& m, const double* start, const double* length, const Way& way) noexcept {
    // Between looks at whether to go on, and between renormalisations: within stability a step changes a tangent vector's
    // length by a factor from 0.27 to e, and 256 of them by none that leaves the range of doubles.
    constexpr int most = 8 * kernels::block_steps;
    const double steps = way.strobe.steps_per_period;
    double h[chunk_size];
    for (int i = 0; i < chunk_size; ++i) h[i] = length[i] / steps;
    const auto advance = way.has_tangent ? kernels::dispatch().rk4_tangent : kernels::dispatch().rk4;
    for (double done = 0; done < steps; done += most) {
        if (!way.progress.proceeds(way.is_caller)) return false;
        const double left = steps - done;
        advance(m.chunk, start, h, done, left < most ? static_cast<int>(left) : most);
        if (way.has_tangent) renormalise(m);
    }
    return true;
}

void round_states(Chunk& c) noexcept {
    for (int i = 0; i < chunk_size; ++i) c.theta_lo[i] = c.omega_lo[i] = 0;
}

}  // namespace

double strobe_frequency(const Pendulum& p) noexcept {
    if (p.drive_frequency > 0) return p.drive_frequency;
    return p.drive_amplitude == 0 && p.drive_frequency == 0 ? sqrt(p.alpha) : nan;
}

double fewest_steps(const Pendulum& p) noexcept {
    const double friction = p.beta / 2.78, swing = sqrt(p.alpha) / 2.82;
    const double steps = two_pi / strobe_frequency(p) * (friction > swing ? friction : swing);
    const double whole = arithmetic::round_even(steps);
    return whole < steps ? whole + 1 : whole;
}

void load(Strobed& m, const Ensemble& ensemble, std::size_t first) noexcept {
    load(m.chunk, ensemble, first);
    for (int i = 0; i < chunk_size; ++i) {
        const auto p = i < m.chunk.count ? pendulum_of(ensemble, first + static_cast<std::size_t>(i)) : Pendulum{};
        m.frequency[i] = strobe_frequency(p);
        m.period[i] = two_pi / m.frequency[i];
        m.root_alpha[i] = sqrt(p.alpha);
        m.growth[i] = 0;
    }
}

bool go_to_first_strobe(Strobed& m, const Way& way) noexcept {
    double start[chunk_size] = {}, length[chunk_size];
    bool moves = false;
    for (int i = 0; i < chunk_size; ++i) {
        const double phase = wrap(-m.chunk.drive_phase[i]);
        length[i] = (phase < 0 ? phase + two_pi : phase) / m.frequency[i];
        moves = moves || length[i] > 0;
    }
    if (!moves) return true;
    const Chunk before = m.chunk;
    if (!take_steps(m, start, length, {way.strobe, way.progress, way.is_caller, false})) return false;
    for (int i = 0; i < chunk_size; ++i) {
        m.chunk.drive_phase[i] = 0;
        if (length[i] != 0) continue;
        m.chunk.theta[i] = before.theta[i];
        m.chunk.omega[i] = before.omega[i];
        m.chunk.turns[i] = before.turns[i];
    }
    round_states(m.chunk);
    return true;
}

bool go_to_next_strobe(Strobed& m, const Way& way) noexcept {
    constexpr double start[chunk_size] = {};
    if (!take_steps(m, start, m.period, way)) return false;
    round_states(m.chunk);
    way.progress.report(m.chunk.count);
    return true;
}

bool go_through_transient(Strobed& m, const Way& way) noexcept {
    for (double done = 0; done < way.strobe.transient; ++done)
        if (!go_to_next_strobe(m, way)) return false;
    return true;
}

}  // namespace pendula
