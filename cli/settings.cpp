#include "cli/settings.hpp"

namespace pendula::cli {

namespace {

double read_setting(const Setting& setting, const Options& options, std::string_view unit, double otherwise) {
    const std::string name = option_of(setting.name);
    if (!setting.is_angle) return number_of(options, name, Rule::finite, otherwise);
    return angle_of(options, name, unit, otherwise);
}

/// Refuses what does not go with the surface of a section.
void require_surface(const Options& options, const Strobe& strobe) {
    if (strobe.plane != Plane::strobe) {
        if (strobe.method == Method::rk4)
            throw bad_usage({"{0} needs --method taylor, which finds the crossings between its steps",
                             "{0} necesita --method taylor, que halla los cruces entre sus pasos"},
                            {"--plane"});
        return;
    }
    for (const auto* name : {"--level", "--direction", "--budget"})
        if (is_given(options, name))
            throw bad_usage({"{0} is for a section by a plane: it needs --plane theta or omega",
                             "{0} es para una sección por un plano: necesita --plane theta u omega"},
                            {name});
}

/// Whether a measure with these settings uses the setting.
bool is_used(const Setting& setting, const MeasureInfo& info, const Strobe& strobe) {
    const auto value = setting.value;
    if (!is_option(setting) || !(setting.measures & bits_of({info.measure}))) return false;
    if (value == &Strobe::steps_per_period) return strobe.method == Method::rk4;
    if (value == &Strobe::tolerance) return strobe.method == Method::taylor;
    const bool is_of_planes = value == &Strobe::level || (value == &Strobe::budget && info.measure == Measure::section);
    return !is_of_planes || strobe.plane != Plane::strobe;
}

}  // namespace

Strobe read_strobe(const MeasureInfo& info, const Options& options) {
    Strobe strobe;
    strobe.periods = info.periods;
    strobe.method = method_of(options, strobe_method_names);
    strobe.plane = static_cast<Plane>(choice(options, option_of(plane_setting.name), plane_names));
    strobe.direction = static_cast<Direction>(choice(options, option_of(direction_setting.name), direction_names));
    if (info.measure == Measure::section) require_surface(options, strobe);
    for (const auto& setting : settings) {
        if (!is_option(setting) || !(setting.measures & bits_of({info.measure}))) continue;
        const bool is_of_omega = setting.value == &Strobe::level && strobe.plane == Plane::omega;
        strobe.*setting.value = read_setting(setting, options, is_of_omega ? "rad/s" : "rad", strobe.*setting.value);
    }
    return strobe;
}

void add_settings(std::string& object, const MeasureInfo& info, const Strobe& strobe) {
    add_member(object, "method", json_string(method_names[static_cast<std::size_t>(strobe.method)]));
    if (strobe.plane != Plane::strobe) {
        add_member(object, plane_setting.name, json_string(plane_names[static_cast<std::size_t>(strobe.plane)]));
        add_member(object, direction_setting.name, json_string(direction_names[static_cast<std::size_t>(strobe.direction)]));
    }
    for (const auto& setting : settings)
        if (is_used(setting, info, strobe)) add_number(object, setting.name, strobe.*setting.value);
}

}  // namespace pendula::cli
