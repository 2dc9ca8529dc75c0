#include "pendula/replay.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <memory>
#include <new>

#include "checks.hpp"
#include "ensemble/members.hpp"

namespace pendula {

namespace {

using kernels::replay_size;
using kernels::ReplayChunk;

constexpr double limit = 0x1p53;  ///< of steps

Refusal check_lengths(const Program& p, std::size_t stages, std::size_t rows) noexcept {
    const auto check_equal = [](const char* name, double length, double wanted) -> Refusal {
        if (length == wanted) return {};
        return {.reason = Refusal::Reason::length, .name = name, .value = length, .least = wanted};
    };
    const auto s = static_cast<double>(p.stages);
    if (const auto refusal = check_count("stages", s, 1, stages_limit)) return refusal;
    if (p.stages != stages)
        return {.reason = Refusal::Reason::whole,
                .name = "stages",
                .value = s,
                .least = static_cast<double>(stages),
                .most = static_cast<double>(stages)};
    if (const auto refusal = check_equal("coefficients", static_cast<double>(p.coefficients.size()), s * (3 + 4 * s)))
        return refusal;
    if (const auto refusal = check_equal("sums", static_cast<double>(p.sums.size()), 4 * s)) return refusal;
    return check_equal("steps", static_cast<double>(p.steps.size()), static_cast<double>(rows));
}

Refusal check_steps(std::span<const std::int64_t> steps) noexcept {
    double last = 0;
    for (std::size_t row = 0; row < steps.size(); ++row) {
        const auto value = static_cast<double>(steps[row]);
        Refusal refusal{.name = "steps", .value = value, .row = row};
        if (value < 0) {
            refusal.reason = Refusal::Reason::whole;
            refusal.most = limit;
        } else if (steps[row] > static_cast<std::int64_t>(limit)) {
            refusal.reason = Refusal::Reason::too_many_steps;
        } else if (value < last) {
            refusal.reason = Refusal::Reason::decreasing;
            refusal.least = last;
        }
        if (refusal) return refusal;
        last = value;
    }
    return {};
}

Refusal check(const Program& p, std::size_t stages, std::size_t rows) noexcept {
    if (const auto refusal = check_lengths(p, stages, rows)) return refusal;
    if (static_cast<unsigned>(p.force) >= std::size(force_names))
        return {.reason = Refusal::Reason::not_among, .name = "force", .legal = "sine, cosine, linear, cubic, quintic"};
    return check_steps(p.steps);
}

/// Stores a program at place i of a chunk.
void put_program(ReplayChunk& c, int i, const Program& p) noexcept {
    const auto put = [&](kernels::ReplayRow& row, double x) { row[i] = p.is_single ? static_cast<float>(x) : x; };
    put(c.theta, p.initial.theta);
    put(c.omega, p.initial.omega);
    Pendulum pendulum = p.pendulum;
    // If another lane has a drive, the cosine is computed in this lane too, and must be finite.
    if (is_driven(pendulum))
        c.is_driven = true;
    else
        pendulum.drive_frequency = pendulum.drive_phase = 0;
    put(c.parameters.alpha, pendulum.alpha);
    put(c.parameters.beta, pendulum.beta);
    put(c.parameters.torque, pendulum.torque);
    put(c.parameters.drive_amplitude, pendulum.drive_amplitude);
    put(c.parameters.pivot_amplitude, pendulum.pivot_amplitude);
    put(c.parameters.drive_frequency, pendulum.drive_frequency);
    put(c.parameters.drive_phase, pendulum.drive_phase);
    put(c.scale, p.scale);
    put(c.dt, p.dt);
    for (std::size_t k = 0; k < p.coefficients.size(); ++k) put(c.coefficients[k], p.coefficients[k]);
    for (std::size_t k = 0; k < p.sums.size(); ++k) put(c.sums[k], p.sums[k]);
    c.stages = p.stages;
    c.force[i] = static_cast<double>(p.force);
    c.has_sine |= p.force == Force::sine || p.force == Force::cosine;
    c.has_polynomial |= p.force == Force::cubic || p.force == Force::quintic;
}

std::int64_t last_step(const Program& p) noexcept { return p.steps.empty() ? 0 : p.steps.back(); }

/// The numbers of the programs, those with floats last and the shorter ones first. Null if memory could not be allocated.
std::unique_ptr<std::size_t[]> order_of(std::span<const Program> programs) noexcept {
    std::unique_ptr<std::size_t[]> order(new (std::nothrow) std::size_t[programs.size()]);
    if (!order) return order;
    for (std::size_t i = 0; i < programs.size(); ++i) order[i] = i;
    std::sort(order.get(), order.get() + programs.size(), [&](std::size_t a, std::size_t b) {
        if (programs[a].is_single != programs[b].is_single) return programs[b].is_single;
        const std::int64_t of_a = last_step(programs[a]), of_b = last_step(programs[b]);
        return of_a != of_b ? of_a < of_b : a < b;
    });
    return order;
}

/// The programs of a call in the order in which chunks take them. A chunk has programs with doubles or programs with floats.
struct Order {
    std::span<const Program> programs;
    std::unique_ptr<std::size_t[]> numbers;
    std::size_t doubles = 0;  ///< how many programs compute with doubles

    explicit Order(std::span<const Program> all) noexcept : programs(all), numbers(order_of(all)) {
        for (const Program& p : all) doubles += !p.is_single;
    }

    static std::size_t chunks_of(std::size_t count) noexcept { return (count + replay_size - 1) / replay_size; }
    std::size_t chunks() const noexcept { return chunks_of(doubles) + chunks_of(programs.size() - doubles); }

    /// The numbers of the programs of a chunk.
    std::span<const std::size_t> of_chunk(std::size_t chunk) const noexcept {
        const std::size_t of_doubles = chunks_of(doubles);
        const bool is_single = chunk >= of_doubles;
        const std::size_t first = is_single ? doubles + (chunk - of_doubles) * replay_size : chunk * replay_size;
        const std::size_t left = (is_single ? programs.size() : doubles) - first;
        return {numbers.get() + first, std::min<std::size_t>(left, replay_size)};
    }

    /// The number of steps of a chunk.
    double steps(std::size_t chunk) const noexcept { return static_cast<double>(last_step(programs[of_chunk(chunk).back()])); }
};

/// The programs of one chunk on their way from row to row.
struct Replaying {
    static constexpr std::int64_t never = std::numeric_limits<std::int64_t>::max();

    const Order& order;
    const ReplayRows& rows;
    std::span<const std::size_t> numbers;
    ReplayChunk chunk{};
    std::size_t row[replay_size] = {};  ///< the next row of each program

    Replaying(const Order& all, const ReplayRows& to, std::size_t number) noexcept
        : order(all), rows(to), numbers(all.of_chunk(number)) {
        for (int i = 0; i < replay_size; ++i) chunk.theta[i] = chunk.omega[i] = __builtin_nan("");
        for (std::size_t i = 0; i < numbers.size(); ++i) put_program(chunk, static_cast<int>(i), order.programs[numbers[i]]);
    }

    /// Writes the rows of program i that are due after `done` steps. Returns the number of steps of its next row.
    std::int64_t put_rows(std::size_t i, std::int64_t done) noexcept {
        const auto& steps = order.programs[numbers[i]].steps;
        double &theta = chunk.theta[i], &omega = chunk.omega[i];
        const bool is_finite = theta - theta == 0 && omega - omega == 0;
        if (!is_finite) theta = omega = __builtin_nan("");
        for (; row[i] < steps.size() && (!is_finite || steps[row[i]] == done); ++row[i]) {
            const std::size_t at = numbers[i] * steps.size() + row[i];
            rows.theta[at] = theta;
            rows.omega[at] = omega;
        }
        if (row[i] < steps.size()) return steps[row[i]];
        theta = omega = __builtin_nan("");  // costs no time; a large angle would
        return never;
    }

    std::int64_t put_rows(std::int64_t done) noexcept {
        std::int64_t next = never;
        for (std::size_t i = 0; i < numbers.size(); ++i) next = std::min(next, put_rows(i, done));
        return next;
    }

    void run(Thread& thread) noexcept {
        constexpr std::int64_t block = 1 << 10;  // steps or rows between two checks for cancellation: below a millisecond
        const bool is_single = order.programs[numbers[0]].is_single;
        const auto advance = is_single ? kernels::dispatch().replay_single : kernels::dispatch().replay;
        std::int64_t unchecked = 0;
        for (std::int64_t done = 0, next; (next = put_rows(done)) != never;) {
            const std::int64_t steps = std::min(next - done, block);
            advance(chunk, static_cast<double>(done), static_cast<int>(steps));
            done += steps;
            thread.report(static_cast<double>(steps));
            unchecked += steps;
            if (unchecked < block) continue;
            if (!thread.goes_on()) return;
            unchecked = 0;
        }
    }
};

}  // namespace

Outcome replay(std::span<const Program> programs, const ReplayRows& rows, const Control& control) noexcept {
    if (const auto refusal = check_call({}, control)) return refusal;
    if (programs.empty()) return {};
    const std::size_t count = programs[0].steps.size();
    for (std::size_t i = 0; i < programs.size(); ++i) {
        Refusal refusal = check(programs[i], programs[0].stages, count);
        if (!refusal) continue;
        refusal.member = i;
        return refusal;
    }
    const double values = static_cast<double>(programs.size()) * static_cast<double>(count);
    if (const auto refusal = check_length(rows.theta, values, "theta")) return refusal;
    if (const auto refusal = check_length(rows.omega, values, "omega")) return refusal;
    const Order order(programs);
    if (!order.numbers) return Refusal{.reason = Refusal::Reason::memory, .name = "programs"};
    double steps = 0;
    for (std::size_t i = 0; i < order.chunks(); ++i) steps += order.steps(i);
    constexpr double few = 1 << 12;  // take a millisecond, which is what waiting for another thread may take
    return for_each_piece(order.chunks(), steps, {steps < few ? 1 : control.threads, control.proceed},
                          [&](Thread& thread, std::size_t chunk) { Replaying(order, rows, chunk).run(thread); });
}

}  // namespace pendula
