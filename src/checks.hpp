// Parts of the checks that several calls make.
#pragma once

#include "pendula/solve.hpp"

namespace pendula {

/// Whether a count is a whole number from `least` to `most`.
constexpr Refusal check_count(const char* name, double x, double least, double most = 0x1p53) noexcept {
    if (x >= least && x <= most && x == static_cast<double>(static_cast<long long>(x))) return {};
    return {.reason = Refusal::Reason::whole, .name = name, .value = x, .least = least, .most = most};
}

/// Whether a number lies in an interval.
constexpr Refusal check_rule(const char* name, double x, Rule rule) noexcept {
    if (satisfies(rule, x)) return {};
    return {.reason = Refusal::Reason::interval, .name = name, .value = x, .rule = rule};
}

/// The first column whose length does not fit.
Refusal check_columns(const Ensemble& ensemble) noexcept;

/// The first member that is not legal, or that `more` refuses.
template <class More>
Refusal check_each(const Ensemble& ensemble, const More& more) noexcept {
    for (std::size_t member = 0; member < ensemble.size; ++member) {
        const auto pendulum = pendulum_of(ensemble, member);
        const auto initial = initial_state_of(ensemble, member);
        Refusal refusal = check(pendulum, initial);
        if (!refusal) refusal = more(member, pendulum);
        if (!refusal) continue;
        refusal.member = member;
        return refusal;
    }
    return {};
}

/// Whether a pendulum can be solved by the method.
Refusal check(const Pendulum& pendulum, Method method, double tolerance) noexcept;

/// Whether equal steps over a length of time [s] are short enough for friction: beta h <= 2 by euler, beta h <= 2.78 by rk4 (the
/// bounds of their stability regions on the negative axis; Hairer & Wanner II, IV.2). `name`: of the argument that counts them.
Refusal check_stability(const Pendulum& pendulum, Method method, double length, double steps, const char* name) noexcept;

}  // namespace pendula
