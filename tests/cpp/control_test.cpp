// Every long call tells its progress and can be stopped.
#include <chrono>
#include <functional>

#include "flocks.hpp"
#include "pendula/pendula.hpp"

namespace {

using namespace reference;

/// A call whose length is that of a number of periods, or of some other unit.
struct LongCall {
    const char* name;
    double length;   ///< of some milliseconds
    double endless;  ///< of hours
    std::function<Outcome(double length, const Control& control)> run;
};

constexpr std::size_t members = 100;
double column[10][4 * members];  // of results

std::function<Outcome(double, const Control&)> ensemble_by(Method method) {
    return [=](double length, const Control& control) {
        const auto theta = linspace(0.1, 3, members);
        const EnsembleTimes times{.every = length, .rows = 4, .steps_per_row = method == Method::taylor ? 1 : 100 * length};
        return solve({.size = members, .theta = theta}, method, 1e-15, times, {column[0], column[1], column[2]}, control);
    };
}

std::function<Outcome(double, const Control&)> measure_of(Measure what, Method method) {
    return [=](double length, const Control& control) {
        const bool is_section = what == Measure::section;
        const auto flock = published(linspace(1.49, 1.5, members));  // chaotic
        const Strobe strobe{.transient = is_section ? length : 0,
                            .periods = is_section ? 4 : length,
                            .steps_per_period = 100,
                            .method = method,
                            .budget = length};
        std::vector<std::span<double>> results(std::begin(column), std::end(column));
        return measure(what, flock.ensemble(), strobe, std::span<const std::span<double>>(results), control);
    };
}

Outcome replayed(double length, const Control& control) {
    const double euler[] = {1, 1, 0, 0, 0, 0, 0}, sums[] = {0.01, 0, 0, 0.01};
    const std::int64_t steps[] = {static_cast<std::int64_t>(length), static_cast<std::int64_t>(2 * length)};
    const Program program{.initial = {1, 0}, .stages = 1, .coefficients = euler, .sums = sums, .steps = steps};
    return replay(std::vector<Program>(members, program), {column[0], column[1]}, control);
}

const LongCall calls[] = {
    {"ensemble by rk4", 20, 1e9, ensemble_by(Method::rk4)},
    {"ensemble by euler", 20, 1e9, ensemble_by(Method::euler)},
    {"ensemble by verlet", 20, 1e9, ensemble_by(Method::verlet)},
    {"ensemble by taylor", 100, 1e12, ensemble_by(Method::taylor)},
    {"replay", 2e4, 1e15, replayed},
    {"section by rk4", 20, 1e9, measure_of(Measure::section, Method::rk4)},
    {"section by taylor", 20, 1e9, measure_of(Measure::section, Method::taylor)},
    {"mean velocity", 20, 1e9, measure_of(Measure::mean_velocity, Method::rk4)},
    {"lyapunov by rk4", 20, 1e9, measure_of(Measure::lyapunov, Method::rk4)},
    {"lyapunov by taylor", 20, 1e9, measure_of(Measure::lyapunov, Method::taylor)},
    {"attractors", 20, 1e9, measure_of(Measure::attractors, Method::rk4)},
    {"orbit", 100, 1e9,
     [](double length, const Control& control) {
         const auto flock = published({0.9});
         std::vector<std::span<double>> results(std::begin(column), std::end(column));
         return measure(Measure::orbit, flock.ensemble(), {.orbit_period = length}, std::span<const std::span<double>>(results),
                        control);
     }},
    {"measured period", 2e4, 1e12,
     [](double length, const Control& control) {
         double period;
         return measured_period({}, {1, 0}, length, 1e-15, period, control);
     }},
    {"measured period of what seldom crosses", 2e3, 1e12,
     [](double length, const Control& control) {
         double period;  // in a well about 0.52, which a weak drive does not leave
         return measured_period({.torque = 0.5, .drive_amplitude = 0.1, .drive_frequency = 3}, {0.5, 0}, length, 1e-15, period,
                                control);
     }},
};

/// The closed form is too fast for a call of hours whose results fit into memory.
const LongCall by_closed_form{"ensemble by exact", 10, 0, ensemble_by(Method::exact)};

/// Figure 3.2's velocity, 1e-7 short of turning over: 3e8 terms.
const LongCall by_series{"series", 0, 0, [](double, const Control& control) {
                             Analysis analysis;
                             return analyze_by_series(1, {0, 1.999999895801368}, 1e-7, analysis, control);
                         }};

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Calls look some hundred times a second; a second is for machines that are busy.
TEST(LongCalls, StopSoonAfterTheyAreTold) {
    for (const auto& call : calls)
        for (int threads : {1, 3}) {
            const auto start = std::chrono::steady_clock::now();
            const Control control{threads, [&](double) { return seconds_since(start) < 0.02; }};
            EXPECT_EQ(call.run(call.endless, control).kind, Outcome::Kind::stopped) << call.name;
            EXPECT_LT(seconds_since(start), 1.02) << call.name;
        }
}

TEST(LongCalls, ThatAreToldAtOnceDoNotEnd) {
    const auto expect_stopped = [](const LongCall& call) {
        EXPECT_EQ(call.run(call.length, {1, [](double) { return false; }}).kind, Outcome::Kind::stopped) << call.name;
    };
    for (const auto& call : calls) expect_stopped(call);
    expect_stopped(by_closed_form);
    expect_stopped(by_series);
}

TEST(LongCalls, TellProgressThatNeverFallsFrom0To1) {
    const auto expect_progress = [](const LongCall& call, double stops_at = 2) {
        for (int threads : {1, 2}) {
            double last = 0, looks = 0;
            bool is_good = true;
            const auto outcome = call.run(call.length, {threads, [&](double done) {
                                                            is_good = is_good && done >= last && done <= 1;
                                                            last = done;
                                                            ++looks;
                                                            return done < stops_at;
                                                        }});
            EXPECT_EQ(outcome.is_done(), stops_at > 1) << call.name;
            EXPECT_TRUE(is_good) << call.name << ' ' << last;
            EXPECT_GE(last, std::min(stops_at, 0.5)) << call.name;
            if (threads == 1) {
                EXPECT_GE(looks, 4) << call.name;
            }
        }
    };
    for (const auto& call : calls) expect_progress(call);
    expect_progress(by_closed_form);
    expect_progress(by_series, 0.1);
}

/// A pendulum whose starts, a grid of them, end on two attractors, each of two periods of the drive.
Outcome two_attractors(const Control& control) {
    Flock flock = published({1.45});
    flock.theta = linspace(-3, 3, members);
    std::vector<std::span<double>> results(std::begin(column), std::end(column));
    return measure(Measure::attractors, flock.ensemble(), {}, std::span<const std::span<double>>(results), control);
}

TEST(LongCalls, TellProgressAndStopWhileAttractorsAreLabelled) {
    double last = 0;
    EXPECT_TRUE(two_attractors({1, [&](double done) { return last = done, true; }}).is_done());
    EXPECT_GT(last, 0.9);  // the share of the orbits
    EXPECT_LE(last, 1);
    EXPECT_EQ(two_attractors({1, [&](double done) { return last = done, done <= 0.9; }}).kind, Outcome::Kind::stopped);
}

TEST(Proceed, IsALambdaOfUpToFourReferencesOrAFunction) {
    double p = 0, q = 0, r = 0, s = 0, t = 0;
    const auto of_four = [&p, &q, &r, &s](double done) { return p = q = r = s = done, done < 0.5; };
    const auto of_five = [&p, &q, &r, &s, &t](double done) { return p = q = r = s = t = done, done < 0.5; };
    static_assert(std::is_constructible_v<Proceed, decltype(of_four)>);
    static_assert(!std::is_constructible_v<Proceed, decltype(of_five)>);
    static_assert(!std::is_constructible_v<Proceed, std::function<bool(double)>>);  // nothing is allocated or destroyed
    const Proceed proceed = of_four, copy = proceed, always, never = +[](double) { return false; };
    EXPECT_TRUE(copy(0.25));
    EXPECT_EQ(s, 0.25);
    EXPECT_FALSE(copy(0.75));
    EXPECT_TRUE(always(1));
    EXPECT_FALSE(never(0));
    (void)of_five;
}

}  // namespace
