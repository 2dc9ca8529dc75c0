// What the program does, one function a command. Each throws Failure where it cannot.
#pragma once

#include <string>
#include <vector>

#include "cli/options.hpp"

namespace pendula::cli {

/// Solves the problems of standard input, a table for each.
void solve_input(const Options& options);
/// Solves the one problem of the options.
void solve_options(const Options& options);
/// Analyses the pendulum of the options, or those of standard input, a line for each; bad_data where a line was bad.
Status analyze(const Options& options);
/// Prints sections, mean velocities or Lyapunov exponents of all pendulums that the ranges of the options make.
void measure(Command command, const Options& options);
/// Runs `pendula-NAME`, beside the program or on PATH, with the arguments; returns only by throwing.
[[noreturn]] void run_other(const std::string& name, const std::vector<std::string>& arguments);
/// The manual, in the language set.
std::string manual();

}  // namespace pendula::cli
