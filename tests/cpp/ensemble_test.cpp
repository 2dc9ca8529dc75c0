// Ensembles are their members one by one, bit for bit: whatever the neighbours, the order of work and the number of threads.
#include <random>

#include "flocks.hpp"
#include "pendula/angle.hpp"
#include "trajectories.hpp"

namespace {

using namespace reference;

constexpr std::size_t most = 130;  // two chunks and a bit
constexpr std::size_t row_count = 4;

constexpr Method every_method[] = {Method::rk4, Method::euler, Method::verlet, Method::taylor, Method::exact};

/// When each member is looked at.
struct Looks {
    std::vector<double> first{0}, every{1}, steps_to_first{1}, steps_per_row{1}, given{}, dt{0};
    EnsembleTimes times() const { return {first, every, row_count, steps_to_first, steps_per_row, given, dt}; }
};

/// Members of every kind that a method takes, in no order: free, with friction, torque, drive or shaken pivot, at rest on top
/// on several turns, and, where it may have a torque, one whose motion leaves the doubles.
Flock mixed(Method method) {
    std::mt19937_64 random(1);
    const auto uniform = [&](double from, double to) {
        return from + (to - from) * (static_cast<double>(random() >> 11) * 0x1p-53);
    };
    Flock f{{}, {}, {}, {}, {}, {}, {}, {}, {}};
    for (std::size_t i = 0; i < most; ++i) {
        const bool is_free = method == Method::exact || i % 6 == 0, is_resting = i % 11 == 4;
        const bool has_friction = !is_free && method != Method::verlet;
        f.theta.push_back(is_resting ? pi * (2.0 * static_cast<double>(i % 5) - 5) : uniform(-10, 10));
        f.omega.push_back(is_resting ? 0 : uniform(-4, 4));
        f.alpha.push_back(uniform(0.2, 5));
        f.beta.push_back(has_friction && i % 2 == 1 ? uniform(0, 1) : 0);
        f.torque.push_back(is_free || is_resting ? 0 : i == 77 ? 1e308 : i % 4 == 1 ? uniform(-1, 1) : 0);
        f.drive_amplitude.push_back(is_free || is_resting || i % 3 == 0 ? 0 : uniform(-2, 2));
        f.pivot_amplitude.push_back(!is_free && i % 5 < 2 ? uniform(-2, 2) : 0);
        f.drive_frequency.push_back(uniform(0.2, 3));
        f.drive_phase.push_back(uniform(-7, 7));
    }
    return f;
}

/// The first members of a flock.
Ensemble first_of(const Flock& flock, std::size_t size) {
    Ensemble e;
    e.size = size;
    const std::pair<Column Ensemble::*, const std::vector<double>*> columns[] = {
        {&Ensemble::theta, &flock.theta},
        {&Ensemble::omega, &flock.omega},
        {&Ensemble::alpha, &flock.alpha},
        {&Ensemble::beta, &flock.beta},
        {&Ensemble::torque, &flock.torque},
        {&Ensemble::drive_amplitude, &flock.drive_amplitude},
        {&Ensemble::pivot_amplitude, &flock.pivot_amplitude},
        {&Ensemble::drive_frequency, &flock.drive_frequency},
        {&Ensemble::drive_phase, &flock.drive_phase}};
    for (const auto& [column, values] : columns) e.*column = std::span(*values).first(size);
    return e;
}

std::vector<double> first_of(const std::vector<double>& values, std::size_t size) {
    return {values.begin(), values.begin() + static_cast<std::ptrdiff_t>(std::min(size, values.size()))};
}

double value_of(const std::vector<double>& column, std::size_t i) { return column[column.size() == 1 ? 0 : i]; }

std::vector<Sample> alone(const Flock& flock, std::size_t i, Method method, const Looks& looks) {
    const Ensemble e = flock.ensemble();
    return all_rows({.pendulum = pendulum_of(e, i),
                     .initial = initial_state_of(e, i),
                     .method = method,
                     .schedule = {.every = value_of(looks.every, i),
                                  .rows = row_count,
                                  .steps_per_row = value_of(looks.steps_per_row, i),
                                  .first = value_of(looks.first, i),
                                  .steps_to_first = value_of(looks.steps_to_first, i),
                                  .times = looks.given,
                                  .dt = value_of(looks.dt, i)}});
}

bool same(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0 || (std::isnan(a) && std::isnan(b)); }

/// Compares ensembles of many sizes, on 1, 2 and 3 threads, with members alone.
void expect_members_alone(Method method, const Looks& looks, std::size_t stride = 31) {
    const Flock flock = mixed(method);
    std::vector<std::vector<Sample>> want;
    for (std::size_t i = 0; i < most; ++i) want.push_back(alone(flock, i, method, looks));
    for (std::size_t size = most; size > 0; size -= std::min(size, stride)) {
        const Looks own{first_of(looks.first, size),
                        first_of(looks.every, size),
                        first_of(looks.steps_to_first, size),
                        first_of(looks.steps_per_row, size),
                        looks.given,
                        first_of(looks.dt, size)};
        const std::vector<double> nowhere(row_count * size, 1e9);
        auto theta = nowhere, omega = nowhere, turns = nowhere;
        const Control control{.threads = 1 + static_cast<int>(size % 3)};
        const auto outcome = solve(first_of(flock, size), method, 1e-15, own.times(), {theta, omega, turns}, control);
        ASSERT_TRUE(outcome.is_done()) << describe(outcome.refusal);
        for (std::size_t i = 0; i < size; ++i)
            for (std::size_t row = 0; row < row_count; ++row) {
                const std::size_t at = row * size + i;
                const Sample& s = want[i][row];
                ASSERT_TRUE(same(theta[at], s.theta) && same(omega[at], s.omega) && same(turns[at], s.turns))
                    << method_names[static_cast<int>(method)] << ", member " << i << " of " << size << ", row " << row;
            }
    }
}

TEST(Ensembles, AreTheirMembersAlone) {
    for (Method method : every_method) expect_members_alone(method, {.every = {0.7}, .steps_per_row = {61}}, 1);
}

TEST(Ensembles, ThatAreLookedAtLateAreTheirMembersAlone) {
    for (Method method : every_method)
        expect_members_alone(method, {.first = {1.3}, .every = {0.7}, .steps_to_first = {97}, .steps_per_row = {40}});
}

TEST(Ensembles, AtGivenTimesAreTheirMembersAlone) {
    std::vector<double> dt;
    for (std::size_t i = 0; i < most; ++i) dt.push_back(0.01 + 0.003 * static_cast<double>(i % 7));
    for (Method method : every_method) {
        expect_members_alone(method, {.given = {0, 0.31, 0.31, 2.5}, .dt = {0.01}});
        expect_members_alone(method, {.given = {0.1, 0.1, 1.7, 30}, .dt = dt});
    }
}

TEST(Ensembles, OfMembersWithTimesAndStepsOfTheirOwnAreTheirMembersAlone) {
    std::mt19937 random(2);
    const auto whole = [&](unsigned from, unsigned to) { return static_cast<double>(from + random() % (to - from)); };
    Looks looks{{}, {}, {}, {}};
    for (std::size_t i = 0; i < most; ++i) {
        looks.first.push_back(i % 4 == 0 ? 0 : 0.1 * whole(1, 21));
        looks.every.push_back(0.1 * whole(1, 10));
        looks.steps_to_first.push_back(whole(30, 130));
        looks.steps_per_row.push_back(whole(20, 70));
    }
    for (Method method : every_method) expect_members_alone(method, looks);
}

TEST(Ensembles, KeepTheTurnsOfMembersAtRestOnTop) {
    const double theta[] = {-pi, 3 * pi, -3 * pi, 0.5}, want[] = {0, 2, -1};
    for (Method method : every_method) {
        double end[8], speed[8], turns[8];
        const EnsembleTimes times{.every = 50, .rows = 2, .steps_per_row = 500};
        ASSERT_TRUE(solve({.size = 4, .theta = theta}, method, 1e-15, times, {end, speed, turns}).is_done());
        for (std::size_t i : {0u, 1u, 2u}) {
            const Sample rest = at(make_exact(1, {theta[i], 0}), 50);
            EXPECT_EQ(rest.turns, want[i]);
            for (std::size_t row : {0u, 1u}) {
                EXPECT_EQ(end[4 * row + i], rest.theta);
                EXPECT_EQ(speed[4 * row + i], 0);
                EXPECT_EQ(turns[4 * row + i], want[i]) << method_names[static_cast<int>(method)] << ' ' << i;
            }
        }
    }
}

// A frequency that is of no account, times a time, leaves the doubles.
TEST(Ensembles, OfMembersWithoutADriveDoNotSeeItsFrequency) {
    const double amplitude[] = {0, 1, 0, 1}, pivot[] = {0, 0, 0, 1}, frequency[] = {1e308, 1, 1e308, 2};
    for (Method method : {Method::rk4, Method::taylor}) {
        double theta[4], omega[4], turns[4];
        const Ensemble e{
            .size = 4, .theta = 1, .drive_amplitude = amplitude, .pivot_amplitude = pivot, .drive_frequency = frequency};
        const EnsembleTimes times{.first = 100, .steps_to_first = 5000};
        ASSERT_TRUE(solve(e, method, 1e-15, times, {theta, omega, turns}).is_done());
        const auto free =
            all_rows({.initial = {1, 0}, .method = method, .schedule = {.rows = 1, .first = 100, .steps_to_first = 5000}});
        for (int i : {0, 2}) {
            EXPECT_EQ(theta[i], free[0].theta) << method_names[static_cast<int>(method)];
            EXPECT_EQ(omega[i], free[0].omega);
        }
    }
}

TEST(Ensembles, AreNaNWhereTheMotionLeavesTheDoublesAndNowhereElse) {
    const double torque[] = {0, 1e308, 0, 0}, omega0[] = {0, 0, 1e308, 0};
    for (Method method : {Method::rk4, Method::euler, Method::verlet, Method::taylor}) {
        double theta[4], omega[4], turns[4], alone[1];
        const EnsembleTimes times{.first = 1e3, .steps_to_first = 1000};
        const Ensemble e{.size = 4, .theta = 1, .omega = omega0, .torque = torque};
        ASSERT_TRUE(solve(e, method, 1e-15, times, {theta, omega, turns}).is_done());
        ASSERT_TRUE(solve({.size = 1, .theta = 1}, method, 1e-15, times, {alone, {&omega[3], 1}, {&turns[3], 1}}).is_done());
        EXPECT_TRUE(std::isnan(theta[1]) && std::isnan(omega[1]));
        EXPECT_TRUE(method != Method::taylor || std::isnan(theta[2]));  // the others take the steps that they are told
        EXPECT_EQ(theta[0], alone[0]);
        EXPECT_EQ(theta[3], alone[0]);
    }
}

TEST(Ensembles, WorkWithDefaults) {
    const std::vector<double> theta{0.1, 0.2, 0.3};
    double end[3], speed[3], turns[3];
    ASSERT_TRUE(solve({.size = 3, .theta = theta}, Method::rk4, 1e-15, {}, {end, speed, turns}).is_done());
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(end[i], theta[i]);  // a row at t = 0
    std::vector<double> none;
    EXPECT_TRUE(solve({}, Method::rk4, 1e-15, {}, {none, none, none}).is_done());
}

}  // namespace
