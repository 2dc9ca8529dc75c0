// The one table of parameters: every face (program, package, browser) and every check reads it.
#pragma once

#include <concepts>
#include <cstddef>
#include <span>

#include "pendula/pendulum.hpp"

namespace pendula {

/// The intervals that arguments lie in.
enum class Rule {
    finite,        ///< any finite number
    positive,      ///< finite and > 0
    not_negative,  ///< finite and >= 0
    fraction,      ///< in (0, 1)
};

constexpr bool satisfies(Rule rule, double x) noexcept {
    if (!(x - x == 0)) return false;
    return rule == Rule::finite || (rule == Rule::not_negative ? x >= 0 : x > 0 && (rule == Rule::positive || x < 1));
}

/// The values of one parameter for all members of an ensemble: one number for all, or one each. Does not own what it points to.
class Column {
  public:
    constexpr Column(double of_all) noexcept : of_all_(of_all) {}
    constexpr Column(std::span<const double> of_each) noexcept : of_each_(of_each), is_span_(true) {}
    template <class Range>
        requires std::convertible_to<const Range&, std::span<const double>>
    constexpr Column(const Range& of_each) noexcept : Column(std::span<const double>(of_each)) {}

    constexpr double operator[](std::size_t member) const noexcept {
        return is_span_ ? of_each_[of_each_.size() == 1 ? 0 : member] : of_all_;
    }
    /// Whether it has a value for each of `size` members: a number, one element, or `size` of them.
    constexpr bool fits(std::size_t size) const noexcept {
        return !is_span_ || size == 0 || (of_each_.data() && (of_each_.size() == 1 || of_each_.size() == size));
    }
    constexpr std::size_t length() const noexcept { return !is_span_ ? 1 : of_each_.data() ? of_each_.size() : 0; }

  private:
    double of_all_ = 0;
    std::span<const double> of_each_;
    bool is_span_ = false;
};

/// Pendulums and their initial states. Symbols, units and intervals are those of `Pendulum` and `State`.
struct Ensemble {
    std::size_t size = 0;  ///< members
    Column theta = 0.0, omega = 0.0;
    Column alpha = 1.0, beta = 0.0, torque = 0.0, drive_amplitude = 0.0, pivot_amplitude = 0.0, drive_frequency = 0.0,
           drive_phase = 0.0;
};

/// A text in the two languages that pendula speaks.
struct Words {
    const char* en;
    const char* es;
};

/// What there is to know of a parameter, or of an initial value. It lives in a Pendulum or in a State; the other pointer is null.
struct Parameter {
    const char* name;     ///< in C++, Python and tables; the program's option is the same with hyphens
    const char* symbol;   ///< as formulas have it
    const char* unit;     ///< SI, as people print it
    Words meaning;        ///< a few words
    double otherwise;     ///< where it is not given
    Rule rule;            ///< its interval; see also `rule_of`
    bool is_angle;        ///< may be typed in degrees (or degrees per second)
    double State::* initial;
    double Pendulum::* value;
    Column Ensemble::* column;
};

/// In the order in which every face lists them.
inline constexpr Parameter parameters[] = {
    {"theta0", "θ0", "rad", {"initial angle", "ángulo inicial"}, 0, Rule::finite, true,
     &State::theta, nullptr, &Ensemble::theta},
    {"omega0", "ω0", "rad/s", {"initial angular velocity", "velocidad angular inicial"}, 0, Rule::finite, true,
     &State::omega, nullptr, &Ensemble::omega},
    {"alpha", "α", "s⁻²", {"stiffness g/l", "rigidez g/l"}, 1, Rule::positive, false,
     nullptr, &Pendulum::alpha, &Ensemble::alpha},
    {"beta", "β", "s⁻¹", {"damping", "rozamiento"}, 0, Rule::not_negative, false,
     nullptr, &Pendulum::beta, &Ensemble::beta},
    {"torque", "μ", "s⁻²", {"constant torque", "par constante"}, 0, Rule::finite, false,
     nullptr, &Pendulum::torque, &Ensemble::torque},
    {"drive_amplitude", "Γ", "s⁻²", {"amplitude of the drive", "amplitud del forzamiento"}, 0, Rule::finite, false,
     nullptr, &Pendulum::drive_amplitude, &Ensemble::drive_amplitude},
    {"pivot_amplitude", "P", "s⁻²", {"amplitude of the shaken pivot's acceleration over l", "amplitud de la aceleración del pivote entre l"},
     0, Rule::finite, false, nullptr, &Pendulum::pivot_amplitude, &Ensemble::pivot_amplitude},
    {"drive_frequency", "Ω", "rad/s", {"angular frequency of drive and pivot", "frecuencia angular del forzamiento y del pivote"},
     0, Rule::not_negative, false, nullptr, &Pendulum::drive_frequency, &Ensemble::drive_frequency},
    {"drive_phase", "φ", "rad", {"phase of drive and pivot at t = 0", "fase del forzamiento y del pivote en t = 0"}, 0, Rule::finite, true,
     nullptr, &Pendulum::drive_phase, &Ensemble::drive_phase},
};
inline constexpr std::size_t parameter_count = std::size(parameters);

/// The value of a parameter of a pendulum that starts from a state.
constexpr double& value_of(const Parameter& parameter, Pendulum& pendulum, State& initial) noexcept {
    return parameter.value ? pendulum.*parameter.value : initial.*parameter.initial;
}

/// The interval of a parameter of this pendulum: its own, but a driven pendulum needs a frequency.
constexpr Rule rule_of(const Parameter& parameter, const Pendulum& pendulum) noexcept {
    return parameter.value == &Pendulum::drive_frequency && is_driven(pendulum) ? Rule::positive : parameter.rule;
}

/// A member of an ensemble.
Pendulum pendulum_of(const Ensemble& ensemble, std::size_t member) noexcept;
State initial_state_of(const Ensemble& ensemble, std::size_t member) noexcept;

/// Why a call was refused: plain values, which `describe` (validate.hpp) puts into words.
struct Refusal {
    enum class Reason {
        none,              ///< nothing is wrong
        interval,          ///< `value` of `name` is outside `rule`
        whole,             ///< `value` of `name` is no whole number from `least` to `most`
        length,            ///< `name` has `value` elements, or is null; it needs `least`
        not_among,         ///< `name` is none of the words in `legal`
        not_conservative,  ///< method `name` needs a pendulum without friction and forcing
        has_friction,      ///< method `name` needs a pendulum without friction
        unstable,          ///< `name` is `value`; with fewer steps than `least` the method is unstable
        too_many_rows,     ///< `value` rows are more than 2^53
        too_many_steps,    ///< `value` steps are more than 2^53
        too_many_terms,    ///< the series needs `value` terms, more than `most`
        too_late,          ///< the closed form is not carried to t = `value`, only to `most`
        instruction_set,   ///< PENDULA_ISA names no instruction set of this processor
        memory,            ///< there is not enough memory
    };
    Reason reason = Reason::none;
    const char* name = "";  ///< of the argument, as the headers spell it
    double value = 0;
    double least = 0;
    double most = 0;
    Rule rule = Rule::finite;
    const char* legal = "";          ///< words that would be legal
    std::size_t member = no_member;  ///< of the ensemble whose member it is

    static constexpr std::size_t no_member = static_cast<std::size_t>(-1);
    constexpr explicit operator bool() const noexcept { return reason != Reason::none; }
};

/// The first parameter that is not legal, and why.
Refusal check(const Pendulum& pendulum) noexcept;
Refusal check(const Pendulum& pendulum, State initial) noexcept;
/// The first column whose length does not fit, or the first member that is not legal.
Refusal check(const Ensemble& ensemble) noexcept;

}  // namespace pendula
