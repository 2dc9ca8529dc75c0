#include "cli/problem.hpp"

#include "cli/numbers.hpp"

namespace pendula::cli {

namespace {

/// Times that overflow or underflow only as a factor times the pendulum's own time.
void require_time(double time, const Duration& duration, double unit, const Source& source, const Words& name) {
    if (!satisfies(Rule::positive, time))
        refuse(source,
               say({"{0}, {1} times {2} s, is out of the range of doubles", "{0}, {1} por {2} s, se sale del rango de double"},
                   {say(name), shown(duration.value), shown(unit)}));
}

}  // namespace

void refuse(const Source& source, const std::string& message) { throw Failure{source.status, source.place + message}; }

Prepared prepare(const Statement& statement) {
    const auto& [pendulum, initial, method, tolerance, durations, source] = statement;
    Prepared prepared{.source = source};
    if (is_conservative(pendulum)) prepared.analysis = analyze(pendulum.alpha, initial);
    const double unit = prepared.analysis ? prepared.analysis->tau : characteristic_time(pendulum, initial);
    Times times = prepared.times = in_seconds(durations, unit);
    require_time(times.every, durations.every, unit, source, {"the time between rows", "el tiempo entre filas"});
    require_time(times.until, durations.until, unit, source, {"the length of the run", "la duración de la simulación"});
    if (takes_steps(method))
        require_time(times.dt, durations.dt, unit, source, {"the step", "el paso"});
    else
        times.dt = times.every;
    prepared.problem = {pendulum, initial, method, make_schedule(times), tolerance};
    if (const auto refusal = check(prepared.problem)) {
        const bool counts_steps = std::string_view(refusal.name) == "steps_per_row";
        refuse(source, say(refusal, counts_steps ? say({"the number of steps between rows", "el número de pasos entre filas"})
                                                 : refusal.name));
    }
    return prepared;
}

}  // namespace pendula::cli
