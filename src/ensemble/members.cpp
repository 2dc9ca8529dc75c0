#include "ensemble/members.hpp"

#include "checks.hpp"
#include "kernels/packs.hpp"
#include "pendula/analysis.hpp"
#include "pendula/angle.hpp"
#include "pendula/exact.hpp"
#include "pendula/version.hpp"
#include "trajectory/scalar.hpp"

namespace pendula {

using kernels::Chunk;
using kernels::chunk_size;

namespace {

/// Stores a legal member at place i of a chunk.
void put_member(Chunk& c, int i, const Pendulum& p, State initial) noexcept {
    c.is_resting[i] = rests_on_top(p, initial);
    auto angle = split_turns(initial.theta);
    if (c.is_resting[i]) {
        const Sample rest = at(make_exact(p.alpha, initial), 0);
        angle = {rest.theta, rest.turns};
    }
    c.resting_theta[i] = angle.theta;
    c.resting_turns[i] = angle.turns;
    kernels::store<double, kernels::Motion>(c.motion, i, {angle.theta, initial.omega, angle.turns, 0, 0});
    kernels::store<double, kernels::Tangent>(c.tangent, i, {1, 0});
    auto parameters = parameters_of(p);
    // If another lane has a drive, the cosine is computed in this lane too: a large frequency times the time could overflow.
    if (!is_driven(p)) parameters.drive_frequency = 0;
    kernels::store<double, kernels::Parameters>(c.parameters, i, parameters);
}

}  // namespace

void load_members(Members& members, const Ensemble& ensemble, std::size_t first, const std::size_t* order) noexcept {
    const std::size_t left = ensemble.size - first;
    members.chunk.count = left < chunk_size ? static_cast<int>(left) : chunk_size;
    for (int i = 0; i < chunk_size; ++i) {
        if (i >= members.chunk.count) {
            put_member(members.chunk, i, {}, {});
            continue;
        }
        const std::size_t place = first + static_cast<std::size_t>(i);
        const std::size_t number = members.number[i] = order ? order[place] : place;
        put_member(members.chunk, i, pendulum_of(ensemble, number), initial_state_of(ensemble, number));
    }
}

void restore_resting(Chunk& c) noexcept {
    for (int i = 0; i < c.count; ++i)
        if (c.is_resting[i])
            kernels::store<double, kernels::Motion>(c.motion, i, {c.resting_theta[i], 0, c.resting_turns[i], 0, 0});
}

void copy_motion(const Chunk& from, int i, Chunk& to, int j) noexcept {
    kernels::store<double, kernels::Motion>(to.motion, j, kernels::load<double, kernels::Motion>(from.motion, i));
    kernels::store<double, kernels::Tangent>(to.tangent, j, kernels::load<double, kernels::Tangent>(from.tangent, i));
}

bool taylor_to(Chunk& chunk, kernels::TaylorChunk& steps, const kernels::Row& t, bool has_tangent, Thread& thread) noexcept {
    constexpr int most = 64;  // steps between two checks for cancellation
    const auto advance = has_tangent ? kernels::dispatch().taylor_tangent : kernels::dispatch().taylor;
    do {
        if (!thread.goes_on()) return false;
    } while (!advance(chunk, steps, t, most));
    return true;
}

Refusal check_call(const Ensemble& ensemble, const Control& control) noexcept {
    if (!instruction_set()) return {.reason = Refusal::Reason::instruction_set, .name = "PENDULA_ISA"};
    if (const auto refusal = check(control)) return refusal;
    return check_columns(ensemble);
}

Refusal check_length(std::span<const double> values, double least, const char* name) noexcept {
    const auto length = static_cast<double>(values.size());
    if (length >= least && (values.data() || least == 0)) return {};
    return {.reason = Refusal::Reason::length, .name = name, .value = values.data() ? length : 0, .least = least};
}

}  // namespace pendula
