#include "pendula/ensemble.hpp"

#include "flock.hpp"
#include "kernels/rk4_kernel.hpp"
#include "pendula/angle.hpp"

namespace pendula {

using kernels::Chunk;
using kernels::chunk_size;

Pendulum pendulum_of(const Ensemble& e, std::size_t i) noexcept {
    return {value_of(e.alpha, i),           value_of(e.beta, i),       value_of(e.torque, i), value_of(e.drive_amplitude, i),
            value_of(e.drive_frequency, i), value_of(e.drive_phase, i)};
}

State state_of(const Ensemble& e, std::size_t i) noexcept { return {value_of(e.theta, i), value_of(e.omega, i)}; }

namespace {

constexpr double nan = __builtin_nan("");

bool is_finite(double x) noexcept { return x - x == 0; }

bool is_legal(const Pendulum& p, State s) noexcept {
    return p.alpha > 0 && is_finite(p.alpha) && p.beta >= 0 && is_finite(p.beta) && is_finite(p.torque) &&
           is_finite(p.drive_amplitude) && p.drive_frequency >= 0 && is_finite(p.drive_frequency) && is_finite(p.drive_phase) &&
           is_finite(s.theta) && is_finite(s.omega);
}

void put(Chunk& c, int i, Pendulum p, State s) noexcept {
    if (!is_legal(p, s)) s = {nan, nan};
    if (rests_on_top(p, s)) {
        s.theta = pi;
        p.alpha = 0;  // nothing moves it
    }
    const auto angle = split_turns(s.theta);
    c.theta[i] = angle.theta;
    c.omega[i] = s.omega;
    c.turns[i] = angle.turns;
    c.theta_lo[i] = c.omega_lo[i] = 0;
    c.tangent_theta[i] = 1;
    c.tangent_omega[i] = 0;
    c.alpha[i] = p.alpha;
    c.beta[i] = p.beta;
    c.torque[i] = p.torque;
    c.drive_amplitude[i] = p.drive_amplitude;
    c.drive_frequency[i] = p.drive_frequency;
    c.drive_phase[i] = p.drive_phase;
}

/// Takes every member by rk4 in `steps` steps over `length` [s] from `start` [s]; arrays of chunk_size. False when stopped.
bool rk4_segment(Chunk& c, const double* start, const double* length, double steps, Progress& progress,
                 bool is_caller) noexcept {
    constexpr int most = 16 * kernels::block_steps;  // between looks at whether to go on
    double h[chunk_size];
    for (int i = 0; i < chunk_size; ++i) h[i] = length[i] / steps;
    for (double done = 0; done < steps; done += most) {
        if (!progress.proceeds(is_caller)) return false;
        const double left = steps - done;
        kernels::dispatch().rk4(c, start, h, done, left < most ? static_cast<int>(left) : most);
    }
    return true;
}

/// A call of `solve`, as its pieces see it: one chunk each.
struct Call {
    const Ensemble& ensemble;
    Method method;
    double tolerance;
    const EnsembleTimes& times;
    const EnsembleRows& rows;
    Progress& progress;

    double row_time(std::size_t member, double row) const noexcept {
        return value_of(times.first, member) + row * value_of(times.every, member);
    }

    void put_row(const Chunk& c, std::size_t first, std::size_t row) const noexcept {
        for (int i = 0; i < c.count; ++i) {
            const std::size_t at = row * ensemble.size + first + static_cast<std::size_t>(i);
            rows.theta[at] = c.theta[i];
            rows.omega[at] = c.omega[i];
            rows.turns[at] = c.turns[i];
        }
    }

    void rk4_rows(std::size_t first, bool is_caller) const noexcept {
        Chunk c;
        load(c, ensemble, first);
        double start[chunk_size], length[chunk_size];
        for (std::size_t row = 0; row < times.rows; ++row) {
            bool moves = false;
            for (int i = 0; i < chunk_size; ++i) {
                const std::size_t member = first + static_cast<std::size_t>(i < c.count ? i : 0);
                start[i] = row == 0 ? 0 : row_time(member, static_cast<double>(row - 1));
                length[i] = row == 0 ? value_of(times.first, member) : value_of(times.every, member);
                moves = moves || length[i] > 0;
            }
            if (moves && !rk4_segment(c, start, length, times.steps_per_row, progress, is_caller)) return;
            put_row(c, first, row);
            progress.report(c.count);
        }
    }

    void taylor_rows(std::size_t first, bool is_caller) const noexcept {
        constexpr int most = 64;  // steps between looks at whether to go on
        Chunk c;
        load(c, ensemble, first);
        kernels::TaylorChunk steps;
        double t[chunk_size] = {};
        start_taylor(steps, c, tolerance, t);
        for (std::size_t row = 0; row < times.rows; ++row) {
            for (int i = 0; i < c.count; ++i) t[i] = row_time(first + static_cast<std::size_t>(i), static_cast<double>(row));
            do {
                if (!progress.proceeds(is_caller)) return;
            } while (!kernels::dispatch().taylor(c, steps, t, most));
            put_row(c, first, row);
            progress.report(c.count);
        }
    }

    void exact_rows(std::size_t first, bool is_caller) const noexcept {
        constexpr std::size_t batch = 256;
        double t[batch] = {}, theta[batch], omega[batch], turns[batch];
        for (std::size_t member = first; member < first + chunk_size && member < ensemble.size; ++member) {
            const auto p = pendulum_of(ensemble, member);
            const auto solution = exact(is_conservative(p) ? p.alpha : nan, state_of(ensemble, member));
            for (std::size_t row = 0; row < times.rows; row += batch) {
                if (!progress.proceeds(is_caller)) return;
                const std::size_t count = times.rows - row < batch ? times.rows - row : batch;
                for (std::size_t i = 0; i < count; ++i) t[i] = row_time(member, static_cast<double>(row + i));
                at(solution, count, t, theta, omega, turns);
                for (std::size_t i = 0; i < count; ++i) {
                    const std::size_t to = (row + i) * ensemble.size + member;
                    rows.theta[to] = theta[i];
                    rows.omega[to] = omega[i];
                    rows.turns[to] = turns[i];
                }
                progress.report(static_cast<double>(count));
            }
        }
    }
};

}  // namespace

void load(Chunk& c, const Ensemble& e, std::size_t first) noexcept {
    c.count = e.size - first < chunk_size ? static_cast<int>(e.size - first) : chunk_size;
    for (int i = 0; i < chunk_size; ++i) {
        const std::size_t member = first + static_cast<std::size_t>(i);
        if (i < c.count)
            put(c, i, pendulum_of(e, member), state_of(e, member));
        else
            put(c, i, {}, {});
    }
}

bool solve(const Ensemble& ensemble, Method method, double tolerance, const EnsembleTimes& times, const Control& control,
           const EnsembleRows& rows) noexcept {
    Progress progress(control, static_cast<double>(ensemble.size) * static_cast<double>(times.rows));
    Call call{ensemble, method, tolerance, times, rows, progress};
    const auto work = [](void* context, std::size_t chunk, bool is_caller) {
        const auto& c = *static_cast<const Call*>(context);
        if (!c.progress.proceeds(is_caller)) return;
        const std::size_t first = chunk * chunk_size;
        if (c.method == Method::exact) c.exact_rows(first, is_caller);
        if (c.method == Method::taylor) c.taylor_rows(first, is_caller);
        if (c.method == Method::rk4) c.rk4_rows(first, is_caller);
    };
    for_each_piece(chunks_of(ensemble.size), control.threads, progress, work, &call);
    return progress.proceeds(true);
}

}  // namespace pendula
