#include "cli/writing.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "cli/messages.hpp"
#include "cli/terminal.hpp"

namespace pendula::cli {

namespace {

constexpr std::size_t capacity = 1 << 16;

std::string name_of(const Writer& writer) {
    return writer.path.empty() ? say({"standard output", "la salida estándar"}) : in_quotes(writer.path);
}

[[noreturn]] void fail(const Writer& writer, int error) {
    if (error == EPIPE) throw Failure{Status::done, {}};
    throw Failure{Status::not_written, say({"{0} could not be written: {1}", "no se ha podido escribir {0}: {1}"},
                                           {name_of(writer), reason(error)})};
}

/// Whether what is written would be read again, or takes the place of what is still to be read. Terminals, other devices and
/// sockets have two directions.
bool is_input(const struct stat& output) {
    struct stat input{};
    return fstat(STDIN_FILENO, &input) == 0 && input.st_dev == output.st_dev && input.st_ino == output.st_ino &&
           !S_ISCHR(input.st_mode) && !S_ISSOCK(input.st_mode);
}

/// Takes `torn`, the bytes of an unfinished row, off the end of a regular file that nobody else has added to since.
void cut(const Writer& writer, std::size_t torn) {
    struct stat status{};
    const off_t end = lseek(writer.descriptor, 0, SEEK_CUR);
    if (fstat(writer.descriptor, &status) == 0 && S_ISREG(status.st_mode) && end == status.st_size)
        // A second failure leaves the file as it is; the first is what the user is told.
        [[maybe_unused]]
        const int result = ftruncate(writer.descriptor, end - static_cast<off_t>(torn));
}

/// A descriptor that others made non-blocking refuses what it has no room for.
void wait_for_room(int descriptor) {
    pollfd output{descriptor, POLLOUT, 0};
    poll(&output, 1, -1);
}

/// Bytes since the last line end before `size`.
std::size_t unfinished(const char* rows, std::size_t size) {
    std::size_t start = size;
    while (start > 0 && rows[start - 1] != '\n') --start;
    return size - start;
}

}  // namespace

void open(Writer& writer) {
    if (writer.descriptor >= 0) return;
    writer.buffer = std::make_unique_for_overwrite<char[]>(capacity);
    const bool is_named = !writer.path.empty();
    // Not emptied before it is known to be another file than the one that is read.
    writer.descriptor = is_named ? ::open(writer.path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666) : STDOUT_FILENO;
    if (writer.descriptor < 0 && is_interrupted())
        throw Failure{Status::interrupted, {}};  // as it waited for a reader of a pipe
    if (writer.descriptor < 0) fail(writer, errno);
    struct stat output{};
    if (fstat(writer.descriptor, &output) != 0) return;  // write(2) will say why
    if (is_input(output))
        throw bad_usage({"{0} is what standard input is read from; write to another file",
                         "{0} es de donde se lee la entrada estándar; escribe en otro fichero"},
                        {name_of(writer)});
    if (is_named && S_ISREG(output.st_mode) && ftruncate(writer.descriptor, 0) != 0) fail(writer, errno);
}

char* room(Writer& writer, std::size_t n) {
    if (writer.size + n > capacity) flush(writer);
    return writer.buffer.get() + writer.size;
}

void commit(Writer& writer, const char* end) { writer.size = static_cast<std::size_t>(end - writer.buffer.get()); }

void append(Writer& writer, std::string_view lines) {
    char* const at = room(writer, lines.size());
    std::memcpy(at, lines.data(), lines.size());
    commit(writer, at + lines.size());
}

void flush(Writer& writer) {
    const char* const rows = writer.buffer.get();
    std::size_t end = writer.size, done = 0;
    writer.size = 0;
    while (done < end) {
        const ssize_t written = ::write(writer.descriptor, rows + done, end - done);
        if (written >= 0) {
            done += static_cast<std::size_t>(written);
        } else if (errno == EAGAIN) {
            wait_for_room(writer.descriptor);
        } else if (errno != EINTR) {
            const int error = errno;
            cut(writer, unfinished(rows, done));
            fail(writer, error);
        }
        if (is_interrupted()) end = unfinished(rows, done) == 0 ? done : std::string_view(rows, end).find('\n', done) + 1;
    }
    if (is_interrupted()) throw Failure{Status::interrupted, {}};
}

void close(Writer& writer) {
    if (writer.descriptor < 0) return;
    flush(writer);
    if (::close(writer.descriptor) != 0) fail(writer, errno);
    writer.descriptor = -1;
}

}  // namespace pendula::cli
