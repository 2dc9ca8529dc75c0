// What stands on the command line. CLI11 takes it apart; every value stays text until one of these functions reads it, so
// that every message is the program's own, in both languages.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "cli/messages.hpp"
#include "cli/numbers.hpp"
#include "cli/problem.hpp"
#include "cli/table.hpp"

namespace pendula::cli {

/// A bit each, so that an option says who takes it.
enum Command : unsigned { reads = 1, solves = 2, analyzes = 4, sections = 8, velocities = 16, exponents = 32 };
inline constexpr unsigned measures = sections | velocities | exponents;

struct CommandName {
    std::string_view name;
    Command command;
};
inline constexpr CommandName commands[] = {
    {"solve", solves}, {"analyze", analyzes}, {"section", sections}, {"velocity", velocities}, {"lyapunov", exponents},
};

struct OptionName {
    std::string_view name;
    unsigned commands;  ///< that take it
};
inline constexpr OptionName option_names[] = {
    {"--theta0", solves | analyzes | measures},
    {"--omega0", solves | analyzes | measures},
    {"--alpha", solves | analyzes | measures},
    {"--gravity", solves | analyzes | measures},
    {"--length", solves | analyzes | measures},
    {"--beta", solves | measures},
    {"--torque", solves | measures},
    {"--drive-amplitude", solves | measures},
    {"--drive-frequency", solves | measures},
    {"--drive-phase", solves | measures},
    {"--transient", measures},
    {"--periods", measures},
    {"--steps", measures},
    {"--threads", measures},
    {"--tolerance", reads | solves | measures},
    {"--dt-factor", solves},
    {"--dt", solves},
    {"--every-factor", solves},
    {"--every", solves},
    {"--until-factor", solves},
    {"--until", solves},
    {"--method", reads | solves | analyzes | measures},
    {"--epsilon", analyzes},
    {"--columns", reads | solves},
    {"--format", reads | solves | analyzes | measures},
    {"--precision", reads | solves | analyzes | measures},
    {"--output", reads | solves | analyzes | measures},
    {"--lang", reads | solves | analyzes | measures},
};

/// The texts of the options given, beside `option_names`.
struct Options {
    std::array<std::string, std::size(option_names)> texts;
    std::array<bool, std::size(option_names)> given{};
    std::vector<std::string> order;  ///< names of those given, as they came
    bool wants_help = false, wants_version = false;
};

/// Takes the arguments behind the command apart. This and all below throw Failure with Status::bad_usage.
Options parse(Command command, const std::vector<std::string>& arguments);

bool is_given(const Options& options, std::string_view name);
/// What was given, empty where nothing was.
const std::string& text(const Options& options, std::string_view name);
[[noreturn]] void refuse_value(const Options& options, std::string_view name, std::string_view wrong);
void refuse_both(const Options& options, std::string_view one, std::string_view other);
/// A number that satisfies the rule, or else what stands for one that is not given.
double number(const Options& options, std::string_view name, Rule rule, double otherwise);
/// Which of the words the option says; the first where it is not given.
std::size_t choice(const Options& options, std::string_view name, std::span<const std::string_view> words);

/// Whether any option says which pendulum, or how it starts.
bool states_pendulum(const Options& options);
/// The pendulum of --alpha, or of --gravity and --length.
Pendulum pendulum(const Options& options);
/// The state of --theta0, which has to be there, and --omega0.
State initial_state(const Options& options);
/// The step, the time between rows and the length of the run, where given.
void read_durations(const Options& options, Statement& statement);
/// --method of a solution.
Method method(const Options& options);
/// --tolerance, of `taylor`.
double tolerance(const Options& options);
/// Refuses methods and columns that a pendulum with friction or forcing does not have.
void require_able(const Statement& statement, const Layout& layout);
/// --epsilon where --method is `series`, else 0.
double series_epsilon(const Options& options);
/// --columns, --format and --precision.
Layout layout(const Options& options);
/// --output.
std::string output_path(const Options& options);
/// --lang, wherever it stands among the arguments, else the environment's.
Language language(const std::vector<std::string>& arguments);

}  // namespace pendula::cli
