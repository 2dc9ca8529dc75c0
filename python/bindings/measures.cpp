// What becomes of many pendulums: one function for all that the core's list of measures has.
#include <deque>

#include "calls.hpp"
#include "pendula/measure.hpp"

namespace pendula::python {

namespace {

constexpr auto measure_names = [] {
    std::array<const char*, std::size(measures)> names{};
    for (std::size_t i = 0; i < names.size(); ++i) names[i] = measures[i].name;
    return names;
}();

/// The measure's columns in the shape of the pendulums, rows last.
nb::typed<nb::tuple, Array, nb::ellipsis> measure(const Pendulums& p, const Name& name, const Number& transient,
                                                  const std::optional<Number>& periods, const Number& steps_per_period,
                                                  const Name& method, const Number& tolerance, const Number& rows,
                                                  const Number& match, const Threads& threads) {
    const MeasureInfo& info = measures[name.among("measure", measure_names)];
    const Strobe strobe{.transient = transient.named("transient"),
                        .periods = periods ? periods->named("periods") : info.periods,
                        .steps_per_period = steps_per_period.named("steps_per_period"),
                        .method = static_cast<Method>(method.among("method", method_names)),
                        .tolerance = tolerance.named("tolerance"),
                        .history_rows = rows.named("rows"),
                        .match = match.named("match")};
    const int thread_count = threads.number();
    const Members members(p);
    // Before there are results: settings that are wrong for every pendulum. The core looks at each.
    if (const auto refusal = check(Pendulum{}, strobe); refusal.reason != Refusal::Reason::unstable) members.require(refusal);

    std::deque<Output> outputs;
    std::vector<std::span<double>> columns;
    for (const ResultColumn& column : info.columns) {
        const bool has_rows = column.rows != ResultColumn::Rows::one;
        Output& output =
            has_rows ? outputs.emplace_back(members.with_rows(rows_of(column, strobe))) : outputs.emplace_back(members.shape());
        columns.push_back(output.values());
    }
    members.require(run_long(many, [&](const Proceed& proceed) {
        return pendula::measure(info.measure, members.ensemble(), strobe, Results(columns), {thread_count, proceed});
    }));
    const std::size_t told = info.compares_members ? columns.size() - 1 : 0;  // labels are 0 where there is no orbit
    warn_of_nan(info.name, columns[told], rows_of(info.columns[told], strobe));

    nb::list values;
    for (std::size_t k = 0; k < outputs.size(); ++k)
        values.append(info.columns[k].rows == ResultColumn::Rows::one ? outputs[k].value() : outputs[k].rows_last());
    return nb::typed<nb::tuple, Array, nb::ellipsis>(nb::tuple(values));
}

}  // namespace

void define_measures(nb::module_& module) {
    constexpr Strobe strobe;
    define<Name, Number, std::optional<Number>, Number, Name, Number, Number, Number, Threads>(
        module, "measure", measure, nb::arg("measure"), nb::kw_only(), nb::arg("transient") = strobe.transient,
        nb::arg("periods") = nb::none(), nb::arg("steps_per_period") = strobe.steps_per_period,
        nb::arg("method") = method_names[static_cast<int>(strobe.method)], nb::arg("tolerance") = strobe.tolerance,
        nb::arg("rows") = strobe.history_rows, nb::arg("match") = strobe.match, nb::arg("threads") = nb::none());
}

}  // namespace pendula::python
