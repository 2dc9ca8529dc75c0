#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <set>

#include "cli/commands.hpp"

namespace pendula::cli {

namespace {

namespace fs = std::filesystem;

fs::path own_directory() {
    std::error_code error;
    return fs::read_symlink("/proc/self/exe", error).parent_path();
}

/// The directories that `pendula-NAME` is looked for in.
std::vector<fs::path> directories() {
    std::vector<fs::path> found{own_directory()};
    const char* const path = std::getenv("PATH");
    std::string_view rest = path ? path : "";
    while (!rest.empty()) {
        const std::size_t colon = rest.find(':');
        found.emplace_back(rest.substr(0, colon));
        rest.remove_prefix(colon == std::string_view::npos ? rest.size() : colon + 1);
    }
    return found;
}

/// Every NAME that there is.
std::set<std::string> known_names() {
    std::set<std::string> names;
    for (const auto& command : commands) names.emplace(command.name);
    std::error_code error;
    for (const auto& directory : directories())
        for (fs::directory_iterator entry(directory, error), end; !error && entry != end; entry.increment(error))
            if (const auto file = entry->path().filename().string(); file.starts_with("pendula-")) names.insert(file.substr(8));
    return names;
}

[[noreturn]] void refuse(const std::string& name) {
    std::error_code error;
    if (fs::is_regular_file(name, error))
        throw Failure{Status::bad_usage, say({"{0} is a file, no command; to read problems from it: pendula < {1}",
                                              "{0} es un fichero, no una orden; para leer problemas de él: pendula < {1}"},
                                             {in_quotes(name), name})};
    const auto known = known_names();
    const std::vector<std::string_view> names(known.begin(), known.end());
    const auto meant = nearest(name, names);
    throw Failure{Status::bad_usage,
                  meant.empty() ? say({"unknown command {0}; there are {1}", "orden desconocida {0}; existen {1}"},
                                      {in_quotes(name), joined(names)})
                                : say({"unknown command {0}; did you mean {1}?", "orden desconocida {0}; ¿querías decir {1}?"},
                                      {in_quotes(name), meant})};
}

}  // namespace

void run_other(const std::string& name, const std::vector<std::string>& arguments) {
    const std::string program = "pendula-" + name;
    std::vector<char*> argv{const_cast<char*>(program.c_str())};
    for (const auto& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    if (name.empty() || name.find('/') != std::string::npos) refuse(name);
    execv((own_directory() / program).c_str(), argv.data());
    if (errno == ENOENT) execvp(program.c_str(), argv.data());
    if (errno == ENOENT) refuse(name);
    throw Failure{Status::bad_usage,
                  say({"{0} could not be run: {1}", "no se ha podido ejecutar {0}: {1}"}, {in_quotes(program), reason(errno)})};
}

}  // namespace pendula::cli
