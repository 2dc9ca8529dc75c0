// The run of a measure command: what is measured, block by block, and what is printed of it.
#pragma once

#include <array>
#include <functional>

#include "cli/settings.hpp"
#include "cli/sweep.hpp"
#include "cli/terminal.hpp"
#include "cli/writing.hpp"

namespace pendula::cli {

/// The most points with a row each that wait to be printed: 24 MiB.
inline constexpr std::size_t most_points = std::size_t{1} << 20;
/// The most members, or points, that are measured in one call because they belong together: about 1 GiB.
inline constexpr std::size_t most_together = std::size_t{1} << 24;

/// Results, a column each.
using Columns = std::vector<std::vector<double>>;

/// A measure of a sweep, from its options to its last row.
struct Run {
    const MeasureInfo& info;
    Sweep sweep;
    Strobe strobe;
    int threads;
    Style style;
    Writer writer = {};
    bool has_details = false, has_shares = false;
    std::vector<Carry> carries = {};        ///< the passes of a carried sweep; empty if members do not depend on each other
    std::optional<double> locate = {};      ///< the tolerance of the jumps that are printed in place of the curve
    std::vector<std::size_t> printed = {};  ///< columns of the measure
    bool has_points = false;                ///< whether a member has a row for each period
    RowStyle row_style = {};
    ProgressLine progress = {};
    std::size_t pass = 0;                                      ///< number of the carry
    std::size_t done = 0, at_hand = 0;                         ///< members printed in this pass, and being measured
    std::array<std::size_t, std::size(kind_names)> gaps = {};  ///< members with results that are nan, by kind
    std::size_t gaps_of_no_kind = 0;                           ///< and those of a measure without kinds
};

/// The members of the last range, which a carried sweep goes along.
std::size_t line_of(const Run& run);
/// Members of all passes.
std::size_t total_of(const Run& run);

/// Room for the columns of `infos`, filled by a call of the library for the members at hand. Ends the program where that is
/// interrupted or refused.
Columns computed(Run& run, std::span<const ResultColumn> infos, const Strobe& strobe,
                 const std::function<Outcome(const Results&, const Control&)>& call);
/// The measure of an ensemble, carried if the run is.
Columns results_of(Run& run, const Ensemble& ensemble, const Strobe& strobe);

/// A value of a column as a field: a word of its list, or a number.
char* put_value(char* at, const RowStyle& style, std::size_t field, const ResultColumn& column, double value);

/// Counts the members at hand whose printed results are nan in the row.
void count_gaps(Run& run, const Columns& results, std::size_t row);
/// Throws Failure with Status::bad_data that says for how many members results are nan, and why, where there are any.
void tell_gaps(const Run& run);

/// Opens the output and writes its header, for rows that have these names.
void start_output(Run& run, const std::vector<std::string>& names);

/// The jumps of the members at hand, one row each.
void print_jumps(Run& run);
std::vector<std::string> jump_names(const Run& run);

/// The table of shares, which needs all members at hand.
void print_shares(Run& run);
std::vector<std::string> share_names(const Run& run);

}  // namespace pendula::cli
