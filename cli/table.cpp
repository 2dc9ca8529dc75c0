#include "cli/table.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "cli/terminal.hpp"
#include "pendula/angle.hpp"

namespace pendula::cli {

namespace {

constexpr std::size_t block = 256;       // rows computed at a time
constexpr double step_budget = 1 << 20;  // some 30 ms of steps: how long an interruption may have to wait
constexpr std::size_t row_room = std::size(table_columns) * field_room;

bool is_of_closed_form(TableColumn column) {
    return column == TableColumn::sine || column == TableColumn::exact || column == TableColumn::error;
}

std::vector<TableColumn> columns_of(const Layout& layout, const std::optional<Analysis>& analysis) {
    if (!layout.columns.empty()) return layout.columns;
    if (!analysis || analysis->regime != Regime::oscillation) return {TableColumn::t, TableColumn::theta, TableColumn::omega};
    return {TableColumn::t, TableColumn::theta, TableColumn::omega, TableColumn::sine};
}

/// The problem as an object of its own, in full precision, so that the run can be repeated from it.
void append_problem(Writer& writer, const Prepared& prepared, std::size_t number) {
    Problem problem = prepared.problem;
    std::string line = "{\"problem\":" + std::to_string(number);
    add_member(line, "method", json_string(method_names[static_cast<std::size_t>(problem.method)]));
    if (problem.method == Method::taylor) add_number(line, "tolerance", problem.tolerance);
    for (const auto& parameter : parameters)
        add_number(line, parameter.name, value_of(parameter, problem.pendulum, problem.initial));
    if (takes_steps(problem.method)) add_number(line, "dt", prepared.times.dt);
    add_number(line, "every", problem.schedule.every);
    add_number(line, "until", prepared.times.until);
    add_number(line, "rows", problem.schedule.rows);
    if (const auto& analysis = prepared.analysis) {
        const int k = static_cast<int>(analysis->regime);
        add_number(line, "k", k);
        add_member(line, "regime", json_string(regime_names[k + 1]));
        add_number(line, "thetaM", analysis->theta_max);
        add_number(line, "tau", analysis->tau);
    }
    append(writer, line + "}\n");
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

double field(TableColumn column, const Block& at_hand, std::size_t i, const Trajectory& run) {
    const Sample& row = at_hand.rows[i];
    switch (column) {
        case TableColumn::t:
            return row.t;
        case TableColumn::theta:
            return row.theta;
        case TableColumn::omega:
            return row.omega;
        case TableColumn::sine:
            return sinusoid(run.solution, row.t);
        case TableColumn::exact:
            return at_hand.theta[i];
        case TableColumn::error:
            return wrap(row.theta - at_hand.theta[i]);
        case TableColumn::energy:
            return energy(run.problem.pendulum.alpha, {row.theta, row.omega});
        case TableColumn::turns:
            return row.turns;
    }
    return NAN;
}

/// Whether a row's columns are all numbers: the motion is within the doubles, and the closed form at its time, where it is
/// printed.
bool is_finite(const Sample& row, double latest) {
    return std::isfinite(row.theta) && std::isfinite(row.omega) && row.t <= latest;
}

/// Appends the rows up to the first that is not finite, and returns how many.
std::size_t append_rows(Writer& writer, const Block& at_hand, std::size_t n, const Trajectory& run,
                        const std::vector<TableColumn>& columns, const RowStyle& style) {
    const double latest = std::ranges::any_of(columns, is_of_closed_form) ? latest_time(run.solution) : INFINITY;
    for (std::size_t i = 0; i < n; ++i) {
        if (!is_finite(at_hand.rows[i], latest)) return i;
        char* end = room(writer, row_room);
        for (std::size_t c = 0; c < columns.size(); ++c) end = put_field(end, style, c, field(columns[c], at_hand, i, run));
        commit(writer, put_text(end, style.end));
    }
    return n;
}

/// Ends a run whose next row, number `row` from 0, is not finite.
[[noreturn]] void refuse_infinite(Writer& writer, const Prepared& prepared, double row) {
    flush(writer);
    throw Failure{
        Status::bad_data,
        prepared.source.place +
            say({"from row {0} on, t = {1} s, the motion is out of the range of doubles; the rows before it are printed",
                 "desde la fila {0}, t = {1} s, el movimiento se sale del rango de double; las filas anteriores están "
                 "escritas"},
                {shown(row + 1, full), shown(prepared.problem.schedule.time_of(row))})};
}

double fraction_done(const Trajectory& run) {
    const Schedule& schedule = run.problem.schedule;
    return (run.rows_done + run.steps_done / schedule.steps_per_row) / schedule.rows;
}

}  // namespace

void require_columns(const Prepared& prepared, const Layout& layout) {
    Problem problem = prepared.problem;
    problem.method = Method::exact;
    for (const TableColumn column : layout.columns)
        if (is_of_closed_form(column))
            if (const auto refusal = check(problem))
                refuse(prepared.source,
                       say(refusal, "exact (--columns " + std::string(table_columns[static_cast<int>(column)].name) + ')'));
}

void print_table(Writer& writer, const Prepared& prepared, const Layout& layout, std::size_t number) {
    const auto columns = columns_of(layout, prepared.analysis);
    const Format format = layout.style.format;
    std::vector<std::string> names;
    bool needs_exact = false;
    for (const TableColumn column : columns) {
        const auto i = static_cast<std::size_t>(column);
        names.push_back(format == Format::text ? table_columns[i].header : table_columns[i].name);
        needs_exact |= column == TableColumn::exact || column == TableColumn::error;
    }
    const RowStyle style = row_style(names, layout.style);
    if (format == Format::json) {
        append_problem(writer, prepared, number);
    } else {
        if (number > 1) append(writer, "\n\n");  // gnuplot's index
        append(writer, header_line(names, format));
    }
    if (!layout.has_rows) return flush(writer);

    Trajectory run = begin(prepared.problem);
    const auto at_hand = std::make_unique<Block>();
    const bool shares_terminal = isatty(writer.descriptor);
    ProgressLine progress;
    while (!run.is_finished()) {
        const std::size_t n = advance(run, at_hand->rows, step_budget);
        if (needs_exact) compute_exact(*at_hand, n, run.solution);
        if (n > 0 && shares_terminal) clear(progress);
        if (const std::size_t finite = append_rows(writer, *at_hand, n, run, columns, style); finite < n)
            refuse_infinite(writer, prepared, run.rows_done - static_cast<double>(n - finite));
        if (is_interrupted() || is_due(progress)) {
            flush(writer);
            show(progress, fraction_done(run));
        }
    }
    flush(writer);
}

}  // namespace pendula::cli
