#include "cli/measuring.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>

namespace pendula::cli {

namespace {

/// Why results are nan, in the order of the kinds; empty for kinds whose results are numbers.
constexpr Words causes[] = {
    {"not settled within --budget", "sin asentarse en --budget"},
    {},
    {},
    {},
    {},
    {},
    {},
    {"a torque without friction accelerates them for ever", "un par sin rozamiento los acelera para siempre"},
    {"their motion leaves the range of doubles", "su movimiento se sale del rango de double"},
};
static_assert(std::size(causes) == std::size(kind_names));

/// Why results of a measure without kinds are nan.
std::string cause_without_kind(const Run& run) {
    if (run.info.measure == Measure::orbit)
        return say({"Newton's method finds no periodic orbit from their initial states",
                    "el método de Newton no encuentra una órbita periódica desde sus estados iniciales"});
    if (run.strobe.plane == Plane::strobe)
        return say({"their motion leaves the range of doubles", "su movimiento se sale del rango de double"});
    return say({"they cross the plane fewer than {0} times in {1} periods (--budget)",
                "cruzan el plano menos de {0} veces en {1} periodos (--budget)"},
               {shown(run.strobe.periods), shown(run.strobe.budget)});
}

std::string json_head(const Run& run) {
    std::string line = "{\"measure\":" + json_string(run.info.name);
    add_settings(line, run.info, run.strobe);
    if (!run.carries.empty())
        add_member(line, "carry", json_string(carried_names[run.carries.size() == 2 ? 2 : static_cast<int>(run.carries[0])]));
    if (run.locate) add_number(line, "locate", *run.locate);
    for (std::size_t i = 0; i < swept_count; ++i) {
        const Parameter& parameter = swept_parameter(i);
        const Range& range = run.sweep.values[i];
        if (!has_value(run.sweep, i)) continue;
        if (!range.is_range) {
            add_number(line, parameter.name, range.first);
            continue;
        }
        std::string values = "[";
        values.append(shown(range.typed_first, full)).append(",").append(shown(range.typed_last, full)).append(",");
        values.append(std::to_string(range.count)).append("]");
        add_member(line, swept_name(run.sweep, i), values);
    }
    return line + "}\n";
}

}  // namespace

std::size_t line_of(const Run& run) { return run.sweep.values[run.sweep.ranges.back()].count; }

std::size_t total_of(const Run& run) { return run.sweep.size * std::max<std::size_t>(1, run.carries.size()); }

Columns computed(Run& run, std::span<const ResultColumn> infos, const Strobe& strobe,
                 const std::function<Outcome(const Results&, const Control&)>& call) {
    Columns columns;
    std::vector<std::span<double>> spans;
    for (const auto& column : infos) columns.emplace_back(rows_of(column, strobe) * run.at_hand);
    for (auto& column : columns) spans.emplace_back(column);
    const auto proceed = [&run](double fraction) {
        const double members =
            static_cast<double>(run.pass * run.sweep.size + run.done) + fraction * static_cast<double>(run.at_hand);
        return show_and_go_on(run.progress, members / static_cast<double>(total_of(run)));
    };
    const auto outcome = call(std::span<const std::span<double>>(spans), {.threads = run.threads, .proceed = proceed});
    if (outcome.kind == Outcome::Kind::stopped) flush(run.writer);
    if (outcome.refusal) throw Failure{Status::bad_usage, say(outcome.refusal, name_in_options(run.sweep, outcome.refusal))};
    if (isatty(run.writer.descriptor)) clear(run.progress);
    return columns;
}

Columns results_of(Run& run, const Ensemble& ensemble, const Strobe& strobe) {
    return computed(run, run.info.columns, strobe, [&](const Results& results, const Control& control) {
        if (run.carries.empty()) return measure(run.info.measure, ensemble, strobe, results, control);
        return measure_carried(run.info.measure, ensemble, line_of(run), run.carries[run.pass], strobe, results, control);
    });
}

char* put_value(char* at, const RowStyle& style, std::size_t field, const ResultColumn& column, double value) {
    if (value >= 0 && value < static_cast<double>(column.words.size()))
        return put_word(at, style, field, column.words[static_cast<std::size_t>(value)]);
    return put_field(at, style, field, value);
}

void count_gaps(Run& run, const Columns& results, std::size_t row) {
    const auto kinds = std::ranges::find(run.info.columns, kind_names, [](const auto& column) { return column.words.data(); });
    for (std::size_t i = 0; i < run.at_hand; ++i) {
        const auto is_gap = [&](std::size_t column) { return std::isnan(results[column][row * run.at_hand + i]); };
        if (std::ranges::none_of(run.printed, is_gap)) continue;
        if (kinds == run.info.columns.end())
            ++run.gaps_of_no_kind;
        else
            ++run.gaps[static_cast<std::size_t>(results[static_cast<std::size_t>(kinds - run.info.columns.begin())][i])];
    }
}

void tell_gaps(const Run& run) {
    std::size_t count = run.gaps_of_no_kind;
    std::vector<std::string> whys;
    if (count > 0) whys.push_back(cause_without_kind(run));
    for (std::size_t kind = 0; kind < run.gaps.size(); ++kind) {
        if (run.gaps[kind] == 0) continue;
        count += run.gaps[kind];
        std::string why = std::to_string(run.gaps[kind]) + ' ' + kind_names[kind];
        if (causes[kind].en) why += " (" + say(causes[kind]) + ')';
        whys.push_back(why);
    }
    if (count > 0)
        throw Failure{Status::bad_data, say({"results are nan for {0} of {1} pendulums: {2}",
                                             "los resultados son nan para {0} de {1} péndulos: {2}"},
                                            {std::to_string(count), std::to_string(total_of(run)), joined(whys)})};
}

void start_output(Run& run, const std::vector<std::string>& names) {
    run.row_style = row_style(names, run.style);
    open(run.writer);
    if (run.style.format == Format::json) return append(run.writer, json_head(run));
    append(run.writer, (run.style.format == Format::text ? "# " : "") + header_line(names, run.style.format));
}

}  // namespace pendula::cli
