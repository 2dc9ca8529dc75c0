#include "measures/strobe.hpp"

#include "arithmetic/double_double.hpp"
#include "arithmetic/exponential.hpp"
#include "kernels/packs.hpp"
#include "kernels/rk4_kernel.hpp"
#include "pendula/angle.hpp"

namespace pendula {

using arithmetic::abs;
using arithmetic::ceiling;
using arithmetic::sqrt;
using kernels::Chunk;
using kernels::chunk_size;
using kernels::Row;

namespace {

constexpr double two_pi = 2 * pi;

/// Rescales the displacement of member i to length 1, and adds the logarithm of its growth.
void renormalise(StrobedMembers& m, int i) noexcept {
    constexpr double large = 0x1p500, log_of_large = 0x1.5a92d6d005c94p+8;  // the square of a larger length may overflow
    auto& d = m.chunk.tangent;
    if (abs(d.theta[i]) > large || abs(d.omega[i] / m.root_alpha[i]) > large) {
        d.theta[i] /= large;
        d.omega[i] /= large;
        m.growth[i] += log_of_large;
    }
    const double d_omega = d.omega[i] / m.root_alpha[i];
    const double length = sqrt(d.theta[i] * d.theta[i] + d_omega * d_omega);
    m.growth[i] += arithmetic::log(length);
    d.theta[i] /= length;
    d.omega[i] /= length;
}

/// Integrates members by rk4 from time 0 over their lengths of time [s]. Returns false if the call was stopped.
bool take_steps(StrobedMembers& m, const Row& length, const Propagation& run) noexcept {
    // The number of steps between two checks for cancellation, and between two rescalings of the displacement. Within the
    // stability bounds one step multiplies the length of a displacement by at least 0.27, and by at most 14.2 (for
    // sqrt(alpha + |pivot_amplitude|) h = 2.82 and reversed gravity). So 256 steps stay in the range of doubles: 0.27^256 =
    // 2^-484, 14.2^256 = 2^980.
    constexpr int most = 8 * kernels::block_steps;
    constexpr Row start = {};
    return rk4_over(m.chunk, start, length, run.strobe.steps_per_period, run.has_tangent, most, run.thread, [&] {
        for (int i = 0; run.has_tangent && i < m.chunk.count; ++i) renormalise(m, i);
    });
}

/// The number of pieces into which the time is divided, with a rescaling of the displacement after each: in one piece it grows
/// or shrinks by at most a factor e^64.
double piece_count(const StrobedMembers& m, int i, double length) noexcept {
    const auto& p = m.chunk.parameters;
    const double pieces = ceiling(length * (sqrt(p.alpha[i] + abs(p.pivot_amplitude[i])) + p.beta[i]) / 64);
    return pieces > 1 && m.chunk.motion.theta[i] == m.chunk.motion.theta[i] ? pieces : 1;
}

/// The same by Taylor's method, in pieces that depend on each member alone.
bool take_taylor_steps(StrobedMembers& m, const Row& length, const Propagation& run) noexcept {
    Row pieces, start = {}, target;
    double longest = 1;
    for (int i = 0; i < chunk_size; ++i) {
        pieces[i] = run.has_tangent ? piece_count(m, i, length[i]) : 1;
        longest = pieces[i] > longest ? pieces[i] : longest;
    }
    kernels::TaylorChunk steps;
    for (double piece = 0; piece < longest; ++piece) {
        const Chunk before = m.chunk;
        for (int i = 0; i < chunk_size; ++i)
            target[i] = piece + 1 < pieces[i] ? (piece + 1) / pieces[i] * length[i] : length[i];
        start_taylor(steps, m.chunk, run.strobe.tolerance, start);
        if (!taylor_to(m.chunk, steps, target, run.has_tangent, run.thread)) return false;
        for (int i = 0; i < m.chunk.count; ++i) {
            if (piece >= pieces[i])
                copy_motion(before, i, m.chunk, i);
            else if (run.has_tangent)
                renormalise(m, i);
            start[i] = target[i];
        }
    }
    return true;
}

/// Integrates members over their lengths of time [s], and rounds their states to the doubles that are reported. Returns false
/// if the call was stopped.
bool integrate(StrobedMembers& m, const Row& length, const Propagation& run) noexcept {
    if (!(run.strobe.method == Method::taylor ? take_taylor_steps(m, length, run) : take_steps(m, length, run))) return false;
    for (int i = 0; i < chunk_size; ++i) m.chunk.motion.theta_lo[i] = m.chunk.motion.omega_lo[i] = 0;
    restore_resting(m.chunk);
    return true;
}

}  // namespace

double strobe_frequency(const Pendulum& p) noexcept {
    if (p.drive_frequency > 0) return p.drive_frequency;
    return !is_driven(p) && p.drive_frequency == 0 ? sqrt(p.alpha) : __builtin_nan("");
}

double fewest_steps(const Pendulum& p) noexcept {
    const double friction = p.beta / 2.78, swing = sqrt(p.alpha + abs(p.pivot_amplitude)) / 2.82;
    return ceiling(two_pi / strobe_frequency(p) * (friction > swing ? friction : swing));
}

void load_strobed(StrobedMembers& m, const Ensemble& ensemble, std::size_t first) noexcept {
    load_members(m, ensemble, first);
    for (int i = 0; i < chunk_size; ++i) {
        const auto p = i < m.chunk.count ? pendulum_of(ensemble, m.number[i]) : Pendulum{};
        m.frequency[i] = strobe_frequency(p);
        m.period[i] = two_pi / m.frequency[i];
        m.root_alpha[i] = sqrt(p.alpha);
        m.growth[i] = m.first[i] = 0;
        m.has_phase[i] = p.drive_frequency != 0;
    }
}

void move_member(StrobedMembers& m, int from, int to) noexcept {
    if (from == to) return;
    kernels::store<double, kernels::Parameters>(m.chunk.parameters, to,
                                                kernels::load<double, kernels::Parameters>(m.chunk.parameters, from));
    copy_motion(m.chunk, from, m.chunk, to);
    m.chunk.is_resting[to] = m.chunk.is_resting[from];
    m.chunk.resting_theta[to] = m.chunk.resting_theta[from];
    m.chunk.resting_turns[to] = m.chunk.resting_turns[from];
    m.number[to] = m.number[from];
    m.has_phase[to] = m.has_phase[from];
    for (Row* row : {&m.frequency, &m.period, &m.root_alpha, &m.growth, &m.first}) (*row)[to] = (*row)[from];
}

bool integrate_to_first_strobe(StrobedMembers& m, const Propagation& run) noexcept {
    bool moves = false;
    for (int i = 0; i < chunk_size; ++i) {
        const auto ahead = arithmetic::two_sum(run.strobe.phase, -m.chunk.parameters.drive_phase[i]);
        const double phase = wrap(ahead.hi) + ahead.lo;
        m.first[i] = m.has_phase[i] ? (phase < 0 ? phase + two_pi : phase) / m.frequency[i] : 0;
        moves = moves || m.first[i] > 0;
    }
    if (!moves) return true;
    if (!integrate(m, m.first, {run.strobe, run.thread, false})) return false;
    for (double& phase : m.chunk.parameters.drive_phase) phase = run.strobe.phase;
    return true;
}

double time_of_strobe(const StrobedMembers& m, int i, double n) noexcept {
    using arithmetic::DoubleDouble;
    const auto turned = DoubleDouble<double>{arithmetic::two_pi_dd[0], arithmetic::two_pi_dd[1]} * n;
    return (turned / DoubleDouble<double>{m.frequency[i], 0} + m.first[i]).hi;
}

bool integrate_to_next_strobe(StrobedMembers& m, const Propagation& run) noexcept { return integrate(m, m.period, run); }

}  // namespace pendula
