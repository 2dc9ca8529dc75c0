// What is asked for is checked at every entry, and refused in one way.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "pendula/pendula.hpp"
#include "trajectories.hpp"

namespace {

using namespace pendula;
using enum Refusal::Reason;

constexpr double inf = HUGE_VAL;
const double nan = std::nan("");

constexpr Pendulum driven{.beta = 0.5, .drive_amplitude = 1, .drive_frequency = 2.0 / 3};

/// What a problem is refused for, by every entry that takes one.
Refusal refusal_of(const Problem& problem) {
    const Refusal refusal = check(problem);
    Trajectory run = begin(problem);
    EXPECT_EQ(run.refusal.reason, refusal.reason);
    Sample rows[2];
    if (refusal) {
        EXPECT_TRUE(run.is_finished());
        EXPECT_EQ(advance(run, rows, inf), 0u);
        try {
            (void)solve(problem);
            ADD_FAILURE() << "solved";
        } catch (const std::invalid_argument& e) {
            EXPECT_EQ(e.what(), describe(refusal));
        }
    }
    return refusal;
}

/// The same problem as an ensemble's second member, beside one that is legal.
Refusal refusal_of_member(const Problem& problem) {
    const Pendulum& p = problem.pendulum;
    const double theta[] = {1, problem.initial.theta}, omega[] = {0, problem.initial.omega}, alpha[] = {1, p.alpha},
                 beta[] = {0, p.beta}, torque[] = {0, p.torque}, drive_amplitude[] = {0, p.drive_amplitude},
                 pivot_amplitude[] = {0, p.pivot_amplitude}, drive_frequency[] = {1, p.drive_frequency},
                 drive_phase[] = {0, p.drive_phase};
    const double first[] = {0, problem.schedule.first}, every[] = {1, problem.schedule.every},
                 to_first[] = {1, problem.schedule.steps_to_first}, per_row[] = {1, problem.schedule.steps_per_row};
    double end[4] = {7, 7, 7, 7}, speed[4], turns[4];
    const auto outcome =
        solve({2, theta, omega, alpha, beta, torque, drive_amplitude, pivot_amplitude, drive_frequency, drive_phase},
              problem.method, problem.tolerance, {first, every, 2, to_first, per_row}, {end, speed, turns});
    if (outcome.kind == Outcome::Kind::refused) {
        for (double x : end) EXPECT_EQ(x, 7);  // nothing was done
    }
    return outcome.refusal;
}

void expect_refused(const Problem& problem, Refusal::Reason reason, const std::string& name) {
    const auto alone = refusal_of(problem), member = refusal_of_member(problem);
    EXPECT_EQ(alone.reason, reason) << name << ": " << describe(alone);
    EXPECT_EQ(alone.name, name);
    EXPECT_EQ(alone.member, Refusal::no_member);
    EXPECT_EQ(member.reason, reason) << name << ": " << describe(member);
    EXPECT_EQ(member.name, name);
}

Problem problem(const Pendulum& pendulum, State initial = {1, 0}, Method method = Method::rk4) {
    return {
        .pendulum = pendulum, .initial = initial, .method = method, .schedule = {.every = 0.1, .rows = 2, .steps_per_row = 10}};
}

TEST(Refusals, AreNoneOfWhatIsLegal) {
    EXPECT_FALSE(refusal_of(problem({})));
    EXPECT_FALSE(refusal_of(problem(driven)));
    EXPECT_FALSE(refusal_of(problem({1, 0.1, -1, -1, 0.5, 2, 3})));
    EXPECT_FALSE(refusal_of({.schedule = {.rows = 1}}));  // one row at t = 0 has no interval
    for (Method method : {Method::euler, Method::verlet, Method::taylor, Method::exact})
        EXPECT_FALSE(refusal_of(problem({}, {1, 0}, method)));
}

TEST(Refusals, OfEveryParameterOutsideItsInterval) {
    for (double alpha : {-1.0, 0.0, nan, inf}) expect_refused(problem({.alpha = alpha}), interval, "alpha");
    for (double beta : {-1.0, nan, inf}) expect_refused(problem({.beta = beta}), interval, "beta");
    for (double bad : {nan, inf, -inf}) {
        expect_refused(problem({.torque = bad}), interval, "torque");
        expect_refused(problem({.drive_amplitude = bad, .drive_frequency = 1}), interval, "drive_amplitude");
        expect_refused(problem({.pivot_amplitude = bad, .drive_frequency = 1}), interval, "pivot_amplitude");
        expect_refused(problem({.drive_phase = bad}), interval, "drive_phase");
        expect_refused(problem({}, {bad, 0}), interval, "theta0");
        expect_refused(problem({}, {0, bad}), interval, "omega0");
    }
    for (double frequency : {-1.0, nan, inf})
        expect_refused(problem({.drive_frequency = frequency}), interval, "drive_frequency");
}

TEST(Refusals, OfADriveOrAShakenPivotWithoutAFrequency) {
    for (const Pendulum& p : {Pendulum{.drive_amplitude = 1}, Pendulum{.pivot_amplitude = -1}}) {
        for (Method method : {Method::rk4, Method::euler, Method::taylor})
            expect_refused(problem(p, {1, 0}, method), needs_frequency, "drive_frequency");
        EXPECT_EQ(check(p).rule, Rule::positive);
        EXPECT_EQ(check(p, Strobe{}).rule, Rule::positive);
        EXPECT_TRUE(std::isnan(at(make_taylor(p, {1, 0}), 0).theta));
        double period = 7;
        EXPECT_EQ(measured_period(p, {1, 0}, 10, 1e-15, period).refusal.name, std::string("drive_frequency"));
        EXPECT_EQ(period, 7);
    }
}

TEST(Refusals, OfMethodsThatAreNotThereOrCannotDoIt) {
    expect_refused(problem({}, {1, 0}, static_cast<Method>(99)), not_among, "method");
    expect_refused(problem({}, {1, 0}, static_cast<Method>(-1)), not_among, "method");
    expect_refused(problem({.beta = 0.1}, {1, 0}, Method::verlet), has_friction, "verlet");
    for (const Pendulum& p :
         {Pendulum{.beta = 0.1}, Pendulum{.torque = 0.1}, Pendulum{.drive_amplitude = 1, .drive_frequency = 1},
          Pendulum{.pivot_amplitude = 1, .drive_frequency = 1}})
        expect_refused(problem(p, {1, 0}, Method::exact), not_conservative, "exact");
}

TEST(Refusals, OfCountsThatAreNotWhole) {
    for (double count : {2.5, 0.0, -1.0, nan, inf}) {
        auto p = problem({});
        p.schedule = {.every = 0.1, .rows = 11, .steps_per_row = count};
        EXPECT_EQ(refusal_of(p).name, std::string(count == inf ? "" : "steps_per_row")) << count;
        p.schedule = {.every = 0.1, .rows = 2, .steps_per_row = 1, .first = 1, .steps_to_first = count};
        EXPECT_EQ(refusal_of(p).name, std::string(count == inf ? "" : "steps_to_first")) << count;
        p.schedule = {.every = 0.1, .rows = count};
        EXPECT_EQ(refusal_of(p).name, std::string(count == inf ? "" : "rows")) << count;
    }
    expect_refused({.schedule = {.every = 0.1, .rows = 11, .steps_per_row = 2.5}}, whole, "steps_per_row");
    for (double every : {0.0, -1.0, nan, inf}) expect_refused({.schedule = {.every = every, .rows = 2}}, interval, "every");
    for (double first : {-1.0, nan, inf})
        expect_refused({.schedule = {.every = 1, .rows = 2, .first = first}}, interval, "first");
    EXPECT_EQ(refusal_of({.schedule = {.every = 1, .rows = 0x1p54}}).reason, too_many_rows);
    EXPECT_EQ(refusal_of({.schedule = {.every = 1, .rows = 0x1p30, .steps_per_row = 0x1p30}}).reason, too_many_steps);
}

TEST(Refusals, OfTolerancesOutsideTheirInterval) {
    for (double tolerance : {1e6, 1.0, 0.0, -1e-9, nan, inf}) {
        auto p = problem({}, {1, 0}, Method::taylor);
        p.tolerance = tolerance;
        expect_refused(p, interval, "tolerance");
        EXPECT_TRUE(std::isnan(at(make_taylor({}, {1, 0}, tolerance), 0).theta)) << tolerance;
        double period;
        EXPECT_EQ(measured_period({}, {1, 0}, 10, tolerance, period).refusal.name, std::string("tolerance"));
        EXPECT_EQ(check(driven, Strobe{.tolerance = tolerance}).name, std::string("tolerance"));
    }
}

TEST(Refusals, OfAnAlphaOutsideItsIntervalByEveryEntry) {
    for (double alpha : {-1.0, 0.0, nan, inf}) {
        const Pendulum p{.alpha = alpha};
        expect_refused(problem(p, {1, 0}, Method::exact), interval, "alpha");
        expect_refused(problem(p, {1, 0}, Method::taylor), interval, "alpha");
        EXPECT_TRUE(std::isnan(at(make_taylor(p, {1, 0}), 0).theta));
        EXPECT_TRUE(std::isnan(at(make_exact(alpha, {1, 0}), 0).theta));
        EXPECT_TRUE(std::isnan(characteristic_time(p, {1, 0})));
        Crossing crossing;
        auto search = make_crossings(p, {1, 0}, Crossed::theta);
        EXPECT_FALSE(next_crossing(search, 10, crossing));
        Analysis analysis;
        EXPECT_EQ(analyze_by_series(alpha, {1, 0}, 1e-7, analysis).refusal.name, std::string("alpha"));
        double period, a[1];
        EXPECT_EQ(measured_period(p, {1, 0}, 10, 1e-15, period).refusal.name, std::string("alpha"));
        const auto outcome = measure(Measure::mean_velocity, {.size = 1, .alpha = alpha}, {}, {a, a, a, a, a});
        EXPECT_EQ(outcome.kind, Outcome::Kind::refused);
        EXPECT_EQ(outcome.refusal.name, std::string("alpha"));
        EXPECT_EQ(outcome.refusal.member, 0u);
    }
}

TEST(Refusals, OfTheSeriesAndThePeriodSayWhy) {
    Analysis analysis;
    double period;
    for (double epsilon : {0.0, 1.0, -1.0, nan}) {
        EXPECT_EQ(analyze_by_series(1, {1, 0}, epsilon, analysis).refusal.name, std::string("epsilon"));
    }
    for (double until : {-1.0, nan, inf})
        EXPECT_EQ(measured_period({}, {1, 0}, until, 1e-15, period).refusal.name, std::string("until"));
}

TEST(Refusals, OfStepsTooLongForFrictionTellHowManyWouldDo) {
    const struct {
        Method method;
        double beta;
    } cases[] = {{Method::rk4, 278.5}, {Method::euler, 201}, {Method::rk4, 1e6}};
    for (const auto& [method, beta] : cases) {
        auto p = problem({.beta = beta}, {1, 0}, method);
        p.schedule = {.every = 0.1, .rows = 100, .steps_per_row = 10};  // h = 0.01
        const auto refusal = refusal_of(p);
        EXPECT_EQ(refusal.reason, unstable);
        EXPECT_EQ(refusal.name, std::string("steps_per_row"));
        EXPECT_EQ(refusal_of_member(p).reason, unstable);
        p.schedule.steps_per_row = refusal.least - 1;
        EXPECT_EQ(refusal_of(p).reason, unstable);
        p.schedule.steps_per_row = refusal.least;
        EXPECT_FALSE(refusal_of(p));
        for (const auto& row : solve(p)) EXPECT_LE(std::fabs(row.omega), 1);  // no growth
    }
    Strobe strobe{.steps_per_period = 10, .method = Method::rk4};
    const Pendulum stiff{.beta = 1000, .drive_amplitude = 1, .drive_frequency = 1};
    EXPECT_EQ(check(stiff, strobe).reason, unstable);
    strobe.steps_per_period = check(stiff, strobe).least;
    EXPECT_FALSE(check(stiff, strobe));
    EXPECT_EQ(fewest_steps(stiff), std::ceil(2 * pi * 1000 / 2.78));
    EXPECT_EQ(fewest_steps({}), 3);
}

TEST(Refusals, OfEveryMemberAsIfItStoodAlone) {
    // Both ends of the range are stable with 1000 steps a period; just above 0 the period is too long.
    std::vector<double> frequency, a(1001);
    for (int i = 0; i <= 1000; ++i) frequency.push_back(1e-3 * i);
    const Ensemble e{.size = 1001, .theta = 1, .drive_frequency = frequency};
    const auto outcome = measure(Measure::mean_velocity, e, {.method = Method::rk4}, {a, a, a, a, a});
    EXPECT_EQ(outcome.refusal.reason, unstable);
    EXPECT_EQ(outcome.refusal.member, 1u);  // the first, of frequency 0, is looked at each period of small swings
    EXPECT_EQ(outcome.refusal.least, std::ceil(2 * pi / 1e-3 / 2.82));
}

TEST(Refusals, OfArraysThatAreTooShortOrNotThere) {
    const std::vector<double> three(3, 0.5), two(2, 0.5);
    double a[6], b[6], c[6];
    const auto solved = [&](const Ensemble& e, const EnsembleTimes& times, const EnsembleRows& rows) {
        return solve(e, Method::rk4, 1e-15, times, rows).refusal;
    };
    const auto refused = [](const Refusal& refusal, const std::string& name, double value, double least) {
        EXPECT_EQ(refusal.reason, length) << name;
        EXPECT_EQ(refusal.name, name);
        EXPECT_EQ(refusal.value, value) << name;
        EXPECT_EQ(refusal.least, least) << name;
    };
    const std::span<const double> nowhere(static_cast<const double*>(nullptr), 3);
    const std::span<double> no_results(static_cast<double*>(nullptr), 3);
    refused(solved({.size = 3, .theta = two}, {}, {a, b, c}), "theta0", 2, 3);
    refused(solved({.size = 3, .theta = nowhere}, {}, {a, b, c}), "theta0", 0, 3);
    refused(solved({.size = 3, .pivot_amplitude = two}, {}, {a, b, c}), "pivot_amplitude", 2, 3);
    refused(solved({.size = 3, .theta = three}, {.steps_per_row = two}, {a, b, c}), "steps_per_row", 2, 3);
    refused(solved({.size = 3, .theta = three}, {.first = two}, {a, b, c}), "first", 2, 3);
    refused(solved({.size = 3}, {.rows = 2}, {{a, 5}, b, c}), "theta", 5, 6);
    refused(solved({.size = 3}, {}, {a, no_results, c}), "omega", 0, 3);
    refused(solved({.size = 3}, {}, {a, b, {}}), "turns", 0, 3);

    const auto measured = [](Measure what, const Ensemble& e, const Strobe& strobe, const Results& results) {
        return measure(what, e, strobe, results).refusal;
    };
    refused(measured(Measure::section, {.size = 3, .theta = two}, {0, 2}, {a, b, c, c}), "theta0", 2, 3);
    refused(measured(Measure::section, {.size = 3}, {0, 2}, {a, {b, 5}, c, c}), "omega", 5, 6);
    refused(measured(Measure::section, {.size = 3}, {0, 2}, {a}), "results", 1, 2);
    refused(measured(Measure::mean_velocity, {.size = 3}, {}, {no_results, b, c, c, c}), "mean_velocity", 0, 3);
    refused(measured(Measure::lyapunov, {.size = 3}, {.periods = 5, .history_rows = 2}, {a, b, c, c, c, c, c, c, c, {}}),
            "history", 0, 6);
}

TEST(Refusals, OfNoDetailsThatAreLeftOut) {
    double velocity[3], error[3], others[3];
    const Ensemble rotations{.size = 3, .omega = 3.0};
    EXPECT_TRUE(measure(Measure::mean_velocity, rotations, {}, {velocity, error}).is_done());
    EXPECT_TRUE(measure(Measure::mean_velocity, rotations, {}, {others, error, {}, {}}).is_done());
    for (int i : {0, 1, 2}) EXPECT_EQ(velocity[i], others[i]);
    EXPECT_NEAR(velocity[0], 2.6040081905309407, 1e-14);  // twice the arithmetic-geometric mean of 3/2 and sqrt(5)/2
}

TEST(Refusals, OfWhatNoMeasureDoes) {
    double a[1];
    const auto refusal = [&](const Strobe& strobe, Measure what = Measure::mean_velocity) {
        const auto outcome = measure(what, {.size = 1, .theta = 1}, strobe, {a, a, a, a, a});
        EXPECT_EQ(outcome.kind, Outcome::Kind::refused);
        if (what == Measure::mean_velocity) {
            EXPECT_EQ(check(Pendulum{}, strobe).name, std::string(outcome.refusal.name));
        }
        return std::pair(outcome.refusal.reason, std::string(outcome.refusal.name));
    };
    for (Method method : {Method::euler, Method::verlet, Method::exact, static_cast<Method>(99)})
        EXPECT_EQ(refusal({.method = method}), std::pair(not_among, std::string("method")));
    for (double count : {2.5, -1.0, nan, inf}) {
        EXPECT_EQ(refusal({.transient = count}), std::pair(whole, std::string("transient")));
        EXPECT_EQ(refusal({.periods = count}), std::pair(whole, std::string("periods")));
        EXPECT_EQ(refusal({.budget = count}), std::pair(whole, std::string("budget")));
        EXPECT_EQ(refusal({.orbit_period = count}), std::pair(whole, std::string("orbit_period")));
        EXPECT_EQ(refusal({.steps_per_period = count}), std::pair(whole, std::string("steps_per_period")));
        EXPECT_EQ(refusal({.history_rows = count}), std::pair(whole, std::string("history_rows")));
    }
    for (double bad : {nan, inf, -inf}) {
        EXPECT_EQ(refusal({.phase = bad}), std::pair(interval, std::string("strobe_phase")));
        EXPECT_EQ(refusal({.level = bad}), std::pair(interval, std::string("level")));
    }
    EXPECT_EQ(refusal({.periods = 0}), std::pair(whole, std::string("periods")));
    EXPECT_EQ(refusal({.periods = 2, .history_rows = 6}), std::pair(whole, std::string("history_rows")));
    for (double match : {0.0, -1.0, nan, inf}) EXPECT_EQ(refusal({.match = match}), std::pair(interval, std::string("match")));
    EXPECT_EQ(refusal({.periods = 1e6, .steps_per_period = 1e12, .method = Method::rk4}).first, too_many_steps);
    EXPECT_EQ(check(Pendulum{.beta = 1e300, .drive_frequency = 1}, Strobe{}).reason, too_many_steps);
    EXPECT_EQ(refusal({}, static_cast<Measure>(99)), std::pair(not_among, std::string("measure")));
}

TEST(Refusals, OfNumbersOfThreads) {
    double a[3], b[3], c[3];
    for (int threads : {-1, 257, std::numeric_limits<int>::max()}) {
        const Control control{.threads = threads};
        for (const auto& outcome : {solve({.size = 3}, Method::rk4, 1e-15, {}, {a, b, c}, control),
                                    measure(Measure::mean_velocity, {.size = 3}, {}, {a}, control)}) {
            EXPECT_EQ(outcome.refusal.name, std::string("threads"));
            EXPECT_EQ(outcome.refusal.most, 256);
        }
    }
    EXPECT_TRUE(solve({.size = 3}, Method::rk4, 1e-15, {}, {a, b, c}, {.threads = 256}).is_done());
}

TEST(Descriptions, NameArgumentValueAndWhatIsLegal) {
    const auto both = [](const Refusal& refusal) { return describe(refusal) + " | " + describe(refusal, Language::es); };
    EXPECT_EQ(both(check(Pendulum{.alpha = -1})),
              "alpha must be positive and finite, got -1 | alpha debe ser un número finito mayor que 0, y es -1");
    EXPECT_EQ(both(check(Pendulum{.beta = -0.1})),
              "beta must be finite and not negative, got -0.1 | beta debe ser un número finito no menor que 0, y es -0.1");
    EXPECT_EQ(both(check(Pendulum{}, State{nan, 0})),
              "theta0 must be finite, got nan | theta0 debe ser un número finito, y es nan");
    EXPECT_EQ(both(check(Problem{.tolerance = 1e6})),
              "tolerance must be between 0 and 1, both excluded, got 1e+06 | tolerance debe ser un número entre 0 y 1, ambos "
              "excluidos, y es 1e+06");
    EXPECT_EQ(both(check(Problem{.schedule = {.every = 1, .rows = 11, .steps_per_row = 2.5}})),
              "steps_per_row must be a whole number from 1 to 2^53, got 2.5 | steps_per_row debe ser un entero de 1 a 2^53, y "
              "es 2.5");
    EXPECT_EQ(both(check(problem({.beta = 0.1}, {1, 0}, Method::verlet))),
              "method verlet needs a pendulum without friction | el método verlet necesita un péndulo sin rozamiento");
    EXPECT_EQ(
        both(check(problem({.beta = 1e6}))),
        "steps_per_row must be at least 35972, or the method is unstable, got 10; or use method taylor | steps_per_row debe "
        "ser al menos 35972, o el método es inestable, y es 10; o usa el método taylor");
    EXPECT_EQ(
        both(check(problem({}, {1, 0}, static_cast<Method>(99)))),
        "method must be one of rk4, euler, verlet, taylor, exact | method debe ser uno de rk4, euler, verlet, taylor, exact");
    const double alpha[] = {1, 1, -2};
    EXPECT_EQ(both(check(Ensemble{.size = 3, .alpha = alpha})),
              "alpha must be positive and finite, got -2 (member 2) | alpha debe ser un número finito mayor que 0, y es -2 "
              "(miembro 2)");
    EXPECT_EQ(both(check(Ensemble{.size = 4, .alpha = alpha})),
              "alpha must have 4 values, got 3 | alpha debe tener 4 valores, y tiene 3");
    EXPECT_EQ(describe(check(Pendulum{.alpha = -1}), Language::en, "--alpha"), "--alpha must be positive and finite, got -1");
    EXPECT_THROW(require(check(Pendulum{.alpha = -1})), std::invalid_argument);
    EXPECT_TRUE(require(Outcome{}));
    EXPECT_FALSE(require(Outcome{Outcome::Kind::stopped}));
}

}  // namespace
