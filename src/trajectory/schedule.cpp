#include "pendula/schedule.hpp"

#include "arithmetic/pack.hpp"

namespace pendula {

namespace {

constexpr double slack = 1e-9;  // relative tolerance of the numbers of rows and steps, so that 1/0.02 gives 50 rows

}  // namespace

Times in_seconds(const Durations& durations, double characteristic_time) noexcept {
    const auto seconds = [=](const Duration& d) { return d.is_factor ? d.value * characteristic_time : d.value; };
    return {seconds(durations.dt), seconds(durations.every), seconds(durations.until)};
}

double steps_in(double length, double dt) noexcept {
    const double steps = arithmetic::ceiling(length / dt * (1 - slack));
    return steps < 1 ? 1 : steps;
}

Schedule make_schedule(const Times& times) noexcept {
    return {.every = times.every,
            .rows = arithmetic::floor(times.until / times.every * (1 + slack)) + 1,
            .steps_per_row = steps_in(times.every, times.dt)};
}

}  // namespace pendula
