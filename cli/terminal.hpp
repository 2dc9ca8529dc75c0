// The person at the keyboard: interruptions, waiting for input, and progress.
#pragma once

#include <chrono>

namespace pendula::cli {

/// Makes SIGINT, SIGTERM and SIGHUP set a flag the first time; a second one kills. What the parent chose to ignore stays
/// ignored.
void catch_interruptions();

bool is_interrupted();

/// Waits until standard input can be read. Throws Failure with Status::interrupted on a signal, however it is timed.
void wait_for_input();

/// How far a run is, as a line on a terminal's standard error once the run has lasted a second. It leaves no trace.
struct ProgressLine {
    using Clock = std::chrono::steady_clock;
    Clock::time_point started = Clock::now();
    Clock::time_point due = started + std::chrono::seconds(1);  ///< when to show it next
    bool is_visible = false;

    ProgressLine() = default;
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;
    ~ProgressLine();
};

bool is_due(const ProgressLine& line);
void show(ProgressLine& line, double fraction);
void clear(ProgressLine& line);

/// What long calls of the library are given: shows the fraction done where it is due, and returns whether to go on.
bool show_and_go_on(ProgressLine& line, double fraction);

}  // namespace pendula::cli
