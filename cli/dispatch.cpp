#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>

#include "cli/commands.hpp"

namespace pendula::cli {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view prefix = "pendula-";
constexpr std::size_t longest_path = 4096;

/// The directories that `pendula-NAME` is looked for in: the program's own, and those of PATH that do not depend on where one
/// is.
std::vector<fs::path> directories() {
    std::error_code error;
    std::vector<fs::path> found;
    if (const auto own = fs::read_symlink("/proc/self/exe", error); own.is_absolute()) found.push_back(own.parent_path());
    const char* const path = std::getenv("PATH");
    std::string_view rest = path ? path : "";
    while (!rest.empty()) {
        const auto directory = rest.substr(0, rest.find(':'));
        if (directory.starts_with('/')) found.emplace_back(directory);
        rest.remove_prefix(std::min(rest.size(), directory.size() + 1));
    }
    return found;
}

bool may_run(const fs::path& file) {
    std::error_code error;
    return fs::is_regular_file(file, error) && access(file.c_str(), X_OK) == 0;
}

/// The names of all commands, the program's own and those that can be run.
std::vector<std::string> known_names() {
    std::set<std::string> names;
    for (auto& name : command_names()) names.insert(std::move(name));
    std::error_code error;
    for (const auto& directory : directories())
        for (fs::directory_iterator entry(directory, error), end; !error && entry != end; entry.increment(error))
            if (const auto file = entry->path().filename().string(); file.starts_with(prefix) && may_run(entry->path()))
                names.insert(file.substr(prefix.size()));
    return {names.begin(), names.end()};
}

[[noreturn]] void refuse_unknown(std::string_view name) {
    std::error_code error;
    if (fs::is_regular_file(name, error))
        throw bad_usage({"{0} is a file, no command; to read problems from it: pendula < {1}",
                         "{0} es un fichero, no una orden; para leer problemas de él: pendula < {1}"},
                        {in_quotes(name), name});
    const auto names = known_names();
    const auto meant = nearest(name, names);
    if (meant.empty())
        throw bad_usage({"unknown command {0}; there are {1}", "orden desconocida {0}; existen {1}"},
                        {in_quotes(name), joined(names)});
    throw bad_usage({"unknown command {0}; did you mean {1}?", "orden desconocida {0}; ¿querías decir {1}?"},
                    {in_quotes(name), meant});
}

/// Why a file that is there was not run: the program that its first line names is missing, or what the system says.
std::string obstacle(const fs::path& file, int error) {
    std::string line;
    if (error != ENOENT) return reason(error);
    std::ifstream stream(file);
    std::getline(stream, line);
    if (!line.starts_with("#!")) return say({"what it needs to be run is missing", "falta lo que necesita para ejecutarse"});
    const auto begin = std::min(line.find_first_not_of(" \t", 2), line.size());
    const auto interpreter = line.substr(begin, line.find_first_of(" \t\r", begin) - begin);
    return say({"its interpreter {0} is missing", "falta su intérprete {0}"}, {in_quotes(interpreter, longest_path)});
}

[[noreturn]] void refuse_found(const fs::path& file, const std::string& why) {
    throw bad_usage({"{0} could not be run: {1}", "no se ha podido ejecutar {0}: {1}"},
                    {in_quotes(file.string(), longest_path), why});
}

}  // namespace

void run_other(std::string_view name, std::span<const std::string_view> arguments) {
    if (name.empty() || name.find('/') != std::string_view::npos) refuse_unknown(name);
    const std::string program = std::string(prefix) + std::string(name);
    std::vector<char*> argv{const_cast<char*>(program.c_str())};
    for (const auto argument : arguments) argv.push_back(const_cast<char*>(argument.data()));  // main's, which end in a 0
    argv.push_back(nullptr);
    fs::path closed, broken;  // a file that may not be run, a link to one that is missing
    for (const auto& directory : directories()) {
        const fs::path file = directory / program;
        std::error_code error;
        if (may_run(file)) {
            execvp(file.c_str(),
                   argv.data());  // the whole path, so that only a script without a first line "#!" is treated otherwise
            refuse_found(file, obstacle(file, errno));
        }
        if (fs::is_regular_file(file, error)) closed = file;
        if (fs::is_symlink(file, error) && !fs::exists(file, error)) broken = file;
    }
    if (!closed.empty()) refuse_found(closed, reason(EACCES));
    if (!broken.empty())
        refuse_found(broken, say({"it links to a file that is missing", "es un enlace a un fichero que falta"}));
    refuse_unknown(name);
}

}  // namespace pendula::cli
