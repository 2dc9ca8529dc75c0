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

/// "mean-velocity" of mean_velocity, and "--drive-amplitude" of drive_amplitude.
std::string hyphenated(std::string_view name);
std::string option_of(std::string_view name);

/// What a range may be given for: the parameters of the table, and gravity and length, which make alpha. Those two have no
/// place in a pendulum.
inline constexpr std::size_t swept_count = parameter_count + 2;
const Parameter& swept_parameter(std::size_t i);

struct Option {
    std::string name;
    unsigned commands;       ///< that take it
    const char* value = "";  ///< a letter for what stands behind it, in the manual, which has a line for each option with one
    Words meaning = {"", ""};
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
/// Which of the words `typed` is, of the text of an option.
std::size_t pick(const Options& options, std::string_view name, std::string_view typed, std::span<const char* const> words);
/// Which of the words the option says; the first where it is not given.
std::size_t choice(const Options& options, std::string_view name, std::span<const char* const> words);

/// --method among the library's, once options that do not go with it are refused.
Method method_of(const Options& options);
/// --tolerance, of `taylor`.
double tolerance_of(const Options& options);
/// --format and --precision.
Style style_of(const Options& options);
/// --output; empty for standard output.
std::string output_path(const Options& options);

}  // namespace pendula::cli
