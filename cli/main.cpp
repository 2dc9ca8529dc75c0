// pendula: the pendulum, exactly and step by step, from the command line.
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <new>

#include "cli/commands.hpp"
#include "cli/terminal.hpp"
#include "cli/writing.hpp"
#include "pendula/version.hpp"

namespace pendula::cli {

namespace {

using Arguments = std::vector<std::string_view>;

/// Standard descriptors that the parent closed are opened for reading only: no file of ours takes their number, and to
/// write to them fails.
void occupy_standard_descriptors() {
    for (int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (fcntl(descriptor, F_GETFD) < 0) ::open("/dev/null", O_RDONLY);
}

void print(std::string_view text) {
    Writer writer;
    open(writer);
    append(writer, text);
    close(writer);
}

/// `pendula [--lang L] [NAME] arguments`: takes NAME out of the arguments, where there is one.
std::optional<std::string_view> take_name(Arguments& arguments) {
    auto at = arguments.begin();
    if (at != arguments.end() && at->starts_with("--lang="))
        ++at;
    else if (at != arguments.end() && *at == "--lang")
        at += std::min<std::ptrdiff_t>(2, arguments.end() - at);
    if (at == arguments.end() || at->starts_with('-')) return {};
    const auto name = *at;
    arguments.erase(at);
    return name;
}

void require_instruction_set() {
    const Refusal refusal{.reason = Refusal::Reason::instruction_set};
    if (!instruction_set()) throw Failure{Status::bad_usage, say(refusal, "")};
}

Status run(Arguments arguments) {
    set_language(language_of(arguments));
    Command command = solve_input_command;
    if (const auto name = take_name(arguments)) {
        const auto own = command_named(*name);
        if (!own) run_other(*name, arguments);
        command = *own;
    }
    const Options options = parse(command, arguments);
    if (options.wants_help) return print(manual()), Status::done;
    if (options.wants_version) return print("pendula " + std::string(version) + '\n'), Status::done;
    require_instruction_set();
    catch_interruptions();
    if (command == analyze_command) return analyze(options);
    if (command == solve_input_command) solve_input(options);
    if (command == solve_command) solve_options(options);
    if (const auto* info = measure_of(command)) measure(*info, options);
    return Status::done;
}

}  // namespace

}  // namespace pendula::cli

int main(int argc, char** argv) {
    using namespace pendula::cli;
    using pendula::Refusal, pendula::Status;
    try {
        occupy_standard_descriptors();
        return static_cast<int>(run({argv + std::min(argc, 1), argv + argc}));
    } catch (const Failure& failure) {
        if (!failure.message.empty()) tell(failure.message);
        return static_cast<int>(failure.status);
    } catch (const std::bad_alloc&) {
        tell(say({.reason = Refusal::Reason::memory}, ""));
        return static_cast<int>(Status::bad_data);
    }
}
