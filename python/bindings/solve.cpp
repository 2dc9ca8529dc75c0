// `solve`: from what people ask for to rows and steps of many pendulums.
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "broadcast.hpp"
#include "pendula/ensemble.hpp"

namespace pendula::python {

namespace {

/// What is asked for of times [s], as far as it is.
struct Asked {
    std::optional<Reals> t, until, every, dt;

    void require() const {
        for (const auto& [name, values] : {std::pair{"until", &until}, std::pair{"every", &every}, std::pair{"dt", &dt}})
            if (*values) require_all(name, (*values)->named(name), Rule::positive);
        if (!t) return;
        if (until || every) throw std::invalid_argument("t cannot be given together with until or every");
        if (t->named("t").shape().size() != 1)
            throw std::invalid_argument("t must have one axis, got shape " + text(t->shape()));
        require_all("t", *t, Rule::finite);
    }
};

/// The same in seconds: what is not given, as the program's factors of each pendulum's characteristic time.
struct InSeconds {
    Reals until, every, dt;
};

Reals or_factor(std::optional<Reals>& given, const Members& members, double Times::* field) {
    if (given) return std::move(*given);
    Output values(members.shape());
    for (std::size_t i = 0; i < members.size(); ++i) {
        const double tau = characteristic_time(pendulum_of(members.ensemble(), i), initial_state_of(members.ensemble(), i));
        values.values()[i] = in_seconds(Durations{}, tau).*field;
    }
    return Reals(values.value());
}

/// (..., 1) of values that vary, so that they broadcast against times.
Reals along_time(const Reals& values, const Shape& shape) {
    if (shape.empty()) return Reals(values.value());
    const auto lengths = nb::steal(PyList_New(0));
    for (const Py_ssize_t length : shape) lengths.attr("append")(length);
    const nb::object all = nb::module_::import_("numpy").attr("broadcast_to")(values.value(), nb::tuple(lengths));
    return Reals(all[nb::make_tuple(nb::ellipsis(), nb::none())]);
}

/// Columns of `EnsembleTimes`, and the times that they stand for.
struct Rows {
    std::vector<double> given;  // times that are not evenly spaced, and their longest step
    Column longest_step = 0.0;
    double first = 0;
    Column every = 1.0;
    std::size_t count = 0;
    std::vector<double> steps_to_first{1}, steps_per_row{1};  // one for all, or one each
    nb::object t;
};

Column column_of(const std::vector<double>& values) { return values.size() == 1 ? Column(values[0]) : Column(values); }

double spacing(double x) { return std::nextafter(x, INFINITY) - x; }

/// Raises ValueError for the first time that is negative or earlier than the one before it.
void require_order(const Reals& t, std::span<const double> times) {
    require_all("t", t, Rule::not_negative);
    const auto last = std::is_sorted_until(times.begin(), times.end());
    if (last == times.end()) return;
    const Refusal refusal{.reason = Refusal::Reason::decreasing, .name = "t", .value = *last, .least = *(last - 1)};
    throw std::invalid_argument(at_place(describe(refusal), &t, t.shape(), static_cast<std::size_t>(last - times.begin())));
}

/// Times as they are given. Those that are evenly spaced, as far as rounding lets them be, become products.
Rows at_times(const Reals& t) {
    const auto n = static_cast<Py_ssize_t>(t.size());
    const auto time = [&](Py_ssize_t j) { return load(t.data() + j * t.step(0, 1)); };
    Rows rows{.first = n > 0 ? time(0) : 0, .count = static_cast<std::size_t>(n)};
    double every = 1;
    // From 0 on, numpy's arange and linspace give multiples of the second time.
    if (n > 1) every = rows.first == 0 ? time(1) : (time(n - 1) - rows.first) / static_cast<double>(n - 1);
    double largest = 0;
    for (Py_ssize_t j = 0; j < n; ++j) largest = std::max(largest, std::abs(time(j)));
    const double slack = 4 * spacing(largest);  // a difference, a quotient, a product and a sum, each rounded once
    bool is_even = rows.first >= 0 && every > 0;
    Output times({n});
    for (Py_ssize_t j = 0; j < n; ++j) {
        const double even = rows.first + static_cast<double>(j) * every;
        times.values()[static_cast<std::size_t>(j)] = even;
        is_even = is_even && std::abs(even - time(j)) <= slack;
    }
    rows.every = every;
    rows.t = times.value();
    if (is_even) return rows;
    for (Py_ssize_t j = 0; j < n; ++j) times.values()[static_cast<std::size_t>(j)] = time(j);
    require_order(t, times.values());
    rows.given.assign(times.values().begin(), times.values().end());
    return rows;
}

/// Equal steps of at most dt to the first row and between rows. Between times that are not evenly spaced the core counts them.
void set_steps(Rows& rows, const Members& members, const Column& dt) {
    rows.longest_step = dt;
    if (!rows.given.empty()) return;
    const std::size_t n = dt.length() == 1 ? 1 : members.size();
    rows.steps_to_first.resize(std::max<std::size_t>(n, 1), 1);
    rows.steps_per_row.resize(std::max<std::size_t>(n, 1), 1);
    for (std::size_t i = 0; i < n; ++i) {
        if (rows.first > 0) rows.steps_to_first[i] = steps_in(rows.first, dt[i]);
        rows.steps_per_row[i] = steps_in(rows.every[i], dt[i]);
    }
}

/// Rows from 0 on, as the program has them, as many for all.
Rows at_intervals(Members& members, const InSeconds& times, bool has_steps) {
    Rows rows{.every = members.column(times.every)};
    const bool counts_steps = has_steps && members.size() > 0;  // the rows of no pendulums are those of any
    const Column until = members.column(times.until), dt = counts_steps ? members.column(times.dt) : rows.every;
    const std::size_t n = rows.every.length() == 1 && until.length() == 1 && dt.length() == 1 ? 1 : members.size();
    rows.steps_per_row.resize(std::max<std::size_t>(n, 1), 1);
    double fewest = INFINITY, most = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const Schedule schedule = make_schedule({dt[i], rows.every[i], until[i]});
        members.require(check(Problem{.schedule = schedule}));
        fewest = std::min(fewest, schedule.rows);
        most = std::max(most, schedule.rows);
        rows.steps_per_row[i] = schedule.steps_per_row;
    }
    if (n > 0 && fewest != most)
        throw std::invalid_argument("until/every must give all pendulums as many rows, got from " +
                                    std::to_string(static_cast<long long>(fewest)) + " to " +
                                    std::to_string(static_cast<long long>(most)));
    rows.count = static_cast<std::size_t>(most);

    Shape shape = times.every.shape();
    std::vector<double> copy;
    const Column every = column_of(times.every, shape, copy);
    const std::size_t size = size_of(shape);
    shape.push_back(static_cast<Py_ssize_t>(rows.count));
    Output t(shape);
    for (std::size_t i = 0; i < size; ++i)
        for (std::size_t j = 0; j < rows.count; ++j) t.values()[i * rows.count + j] = static_cast<double>(j) * every[i];
    rows.t = t.value();
    return rows;
}

using Solved = std::tuple<Array, Array, Array, Array, std::optional<Value>, nb::typed<nb::tuple, Value, nb::ellipsis>>;

/// By the closed form, at any times.
Solved solve_exactly(const Pendulums& p, const Members& members, const nb::object& t, double tolerance) {
    require_each(members, [&](std::size_t i) {
        return check(Problem{.pendulum = pendulum_of(members.ensemble(), i),
                             .initial = initial_state_of(members.ensemble(), i),
                             .method = Method::exact,
                             .schedule = {.every = 1, .rows = 1},
                             .tolerance = tolerance});
    });
    const Shape& shape = members.shape();
    auto [theta, omega, turns] = states(along_time(p[0], shape), along_time(p[1], shape), along_time(p[2], shape), Reals(t));
    return {Array{t}, theta, omega, turns, std::nullopt, values_of(p)};
}

Solved solve_by_steps(const Pendulums& p, const Members& members, Method method, double tolerance, int threads,
                      const Rows& rows, std::optional<Value> dt) {
    const Shape shape = members.with_rows(rows.count);
    Output theta(shape), omega(shape), turns(shape);
    if (rows.count > 0) {
        const EnsembleTimes times{.first = rows.first,
                                  .every = rows.every,
                                  .rows = rows.count,
                                  .steps_to_first = column_of(rows.steps_to_first),
                                  .steps_per_row = column_of(rows.steps_per_row),
                                  .times = rows.given,
                                  .dt = rows.longest_step};
        const EnsembleRows to{theta.values(), omega.values(), turns.values()};
        members.require(run_long(many, [&](const Proceed& proceed) {
            return pendula::solve(members.ensemble(), method, tolerance, times, to, {threads, proceed});
        }));
        warn_of_nan("solve", theta.values(), rows.count);
    }
    return {Array{rows.t}, Array{theta.rows_last()}, Array{omega.rows_last()}, Array{turns.rows_last()}, std::move(dt),
            values_of(p)};
}

Solved solve(const Pendulums& p, std::optional<Reals> t, std::optional<Reals> until, std::optional<Reals> every,
             std::optional<Reals> dt, const Name& method_name, const Number& tolerance_given, const Threads& threads_given) {
    const auto method = static_cast<Method>(method_name.among("method", method_names));
    const double tolerance = tolerance_given.named("tolerance");
    const int threads = threads_given.number();
    Asked asked{std::move(t), std::move(until), std::move(every), std::move(dt)};
    asked.require();
    const Members alone(p);
    alone.require(check(alone.ensemble()));
    if (asked.t && method == Method::exact) return solve_exactly(p, alone, asked.t->value(), tolerance);

    const bool has_steps = takes_steps(method);
    InSeconds times;
    std::vector<NamedReals> others;
    if (has_steps) {
        times.dt = or_factor(asked.dt, alone, &Times::dt);
        others.push_back({"dt", &times.dt});
    }
    if (!asked.t) {
        times.every = or_factor(asked.every, alone, &Times::every);
        times.until = or_factor(asked.until, alone, &Times::until);
        others.insert(others.end(), {{"every", &times.every}, {"until", &times.until}});
    }
    Members members(p, others);
    Rows rows = asked.t ? at_times(*asked.t) : at_intervals(members, times, has_steps);
    if (asked.t && has_steps) set_steps(rows, members, members.column(times.dt));
    if (method == Method::exact) return solve_exactly(p, members, rows.t, tolerance);
    return solve_by_steps(p, members, method, tolerance, threads, rows,
                          has_steps ? std::optional(Value{times.dt.value()}) : std::nullopt);
}

}  // namespace

nb::typed<nb::tuple, Value, nb::ellipsis> values_of(const Pendulums& pendulums) {
    const auto values = nb::steal(PyTuple_New(static_cast<Py_ssize_t>(parameter_count)));
    for (std::size_t k = 0; k < parameter_count; ++k)
        PyTuple_SetItem(values.ptr(), static_cast<Py_ssize_t>(k), pendulums[k].value().release().ptr());
    return nb::borrow<nb::typed<nb::tuple, Value, nb::ellipsis>>(values);
}

void define_solve(nb::module_& module) {
    using OptionalReals = std::optional<Reals>;
    define<OptionalReals, OptionalReals, OptionalReals, OptionalReals, Name, Number, Threads>(
        module, "solve", solve, nb::kw_only(), nb::arg("t") = nb::none(), nb::arg("until") = nb::none(),
        nb::arg("every") = nb::none(), nb::arg("dt") = nb::none(), nb::arg("method") = method_names[0],
        nb::arg("tolerance") = Problem{}.tolerance, nb::arg("threads") = nb::none());
}

}  // namespace pendula::python
