#include "pendula/ensemble.hpp"

#include <algorithm>
#include <memory>
#include <new>

#include "checks.hpp"
#include "ensemble/members.hpp"
#include "kernels/rk4_kernel.hpp"

namespace pendula {

using kernels::chunk_size;
using kernels::Row;

namespace {

/// The arguments of one call.
struct EnsembleCall {
    const Ensemble& ensemble;
    Method method;
    double tolerance;
    const EnsembleTimes& times;
    const EnsembleRows& rows;

    Problem problem(std::size_t member) const noexcept {
        return {.pendulum = pendulum_of(ensemble, member),
                .initial = initial_state_of(ensemble, member),
                .method = method,
                .schedule = {.every = times.every[member],
                             .rows = static_cast<double>(times.rows),
                             .steps_per_row = times.steps_per_row[member],
                             .first = times.first[member],
                             .steps_to_first = times.steps_to_first[member],
                             .times = times.times,
                             .dt = times.dt[member]},
                .tolerance = tolerance};
    }

    double time_of(std::size_t member, std::size_t row) const noexcept {
        if (!times.times.empty()) return times.times[row];
        return times.first[member] + static_cast<double>(row) * times.every[member];
    }

    void put_row(const Members& m, std::size_t row) const noexcept {
        const auto& motion = m.chunk.motion;
        for (int i = 0; i < m.chunk.count; ++i) {
            const std::size_t at = row * ensemble.size + m.number[i];
            rows.theta[at] = motion.theta[i];
            rows.omega[at] = motion.omega[i];
            rows.turns[at] = motion.turns[i];
        }
    }

    /// Computes the rows of one member by `advance`, for methods without packs and for an ensemble of one member.
    void member_rows(Thread& thread, std::size_t member) const noexcept {
        constexpr std::size_t block = 256;
        constexpr double step_budget = 1 << 16;  // takes some milliseconds
        Sample samples[block];
        Trajectory run = begin(problem(member));
        for (std::size_t at = member; !run.is_finished();) {
            const std::size_t n = advance(run, samples, step_budget);
            for (std::size_t i = 0; i < n; ++i, at += ensemble.size) {
                rows.theta[at] = samples[i].theta;
                rows.omega[at] = samples[i].omega;
                rows.turns[at] = samples[i].turns;
            }
            thread.report(static_cast<double>(n));
            if (!thread.goes_on()) return;
        }
    }

    /// Integrates the members whose number of steps is `count` over their lengths of time. The other members do not change.
    bool rk4_by_count(Members& m, const Row& start, const Row& length, const Row& counts, double count,
                      Thread& thread) const noexcept {
        constexpr int most = 16 * kernels::block_steps;  // steps between two checks for cancellation
        const auto before = m.chunk;
        Row own;
        for (int i = 0; i < chunk_size; ++i) own[i] = counts[i] == count ? length[i] : 0;
        if (!rk4_over(m.chunk, start, own, count, false, most, thread, [] {})) return false;
        for (int i = 0; i < m.chunk.count; ++i)
            if (counts[i] != count) copy_motion(before, i, m.chunk, i);
        return true;
    }

    bool rk4_to_row(Members& m, std::size_t row, Thread& thread) const noexcept {
        Row start, length, counts;
        bool moves = false;
        for (int i = 0; i < chunk_size; ++i) {
            const std::size_t member = m.number[i < m.chunk.count ? i : 0];
            start[i] = row == 0 ? 0 : time_of(member, row - 1);
            if (!times.times.empty()) {
                length[i] = times.times[row] - start[i];
                counts[i] = length[i] > 0 ? steps_in(length[i], times.dt[member]) : 1;
            } else {
                length[i] = row == 0 ? times.first[member] : times.every[member];
                counts[i] = row == 0 ? times.steps_to_first[member] : times.steps_per_row[member];
            }
            moves = moves || length[i] > 0;
        }
        if (!moves) return true;
        for (int i = 0; i < m.chunk.count; ++i) {
            if (std::find(counts, counts + i, counts[i]) != counts + i) continue;
            if (!rk4_by_count(m, start, length, counts, counts[i], thread)) return false;
        }
        return true;
    }

    void rk4_rows(Members& m, Thread& thread) const noexcept {
        for (std::size_t row = 0; row < times.rows; ++row) {
            if (!rk4_to_row(m, row, thread)) return;
            restore_resting(m.chunk);
            put_row(m, row);
            thread.report(m.chunk.count);
        }
    }

    void taylor_rows(Members& m, Thread& thread) const noexcept {
        kernels::TaylorChunk steps;
        Row t = {};
        start_taylor(steps, m.chunk, tolerance, t);
        for (std::size_t row = 0; row < times.rows; ++row) {
            for (int i = 0; i < m.chunk.count; ++i) t[i] = time_of(m.number[i], row);
            if (!taylor_to(m.chunk, steps, t, false, thread)) return;
            restore_resting(m.chunk);
            put_row(m, row);
            thread.report(m.chunk.count);
        }
    }
};

Refusal check_when(const Ensemble& ensemble, const EnsembleTimes& times) noexcept {
    const std::pair<const char*, const Column*> columns[] = {{"first", &times.first},
                                                             {"every", &times.every},
                                                             {"steps_to_first", &times.steps_to_first},
                                                             {"steps_per_row", &times.steps_per_row},
                                                             {"dt", &times.dt}};
    for (const auto& [name, column] : columns)
        if (!column->fits(ensemble.size))
            return {.reason = Refusal::Reason::length,
                    .name = name,
                    .value = static_cast<double>(column->length()),
                    .least = static_cast<double>(ensemble.size)};
    return times.times.empty() ? Refusal{} : check_times(times.times, static_cast<double>(times.rows));
}

Refusal check_rows(const Ensemble& ensemble, const EnsembleTimes& times, const EnsembleRows& rows) noexcept {
    const double values = static_cast<double>(times.rows) * static_cast<double>(ensemble.size);
    if (const auto refusal = check_length(rows.theta, values, "theta")) return refusal;
    if (const auto refusal = check_length(rows.omega, values, "omega")) return refusal;
    return check_length(rows.turns, values, "turns");
}

/// The numbers of the members, sorted by their numbers of steps, so that most members of a chunk have the same number. Null if
/// memory could not be allocated.
std::unique_ptr<std::size_t[]> order_by_steps(std::size_t size, const EnsembleTimes& times) noexcept {
    std::unique_ptr<std::size_t[]> order(new (std::nothrow) std::size_t[size]);
    if (!order) return order;
    for (std::size_t i = 0; i < size; ++i) order[i] = i;
    const Column& steps = times.times.empty() ? times.steps_per_row : times.dt;
    std::sort(order.get(), order.get() + size, [&](std::size_t a, std::size_t b) {
        const double steps_of_a = steps[a], steps_of_b = steps[b];
        return steps_of_a != steps_of_b ? steps_of_a < steps_of_b : a < b;
    });
    return order;
}

}  // namespace

Outcome solve(const Ensemble& ensemble, Method method, double tolerance, const EnsembleTimes& times, const EnsembleRows& rows,
              const Control& control) noexcept {
    const EnsembleCall call{ensemble, method, tolerance, times, rows};
    if (const auto refusal = check_call(ensemble, control)) return refusal;
    if (const auto refusal = check_when(ensemble, times)) return refusal;
    if (const auto refusal = check_rows(ensemble, times, rows)) return refusal;
    const auto check_member = [&](std::size_t member, const Pendulum&) { return check_but_times(call.problem(member)); };
    if (const auto refusal = check_each(ensemble, check_member)) return refusal;

    const double units = static_cast<double>(ensemble.size) * static_cast<double>(times.rows);
    const bool has_packs = method == Method::rk4 || method == Method::taylor;
    if (!has_packs || ensemble.size == 1)
        return for_each_piece(ensemble.size, units, control,
                              [&](Thread& thread, std::size_t member) { call.member_rows(thread, member); });
    std::unique_ptr<std::size_t[]> order;
    if (method == Method::rk4 &&
        (times.steps_per_row.length() > 1 || times.steps_to_first.length() > 1 || times.dt.length() > 1)) {
        order = order_by_steps(ensemble.size, times);
        if (!order) return Refusal{.reason = Refusal::Reason::memory, .name = "ensemble"};
    }
    return for_each_piece(chunks_of(ensemble.size), units, control, [&](Thread& thread, std::size_t chunk) {
        Members m;
        load_members(m, ensemble, chunk * chunk_size, order.get());
        method == Method::rk4 ? call.rk4_rows(m, thread) : call.taylor_rows(m, thread);
    });
}

}  // namespace pendula
