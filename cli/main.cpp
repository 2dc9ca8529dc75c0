// pendula: the pendulum, exactly and step by step, from the command line.
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <optional>

#include "cli/commands.hpp"
#include "cli/terminal.hpp"

namespace pendula::cli {

namespace {

/// Standard descriptors that the parent closed are opened for reading only: no file of ours takes their number, and to
/// write to them fails.
void occupy_standard_descriptors() {
    for (int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (fcntl(descriptor, F_GETFD) < 0) ::open("/dev/null", O_RDONLY);
}

Status print(std::string_view text) {
    Writer writer;
    open(writer);
    put(writer, text);
    close(writer);
    return Status::done;
}

/// `pendula [--lang L] [NAME] arguments`: takes NAME out of the arguments, where there is one.
std::optional<std::string> take_name(std::vector<std::string>& arguments) {
    auto at = arguments.begin();
    if (at != arguments.end() && at->starts_with("--lang="))
        ++at;
    else if (at != arguments.end() && *at == "--lang")
        at += std::min<std::ptrdiff_t>(2, arguments.end() - at);
    if (at == arguments.end() || at->starts_with('-')) return {};
    std::string name = std::move(*at);
    arguments.erase(at);
    return name;
}

Status run(std::vector<std::string> arguments) {
    set_language(language(arguments));
    Command command = reads;
    if (const auto name = take_name(arguments)) {
        const auto own = std::ranges::find(commands, *name, &CommandName::name);
        if (own == std::end(commands)) run_other(*name, arguments);
        command = own->command;
    }
    const Options options = parse(command, arguments);
    if (options.wants_help) return print(manual());
    if (options.wants_version) return print("pendula " PENDULA_VERSION "\n");
    catch_interruptions();
    switch (command) {
        case reads:
            solve_input(options);
            break;
        case solves:
            solve_options(options);
            break;
        case analyzes:
            return analyze(options);
        case sections:
        case velocities:
        case exponents:
            measure(command, options);
            break;
    }
    return Status::done;
}

}  // namespace

}  // namespace pendula::cli

int main(int argc, char** argv) {
    using namespace pendula::cli;
    try {
        occupy_standard_descriptors();
        return static_cast<int>(run({argv + std::min(argc, 1), argv + argc}));
    } catch (const Failure& failure) {
        if (!failure.message.empty()) tell(failure.message);
        return static_cast<int>(failure.status);
    }
}
