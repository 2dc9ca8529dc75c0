// The settings of measures as options: each command has those that its measure uses.
#pragma once

#include "cli/options.hpp"
#include "pendula/carry.hpp"

namespace pendula::cli {

/// The commands that take a setting.
constexpr unsigned takers(const Setting& setting) { return setting.measures * first_measure_command; }
inline constexpr unsigned measure_commands = all_measures * first_measure_command;
inline constexpr unsigned section_command = bits_of({Measure::section}) * first_measure_command;
inline constexpr unsigned attractors_command = bits_of({Measure::attractors}) * first_measure_command;
inline constexpr unsigned settling_commands = settling_measures * first_measure_command;

/// Whether a setting is an option: all but the length of the history of lyapunov, which the program does not print.
constexpr bool is_option(const Setting& setting) { return setting.value != &Strobe::history_rows; }

/// Whether the program prints a column only with --details; the history of lyapunov it never does.
constexpr bool is_detail(const ResultColumn& column) { return column.is_detail && column.rows != ResultColumn::Rows::history; }
inline constexpr unsigned detail_commands = [] {
    unsigned commands = 0;
    for (const auto& info : measures)
        for (const auto& column : info.columns)
            if (is_detail(column)) commands |= command_of(info);
    return commands;
}();

/// Settings that are words, with their lists in the order of the enumerators.
struct WordSetting {
    const char* name;
    std::span<const char* const> words;
    Words meaning;
    unsigned commands;
};
inline constexpr const char* strobe_method_names[] = {method_names[static_cast<int>(Method::taylor)],
                                                      method_names[static_cast<int>(Method::rk4)]};
inline constexpr const char* carried_names[] = {carry_names[0], carry_names[1], "both"};
inline constexpr WordSetting plane_setting{
    "plane", plane_names, {"the surface of section", "la superficie de sección"}, section_command};
inline constexpr WordSetting direction_setting{
    "direction", direction_names, {"in which the plane is crossed", "en que se cruza el plano"}, section_command};
inline constexpr WordSetting carry_setting{"carry",
                                           carried_names,
                                           {"along the last range, each starts where the one before ended",
                                            "en el último rango, cada uno empieza donde acabó el anterior"},
                                           settling_commands | section_command};

/// The settings of a measure: those of the library, but for what is given. Throws Failure with Status::bad_usage.
Strobe read_strobe(const MeasureInfo& info, const Options& options);

/// The members of a json object that say with which settings a measure was made.
void add_settings(std::string& object, const MeasureInfo& info, const Strobe& strobe);

}  // namespace pendula::cli
