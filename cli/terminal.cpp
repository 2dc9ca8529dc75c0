#include "cli/terminal.hpp"

#include <sys/select.h>
#include <unistd.h>

#include <csignal>

#include "cli/messages.hpp"
#include "cli/numbers.hpp"

namespace pendula::cli {

namespace {

constexpr int interruptions[] = {SIGINT, SIGTERM, SIGHUP};

volatile std::sig_atomic_t was_signalled = 0;

void write_to_terminal(const std::string& text) {
    [[maybe_unused]] const auto written = ::write(STDERR_FILENO, text.data(), text.size());
}

}  // namespace

void catch_interruptions() {
    for (const int signal : interruptions) {
        struct sigaction former{}, action{};
        action.sa_handler = [](int) { was_signalled = 1; };
        action.sa_flags = static_cast<int>(SA_RESETHAND);
        sigaction(signal, nullptr, &former);
        if (former.sa_handler != SIG_IGN) sigaction(signal, &action, nullptr);
    }
    std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow is an error of write(2), told like the others
}

bool is_interrupted() { return was_signalled != 0; }

void wait_for_input() {
    // Blocked but for the wait itself: a signal between the question and the wait would be lost otherwise.
    sigset_t blocked, former;
    sigemptyset(&blocked);
    for (const int signal : interruptions) sigaddset(&blocked, signal);
    sigprocmask(SIG_BLOCK, &blocked, &former);
    fd_set input;
    FD_ZERO(&input);
    FD_SET(STDIN_FILENO, &input);
    if (!is_interrupted()) pselect(STDIN_FILENO + 1, &input, nullptr, nullptr, nullptr, &former);
    sigprocmask(SIG_SETMASK, &former, nullptr);
    if (is_interrupted()) throw Failure{Status::interrupted, {}};
}

ProgressLine::~ProgressLine() { clear(*this); }

bool is_due(const ProgressLine& line) { return ProgressLine::Clock::now() >= line.due; }

void show(ProgressLine& line, double fraction) {
    const auto now = ProgressLine::Clock::now();
    line.due = now + std::chrono::milliseconds(200);
    if (!isatty(STDERR_FILENO)) return;
    const double elapsed = std::chrono::duration<double>(now - line.started).count();
    std::string text = "\r\x1b[Kpendula: " + std::to_string(static_cast<int>(100 * fraction)) + " %";
    if (fraction > 0) {
        const auto left = std::to_string(static_cast<long long>(elapsed * (1 - fraction) / fraction) + 1);
        text += say({", {0} s left", ", faltan {0} s"}, {left});
    }
    write_to_terminal(text);
    line.is_visible = true;
}

void clear(ProgressLine& line) {
    if (line.is_visible) write_to_terminal("\r\x1b[K");
    line.is_visible = false;
}

bool show_and_go_on(ProgressLine& line, double fraction) {
    if (is_interrupted()) return false;
    if (is_due(line)) show(line, fraction);
    return true;
}

}  // namespace pendula::cli
