// A vertically shaken pivot: every method against 50 digits, and members of ensembles against themselves alone.
#include <bit>
#include <random>

#include "flocks.hpp"
#include "kernels/dispatch.hpp"
#include "pendula/pendula.hpp"
#include "reference_table.hpp"

namespace {

using namespace reference;

constexpr Method all_but_exact[] = {Method::rk4, Method::euler, Method::verlet, Method::taylor};

/// The seven parameters that a row of pivot.txt or pivot_steps.txt begins with.
Pendulum parameters_in(const Row& r) {
    return {.alpha = r[0],
            .beta = r[1],
            .torque = r[2],
            .drive_amplitude = r[3],
            .pivot_amplitude = r[4],
            .drive_frequency = r[5],
            .drive_phase = r[6]};
}

/// A line of pivot.txt: the state, and the displacement that was (1, 0) at t = 0.
struct True {
    double t;
    Value theta, omega, d_theta, d_omega;
};

struct Shaken {
    Pendulum pendulum;
    State initial;
    std::vector<True> rows;

    /// How far a displacement has grown at most, at the times of the table up to t.
    double growth(double t) const {
        double largest = 1;
        for (const True& r : rows)
            if (r.t <= t) largest = std::max(largest, std::hypot(r.d_theta.hi, r.d_omega.hi));
        return largest;
    }
    /// The size of the velocity, of which rounding is a fraction.
    double speed(const True& r) const {
        return std::max({1.0, std::fabs(r.omega.hi), std::fabs(pendulum.pivot_amplitude) / pendulum.drive_frequency});
    }
};

std::vector<Shaken> shaken() {
    std::vector<Shaken> problems;
    for (const Row& r : table("pivot.txt")) {
        if (r.words[0] == "problem")
            problems.push_back({parameters_in(r), {r[7], r[8]}, {}});
        else
            problems.back().rows.push_back({r[0], r.value(1), r.value(3), r.value(5), r.value(7)});
    }
    return problems;
}

TEST(ShakenPivot, StepsFollowTheirFormulas) {
    for (const Row& r : table("pivot_steps.txt")) {
        const Pendulum p = parameters_in(r);
        const double theta = r[7], omega = r[8], t = r[9], h = r[10];
        const auto step = r.words[0] == "euler" ? euler_step : r.words[0] == "verlet" ? verlet_step : rk4_step;
        const State s = step(p, {theta, omega}, t, h);
        // A rounding each of the angle, of the velocity, and of the sine and the phase in what acts during the step.
        const double way = std::fabs(theta) + std::fabs(omega) * h, stiffness = p.alpha + std::fabs(p.pivot_amplitude);
        const double force = stiffness * std::fmin(1, way) + p.beta * std::fabs(omega) + p.torque + p.drive_amplitude;
        const double phase = std::fmax(1, p.drive_frequency * (t + h) + std::fabs(p.drive_phase));
        const double omega_slack = ulp(std::fabs(omega) + force * h) + h * (stiffness * ulp(way) + force * ulp(phase));
        EXPECT_LE(error(s.theta, r.value(11)), ulp(way) + h * omega_slack) << r.words[0] << ' ' << h;
        EXPECT_LE(error(s.omega, r.value(13)), omega_slack) << r.words[0] << ' ' << h;
    }
}

/// The error at the first time of the table after so many steps.
double error_after(const Shaken& problem, Method method, double steps) {
    const True& want = problem.rows[0];
    const auto rows = solve(Problem{.pendulum = problem.pendulum,
                                    .initial = problem.initial,
                                    .method = method,
                                    .schedule = {.every = want.t, .rows = 2, .steps_per_row = steps}});
    const Sample& s = rows.back();
    return std::hypot(angle_error(s.theta, s.turns, want.theta, 0), error(s.omega, want.omega));
}

using kernels::Chunk;

/// A chunk of one member, displaced by (1, 0).
Chunk chunk_of(const Shaken& problem) {
    Chunk c{};
    c.count = 1;
    for (double& alpha : c.parameters.alpha) alpha = 1;
    const auto angle = split_turns(problem.initial.theta);
    c.motion.theta[0] = angle.theta;
    c.motion.turns[0] = angle.turns;
    c.motion.omega[0] = problem.initial.omega;
    c.tangent.theta[0] = 1;
    const Pendulum& p = problem.pendulum;
    c.parameters.alpha[0] = p.alpha;
    c.parameters.beta[0] = p.beta;
    c.parameters.torque[0] = p.torque;
    c.parameters.drive_amplitude[0] = p.drive_amplitude;
    c.parameters.pivot_amplitude[0] = p.pivot_amplitude;
    c.parameters.drive_frequency[0] = p.drive_frequency;
    c.parameters.drive_phase[0] = p.drive_phase;
    return c;
}

/// The same of the displacement, by rk4.
double displacement_error_after(const Shaken& problem, int steps) {
    const True& want = problem.rows[0];
    Chunk c = chunk_of(problem);
    const kernels::Row start{}, h{want.t / steps};
    kernels::dispatch().rk4_tangent(c, start, h, 0, steps);
    return std::hypot(error(c.tangent.theta[0], want.d_theta), error(c.tangent.omega[0], want.d_omega));
}

/// Where steps are short beside the drive's period, and the error is not yet all rounding.
template <class Error>
void expect_order(double order, int steps, Error error_of) {
    int problems = 0;
    for (const auto& problem : shaken()) {
        const double at_first = error_of(problem, steps), at_last = error_of(problem, 2 * steps);
        if (problem.pendulum.drive_frequency > 30 || !(at_last > 1e-12)) continue;
        EXPECT_NEAR(std::log2(at_first / at_last), order, 0.1)
            << problem.pendulum.pivot_amplitude << ' ' << problem.initial.theta;
        ++problems;
    }
    EXPECT_GE(problems, 5);
}

TEST(ShakenPivot, EulerConvergesAtOrder1) {
    expect_order(1, 1024, [](const Shaken& s, int steps) { return error_after(s, Method::euler, steps); });
}

TEST(ShakenPivot, VerletConvergesAtOrder2) {
    expect_order(2, 256,
                 [](const Shaken& s, int steps) { return s.pendulum.beta == 0 ? error_after(s, Method::verlet, steps) : 0; });
}

TEST(ShakenPivot, Rk4ConvergesAtOrder4) {
    expect_order(4, 64, [](const Shaken& s, int steps) { return error_after(s, Method::rk4, steps); });
}

TEST(ShakenPivot, DisplacementsByRk4ConvergeAtOrder4) { expect_order(4, 64, displacement_error_after); }

Sample solved(Taylor& run, double t) {
    while (!reaches(run, t)) step(run);
    return at(run, t);
}

TEST(ShakenPivot, TaylorSolvesIt) {
    for (const auto& problem : shaken()) {
        auto run = make_taylor(problem.pendulum, problem.initial);
        const double amplitude = std::fmin(1, std::fabs(problem.initial.theta) + std::fabs(problem.initial.omega));
        for (const True& r : problem.rows) {
            const auto s = solved(run, r.t);
            // Roundings of 1e-16 of the velocity, grown as a displacement does: 2e-14 is measured for the fast rotation, whose
            // angle is 1,500 rad in the end, and 4e-15 elsewhere.
            const double tolerance = 3e-14 * problem.growth(r.t) * problem.speed(r) * amplitude;
            EXPECT_LE(angle_error(s.theta, s.turns, r.theta, 0), tolerance) << problem.pendulum.pivot_amplitude << ' ' << r.t;
            EXPECT_LE(error(s.omega, r.omega), tolerance) << problem.pendulum.pivot_amplitude << ' ' << r.t;
        }
    }
}

TEST(ShakenPivot, TaylorErrsNoMoreThanItsTolerance) {
    for (const auto& problem : shaken()) {
        for (double tolerance : {1e-4, 1e-8, 1e-10, 1e-12}) {
            const True& r = problem.rows[1];
            auto run = make_taylor(problem.pendulum, problem.initial, tolerance);
            const auto s = solved(run, r.t);
            // Of a step; some five steps for each radian of the drive's phase, and 1 s of the fastest motion beside it.
            const double steps = 5 * r.t * (problem.pendulum.drive_frequency + problem.speed(r) + 1);
            EXPECT_LE(angle_error(s.theta, s.turns, r.theta, 0), tolerance * steps * problem.growth(r.t) + 1e-12)
                << problem.pendulum.pivot_amplitude << ' ' << tolerance;
        }
    }
}

TEST(ShakenPivot, DisplacementsByTaylorGrowAsTheLinearisedEquationSays) {
    for (const auto& problem : shaken()) {
        Chunk c = chunk_of(problem);
        static kernels::TaylorChunk steps;
        kernels::Row t{};
        kernels::start_taylor(steps, c, 1e-15, t);
        for (const True& r : problem.rows) {
            t[0] = r.t;
            while (!kernels::dispatch().taylor_tangent(c, steps, t, 100)) {
            }
            // The state's errors, grown like a displacement, change the rate of displacements: hence the square. 4.5e-15 is
            // measured.
            const double tolerance = 1e-14 * std::pow(problem.growth(r.t), 2) * std::pow(problem.speed(r), 2);
            EXPECT_LE(error(c.tangent.theta[0], r.d_theta), tolerance) << problem.pendulum.pivot_amplitude << ' ' << r.t;
            EXPECT_LE(error(c.tangent.omega[0], r.d_omega), tolerance) << problem.pendulum.pivot_amplitude << ' ' << r.t;
        }
    }
}

bool same(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

TEST(ShakenPivot, MembersOfAnEnsembleHaveTheBitsOfThemselvesAlone) {
    constexpr std::size_t size = 100, rows = 21;
    std::mt19937 random(1);
    const auto uniform = [&](double from, double to) { return from + (to - from) * (static_cast<double>(random()) * 0x1p-32); };
    const auto values = [&](std::size_t every, double from, double to) {
        std::vector<double> column(size, 0.0);
        for (std::size_t i = 0; i < size; ++i)
            if (i % every != 0) column[i] = uniform(from, to);
        return column;
    };
    const auto theta = values(20, -10, 10), omega = values(3, -3, 3), torque = values(4, -1, 1), drive = values(5, 0, 2);
    const auto pivot = values(7, -40, 40), friction = values(2, 0, 0.5);
    std::vector<double> frequency(size);
    for (double& f : frequency) f = uniform(0.3, 20);
    for (Method method : all_but_exact) {
        const Ensemble ensemble{.size = size,
                                .theta = theta,
                                .omega = omega,
                                .alpha = 2.0,
                                .beta = method == Method::verlet ? Column(0.0) : Column(friction),
                                .torque = torque,
                                .drive_amplitude = drive,
                                .pivot_amplitude = pivot,
                                .drive_frequency = frequency,
                                .drive_phase = 0.5};
        std::vector<double> its_theta(size * rows), its_omega(size * rows), its_turns(size * rows);
        ASSERT_TRUE(solve(ensemble, method, 1e-15, {.every = 0.25, .rows = rows, .steps_per_row = 50.0},
                          {its_theta, its_omega, its_turns})
                        .is_done());
        for (std::size_t i = 0; i < size; ++i) {
            const auto alone = solve(Problem{.pendulum = pendulum_of(ensemble, i),
                                             .initial = initial_state_of(ensemble, i),
                                             .method = method,
                                             .schedule = {.every = 0.25, .rows = rows, .steps_per_row = 50}});
            for (std::size_t j = 0; j < rows; ++j) {
                const std::size_t at = j * size + i;
                EXPECT_TRUE(same(its_theta[at], alone[j].theta) && same(its_omega[at], alone[j].omega) &&
                            same(its_turns[at], alone[j].turns))
                    << method_names[static_cast<int>(method)] << ' ' << i << ' ' << j;
            }
        }
    }
}

Problem shaken_from(State initial, Method method, const Pendulum& pendulum) {
    return {.pendulum = pendulum,
            .initial = initial,
            .method = method,
            .schedule = {.every = 0.25, .rows = 41, .steps_per_row = 100}};
}

TEST(ShakenPivot, MotionsAreOddToTheBit) {
    for (Method method : all_but_exact) {
        const Pendulum p{.alpha = 2, .pivot_amplitude = 30, .drive_frequency = 7, .drive_phase = 1};
        const auto rows = solve(shaken_from({0.7, 1.3}, method, p)), mirrored = solve(shaken_from({-0.7, -1.3}, method, p));
        for (std::size_t i = 0; i < rows.size(); ++i)
            EXPECT_TRUE(rows[i].theta == -mirrored[i].theta && rows[i].omega == -mirrored[i].omega)
                << method_names[static_cast<int>(method)] << ' ' << i;
    }
}

TEST(ShakenPivot, AnAmplitudeBelowZeroIsAPhaseOfHalfATurn) {
    for (Method method : all_but_exact) {
        const Pendulum p{.alpha = 2, .pivot_amplitude = 5, .drive_frequency = 7, .drive_phase = 1};
        auto shifted = p;
        shifted.pivot_amplitude = -5;
        shifted.drive_phase = 1 + pi;
        const auto rows = solve(shaken_from({0.7, 1.3}, method, p)), others = solve(shaken_from({0.7, 1.3}, method, shifted));
        // 1 + pi is rounded, by 2e-16 of the phase: a force 1e-15 off for 10 s.
        for (std::size_t i = 0; i < rows.size(); ++i) EXPECT_NEAR(unwrapped(rows[i]), unwrapped(others[i]), 1e-12);
    }
}

TEST(ShakenPivot, LeavesAPendulumAtRestWhereItIs) {
    for (Method method : all_but_exact) {
        for (State initial : {State{0, 0}, {pi, 0}, {-3 * pi, 0}}) {
            const auto rows = solve(shaken_from(initial, method, {.pivot_amplitude = 20, .drive_frequency = 20}));
            for (const auto& s : rows) {
                EXPECT_EQ(s.theta, rows[0].theta);
                EXPECT_EQ(s.turns, rows[0].turns);
                EXPECT_EQ(s.omega, 0);
            }
        }
    }
}

TEST(ShakenPivot, IsForcing) {
    const Pendulum p{.pivot_amplitude = -3, .drive_frequency = 4};
    EXPECT_TRUE(is_driven(p));
    EXPECT_FALSE(is_conservative(p));
    // A rounding each of pi and of the quotient.
    EXPECT_NEAR(characteristic_time(p, {1, 0}), 2 * pi / 4, 2 * ulp(1.5));
    EXPECT_EQ(strobe_frequency(p), 4);
    const auto of_exact = check(Problem{.pendulum = p, .method = Method::exact, .schedule = {.every = 1, .rows = 2}});
    EXPECT_EQ(of_exact.reason, Refusal::Reason::not_conservative);
    const auto without_frequency = check(Pendulum{.pivot_amplitude = -3});
    EXPECT_EQ(without_frequency.reason, Refusal::Reason::needs_frequency);
    EXPECT_STREQ(without_frequency.name, "drive_frequency");
}

TEST(ShakenPivot, AddsToTheStiffnessThatStepsHaveToFollow) {
    const Pendulum p{.pivot_amplitude = -99, .drive_frequency = 1};
    const double fewest = fewest_steps(p);
    EXPECT_EQ(fewest, std::ceil(2 * pi * 10 / 2.82));
    EXPECT_FALSE(check(p, Strobe{.steps_per_period = fewest, .method = Method::rk4}));
    EXPECT_EQ(check(p, Strobe{.steps_per_period = fewest - 1, .method = Method::rk4}).reason, Refusal::Reason::unstable);
}

TEST(ShakenPivot, LocksARotationToItsFrequency) {
    const Pendulum p{.beta = 0.1, .pivot_amplitude = 2, .drive_frequency = 2.5, .drive_phase = 0.75};
    const Flock flock{.omega = {3},
                      .beta = {p.beta},
                      .pivot_amplitude = {p.pivot_amplitude},
                      .drive_frequency = {p.drive_frequency},
                      .drive_phase = {p.drive_phase}};
    for (const auto& strobe : {by_taylor(400, 3), by_rk4(400, 3, 1000)}) {
        const auto found = velocity_of(flock, strobe);
        EXPECT_EQ(found["mean_velocity"][0], p.drive_frequency);
        EXPECT_EQ(found["error"][0], 0);
        // The state at a strobe, where the phase is 0, is that of the trajectory. rk4 errs by some (2 pi/1000)^4/120, 1e-11.
        const auto points = section_of(flock, strobe);
        const double period = 2 * pi / p.drive_frequency, start = (2 * pi - p.drive_phase) / p.drive_frequency;
        auto run = make_taylor(p, {0, 3});
        const auto s = solved(run, start + 400 * period);
        EXPECT_NEAR(points["theta"][0], s.theta, 1e-9);
        EXPECT_NEAR(points["omega"][0], s.omega, 1e-9);
        EXPECT_EQ(points["turns"][1] - points["turns"][0], 1);
    }
}

}  // namespace
