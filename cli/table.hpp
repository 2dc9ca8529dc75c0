// The table of a solved problem: which columns, and its rows.
#pragma once

#include <array>
#include <vector>

#include "cli/problem.hpp"
#include "cli/rows.hpp"
#include "cli/writing.hpp"

namespace pendula::cli {

enum class TableColumn { t, theta, omega, sine, exact, error, energy, turns };

struct ColumnInfo {
    const char* name;    ///< in --columns, csv and json
    const char* header;  ///< in text: the assignment's words where it has them
    Words meaning;
};

/// In the order of the enumerators.
inline constexpr ColumnInfo table_columns[] = {
    {"t", "t", {"time, s", "tiempo, s"}},
    {"theta", "angulo", {"angle in [-π, π), rad", "ángulo en [-π, π), rad"}},
    {"omega", "velocidad", {"angular velocity, rad/s", "velocidad angular, rad/s"}},
    {"sine", "funcionSinusoidal", {"the sinusoid; nan where it does not oscillate", "la sinusoide; nan si no oscila"}},
    {"exact", "exact", {"angle of the closed form", "ángulo de la solución exacta"}},
    {"error", "error", {"theta less exact, in [-π, π)", "theta menos exact, en [-π, π)"}},
    {"energy", "energy", {"ω²/2 + α(1 - cos θ), 1/s²", "ω²/2 + α(1 - cos θ), 1/s²"}},
    {"turns", "turns", {"whole turns: θ + 2π turns counts them all", "vueltas enteras: θ + 2π turns las cuenta todas"}},
};
inline constexpr auto column_names = [] {
    std::array<const char*, std::size(table_columns)> names{};
    for (std::size_t i = 0; i < names.size(); ++i) names[i] = table_columns[i].name;
    return names;
}();

struct Layout {
    std::vector<TableColumn> columns;  ///< empty for t, theta, omega, and sine where it oscillates
    Style style;
    bool has_rows = true;  ///< otherwise what stands before the rows is all
};

/// Refuses columns of the closed form for a pendulum that has none, or later than it is right.
void require_columns(const Prepared& prepared, const Layout& layout);

/// Solves the problem, the `number`th from 1, and prints its table while it runs, and shows its progress. Throws Failure with
/// Status::bad_data where the motion leaves the doubles, behind the last row that is finite.
void print_table(Writer& writer, const Prepared& prepared, const Layout& layout, std::size_t number);

}  // namespace pendula::cli
