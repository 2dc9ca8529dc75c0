#include <cmath>
#include <map>
#include <tuple>

#include "cli/measuring.hpp"

namespace pendula::cli {

namespace {

/// The columns of attractors, in their order.
enum Column : std::size_t { label, kind, period, rotation, theta, omega };
constexpr const char* column_names[] = {"label", "kind", "period", "rotation", "theta", "omega"};
static_assert([] {
    for (std::size_t i = 0; i < std::size(column_names); ++i)
        if (std::string_view(attractors_columns[i].name) != column_names[i]) return false;
    return true;
}());

/// The members of a set of parameters that end in the same way: on an attractor, or where it has no number as motions of a
/// kind.
struct Ending {
    std::size_t example = 0;  ///< one of them
    double members = 0;
};
/// By the set, the label and the kind: attractors in the order of their numbers, behind them those without one.
using Endings = std::map<std::tuple<std::size_t, bool, double, double>, Ending>;

Endings endings_of(const Run& run, const Sweep& sets, const Columns& results) {
    Endings endings;
    for (std::size_t i = 0; i < run.at_hand; ++i) {
        const double number = results[label][i];
        Ending& ending = endings[{member_in(sets, run.sweep, i), number == 0, number, results[kind][i]}];
        if (ending.members++ == 0) ending.example = i;
    }
    return endings;
}

}  // namespace

std::vector<std::string> share_names(const Run& run) {
    auto names = swept_names(pendulums_of(run.sweep));
    names.insert(names.end(), std::begin(column_names), std::end(column_names));
    names.insert(names.end(), {"members", "share", "error"});
    return names;
}

void print_shares(Run& run) {
    const Members members = members_of(run.sweep, run.done, run.at_hand);
    const auto results = results_of(run, members.ensemble, run.strobe);
    const Sweep sets = pendulums_of(run.sweep);
    const std::size_t starts = run.sweep.size / sets.size;
    const auto of_set = static_cast<double>(starts);
    std::size_t printed = 0;
    for (const auto& [key, ending] : endings_of(run, sets, results)) {
        const std::size_t set = std::get<0>(key);
        if (set != printed && run.style.format == Format::text) append(run.writer, "\n");
        printed = set;
        char* at = room(run.writer, run.row_style.leads.size() * field_room);
        at = put_swept(at, run.row_style, sets, set);
        std::size_t field = sets.ranges.size();
        const bool has_orbit = results[label][ending.example] != 0;
        for (const Column column : {label, kind, period, rotation, theta, omega}) {
            const bool is_shared = has_orbit || column <= period;
            at = put_value(at, run.row_style, field++, attractors_columns[column],
                           is_shared ? results[column][ending.example] : std::nan(""));
        }
        for (const double value : {ending.members, ending.members / of_set, share_error(ending.members, of_set)})
            at = put_field(at, run.row_style, field++, value);
        commit(run.writer, put_text(at, run.row_style.end));
    }
}

}  // namespace pendula::cli
