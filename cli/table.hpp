// Tables: which columns, spelled how, and the rows themselves.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cli/problem.hpp"
#include "cli/writing.hpp"

namespace pendula::cli {

enum class Column { t, theta, omega, sine, exact, error, energy, turns };
enum class Format { text, csv, json };

/// The words of --columns and --format, in the order of the enumerators.
inline constexpr std::string_view column_names[] = {"t", "theta", "omega", "sine", "exact", "error", "energy", "turns"};
inline constexpr std::string_view format_names[] = {"text", "csv", "json"};
/// The words of --method, in the order of `Method`; those of the assignment's k from -1 to 1.
inline constexpr std::string_view method_names[] = {"rk4", "euler", "verlet", "taylor", "exact"};
inline constexpr std::string_view regime_names[] = {"oscillation", "separatrix", "rotation"};

struct Layout {
    std::vector<Column> columns;  ///< empty for t, theta, omega, and sine where it oscillates
    Format format = Format::text;
    int precision = 6;
};

/// How rows are spelled.
struct RowStyle {
    std::vector<std::string> leads;  ///< what stands before each field
    std::string_view end;
    bool is_json;  ///< which knows no nan and no inf: they become null
    int precision;
};

/// The style of rows whose fields have these names.
RowStyle row_style(const std::vector<std::string_view>& names, Format format, int precision);

/// The text in quotes, as JSON has it; it holds no control characters.
std::string json_string(std::string_view text);

char* put_text(char* at, std::string_view text);
/// Writes field number `field` of a row, with what stands before it; returns the end.
char* put_field(char* at, const RowStyle& style, std::size_t field, double value);

/// Solves the problem, the `number`th from 1, and prints its table while it runs, and shows its progress.
void print_table(Writer& writer, const Prepared& prepared, const Layout& layout, std::size_t number);

}  // namespace pendula::cli
