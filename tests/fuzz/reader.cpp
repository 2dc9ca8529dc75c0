// libFuzzer target: whatever bytes stand on standard input, the readers end, and what they let through is legal.
#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>

#include "cli/messages.hpp"
#include "cli/reading.hpp"
#include "pendula/validate.hpp"

namespace {

using namespace pendula;
using namespace pendula::cli;

void expect(bool holds) {
    if (!holds) std::abort();
}

void rewind_input() { expect(lseek(STDIN_FILENO, 0, SEEK_SET) == 0); }

void give_input(const std::uint8_t* data, std::size_t size) {
    [[maybe_unused]] static const int input = dup2(memfd_create("input", 0), STDIN_FILENO);
    expect(ftruncate(STDIN_FILENO, 0) == 0 && pwrite(STDIN_FILENO, data, size, 0) == static_cast<ssize_t>(size));
    rewind_input();
}

void expect_legal(const Pendulum& pendulum, State initial) {
    expect(satisfies(Rule::positive, pendulum.alpha));
    expect(satisfies(Rule::finite, initial.theta) && satisfies(Rule::finite, initial.omega));
}

/// One line, in UTF-8 that cannot control a terminal.
void expect_printable(const std::string& message) {
    expect(!message.empty() && message.size() < 400);
    for (const char c : message) expect(static_cast<unsigned char>(c) >= 0x20 && c != 0x7f);
}

void read_problems() {
    Tokens tokens;
    try {
        for (std::size_t number = 1; const auto statement = read_problem(tokens, number); ++number) {
            expect_legal(statement->pendulum, statement->initial);
            const auto& [dt, every, until] = statement->durations;
            for (const Duration& factor : {dt, every, until})
                expect(factor.is_factor && satisfies(Rule::positive, factor.value));
            expect(!check(prepare(*statement).problem));
        }
    } catch (const Failure& failure) {
        expect(failure.status == Status::bad_data);
        expect_printable(failure.message);
    }
}

void read_lines() {
    Tokens tokens;
    while (const auto line = read_line(tokens)) {
        if (line->wrong.empty())
            expect_legal(line->pendulum, line->initial);
        else
            expect_printable(line->wrong);
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    set_language(size % 2 == 0 ? Language::en : Language::es);
    give_input(data, size);
    read_problems();
    rewind_input();
    read_lines();
    return 0;
}
