#include "cli/table.hpp"

#include <unistd.h>

#include <cmath>
#include <cstring>
#include <memory>

#include "cli/numbers.hpp"
#include "cli/terminal.hpp"
#include "pendula/angle.hpp"

namespace pendula::cli {

namespace {

constexpr std::size_t block = 256;       // rows computed at a time
constexpr double step_budget = 1 << 20;  // some 30 ms of steps: how long an interruption may have to wait
constexpr std::size_t row_room = 512;    // eight fields of at most 12 bytes of lead and `number_room` of number

/// The assignment's words where it has them.
constexpr std::string_view text_headers[] = {"t",     "angulo", "velocidad", "funcionSinusoidal",
                                             "exact", "error",  "energy",    "turns"};

std::vector<Column> columns_of(const Layout& layout, const std::optional<Analysis>& analysis) {
    if (!layout.columns.empty()) return layout.columns;
    if (!analysis || analysis->regime != Regime::oscillation) return {Column::t, Column::theta, Column::omega};
    return {Column::t, Column::theta, Column::omega, Column::sine};
}

void put_header(Writer& writer, const std::vector<Column>& columns, Format format) {
    std::string header;
    for (const Column column : columns) {
        const auto i = static_cast<std::size_t>(column);
        if (!header.empty()) header += format == Format::csv ? ',' : ' ';
        header += format == Format::csv ? column_names[i] : text_headers[i];
    }
    put(writer, header + '\n');
}

/// The problem as an object of its own, in full precision, so that the run can be repeated from it.
void put_problem(Writer& writer, const Prepared& prepared, std::size_t number) {
    const Problem& problem = prepared.problem;
    const auto method = method_names[static_cast<std::size_t>(problem.method)];
    std::string line = "{\"problem\":" + std::to_string(number) + ",\"method\":\"" + std::string(method) + '"';
    const auto add = [&](std::string_view name, double value) {
        char digits[number_room];
        line.append(",\"").append(name).append("\":").append(digits, put_number(digits, value, full));
    };
    if (problem.method == Method::taylor) add("tolerance", problem.tolerance);
    add("alpha", problem.pendulum.alpha);
    add("beta", problem.pendulum.beta);
    add("torque", problem.pendulum.torque);
    add("drive_amplitude", problem.pendulum.drive_amplitude);
    add("drive_frequency", problem.pendulum.drive_frequency);
    add("drive_phase", problem.pendulum.drive_phase);
    add("theta0", problem.initial.theta);
    add("omega0", problem.initial.omega);
    add("dt", prepared.dt);
    add("every", problem.schedule.every);
    add("until", prepared.until);
    add("rows", problem.schedule.rows);
    if (const auto& analysis = prepared.analysis) {
        const int k = static_cast<int>(analysis->regime);
        add("k", k);
        line.append(",\"regime\":\"").append(regime_names[k + 1]).append("\"");
        add("thetaM", analysis->theta_max);
        add("tau", analysis->tau);
    }
    put(writer, line + "}\n");
}

/// The rows at hand, and the closed form beside them.
struct Block {
    Sample rows[block];
    double t[block], theta[block], omega[block], turns[block];
};

void compute_exact(Block& at_hand, std::size_t n, const Exact& solution) {
    for (std::size_t i = 0; i < n; ++i) at_hand.t[i] = at_hand.rows[i].t;
    at(solution, n, at_hand.t, at_hand.theta, at_hand.omega, at_hand.turns);
}

double field(Column column, const Block& at_hand, std::size_t i, const Trajectory& run) {
    const Sample& row = at_hand.rows[i];
    switch (column) {
        case Column::t:
            return row.t;
        case Column::theta:
            return row.theta;
        case Column::omega:
            return row.omega;
        case Column::sine:
            return sinusoid(run.solution, row.t);
        case Column::exact:
            return at_hand.theta[i];
        case Column::error:
            return wrap(row.theta - at_hand.theta[i]);
        case Column::energy:
            return energy(run.problem.pendulum.alpha, {row.theta, row.omega});
        case Column::turns:
            return row.turns;
    }
    return NAN;
}

void put_rows(Writer& writer, const Block& at_hand, std::size_t n, const Trajectory& run, const std::vector<Column>& columns,
              const RowStyle& style) {
    for (std::size_t i = 0; i < n; ++i) {
        char* end = room(writer, row_room);
        for (std::size_t c = 0; c < columns.size(); ++c) end = put_field(end, style, c, field(columns[c], at_hand, i, run));
        commit(writer, put_text(end, style.end));
    }
}

double fraction_done(const Trajectory& run) {
    const Schedule& schedule = run.problem.schedule;
    return (run.rows_done + run.steps_done / schedule.steps_per_row) / schedule.rows;
}

}  // namespace

RowStyle row_style(const std::vector<std::string_view>& names, Format format, int precision) {
    const bool is_json = format == Format::json;
    RowStyle style{{}, is_json ? "}\n" : "\n", is_json, precision};
    for (const auto name : names) {
        const bool is_first = style.leads.empty();
        if (is_json)
            style.leads.push_back((is_first ? "{\"" : ",\"") + std::string(name) + "\":");
        else
            style.leads.push_back(is_first ? "" : format == Format::csv ? "," : " ");
    }
    return style;
}

std::string json_string(std::string_view text) {
    std::string escaped = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') escaped += '\\';
        escaped += c;
    }
    return escaped + '"';
}

char* put_text(char* at, std::string_view text) {
    return static_cast<char*>(std::memcpy(at, text.data(), text.size())) + text.size();
}

char* put_field(char* at, const RowStyle& style, std::size_t field, double value) {
    at = put_text(at, style.leads[field]);
    return style.is_json && !std::isfinite(value) ? put_text(at, "null") : put_number(at, value, style.precision);
}

void print_table(Writer& writer, const Prepared& prepared, const Layout& layout, std::size_t number) {
    const auto columns = columns_of(layout, prepared.analysis);
    std::vector<std::string_view> names;
    bool needs_exact = false;
    for (const Column column : columns) {
        names.push_back(column_names[static_cast<std::size_t>(column)]);
        needs_exact |= column == Column::exact || column == Column::error;
    }
    const RowStyle style = row_style(names, layout.format, layout.precision);
    if (layout.format == Format::json) {
        put_problem(writer, prepared, number);
    } else {
        if (number > 1) put(writer, "\n\n");  // gnuplot's index
        put_header(writer, columns, layout.format);
    }

    Trajectory run = begin(prepared.problem);
    const auto at_hand = std::make_unique<Block>();
    const bool shares_terminal = isatty(writer.descriptor);
    Progress progress;
    while (!run.is_finished()) {
        const std::size_t n = advance(run, block, at_hand->rows, step_budget);
        if (needs_exact) compute_exact(*at_hand, n, run.solution);
        if (n > 0 && shares_terminal) clear(progress);
        put_rows(writer, *at_hand, n, run, columns, style);
        if (is_interrupted() || is_due(progress)) {
            flush(writer);
            show(progress, fraction_done(run));
        }
    }
    flush(writer);
}

}  // namespace pendula::cli
