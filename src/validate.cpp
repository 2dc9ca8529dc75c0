#include "pendula/validate.hpp"

#include <charconv>
#include <cmath>
#include <stdexcept>

namespace pendula {

namespace {

const char* legal(Rule rule) {
    switch (rule) {
        case Rule::finite:
            return "finite";
        case Rule::positive:
            return "positive and finite";
        case Rule::not_negative:
            return "finite and not negative";
        case Rule::fraction:
            return "between 0 and 1, both excluded";
    }
    return "";
}

std::string shortest(double value) {
    char digits[32];
    return {digits, std::to_chars(digits, digits + sizeof digits, value).ptr};
}

void require_whole(const std::string& name, double value, double least) {
    if (!(value >= least && value <= 0x1p53 && value == std::floor(value)))
        throw std::invalid_argument(name + " must be a whole number from " + shortest(least) + " to 2^53, got " +
                                    shortest(value));
}

}  // namespace

bool satisfies(Rule rule, double value) noexcept {
    if (!std::isfinite(value)) return false;
    switch (rule) {
        case Rule::finite:
            return true;
        case Rule::positive:
            return value > 0;
        case Rule::not_negative:
            return value >= 0;
        case Rule::fraction:
            return value > 0 && value < 1;
    }
    return false;
}

std::string complaint(const std::string& name, double value, Rule rule) {
    return name + " must be " + legal(rule) + ", got " + shortest(value);
}

void require(const std::string& name, double value, Rule rule) {
    if (!satisfies(rule, value)) throw std::invalid_argument(complaint(name, value, rule));
}

void validate(const Pendulum& pendulum) {
    require("alpha", pendulum.alpha, Rule::positive);
    require("beta", pendulum.beta, Rule::not_negative);
    require("torque", pendulum.torque, Rule::finite);
    require("drive_amplitude", pendulum.drive_amplitude, Rule::finite);
    require("drive_frequency", pendulum.drive_frequency, pendulum.drive_amplitude == 0 ? Rule::not_negative : Rule::positive);
    require("drive_phase", pendulum.drive_phase, Rule::finite);
}

void validate(const Problem& problem) {
    validate(problem.pendulum);
    require("theta0", problem.initial.theta, Rule::finite);
    require("omega0", problem.initial.omega, Rule::finite);
    require("tolerance", problem.tolerance, Rule::fraction);
    const Schedule& schedule = problem.schedule;
    require("every", schedule.every, Rule::positive);
    require("step", schedule.step, Rule::positive);
    require("rows", schedule.rows, Rule::positive);
    require("steps_per_row", schedule.steps_per_row, Rule::positive);
    if (!schedule.is_feasible())
        throw std::invalid_argument("a run must have at most 2^53 rows and steps, got " + shortest(schedule.rows) +
                                    " rows and " + shortest(schedule.steps()) + " steps");
    if (problem.method == Method::exact && !is_conservative(problem.pendulum))
        throw std::invalid_argument("method exact needs beta, torque and drive_amplitude to be 0");
    if (problem.method == Method::verlet && problem.pendulum.beta != 0)
        throw std::invalid_argument("method verlet needs beta to be 0, got " + shortest(problem.pendulum.beta));
}

void validate(const Pendulum& pendulum, const Strobe& strobe) {
    validate(pendulum);
    require_whole("transient", strobe.transient, 0);
    require_whole("periods", strobe.periods, 1);
    require_whole("steps_per_period", strobe.steps_per_period, 1);
    require("tolerance", strobe.tolerance, Rule::fraction);
    if (strobe.method != Method::rk4 && strobe.method != Method::taylor)
        throw std::invalid_argument("method must be rk4 or taylor to measure");
    const double fewest = fewest_steps(pendulum);
    if (strobe.method == Method::rk4 && !(strobe.steps_per_period >= fewest))
        throw std::invalid_argument("steps_per_period must be at least " + shortest(fewest) + " for rk4 to be stable, got " +
                                    shortest(strobe.steps_per_period));
    const double steps =
        (strobe.transient + strobe.periods) * (strobe.method == Method::rk4 ? strobe.steps_per_period : fewest);
    if (steps > 0x1p53) throw std::invalid_argument("a measure must take at most 2^53 steps, got " + shortest(steps));
}

}  // namespace pendula
