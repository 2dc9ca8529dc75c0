#include "cli/rows.hpp"

namespace pendula::cli {

namespace {

std::string_view separator(Format format) { return format == Format::text ? " " : ","; }

}  // namespace

RowStyle row_style(const std::vector<std::string>& names, const Style& style) {
    const bool is_json = style.format == Format::json;
    RowStyle made{{}, is_json ? "}\n" : "\n", is_json, style.precision};
    for (const auto& name : names) {
        std::string lead(made.leads.empty() ? (is_json ? "{" : "") : separator(style.format));
        if (is_json) lead += json_string(name) + ':';
        Lead& kept = made.leads.emplace_back();
        kept.size = lead.copy(kept.text.data(), kept.text.size());
    }
    return made;
}

std::string header_line(const std::vector<std::string>& names, Format format) {
    std::string line;
    for (const auto& name : names) line.append(line.empty() ? "" : separator(format)).append(name);
    return line + '\n';
}

std::string json_string(std::string_view text) {
    std::string escaped = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') escaped += '\\';
        escaped += c;
    }
    return escaped + '"';
}

void add_member(std::string& object, std::string_view name, std::string_view text) {
    object.append(",").append(json_string(name)).append(":").append(text);
}

void add_number(std::string& object, std::string_view name, double value) { add_member(object, name, shown(value, full)); }

}  // namespace pendula::cli
