#include "cli/messages.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>

namespace pendula::cli {

namespace {

Language spoken = Language::en;

/// Bytes of the UTF-8 character beyond ASCII that begins `text`; 0 where none does, or one that controls a terminal.
std::size_t character_length(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const std::size_t length = byte(0) >= 0xf5 ? 0 : byte(0) >= 0xf0 ? 4 : byte(0) >= 0xe0 ? 3 : byte(0) >= 0xc2 ? 2 : 0;
    if (length == 0 || text.size() < length || (byte(0) == 0xc2 && byte(1) < 0xa0)) return 0;
    for (std::size_t i = 1; i < length; ++i)
        if ((byte(i) & 0xc0) != 0x80) return 0;
    return length;
}

/// Slips (a letter left out, put in, changed, or two exchanged) between two words.
std::size_t slips(std::string_view a, std::string_view b) {
    std::vector<std::size_t> before, above(b.size() + 1), row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) above[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            row[j] = std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + (a[i - 1] != b[j - 1])});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) row[j] = std::min(row[j], before[j - 2] + 1);
        }
        before = above;
        std::swap(above, row);
    }
    return above[b.size()];
}

}  // namespace

void set_language(Language language) { spoken = language; }

std::string say(const Words& text, std::initializer_list<std::string_view> values) {
    const std::string_view pattern = spoken == Language::es ? text.es : text.en;
    std::string filled;
    for (std::size_t i = 0; i < pattern.size(); ++i) {
        if (pattern[i] == '{' && i + 2 < pattern.size() && pattern[i + 2] == '}') {
            filled += values.begin()[pattern[i + 1] - '0'];
            i += 2;
        } else {
            filled += pattern[i];
        }
    }
    return filled;
}

std::string say(const Refusal& refusal, const std::string& name) { return describe(refusal, spoken, name); }

Failure bad_usage(const Words& text, std::initializer_list<std::string_view> values) {
    return {Status::bad_usage, say(text, values)};
}

void tell(std::string_view message) {
    const std::string line = "pendula: " + std::string(message) + '\n';
    // One write, so that lines of several processes do not mix. There is nobody to tell if it fails.
    [[maybe_unused]] const auto written = ::write(STDERR_FILENO, line.data(), line.size());
}

std::string in_quotes(std::string_view token, std::size_t longest) {
    std::string shown = "\"";
    std::size_t i = 0;
    while (i < token.size() && i < longest) {
        const auto byte = static_cast<unsigned char>(token[i]);
        if (byte >= 0x20 && byte < 0x7f) {
            shown += token[i++];
        } else if (const std::size_t length = character_length(token.substr(i))) {
            shown += token.substr(i, length);
            i += length;
        } else {
            constexpr char digits[] = "0123456789abcdef";
            shown += {'\\', 'x', digits[byte >> 4], digits[byte & 15]};
            ++i;
        }
    }
    return shown + (i < token.size() ? "...\"" : "\"");
}

std::string reason(int error) {
    static constexpr struct {
        int error;
        Words text;
    } known[] = {
        {ENOSPC, {"no space left on the device", "no queda espacio en el dispositivo"}},
        {EDQUOT, {"disk quota exceeded", "se ha superado la cuota de disco"}},
        {EFBIG, {"the file would be too large", "el fichero sería demasiado grande"}},
        {EACCES, {"permission denied", "permiso denegado"}},
        {ENOENT, {"no such file or directory", "no existe el fichero o el directorio"}},
        {EISDIR, {"it is a directory", "es un directorio"}},
        {ENOTDIR, {"part of the path is not a directory", "parte de la ruta no es un directorio"}},
        {EROFS, {"the file system is read-only", "el sistema de ficheros es de solo lectura"}},
        {EBADF, {"it is closed", "está cerrada"}},
        {EIO, {"input/output error", "error de entrada/salida"}},
    };
    for (const auto& [number, text] : known)
        if (number == error) return say(text);
    return say({"system error {0}", "error {0} del sistema"}, {std::to_string(error)});
}

std::string joined(const std::vector<std::string>& words, std::string_view separator) {
    std::string list;
    for (const auto& word : words) list.append(list.empty() ? "" : separator).append(word);
    return list;
}

std::string nearest(std::string_view typed, const std::vector<std::string>& names) {
    std::string best;
    std::size_t fewest = std::min<std::size_t>(typed.size(), typed.size() < 5 ? 2 : 3);  // as many slips are another word
    for (const auto& name : names) {
        if (const std::size_t n = slips(typed, name); n < fewest) {
            fewest = n;
            best = name;
        }
    }
    if (!best.empty()) return best;
    const auto last_words = typed.substr(std::min(typed.find_first_not_of('-'), typed.size()));
    const auto ends_so = [&](const std::string& name) { return name.ends_with(std::string("-").append(last_words)); };
    const auto found = std::ranges::find_if(names, ends_so);
    return last_words.empty() || found == names.end() ? std::string() : *found;
}

}  // namespace pendula::cli
