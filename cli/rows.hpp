// Rows of numbers as text, csv or json: what every table of the program is spelled with.
#pragma once

#include <array>
#include <cmath>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "cli/numbers.hpp"

namespace pendula::cli {

enum class Format { text, csv, json };

/// The words of --format, in the order of the enumerators; those of the assignment's k from -1 to 1.
inline constexpr const char* format_names[] = {"text", "csv", "json"};
inline constexpr const char* regime_names[] = {"oscillation", "separatrix", "rotation"};

/// How numbers are printed.
struct Style {
    Format format = Format::text;
    int precision = 6;
};

/// What stands before a field; copied whole, which is faster than by its size.
struct Lead {
    std::array<char, 32> text{};
    std::size_t size = 0;
};

/// How rows are spelled.
struct RowStyle {
    std::vector<Lead> leads;
    std::string_view end;
    bool is_json;  ///< which knows no nan and no inf: they become null
    int precision;
};

/// The style of rows whose fields have these names.
RowStyle row_style(const std::vector<std::string>& names, const Style& style);

/// The names as a header line of text or csv.
std::string header_line(const std::vector<std::string>& names, Format format);

/// The text in quotes, as JSON has it; it holds no control characters.
std::string json_string(std::string_view text);
/// `,"name":text`: a further member of an object.
void add_member(std::string& object, std::string_view name, std::string_view text);
/// The same of a number in full precision.
void add_number(std::string& object, std::string_view name, double value);

/// The most bytes that `put_field` writes, and `put_word` of a word of up to 30 bytes.
inline constexpr std::size_t field_room = sizeof(Lead::text) + number_room;

/// Both write at a place and return the end.
inline char* put_text(char* at, std::string_view text) {
    return static_cast<char*>(std::memcpy(at, text.data(), text.size())) + text.size();
}

/// What stands before field number `field` of a row.
inline char* put_lead(char* at, const RowStyle& style, std::size_t field) {
    const Lead& lead = style.leads[field];
    return put_text(at, {lead.text.data(), lead.text.size()}) - lead.text.size() + lead.size;
}

/// A field that is a word.
inline char* put_word(char* at, const RowStyle& style, std::size_t field, std::string_view word) {
    at = put_lead(at, style, field);
    return style.is_json ? put_text(put_text(put_text(at, "\""), word), "\"") : put_text(at, word);
}

/// Field number `field` of a row, with what stands before it.
inline char* put_field(char* at, const RowStyle& style, std::size_t field, double value) {
    at = put_lead(at, style, field);
    return style.is_json && !std::isfinite(value) ? put_text(at, "null") : put_number(at, value, style.precision);
}

}  // namespace pendula::cli
