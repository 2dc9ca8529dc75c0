// What the program does, one function a command. Each throws Failure where it cannot.
#pragma once

#include "cli/options.hpp"

namespace pendula::cli {

/// Solves the problems of standard input, a table for each.
void solve_input(const Options& options);
/// Solves the one problem of the options.
void solve_options(const Options& options);
/// Analyses the pendulums of the options, or those of standard input, a line for each; bad_data where a line was bad.
Status analyze(const Options& options);
/// Measures all pendulums that the ranges of the options make, and prints lines for each.
void measure(const MeasureInfo& info, const Options& options);
/// Runs `pendula-NAME`, beside the program or on PATH, with the arguments; returns only by throwing.
[[noreturn]] void run_other(std::string_view name, std::span<const std::string_view> arguments);
/// The manual, in the language set.
std::string manual();

}  // namespace pendula::cli
