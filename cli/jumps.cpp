#include <cmath>

#include "cli/measuring.hpp"

namespace pendula::cli {

std::vector<std::string> jump_names(const Run& run) {
    auto names = swept_names(run.sweep);
    names.insert(names.end() - 1, carry_setting.name);
    const std::string swept = names.back();
    names.pop_back();
    for (const auto& column : jump_columns) names.emplace_back(&column == jump_columns ? swept : column.name);
    return names;
}

void print_jumps(Run& run) {
    const Members members = members_of(run.sweep, run.done, run.at_hand);
    const Parameter& swept = parameters[run.sweep.ranges.back()];
    const Carry carry = run.carries[run.pass];
    const auto results = computed(run, jump_columns, run.strobe, [&](const Results& into, const Control& control) {
        return locate_jumps(members.ensemble, line_of(run), carry, swept, *run.locate, run.strobe, into, control);
    });
    Sweep outer = run.sweep;
    outer.ranges.pop_back();
    for (std::size_t i = 0; i < run.at_hand; ++i) {
        if (std::isnan(results[0][i])) continue;
        char* at = room(run.writer, run.row_style.leads.size() * field_room);
        at = put_swept(at, run.row_style, outer, (run.done + i) / line_of(run));
        std::size_t field = outer.ranges.size();
        at = put_word(at, run.row_style, field++, carry_names[static_cast<std::size_t>(carry)]);
        for (std::size_t column = 0; column < std::size(jump_columns); ++column)
            at = put_value(at, run.row_style, field++, jump_columns[column], results[column][i]);
        commit(run.writer, put_text(at, run.row_style.end));
    }
}

}  // namespace pendula::cli
