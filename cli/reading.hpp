// Problems and lines from standard input, as they arrive.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "cli/problem.hpp"

namespace pendula::cli {

/// Standard input as tokens between white space; `#` starts a comment to the end of the line.
struct Tokens {
    std::unique_ptr<char[]> buffer;
    std::size_t begin = 0, end = 0;  ///< what of the buffer is still unread
    std::size_t line = 1;            ///< of `token`
    std::string token;               ///< the last one read, up to one byte more than is legal
    bool is_comment = false;
};

enum class Next { token, line_end, input_end };

Next next(Tokens& tokens);

/// Whether reading on to the next line end needs no waiting.
bool has_line(const Tokens& tokens);

/// The next problem, of eight tokens; none at the end of the input. `number` counts from 1.
/// Throws Failure with Status::bad_data at the first token that is none of what would be legal there.
std::optional<Statement> read_problem(Tokens& tokens, std::size_t number);

/// A line of `analyze`: θ0 unit ω0 unit α.
struct ReadLine {
    Pendulum pendulum;
    State initial;
    std::string place;  ///< "line 3: "
    std::string wrong;  ///< empty where the line stands
};

/// The next line that is not empty; none at the end of the input.
std::optional<ReadLine> read_line(Tokens& tokens);

}  // namespace pendula::cli
