// The person at the keyboard: interruptions, waiting for input, and progress.
#pragma once

#include <chrono>

namespace pendula::cli {

/// Makes SIGINT and SIGTERM set a flag the first time; a second one kills. What the parent chose to ignore stays ignored.
void catch_interruptions();

bool is_interrupted();

/// Waits until standard input can be read. Throws Failure with Status::interrupted on a signal, however it is timed.
void wait_for_input();

/// Progress of one run, on a terminal's standard error, once the run has lasted a second. It leaves no trace.
struct Progress {
    using Clock = std::chrono::steady_clock;
    Clock::time_point started = Clock::now();
    Clock::time_point due = started + std::chrono::seconds(1);  ///< when to show it next
    bool is_visible = false;

    Progress() = default;
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    ~Progress();
};

bool is_due(const Progress& progress);
void show(Progress& progress, double fraction);
void clear(Progress& progress);

}  // namespace pendula::cli
