// The table of a solved problem: which columns, and its rows.
#pragma once

#include <vector>

#include "cli/problem.hpp"
#include "cli/rows.hpp"
#include "cli/writing.hpp"

namespace pendula::cli {

enum class TableColumn { t, theta, omega, sine, exact, error, energy, turns };

/// The words of --columns, in the order of the enumerators.
inline constexpr const char* column_names[] = {"t", "theta", "omega", "sine", "exact", "error", "energy", "turns"};

struct Layout {
    std::vector<TableColumn> columns;  ///< empty for t, theta, omega, and sine where it oscillates
    Style style;
};

/// Refuses columns of the closed form for a pendulum that has none.
void require_columns(const Prepared& prepared, const Layout& layout);

/// Solves the problem, the `number`th from 1, and prints its table while it runs, and shows its progress. Throws Failure with
/// Status::bad_data where the motion leaves the doubles, behind the last row that is finite.
void print_table(Writer& writer, const Prepared& prepared, const Layout& layout, std::size_t number);

}  // namespace pendula::cli
