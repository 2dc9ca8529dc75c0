// What becomes of many pendulums: one function for all that the core's list of measures has.
#include "measures.hpp"

#include <nanobind/stl/string.h>

#include <deque>

#include "broadcast.hpp"
#include "pendula/carry.hpp"

namespace pendula::python {

namespace {

constexpr auto measure_names = [] {
    std::array<const char*, std::size(measures)> names{};
    for (std::size_t i = 0; i < names.size(); ++i) names[i] = measures[i].name;
    return names;
}();

constexpr auto parameter_names = [] {
    std::array<const char*, parameter_count> names{};
    for (std::size_t i = 0; i < names.size(); ++i) names[i] = parameters[i].name;
    return names;
}();

/// Gives a field of the strobe the value of a keyword. Throws TypeError where the measure has no setting of that name.
void set(Strobe& strobe, const MeasureInfo& info, const std::string& name, nb::handle value) {
    const auto among = [&](std::span<const char* const> names) { return Name{nb::borrow(value)}.among(name.c_str(), names); };
    if (name == "method") {
        strobe.method = strobe_methods[among(strobe_method_names)];
        return;
    }
    if (info.measure == Measure::section && name == "plane") {
        strobe.plane = static_cast<Plane>(among(plane_names));
        return;
    }
    if (info.measure == Measure::section && name == "direction") {
        strobe.direction = static_cast<Direction>(among(direction_names));
        return;
    }
    for (const Setting& setting : settings)
        if (name == setting.name && uses(setting, info.measure)) {
            strobe.*setting.value = Number{Reals(value)}.named(setting.name);
            return;
        }
    throw nb::type_error((name + " is no setting of " + info.name).c_str());
}

using Given = nb::typed<nb::dict, nb::str, nb::object>;

Strobe strobe_of(const MeasureInfo& info, const Given& given) {
    Strobe strobe{.periods = info.periods};
    for (const auto [name, value] : given) set(strobe, info, nb::cast<std::string>(name), value);
    return strobe;
}

/// The arrays of a table of columns.
class Columns {
  public:
    Columns(std::span<const ResultColumn> table, const Members& members, const Strobe& strobe) : table_(table) {
        for (const ResultColumn& column : table) {
            const bool has_rows = column.rows != ResultColumn::Rows::one;
            Output& output = has_rows ? outputs_.emplace_back(members.with_rows(rows_of(column, strobe)))
                                      : outputs_.emplace_back(members.shape());
            spans_.push_back(output.values());
        }
    }

    Results results() const { return Results(spans_); }

    nb::typed<nb::tuple, Array, nb::ellipsis> values() const {
        nb::list values;
        for (std::size_t k = 0; k < outputs_.size(); ++k)
            values.append(table_[k].rows == ResultColumn::Rows::one ? outputs_[k].value() : outputs_[k].rows_last());
        return nb::typed<nb::tuple, Array, nb::ellipsis>(nb::tuple(values));
    }

  private:
    std::span<const ResultColumn> table_;
    std::deque<Output> outputs_;
    std::vector<std::span<double>> spans_;
};

/// The length of the last axis, along which sweeps are carried.
std::size_t line_of(const Members& members) {
    return members.size() == 0 || members.shape().empty() ? 1 : static_cast<std::size_t>(members.shape().back());
}

/// The measure's columns in the shape of the pendulums, rows last.
nb::typed<nb::tuple, Array, nb::ellipsis> measure(const Pendulums& p, const Name& name, const Given& given,
                                                  const std::optional<Name>& carry, const Threads& threads) {
    const MeasureInfo& info = measures[name.among("measure", measure_names)];
    const Strobe strobe = strobe_of(info, given);
    std::optional<Carry> order;
    if (carry) order = static_cast<Carry>(carry->among("carry", carry_names));
    const int thread_count = threads.number();
    const Members members(p);
    // Before there are results: settings that are wrong for every pendulum. The core looks at each.
    if (const auto refusal = check(Pendulum{}, strobe); refusal.reason != Refusal::Reason::unstable) members.require(refusal);

    Columns columns(info.columns, members, strobe);
    members.require(run_long(many, [&](const Proceed& proceed) {
        const Control control{thread_count, proceed};
        if (!order) return pendula::measure(info.measure, members.ensemble(), strobe, columns.results(), control);
        return measure_carried(info.measure, members.ensemble(), line_of(members), *order, strobe, columns.results(), control);
    }));
    return columns.values();
}

/// The columns of jumps in the shape of the pendulums, of which those along the last axis differ in one parameter only.
nb::typed<nb::tuple, Array, nb::ellipsis> jumps(const Pendulums& p, const Name& parameter, const Number& tolerance,
                                                const Given& given, const Name& carry, const Threads& threads) {
    const Parameter& swept = parameters[parameter.among("along", parameter_names)];
    const Strobe strobe = strobe_of(measures[static_cast<int>(Measure::attractors)], given);
    const double most = tolerance.named("jump_tolerance");
    const auto order = static_cast<Carry>(carry.among("carry", carry_names));
    const int thread_count = threads.number();
    const Members members(p);
    Columns columns(jump_columns, members, strobe);
    members.require(run_long(many, [&](const Proceed& proceed) {
        return locate_jumps(members.ensemble(), line_of(members), order, swept, most, strobe, columns.results(),
                            {thread_count, proceed});
    }));
    return columns.values();
}

/// Half the width of the interval that covers a share.
Array share_errors(const Reals& count, const Reals& trials) {
    Broadcast<2, 1> arrays({&count.named("count"), &trials.named("trials")});
    return {elementwise(arrays, [](double n, double all) { return std::array{share_error(n, all)}; })[0]};
}

constexpr const char* kind_doc =
    "What becomes of a motion in the long run. `Kind(k).name` is the word for a value of an array of kinds.";

/// In the order of the enumerators.
constexpr const char* kind_meanings[] = {
    "None of the others up to the budget.",
    "At rest: at the bottom, where torque and gravity balance, or at the top.",
    "On a periodic orbit of the strobe map.",
    "Without drive: a limit cycle that turns over and over.",
    "On an orbit that fills a curve: the exponent is 0 within its error.",
    "The exponent is above three times its error.",
    "Without friction, drive and shaken pivot: the energy stays, and nothing is approached.",
    "Without friction: a torque accelerates the motion for ever.",
    "The motion leaves the range of doubles.",
};
static_assert(std::size(kind_meanings) == std::size(kind_names));

}  // namespace

void define_measures(nb::module_& module) {
    nb::enum_<Kind> kind(module, "Kind", nb::is_arithmetic(), kind_doc);
    for (std::size_t i = 0; i < std::size(kind_names); ++i) kind.value(kind_names[i], static_cast<Kind>(i), kind_meanings[i]);
    define<Name, Given, std::optional<Name>, Threads>(module, "measure", measure, nb::arg("measure"), nb::arg("settings"),
                                                      nb::kw_only(), nb::arg("carry") = nb::none(),
                                                      nb::arg("threads") = nb::none());
    define<Name, Number, Given, Name, Threads>(module, "jumps", jumps, nb::arg("along"), nb::arg("jump_tolerance"),
                                               nb::arg("settings"), nb::kw_only(), nb::arg("carry"),
                                               nb::arg("threads") = nb::none());
    module.def("share_error", share_errors, nb::arg("count"), nb::arg("trials"));
}

}  // namespace pendula::python
