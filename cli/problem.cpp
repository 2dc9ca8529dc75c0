#include "cli/problem.hpp"

#include <algorithm>
#include <limits>

#include "cli/messages.hpp"
#include "cli/numbers.hpp"
#include "pendula/validate.hpp"

namespace pendula::cli {

namespace {

[[noreturn]] void fail(std::string_view place, const Text& text, std::initializer_list<std::string_view> values) {
    throw Failure{Status::bad_data, std::string(place) + say(text, values)};
}

double seconds(const Duration& duration, double unit, std::string_view place, const Text& name) {
    const double time = duration.is_factor ? duration.value * unit : duration.value;
    if (!satisfies(Rule::positive, time))
        fail(place, {"{0}, {1} times {2} s, is out of the range of doubles", "{0}, {1} por {2} s, se sale del rango de double"},
             {say(name), shown(duration.value), shown(unit)});
    return time;
}

void require_feasible(const Schedule& schedule, std::string_view place) {
    if (schedule.is_feasible()) return;
    constexpr double largest = std::numeric_limits<double>::max();  // a count beyond it reads as inf
    if (schedule.rows > 0x1p53)
        fail(
            place,
            {"it would print {0} rows, more than 2^53 = 9007199254740992; leave more time between them or make the run shorter",
             "escribiría {0} filas, más de 2^53 = 9007199254740992; deja más tiempo entre ellas o acorta la simulación"},
            {shown(std::min(schedule.rows, largest))});
    fail(place,
         {"it would take {0} steps, more than 2^53 = 9007199254740992; make them longer or the run shorter",
          "daría {0} pasos, más de 2^53 = 9007199254740992; alárgalos o acorta la simulación"},
         {shown(std::min(schedule.steps(), largest))});
}

}  // namespace

Prepared prepare(const Statement& statement, std::string_view place) {
    Prepared prepared;
    if (is_conservative(statement.pendulum)) prepared.analysis = analyze(statement.pendulum.alpha, statement.initial);
    const double unit = characteristic_time(statement.pendulum, statement.initial);
    prepared.dt = seconds(statement.dt, unit, place, {"the step", "el paso"});
    const double every = seconds(statement.every, unit, place, {"the time between rows", "el tiempo entre filas"});
    prepared.until = seconds(statement.until, unit, place, {"the length of the run", "la duración de la simulación"});
    // The closed form takes no steps, and Taylor's method its own.
    const bool has_steps = statement.method != Method::exact && statement.method != Method::taylor;
    const double dt = has_steps ? prepared.dt : every;
    prepared.problem = {.pendulum = statement.pendulum,
                        .initial = statement.initial,
                        .method = statement.method,
                        .schedule = schedule({dt, every, prepared.until}),
                        .tolerance = statement.tolerance};
    require_feasible(prepared.problem.schedule, place);
    return prepared;
}

}  // namespace pendula::cli
