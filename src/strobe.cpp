#include "strobe.hpp"

#include "arithmetic/exponential.hpp"
#include "kernels/rk4_kernel.hpp"
#include "pendula/angle.hpp"

namespace pendula {

using arithmetic::ceiling;
using arithmetic::sqrt;
using kernels::Chunk;
using kernels::chunk_size;

namespace {

constexpr double nan = __builtin_nan("");
constexpr double two_pi = 2 * pi;

void renormalise(Strobed& m, int i) noexcept {
    Chunk& c = m.chunk;
    const double d_omega = c.tangent_omega[i] / m.root_alpha[i];
    const double length = sqrt(c.tangent_theta[i] * c.tangent_theta[i] + d_omega * d_omega);
    m.growth[i] += arithmetic::log(length);
    c.tangent_theta[i] /= length;
    c.tangent_omega[i] /= length;
}

/// Takes members over their lengths [s] from time 0, by rk4.
bool take_steps(Strobed& m, const double* length, const Way& way) noexcept {
    // Between looks at whether to go on, and between renormalisations: within stability a step changes a tangent vector's
    // length by a factor from 0.27 to e, and 256 of them by none that leaves the range of doubles.
    constexpr int most = 8 * kernels::block_steps;
    constexpr double start[chunk_size] = {};
    const double steps = way.strobe.steps_per_period;
    double h[chunk_size];
    for (int i = 0; i < chunk_size; ++i) h[i] = length[i] / steps;
    const auto advance = way.has_tangent ? kernels::dispatch().rk4_tangent : kernels::dispatch().rk4;
    for (double done = 0; done < steps; done += most) {
        if (!way.progress.proceeds(way.is_caller)) return false;
        const double left = steps - done;
        advance(m.chunk, start, h, done, left < most ? static_cast<int>(left) : most);
        for (int i = 0; way.has_tangent && i < m.chunk.count; ++i) renormalise(m, i);
    }
    return true;
}

/// Leaves a member as it was.
void keep(Chunk& now, const Chunk& before, int i) noexcept {
    now.theta[i] = before.theta[i];
    now.omega[i] = before.omega[i];
    now.turns[i] = before.turns[i];
    now.theta_lo[i] = before.theta_lo[i];
    now.omega_lo[i] = before.omega_lo[i];
    now.tangent_theta[i] = before.tangent_theta[i];
    now.tangent_omega[i] = before.tangent_omega[i];
}

/// Times at which a member's tangent vector is renormalised on its way: before it can grow or shrink by more than e^64.
double piece_count(const Strobed& m, int i, double length) noexcept {
    const double pieces = ceiling(length * (m.root_alpha[i] + m.chunk.beta[i]) / 64);
    return pieces > 1 && m.chunk.theta[i] == m.chunk.theta[i] ? pieces : 1;
}

/// The same by Taylor's method, in pieces that depend on each member alone.
bool take_taylor_steps(Strobed& m, const double* length, const Way& way) noexcept {
    constexpr int most = 64;  // steps between looks at whether to go on
    double pieces[chunk_size], start[chunk_size] = {}, goal[chunk_size];
    double longest = 1;
    for (int i = 0; i < chunk_size; ++i) {
        pieces[i] = way.has_tangent ? piece_count(m, i, length[i]) : 1;
        longest = pieces[i] > longest ? pieces[i] : longest;
    }
    const auto advance = way.has_tangent ? kernels::dispatch().taylor_tangent : kernels::dispatch().taylor;
    kernels::TaylorChunk steps;
    for (double piece = 0; piece < longest; ++piece) {
        const Chunk before = m.chunk;
        for (int i = 0; i < chunk_size; ++i) goal[i] = piece + 1 < pieces[i] ? (piece + 1) / pieces[i] * length[i] : length[i];
        start_taylor(steps, m.chunk, way.strobe.tolerance, start);
        do {
            if (!way.progress.proceeds(way.is_caller)) return false;
        } while (!advance(m.chunk, steps, goal, most));
        for (int i = 0; i < m.chunk.count; ++i) {
            if (piece >= pieces[i])
                keep(m.chunk, before, i);
            else if (way.has_tangent)
                renormalise(m, i);
            start[i] = goal[i];
        }
    }
    return true;
}

bool go(Strobed& m, const double* length, const Way& way) noexcept {
    return way.strobe.method == Method::taylor ? take_taylor_steps(m, length, way) : take_steps(m, length, way);
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
    return ceiling(two_pi / strobe_frequency(p) * (friction > swing ? friction : swing));
}

void load(Strobed& m, const Ensemble& ensemble, std::size_t first) noexcept {
    load(m.chunk, ensemble, first);
    for (int i = 0; i < chunk_size; ++i) {
        const auto p = i < m.chunk.count ? pendulum_of(ensemble, first + static_cast<std::size_t>(i)) : Pendulum{};
        m.frequency[i] = strobe_frequency(p);
        m.period[i] = two_pi / m.frequency[i];
        m.root_alpha[i] = sqrt(p.alpha);
        m.growth[i] = 0;
        if (!(fewest_steps(p) <= 0x1p53)) m.chunk.theta[i] = nan;  // times of a period would not tell its steps apart
    }
}

bool go_to_first_strobe(Strobed& m, const Way& way) noexcept {
    double length[chunk_size];
    bool moves = false;
    for (int i = 0; i < chunk_size; ++i) {
        const double phase = wrap(-m.chunk.drive_phase[i]);
        length[i] = (phase < 0 ? phase + two_pi : phase) / m.frequency[i];
        moves = moves || length[i] > 0;
    }
    if (!moves) return true;
    if (!go(m, length, {way.strobe, way.progress, way.is_caller, false})) return false;
    for (int i = 0; i < chunk_size; ++i) m.chunk.drive_phase[i] = 0;
    round_states(m.chunk);
    return true;
}

bool go_to_next_strobe(Strobed& m, const Way& way) noexcept {
    if (!go(m, m.period, way)) return false;
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
