// Checks that several calls share. Each returns a refusal, which is empty if the argument is legal.
#pragma once

#include "pendula/solve.hpp"

namespace pendula {

/// Refuses a count that is not a whole number from `least` to `most`.
constexpr Refusal check_count(const char* name, double x, double least, double most = 0x1p53) noexcept {
    if (x >= least && x <= most && x == static_cast<double>(static_cast<long long>(x))) return {};
    return {.reason = Refusal::Reason::whole, .name = name, .value = x, .least = least, .most = most};
}

/// Refuses a number outside the interval of the rule.
constexpr Refusal check_rule(const char* name, double x, Rule rule) noexcept {
    if (satisfies(rule, x)) return {};
    return {.reason = Refusal::Reason::interval, .name = name, .value = x, .rule = rule};
}

/// Refuses the first column whose length is not that of the ensemble.
Refusal check_columns(const Ensemble& ensemble) noexcept;

/// Refuses the first member with an illegal parameter, or that the function `more` refuses.
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

/// Refuses a method that cannot solve the pendulum, and an illegal tolerance.
Refusal check(const Pendulum& pendulum, Method method, double tolerance) noexcept;

/// Refuses given times of rows that are not as many as `rows`, negative, not finite, or decreasing.
Refusal check_times(std::span<const double> times, double rows) noexcept;

/// Refuses what `check(problem)` refuses, without a look at each of the given times, which members of an ensemble share.
Refusal check_but_times(const Problem& problem) noexcept;

/// Refuses steps that are too long for the friction: equal steps over a length of time [s] with beta h > 2 for euler or beta h
/// > 2.78 for rk4, the bounds of their stability regions on the negative real axis (Hairer & Wanner II, IV.2). `name` is the
/// argument that gives the number of steps.
Refusal check_stability(const Pendulum& pendulum, Method method, double length, double steps, const char* name) noexcept;

}  // namespace pendula
