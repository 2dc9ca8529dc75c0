#include <unistd.h>

#include <cmath>

#include "cli/commands.hpp"
#include "cli/reading.hpp"
#include "cli/sweep.hpp"
#include "cli/terminal.hpp"
#include "cli/writing.hpp"
#include "pendula/angle.hpp"

namespace pendula::cli {

namespace {

/// How analyses are computed and printed.
struct Analyzer {
    double epsilon;  ///< of the series; 0 for the arithmetic-geometric mean
    Style style;
    Writer writer;
};

double read_epsilon(const Options& options) {
    constexpr const char* words[] = {"agm", "series"};
    if (is_given(options, "--tau"))
        for (const auto* name : {"--method", "--epsilon"}) refuse_both(options, "--tau", name);
    if (choice(options, "--method", words) == 1) return number_of(options, "--epsilon", Rule::fraction, 1e-7);
    if (is_given(options, "--epsilon"))
        throw bad_usage({"{0} does not go with --method {1}", "{0} no va con --method {1}"}, {"--epsilon", "agm"});
    return 0;
}

/// Says how many terms the series needs before they are summed.
Analysis analyze_one(Analyzer& analyzer, const Pendulum& pendulum, State initial, const Source& source, Proceed proceed) {
    if (analyzer.epsilon == 0) return analyze(pendulum.alpha, initial);
    const double terms = series_terms(pendulum.alpha, initial, analyzer.epsilon);
    if (terms <= series_terms_limit)
        tell(source.place + say({"the series needs {0} terms", "la serie necesita {0} términos"}, {shown(terms)}));
    Analysis analysis;
    const auto outcome = analyze_by_series(pendulum.alpha, initial, analyzer.epsilon, analysis, {.proceed = proceed});
    if (outcome.kind == Outcome::Kind::stopped) {
        if (analyzer.writer.descriptor >= 0) flush(analyzer.writer);
        throw Failure{Status::interrupted, {}};
    }
    if (outcome.refusal)
        refuse(source, say(outcome.refusal, "") + say({"; ask for a larger --epsilon, or leave --method series out",
                                                       "; pide un --epsilon mayor, o quita --method series"}));
    return analysis;
}

/// The columns of analyses behind those of the ranges.
std::vector<std::string> columns_behind(std::vector<std::string> names) {
    names.insert(names.end(), {"k", "thetaM", "tau"});
    return names;
}

/// Opens the output, the first time, once there is something to be written.
void open_output(Analyzer& analyzer, const std::vector<std::string>& names) {
    if (analyzer.writer.descriptor >= 0) return;
    open(analyzer.writer);
    if (analyzer.style.format == Format::csv) append(analyzer.writer, header_line(names, Format::csv));
}

/// The three fields of an analysis behind those of the ranges.
char* put_analysis(char* at, const RowStyle& style, const Analysis& analysis) {
    const std::size_t field = style.leads.size() - 3;
    const int k = static_cast<int>(analysis.regime);
    at = put_field(at, style, field, k);
    if (style.is_json) at = put_text(at, ",\"regime\":" + json_string(regime_names[k + 1]));
    at = put_field(at, style, field + 1, analysis.theta_max);
    return put_text(put_field(at, style, field + 2, analysis.tau), style.end);
}

/// Refuses a period that no amplitude has.
void require_periods(const Sweep& sweep) {
    for (std::size_t member = 0; sweep.has_tau && member < sweep.size; ++member) {
        if (is_interrupted()) throw Failure{Status::interrupted, {}};
        const double alpha = pendulum_of(sweep, member).alpha;
        if (!std::isnan(initial_state_of(sweep, member).theta)) continue;
        throw bad_usage({"{0}--tau must be at least {1} s, the period 2π/√α of small swings",
                         "{0}--tau debe ser al menos {1} s, el periodo 2π/√α de las oscilaciones pequeñas"},
                        {place_of(sweep, member), shown(2 * pi / std::sqrt(alpha), full)});
    }
}

/// The analysis of a member: of its initial state, or of the amplitude with its period.
Analysis analyze_member(Analyzer& analyzer, const Sweep& sweep, std::size_t member, Proceed proceed) {
    const State initial = initial_state_of(sweep, member);
    if (sweep.has_tau) return {Regime::oscillation, initial.theta, tau_of(sweep, member)};
    return analyze_one(analyzer, pendulum_of(sweep, member), initial, {}, proceed);
}

void analyze_sweep(Analyzer& analyzer, const Sweep& sweep) {
    constexpr std::size_t row_room = (swept_count + 4) * field_room;
    require_each(sweep, [](const Pendulum& pendulum) { return check(pendulum); });
    require_periods(sweep);
    const auto names = columns_behind(swept_names(sweep));
    const RowStyle style = row_style(names, analyzer.style);
    std::size_t member = 0;
    ProgressLine progress;
    const auto proceed = [&](double fraction) {
        return show_and_go_on(progress, (static_cast<double>(member) + fraction) / static_cast<double>(sweep.size));
    };
    for (; member < sweep.size; ++member) {
        const Analysis analysis = analyze_member(analyzer, sweep, member, proceed);
        open_output(analyzer, names);
        char* const at = room(analyzer.writer, row_room);
        commit(analyzer.writer, put_analysis(put_swept(at, style, sweep, member), style, analysis));
        if (analyzer.style.format == Format::text) append(analyzer.writer, lines_behind(sweep, member));
        if (is_interrupted()) flush(analyzer.writer);
    }
}

/// A bad line's message in its place.
void append_error(Analyzer& analyzer, const std::string& message) {
    append(analyzer.writer,
           analyzer.style.format == Format::json ? "{\"error\":" + json_string(message) + "}\n" : "ERROR: " + message + '\n');
}

Status analyze_lines(Analyzer& analyzer) {
    if (isatty(STDIN_FILENO))
        tell(say({"type lines θ0 r|s ω0 r|s α, as 90 s 0 r 1 (r: radians, s: degrees), and end with Ctrl-D",
                  "escribe líneas θ0 r|s ω0 r|s α, como 90 s 0 r 1 (r: radianes, s: grados), y termina con Ctrl-D"}));
    const auto names = columns_behind({});
    const RowStyle style = row_style(names, analyzer.style);
    Status status = Status::done;
    Tokens tokens;
    while (const auto line = read_line(tokens)) {
        open_output(analyzer, names);
        const Source source{Status::bad_data, line->place};
        ProgressLine progress;
        const auto proceed = [&progress](double fraction) { return show_and_go_on(progress, fraction); };
        try {
            if (!line->wrong.empty()) refuse(source, line->wrong);
            const Analysis analysis = analyze_one(analyzer, line->pendulum, line->initial, source, proceed);
            commit(analyzer.writer, put_analysis(room(analyzer.writer, 4 * field_room), style, analysis));
        } catch (const Failure& failure) {
            if (failure.status != Status::bad_data) throw;
            append_error(analyzer, failure.message);
            status = Status::bad_data;
        }
        if (is_interrupted() || !has_line(tokens)) flush(analyzer.writer);
    }
    return status;
}

}  // namespace

Status analyze(const Options& options) {
    Analyzer analyzer{.epsilon = read_epsilon(options), .style = style_of(options), .writer = {.path = output_path(options)}};
    Status status = Status::done;
    const Sweep sweep = read_sweep(options);
    if (sweep.is_given) {
        require_theta0(options);
        analyze_sweep(analyzer, sweep);
    } else {
        status = analyze_lines(analyzer);
    }
    close(analyzer.writer);
    return status;
}

}  // namespace pendula::cli
