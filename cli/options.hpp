// What stands on the command line. Every value stays text until the command that takes it reads it.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "cli/messages.hpp"
#include "cli/numbers.hpp"
#include "cli/rows.hpp"
#include "pendula/measure.hpp"

namespace pendula::cli {

/// What the program is asked to do; a bit each, so that an option can say which commands take it.
enum Command : unsigned {
    solve_input_command = 1,
    solve_command = 2,
    analyze_command = 4,
    first_measure_command = 8,  ///< that of measures[0]; those of the others follow
};
constexpr Command command_of(const MeasureInfo& info) {
    return static_cast<Command>(first_measure_command << static_cast<unsigned>(info.measure));
}

/// The measure of a command, where it is one.
const MeasureInfo* measure_of(Command command);
/// The command of this name, and all names.
std::optional<Command> command_named(std::string_view name);
std::vector<std::string> command_names();

/// The commands of a mask, as they are typed: "pendula, pendula solve".
std::string typed_commands(unsigned mask, const std::string& lead = "pendula ");

/// "mean-velocity" of mean_velocity, and "--drive-amplitude" of drive_amplitude; "--steps" of steps_per_period.
std::string hyphenated(std::string_view name);
std::string option_of(std::string_view name);

/// What stands behind an angle in degrees: "deg" for rad, "deg/s" for rad/s.
std::string degrees_of(std::string_view unit);

/// What a range may be given for: the parameters of the table; gravity and length, which make alpha; and tau, the period, which
/// makes theta0. Those three have no place in a pendulum.
inline constexpr std::size_t swept_count = parameter_count + 3;
const Parameter& swept_parameter(std::size_t i);

struct Option {
    std::string name;
    unsigned commands;  ///< that take it
    std::string value;  ///< what stands behind it, in the manual; empty where nothing does
    Words meaning;
    std::string otherwise = {};
};

/// All options, those of parameters first.
const std::vector<Option>& known_options();
/// The option of this name, or null.
const Option* find_option(std::string_view name);

/// The options given, in their order.
struct Options {
    struct Given {
        std::string name;
        std::string_view text;
    };
    std::vector<Given> given;
    bool wants_help = false, wants_version = false;
};

/// Cuts the arguments behind the command apart. This and all below throw Failure with Status::bad_usage.
Options parse(Command command, std::span<const std::string_view> arguments);

bool is_given(const Options& options, std::string_view name);
/// What was given, empty where nothing was.
std::string_view text_of(const Options& options, std::string_view name);
[[noreturn]] void refuse_value(const Options& options, std::string_view name, std::string_view wrong);
void refuse_both(const Options& options, std::string_view one, std::string_view other);
/// A number that satisfies the rule, or else what stands for one that is not given.
double number_of(const Options& options, std::string_view name, Rule rule, double otherwise);
/// An angle [rad] or angular velocity [rad/s], with what is remarked on it.
double angle_of(const Options& options, std::string_view name, std::string_view unit, double otherwise);
/// Whether an angle was typed in radians and hardly meant so: a whole number beyond one turn, up to 3600.
bool looks_like_degrees(const Parsed& angle);
/// Then says on standard error how far it goes and how degrees are typed.
void remark_on_degrees(std::string_view name, std::string_view text, const Parsed& angle);
/// Which of the words `typed` is, of the text of an option.
std::size_t pick(const Options& options, std::string_view name, std::string_view typed, std::span<const char* const> words);
/// Which of the words the option says; the first where it is not given.
std::size_t choice(const Options& options, std::string_view name, std::span<const char* const> words);

/// --method among `words`, the names of methods, once options that do not go with it are refused. The first where not given.
Method method_of(const Options& options, std::span<const char* const> words);
/// --tolerance, of `taylor`.
double tolerance_of(const Options& options);
/// --format and --precision.
Style style_of(const Options& options);
/// --output; empty for standard output.
std::string output_path(const Options& options);

}  // namespace pendula::cli
