// The table of parameters. Every interface (program, Python package, browser) and every check reads it.
#pragma once

#include <concepts>
#include <cstddef>
#include <span>

#include "pendula/pendulum.hpp"

namespace pendula {

/// The legal intervals of arguments.
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

/// The values of one parameter for the members of an ensemble: one number for all members, or one number for each. A column
/// refers to the values of a span and does not own them.
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
    /// Whether there is a value for each of `size` members: a number, a span of one element, or a span of `size` elements.
    constexpr bool fits(std::size_t size) const noexcept {
        return !is_span_ || size == 0 || (of_each_.data() && (of_each_.size() == 1 || of_each_.size() == size));
    }
    constexpr std::size_t length() const noexcept { return !is_span_ ? 1 : of_each_.data() ? of_each_.size() : 0; }

  private:
    double of_all_ = 0;
    std::span<const double> of_each_;
    bool is_span_ = false;
};

/// Pendulums and their initial states, one value or column for each parameter. Symbols, units and intervals are those of
/// `Pendulum` and `State`.
struct Ensemble {
    std::size_t size = 0;  ///< number of members
    Column theta = 0.0, omega = 0.0;
    Column alpha = 1.0, beta = 0.0, torque = 0.0, drive_amplitude = 0.0, pivot_amplitude = 0.0, drive_frequency = 0.0,
           drive_phase = 0.0;
};

/// A text in English and in Spanish.
struct Words {
    const char* en;
    const char* es;
};

/// The properties of a parameter or of an initial value. The first is a member of Pendulum, the second of State; the other of
/// the two pointers is null.
struct Parameter {
    const char* name;    ///< in C++, Python and tables; the option of the program has hyphens for underscores
    const char* symbol;  ///< as in formulas
    const char* unit;    ///< SI, as printed
    Words meaning;       ///< a short description
    double otherwise;    ///< the default
    Rule rule;           ///< its legal interval; see also `rule_of`
    bool is_angle;       ///< may be typed in degrees (or degrees per second)
    double State::* initial;
    double Pendulum::* value;
    Column Ensemble::* column;
};

/// In the order in which every interface lists them.
inline constexpr Parameter parameters[] = {
    {"theta0",
     "θ0",
     "rad",
     {"initial angle", "ángulo inicial"},
     0,
     Rule::finite,
     true,
     &State::theta,
     nullptr,
     &Ensemble::theta},
    {"omega0",
     "ω0",
     "rad/s",
     {"initial angular velocity", "velocidad angular inicial"},
     0,
     Rule::finite,
     true,
     &State::omega,
     nullptr,
     &Ensemble::omega},
    {"alpha",
     "α",
     "s⁻²",
     {"stiffness g/l", "rigidez g/l"},
     1,
     Rule::positive,
     false,
     nullptr,
     &Pendulum::alpha,
     &Ensemble::alpha},
    {"beta", "β", "s⁻¹", {"damping", "rozamiento"}, 0, Rule::not_negative, false, nullptr, &Pendulum::beta, &Ensemble::beta},
    {"torque",
     "μ",
     "s⁻²",
     {"constant torque", "par constante"},
     0,
     Rule::finite,
     false,
     nullptr,
     &Pendulum::torque,
     &Ensemble::torque},
    {"drive_amplitude",
     "Γ",
     "s⁻²",
     {"amplitude of the drive", "amplitud del forzamiento"},
     0,
     Rule::finite,
     false,
     nullptr,
     &Pendulum::drive_amplitude,
     &Ensemble::drive_amplitude},
    {"pivot_amplitude",
     "P",
     "s⁻²",
     {"amplitude of the shaken pivot's acceleration over l", "amplitud de la aceleración del pivote entre l"},
     0,
     Rule::finite,
     false,
     nullptr,
     &Pendulum::pivot_amplitude,
     &Ensemble::pivot_amplitude},
    {"drive_frequency",
     "Ω",
     "rad/s",
     {"angular frequency of drive and pivot", "frecuencia angular del forzamiento y del pivote"},
     0,
     Rule::not_negative,
     false,
     nullptr,
     &Pendulum::drive_frequency,
     &Ensemble::drive_frequency},
    {"drive_phase",
     "φ",
     "rad",
     {"phase of drive and pivot at t = 0", "fase del forzamiento y del pivote en t = 0"},
     0,
     Rule::finite,
     true,
     nullptr,
     &Pendulum::drive_phase,
     &Ensemble::drive_phase},
};
inline constexpr std::size_t parameter_count = std::size(parameters);

/// The value of a parameter of a pendulum that starts from a state.
constexpr double& value_of(const Parameter& parameter, Pendulum& pendulum, State& initial) noexcept {
    return parameter.value ? pendulum.*parameter.value : initial.*parameter.initial;
}

/// The legal interval of a parameter of this pendulum: that of the table, but drive_frequency must be positive if there is a
/// drive or a shaken pivot.
constexpr Rule rule_of(const Parameter& parameter, const Pendulum& pendulum) noexcept {
    return parameter.value == &Pendulum::drive_frequency && is_driven(pendulum) ? Rule::positive : parameter.rule;
}

/// The parameters and the initial state of a member.
Pendulum pendulum_of(const Ensemble& ensemble, std::size_t member) noexcept;
State initial_state_of(const Ensemble& ensemble, std::size_t member) noexcept;

/// Why a call was refused. `describe` (validate.hpp) turns it into a sentence.
struct Refusal {
    enum class Reason {
        none,              ///< the call was not refused
        interval,          ///< `value` of `name` is outside `rule`
        needs_frequency,   ///< the same, where a drive or a shaken pivot needs a frequency
        whole,             ///< `value` of `name` is not a whole number from `least` to `most`
        length,            ///< `name` has `value` elements, or is null; it needs at least `least`
        decreasing,        ///< `name` is `value`, which is less than `least`, the one before it
        not_among,         ///< `name` is not one of the words in `legal`
        not_conservative,  ///< method `name` needs a pendulum without friction and forcing
        has_friction,      ///< method `name` needs a pendulum without friction
        unstable,          ///< `name` is `value`; the method is unstable with fewer than `least` steps
        too_many_rows,     ///< there would be `value` rows, more than 2^53
        too_many_steps,    ///< there would be `value` steps, more than 2^53
        too_many_terms,    ///< the series needs `value` terms, more than `most`
        too_late,          ///< the closed form is accurate up to t = `most`, not at t = `value`
        instruction_set,   ///< PENDULA_ISA is not the name of an instruction set of this processor
        memory,            ///< memory could not be allocated
    };
    Reason reason = Reason::none;
    const char* name = "";  ///< the argument, as spelled in the headers
    double value = 0;
    double least = 0;
    double most = 0;
    Rule rule = Rule::finite;
    const char* legal = "";          ///< the legal words
    std::size_t member = no_member;  ///< number of the member that was refused, in an ensemble
    std::size_t row = no_member;     ///< number of the time that was refused, among given times

    static constexpr std::size_t no_member = static_cast<std::size_t>(-1);
    constexpr explicit operator bool() const noexcept { return reason != Reason::none; }
};

/// The first parameter that is outside its interval, or no refusal.
Refusal check(const Pendulum& pendulum) noexcept;
Refusal check(const Pendulum& pendulum, State initial) noexcept;
/// The first column whose length does not fit, or else the first member with a parameter outside its interval, or no refusal.
Refusal check(const Ensemble& ensemble) noexcept;

}  // namespace pendula
