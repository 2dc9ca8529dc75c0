// Output that is never silently short: whole rows, every write checked.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

namespace pendula::cli {

/// Standard output, or the file at `path`; rows gather in a buffer between lines that reach the system whole.
struct Writer {
    std::string path;  ///< empty for standard output
    int descriptor = -1;
    std::size_t size = 0;
    std::unique_ptr<char[]> buffer = nullptr;
};

/// Opens the output, the first time; what the file held is gone. Call it once there is something sure to be written.
/// Throws Failure with Status::bad_usage where the output is the very file that standard input is read from.
void open(Writer& writer);

/// Room for n more bytes, up to 64 KiB, behind the rows that wait. Fill it with whole rows and call `commit` with their end.
char* room(Writer& writer, std::size_t n);
void commit(Writer& writer, const char* end);

/// Adds whole lines.
void append(Writer& writer, std::string_view lines);

/// Hands the rows that wait to the system. On a full disk the file is cut after its last whole row and Failure is thrown
/// with Status::not_written; on an interruption with Status::interrupted, at the end of a row; on a pipe that nobody
/// reads with Status::done.
void flush(Writer& writer);

/// Flushes and closes, if it was opened.
void close(Writer& writer);

}  // namespace pendula::cli
