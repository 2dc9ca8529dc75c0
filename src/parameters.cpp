#include "pendula/parameters.hpp"

#include "checks.hpp"

namespace pendula {

Pendulum pendulum_of(const Ensemble& ensemble, std::size_t member) noexcept {
    Pendulum pendulum;
    for (const auto& parameter : parameters)
        if (parameter.value) pendulum.*parameter.value = (ensemble.*parameter.column)[member];
    return pendulum;
}

State initial_state_of(const Ensemble& ensemble, std::size_t member) noexcept {
    return {ensemble.theta[member], ensemble.omega[member]};
}

Refusal check(const Pendulum& pendulum) noexcept { return check(pendulum, State{}); }

Refusal check(const Pendulum& pendulum, State initial) noexcept {
    Pendulum p = pendulum;
    State s = initial;
    for (const auto& parameter : parameters) {
        const Rule rule = rule_of(parameter, pendulum);
        Refusal refusal = check_rule(parameter.name, value_of(parameter, p, s), rule);
        if (!refusal) continue;
        if (rule != parameter.rule) refusal.reason = Refusal::Reason::needs_frequency;
        return refusal;
    }
    return {};
}

Refusal check_columns(const Ensemble& ensemble) noexcept {
    for (const auto& parameter : parameters) {
        const Column& column = ensemble.*parameter.column;
        if (!column.fits(ensemble.size))
            return {.reason = Refusal::Reason::length,
                    .name = parameter.name,
                    .value = static_cast<double>(column.length()),
                    .least = static_cast<double>(ensemble.size)};
    }
    return {};
}

Refusal check(const Ensemble& ensemble) noexcept {
    if (const auto refusal = check_columns(ensemble)) return refusal;
    return check_each(ensemble, [](std::size_t, const Pendulum&) { return Refusal{}; });
}

}  // namespace pendula
