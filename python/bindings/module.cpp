// The extension module: the core's tables as data, its enumerations, and its functions of arrays.
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include "calls.hpp"
#include "measures.hpp"
#include "pendula/carry.hpp"
#include "pendula/version.hpp"
#include "src/messages.hpp"

namespace pendula::python {

namespace {

template <class Values>
nb::tuple tuple_of(const Values& values) {
    nb::list items;
    for (const auto& each : values) items.append(nb::cast(each));
    return nb::tuple(items);
}

/// Structs of the core's tables, whose fields are read only.
void define_tables(nb::module_& module) {
    nb::enum_<Rule>(module, "Rule", "The intervals that parameters lie in.")
        .value("finite", Rule::finite)
        .value("positive", Rule::positive)
        .value("not_negative", Rule::not_negative)
        .value("fraction", Rule::fraction);
    nb::class_<Parameter>(module, "Parameter", "What there is to know of a parameter, or of an initial value.")
        .def_ro("name", &Parameter::name)
        .def_ro("symbol", &Parameter::symbol)
        .def_ro("unit", &Parameter::unit)
        .def_prop_ro("meaning", [](const Parameter& p) { return p.meaning.en; })
        .def_ro("default", &Parameter::otherwise)
        .def_ro("interval", &Parameter::rule)
        .def_ro("is_angle", &Parameter::is_angle)
        .def_prop_ro(
            "is_initial", [](const Parameter& p) { return p.initial != nullptr; }, "Of the start, not of the pendulum.");
    nb::class_<ResultColumn>(module, "ResultColumn", "A column of results.")
        .def_ro("name", &ResultColumn::name)
        .def_ro("symbol", &ResultColumn::symbol)
        .def_ro("unit", &ResultColumn::unit)
        .def_prop_ro("meaning", [](const ResultColumn& c) { return c.meaning.en; })
        .def_prop_ro(
            "has_rows", [](const ResultColumn& c) { return c.rows != ResultColumn::Rows::one; }, "More than one value.")
        .def_prop_ro(
            "is_kind", [](const ResultColumn& c) { return c.words.data() == kind_names; }, "The values are those of Kind.");
    nb::class_<OwnSetting>(module, "Setting", "A number among the settings of a measure.")
        .def_prop_ro("name", [](const OwnSetting& s) { return s.setting->name; })
        .def_prop_ro("unit", [](const OwnSetting& s) { return s.setting->unit; })
        .def_prop_ro("meaning", [](const OwnSetting& s) { return s.setting->meaning.en; })
        .def_ro("default", &OwnSetting::otherwise);
    nb::class_<MeasureInfo>(module, "Measure", "What there is to know of a measure.")
        .def_ro("name", &MeasureInfo::name)
        .def_prop_ro("meaning", [](const MeasureInfo& m) { return m.meaning.en; })
        .def_prop_ro("settings",
                     [](const MeasureInfo& m) {
                         std::vector<OwnSetting> own;
                         for (const Setting& s : settings)
                             if (uses(s, m.measure))
                                 own.push_back({&s, s.value == &Strobe::periods ? m.periods : Strobe{}.*s.value});
                         return nb::typed<nb::tuple, OwnSetting, nb::ellipsis>(tuple_of(own));
                     })
        .def_prop_ro("columns", [](const MeasureInfo& m) {
            return nb::typed<nb::tuple, ResultColumn, nb::ellipsis>(tuple_of(m.columns));
        });
    module.attr("parameters") = tuple_of(parameters);
    module.attr("measures") = tuple_of(measures);
    module.attr("jump_columns") = tuple_of(jump_columns);
    module.attr("method_names") = tuple_of(method_names);
    module.attr("strobe_method_names") = tuple_of(strobe_method_names);
    module.attr("plane_names") = tuple_of(plane_names);
    module.attr("direction_names") = tuple_of(direction_names);
    module.attr("carry_names") = tuple_of(carry_names);
}

void define_programs_part(nb::module_& module) {
    nb::enum_<Status>(module, "Status", nb::is_arithmetic(), "How a program ends.")
        .value("done", Status::done)
        .value("bad_data", Status::bad_data)
        .value("bad_usage", Status::bad_usage)
        .value("not_written", Status::not_written)
        .value("interrupted", Status::interrupted);
    module.def(
        "language_of",
        [](const std::vector<std::string>& arguments) {
            const std::vector<std::string_view> views(arguments.begin(), arguments.end());
            return language_of(views) == Language::es ? "es" : "en";
        },
        nb::arg("arguments"), "The language of messages, as the program chooses it.");
}

void define_parameters(nb::module_& module) {
    define<>(
        module, "as_parameters",
        [](const Pendulums& pendulums) {
            const Members members(pendulums);
            return values_of(pendulums);
        },
        "What people pass, made float or float64 and known to broadcast.");
    define<>(
        module, "are_conservative",
        [](const Pendulums& pendulums) {
            const Members members(pendulums);
            for (std::size_t i = 0; i < members.size(); ++i)
                if (!is_conservative(pendulum_of(members.ensemble(), i))) return false;
            return true;
        },
        "Whether none of them has friction or forcing.");
}

}  // namespace

}  // namespace pendula::python

NB_MODULE(_core, module) {
    using namespace pendula::python;
    if (!pendula::instruction_set())
        throw nb::import_error(describe(pendula::Refusal{.reason = pendula::Refusal::Reason::instruction_set}).c_str());
    nb::set_leak_warnings(false);  // of what users still hold when the interpreter ends
    module.attr("version") = pendula::version;
    define_tables(module);
    define_programs_part(module);
    define_parameters(module);
    define_closed_form(module);
    define_solve(module);
    define_crossings(module);
    define_measures(module);
    define_replay(module);
}
