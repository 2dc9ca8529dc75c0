#include <unistd.h>

#include "cli/commands.hpp"
#include "cli/reading.hpp"
#include "cli/terminal.hpp"

namespace pendula::cli {

namespace {

/// Says how many terms the series needs before it sums them; refuses more than the library sums.
Analysis analyze_by(double epsilon, const Pendulum& pendulum, State initial, std::string_view place) {
    if (epsilon == 0) return analyze(pendulum.alpha, initial);
    const double terms = series_terms(pendulum.alpha, initial, epsilon);
    if (terms > series_terms_limit)
        throw Failure{
            Status::bad_data,
            std::string(place) + say({"the series needs {0} terms, more than {1}; ask for a larger --epsilon, or leave "
                                      "--method series out",
                                      "la serie necesita {0} términos, más de {1}; pide un --epsilon mayor, o quita "
                                      "--method series"},
                                     {shown(terms), shown(series_terms_limit)})};
    tell(std::string(place) + say({"the series needs {0} terms", "la serie necesita {0} términos"}, {shown(terms)}));
    return analyze_by_series(pendulum.alpha, initial, epsilon);
}

void begin_output(Writer& writer, const Layout& chosen) {
    const bool is_first = writer.descriptor < 0;
    open(writer);
    if (is_first && chosen.format == Format::csv) put(writer, "k,thetaM,tau\n");
}

void put_analysis(Writer& writer, const Analysis& analysis, const Layout& chosen) {
    const RowStyle style = row_style({"k", "thetaM", "tau"}, chosen.format, chosen.precision);
    const int k = static_cast<int>(analysis.regime);
    char row[256];
    char* end = put_field(row, style, 0, k);
    if (chosen.format == Format::json) end = put_text(end, ",\"regime\":\"" + std::string(regime_names[k + 1]) + '"');
    end = put_field(end, style, 1, analysis.theta_max);
    end = put_field(end, style, 2, analysis.tau);
    put(writer, {row, static_cast<std::size_t>(put_text(end, style.end) - row)});
}

/// A bad line's message in its place.
void put_error(Writer& writer, const std::string& message, Format format) {
    put(writer, format == Format::json ? "{\"error\":" + json_string(message) + "}\n" : "ERROR: " + message + '\n');
}

Status analyze_input(Writer& writer, const Layout& chosen, double epsilon) {
    if (isatty(STDIN_FILENO))
        tell(say({"type lines θ0 r|s ω0 r|s α, as 90 s 0 r 1 (r: radians, s: degrees), and end with Ctrl-D",
                  "escribe líneas θ0 r|s ω0 r|s α, como 90 s 0 r 1 (r: radianes, s: grados), y termina con Ctrl-D"}));
    Status status = Status::done;
    Tokens tokens;
    while (const auto line = read_line(tokens)) {
        begin_output(writer, chosen);
        try {
            if (!line->wrong.empty()) throw Failure{Status::bad_data, line->place + line->wrong};
            put_analysis(writer, analyze_by(epsilon, line->pendulum, line->initial, line->place), chosen);
        } catch (const Failure& failure) {
            if (failure.status != Status::bad_data) throw;
            put_error(writer, failure.message, chosen.format);
            status = Status::bad_data;
        }
        if (is_interrupted() || !has_line(tokens)) flush(writer);
    }
    return status;
}

}  // namespace

Status analyze(const Options& options) {
    const Layout chosen = layout(options);
    const double epsilon = series_epsilon(options);
    Writer writer{.path = output_path(options)};
    Status status = Status::done;
    if (states_pendulum(options)) {
        const Analysis analysis = analyze_by(epsilon, pendulum(options), initial_state(options), "");
        begin_output(writer, chosen);
        put_analysis(writer, analysis, chosen);
    } else {
        status = analyze_input(writer, chosen, epsilon);
    }
    close(writer);
    return status;
}

}  // namespace pendula::cli
