// Programs that are numbers: right ones against closed forms and the core's own steps, wrong ones against their formulas.
#include "pendula/replay.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "pendula/angle.hpp"
#include "pendula/exact.hpp"
#include "pendula/steps.hpp"
#include "pendula/validate.hpp"
#include "rk4_rounding.hpp"
#include "trajectories.hpp"

namespace {

using namespace pendula;
using namespace reference;

constexpr double inf = std::numeric_limits<double>::infinity();
const double nan = std::nan("");

using Matrix = std::vector<std::vector<double>>;

/// The coefficients of a program, which outlive it.
struct Stepper {
    std::size_t stages;
    double h;
    std::vector<double> coefficients = std::vector<double>(stages * (3 + 4 * stages)), sums = std::vector<double>(4 * stages);

    enum Part { P, Q, R, U };
    double* row(std::size_t s) { return coefficients.data() + s * (3 + 4 * stages); }
    double& at(Part part, std::size_t s, std::size_t j) { return row(s)[3 + part * stages + j]; }
    double& sum(Part part, std::size_t j) { return sums[part * stages + j]; }  // b, d, e, k

    /// Stage s sees the state.
    void see(std::size_t s, double c) { row(s)[0] = row(s)[1] = 1, row(s)[2] = c; }

    Program program(State initial, std::span<const std::int64_t> steps, const Pendulum& pendulum = {}) const {
        return {.initial = initial,
                .pendulum = pendulum,
                .dt = h,
                .stages = stages,
                .coefficients = coefficients,
                .sums = sums,
                .steps = steps};
    }
};

Stepper runge_kutta(const Matrix& a, const std::vector<double>& b, double h) {
    Stepper s{b.size(), h};
    for (std::size_t i = 0; i < b.size(); ++i) {
        double c = 0;
        for (std::size_t j = 0; j < i; ++j) {
            s.at(Stepper::P, i, j) = s.at(Stepper::U, i, j) = a[i][j] * h;
            c += a[i][j];
        }
        s.see(i, c * h);
        s.sum(Stepper::P, i) = s.sum(Stepper::U, i) = b[i] * h;
    }
    return s;
}

Stepper euler(double h) { return runge_kutta({{}}, {1}, h); }
Stepper midpoint(double h) { return runge_kutta({{}, {0.5}}, {0, 1}, h); }
Stepper rk4(double h) { return runge_kutta({{}, {0.5}, {0, 0.5}, {0, 0, 1}}, {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6}, h); }

/// Kick, drift, kick: v[1] is the velocity in the middle.
Stepper verlet(double h) {
    Stepper s{3, h};
    for (std::size_t i = 0; i < 3; ++i) s.see(i, i == 2 ? h : 0);
    s.at(Stepper::U, 1, 0) = s.at(Stepper::U, 2, 0) = h / 2;
    s.at(Stepper::P, 2, 1) = h;
    s.sum(Stepper::P, 1) = h;
    s.sum(Stepper::U, 0) = s.sum(Stepper::U, 2) = h / 2;
    return s;
}

/// The rows of some programs, one behind the other.
std::vector<State> rows_of(std::span<const Program> programs, int threads = 1) {
    const std::size_t size = programs.size() * programs[0].steps.size();
    std::vector<double> theta(size), omega(size);
    require(replay(programs, {theta, omega}, {threads}));
    std::vector<State> rows;
    for (std::size_t i = 0; i < size; ++i) rows.push_back({theta[i], omega[i]});
    return rows;
}

std::vector<State> rows_of(const Program& program) { return rows_of(std::span(&program, 1)); }

bool same(double a, double b) { return __builtin_bit_cast(std::uint64_t, a) == __builtin_bit_cast(std::uint64_t, b); }
bool same(const std::vector<State>& a, const std::vector<State>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](State x, State y) { return same(x.theta, y.theta) && same(x.omega, y.omega); });
}

std::vector<std::int64_t> counted(std::int64_t last, std::int64_t every = 1) {
    std::vector<std::int64_t> steps;
    for (std::int64_t n = 0; n <= last; n += every) steps.push_back(n);
    return steps;
}

double distance(State a, State b) { return std::hypot(a.theta - b.theta, a.omega - b.omega); }

// A step of x'' = -alpha x - beta x' is the exponential series of h times its matrix, up to the power of the order.
void expect_truncated_exponential(const Stepper& stepper, int order) {
    constexpr double alpha = 2, beta = 0.125;
    const auto steps = counted(1000);
    Program program = stepper.program({0.75, -0.5}, steps, {.alpha = alpha, .beta = beta});
    program.force = Force::linear;
    const auto rows = rows_of(program);
    long double x = 0.75L, v = -0.5L;
    double largest = 0;
    for (const State& row : rows) {
        largest =
            std::max({largest, std::fabs(row.theta - static_cast<double>(x)), std::fabs(row.omega - static_cast<double>(v))});
        long double sum_x = x, sum_v = v;
        for (int k = order; k > 0; --k) {
            const long double of_x = sum_v, of_v = -alpha * sum_x - beta * sum_v, h = stepper.h / static_cast<long double>(k);
            sum_x = x + h * of_x;
            sum_v = v + h * of_v;
        }
        x = sum_x;
        v = sum_v;
    }
    EXPECT_LE(largest, 1000 * 3 * 1.2e-16);  // 3 roundings of numbers around 1 in a step, which damping lets decay
    EXPECT_GT(std::fabs(rows.back().theta), 1e-4);
}

TEST(Replay, OfTheLinearPendulumIsTheSeriesOfTheExponential) {
    expect_truncated_exponential(euler(1.0 / 64), 1);
    expect_truncated_exponential(midpoint(1.0 / 64), 2);
    expect_truncated_exponential(rk4(1.0 / 64), 4);
}

double order_of(Stepper (*method)(double h), std::int64_t steps) {
    const State initial{1.5, 0.3};
    const Sample end = at(make_exact(1, initial), 1.0);
    const auto error = [&](std::int64_t n) {
        const std::int64_t last[] = {n};
        return distance(rows_of(method(1.0 / static_cast<double>(n)).program(initial, last))[0], {end.theta, end.omega});
    };
    return std::log2(error(steps) / error(2 * steps));
}

// Steps at which the error is far above rounding and the next order is below a tenth of it.
TEST(Replay, ConvergesAtTheOrderOfTheMethod) {
    EXPECT_NEAR(order_of(euler, 256), 1, 0.1);
    EXPECT_NEAR(order_of(midpoint, 64), 2, 0.1);
    EXPECT_NEAR(order_of(verlet, 64), 2, 0.1);
    EXPECT_NEAR(order_of(rk4, 32), 4, 0.1);
}

constexpr Pendulum shaken{1.5, 0.25, 0.5, 0.75, 0.5, 2.0 / 3, 1};

/// The largest distance from the core's own steps over 200 steps.
template <class Step>
double from_own_steps(const Stepper& stepper, const Pendulum& pendulum, Step step) {
    const auto rows = rows_of(stepper.program({0.4, 1.1}, counted(200), pendulum));
    State state{0.4, 1.1};
    double largest = 0;
    for (std::size_t n = 0; n < rows.size(); ++n) {
        largest = std::max(largest, distance(rows[n], state));
        state = step(pendulum, state, static_cast<double>(n) * stepper.h, stepper.h);
    }
    return largest;
}

TEST(Replay, MakesTheStepsOfTheCore) {
    EXPECT_EQ(from_own_steps(euler(0.01), shaken, euler_step), 0);
    // Over 2 s the errors of some roundings of numbers around 1 in each of 200 steps grow by less than 4.
    constexpr double slack = 200 * 4 * 1.2e-16 * 4;
    EXPECT_LE(from_own_steps(rk4(0.01), shaken, rk4_step), slack);
    Pendulum frictionless = shaken;
    frictionless.beta = 0;
    EXPECT_LE(from_own_steps(verlet(0.01), frictionless, verlet_step), slack);
}

// `solve` sums with compensation; here the roundings of 1e4 steps add up as in a plain program, to 1e-15 to 4e-11 after 100 s.
// Two sums of roundings differ by a factor, of up to 7 as measured.
TEST(Replay, OfARightProgramRoundsAsPlainFormulasOverTenThousandSteps) {
    const auto steps = counted(10000, 100);
    for (const State initial : {State{1, 0.3}, State{0.1, 0}, State{2, 0}, State{2.5, -0.5}, State{-1, 1.5}, State{0.5, 2.2}}) {
        const auto rows = rows_of(rk4(0.01).program(initial, steps));
        State plain = initial;
        Largest own, of_plain;
        for (const Sample& want : all_rows(stepwise(Method::rk4, 1, initial, 0.01, 100, 100))) {
            const State state{unwrapped(want), want.omega};
            own(distance(rows[static_cast<std::size_t>(std::lround(want.t))], state));
            of_plain(distance(plain, state));
            for (int n = 0; n < 100; ++n) plain_rk4(1, plain.theta, plain.omega, 0.01);
        }
        EXPECT_LE(own.value, 20 * of_plain.value) << initial.theta << ' ' << initial.omega;
    }
}

TEST(Replay, KnowsTheForcesThatStandInTheSinesPlace) {
    const std::int64_t once[] = {1};
    const auto stepper = euler(0.5);
    const auto force_at = [&](Force force, double x, double scale) {
        Program program = stepper.program({x, 0}, once, {.alpha = 2});
        program.force = force;
        program.scale = scale;
        return -rows_of(program)[0].omega;  // h alpha is 1
    };
    for (double x : {-2.5, -0.3, 0.0, 1.0, 7.0})
        for (double scale : {1.0, 0.25, pi / 180}) {
            const double y = scale * x, slack = 1e-15 * (1 + std::pow(std::fabs(y), 5) / 120);
            EXPECT_NEAR(force_at(Force::sine, x, scale), std::sin(y), slack);
            EXPECT_NEAR(force_at(Force::cosine, x, scale), std::cos(y), slack);
            EXPECT_EQ(force_at(Force::linear, x, scale), y);
            EXPECT_NEAR(force_at(Force::cubic, x, scale), y - std::pow(y, 3) / 6, slack);
            EXPECT_NEAR(force_at(Force::quintic, x, scale), y - std::pow(y, 3) / 6 + std::pow(y, 5) / 120, slack);
        }
}

/// (3.10) with floats, for a driven pendulum with friction.
std::vector<State> plain_floats(const Pendulum& p, State initial, double dt, std::size_t count) {
    const auto alpha = static_cast<float>(p.alpha), beta = static_cast<float>(p.beta), torque = static_cast<float>(p.torque),
               amplitude = static_cast<float>(p.drive_amplitude), frequency = static_cast<float>(p.drive_frequency),
               phase = static_cast<float>(p.drive_phase), h = static_cast<float>(dt), half = h / 2,
               sixth = static_cast<float>(dt / 6), third = static_cast<float>(dt / 3);
    const auto slope = [&](float theta, float omega, float t) {
        const auto sine = static_cast<float>(std::sin(static_cast<double>(theta)));
        const auto cosine = static_cast<float>(std::cos(static_cast<double>(frequency * t + phase)));
        return torque + amplitude * cosine - alpha * sine - beta * omega;
    };
    auto theta = static_cast<float>(initial.theta), omega = static_cast<float>(initial.omega);
    std::vector<State> rows;
    for (std::size_t n = 0; n < count; ++n) {
        rows.push_back({theta, omega});
        const float t = static_cast<float>(n) * h;
        const float va = omega, aa = slope(theta, va, t);
        const float vb = omega + half * aa, ab = slope(theta + half * va, vb, t + half);
        const float vc = omega + half * ab, ac = slope(theta + half * vb, vc, t + half);
        const float vd = omega + h * ac, ad = slope(theta + h * vc, vd, t + h);
        theta += sixth * va + third * vb + third * vc + sixth * vd;
        omega += sixth * aa + third * ab + third * ac + sixth * ad;
    }
    return rows;
}

TEST(Replay, WithFloatsIsAProgramWithFloats) {
    const auto steps = counted(2000);
    const Pendulum driven{
        .alpha = 1.3, .beta = 0.1, .torque = 0.2, .drive_amplitude = 0.7, .drive_frequency = 0.6, .drive_phase = 0.4};
    const auto stepper = rk4(0.01);
    Program program = stepper.program({1.1, 0.3}, steps, driven);
    const auto with_doubles = rows_of(program);
    program.is_single = true;
    const auto with_floats = rows_of(program), want = plain_floats(driven, {1.1, 0.3}, 0.01, steps.size());
    EXPECT_TRUE(same(with_floats, want));
    double largest = 0;
    for (std::size_t i = 0; i < steps.size(); ++i) largest = std::max(largest, distance(with_doubles[i], with_floats[i]));
    EXPECT_GT(largest, 1e-6);  // half an ulp of a float near 1 is 6e-8, and there are 2000 steps
    EXPECT_LT(largest, 1e-3);
}

TEST(Replay, GivesARowForEachNumberOfSteps) {
    const auto stepper = rk4(0.1);
    const std::int64_t some[] = {0, 0, 3, 3, 3, 1500, 4001};
    const auto all = counted(4001);
    const auto rows = rows_of(stepper.program({1, 0}, some)), every = rows_of(stepper.program({1, 0}, all));
    for (std::size_t i = 0; i < rows.size(); ++i) EXPECT_TRUE(same({rows[i]}, {every[static_cast<std::size_t>(some[i])]})) << i;
    EXPECT_EQ(rows[1].theta, 1);
    EXPECT_TRUE(rows_of(stepper.program({1, 0}, {})).empty());
}

/// Programs of every kind, one behind the other, with 5 rows each.
struct Mixed {
    std::vector<Stepper> steppers;
    std::vector<std::array<std::int64_t, 5>> steps;
    std::vector<Program> programs;

    explicit Mixed(std::size_t count) {
        std::mt19937_64 random(1);
        const auto uniform = [&](double from, double to) {
            return from + (to - from) * (static_cast<double>(random() >> 11) * 0x1p-53);
        };
        for (std::size_t i = 0; i < count; ++i) {
            steppers.push_back(rk4(uniform(0.001, 0.1)));
            if (i % 4 == 1) steppers.back().at(Stepper::Q, 2, 1) = uniform(-1, 1);
            if (i % 4 == 2) steppers.back().row(1)[0] = uniform(0, 2);
            const auto first = static_cast<std::int64_t>(random() % 2), every = static_cast<std::int64_t>(random() % 700);
            steps.push_back({first, first + every, first + every, first + 2 * every, first + 3 * every});
        }
        for (std::size_t i = 0; i < count; ++i) {
            Pendulum p{.alpha = uniform(-1, 3)};
            if (i % 2 == 1) p.beta = uniform(0, 1);
            if (i % 5 == 1) p.torque = uniform(-1, 1);
            if (i % 3 == 1) p.drive_amplitude = uniform(-2, 2);
            if (i % 7 == 1) p.pivot_amplitude = uniform(-2, 2);
            p.drive_frequency = i % 3 == 0 ? inf : uniform(0.2, 3);  // of no use without a drive
            if (i % 7 == 1) p.drive_frequency = 2;
            programs.push_back(steppers[i].program({uniform(-3, 3), i == 11 ? nan : uniform(-3, 3)}, steps[i], p));
            programs[i].force = static_cast<Force>(i % 6 % 5);
            programs[i].scale = i == 5 ? 1e300 : uniform(0.5, 2);
            programs[i].is_single = i % 4 == 3;
        }
    }
};

TEST(Replay, GivesTheSameBitsBesideAnyOthersOnAnyNumberOfThreads) {
    const Mixed mixed(45);
    std::vector<State> alone;
    for (const Program& program : mixed.programs)
        for (const State& row : rows_of(program)) alone.push_back(row);
    std::size_t finite = 0;
    for (const State& row : alone) finite += std::isfinite(row.theta);
    EXPECT_GT(finite, alone.size() / 2);
    EXPECT_LT(finite, alone.size());
    for (int threads : {0, 1, 2, 3}) EXPECT_TRUE(same(rows_of(mixed.programs, threads), alone)) << threads;
}

TEST(Replay, OfWhatIsNotFiniteIsNanAndEndsAtOnce) {
    const auto stepper = euler(1);
    const std::int64_t steps[] = {0, 1, 2, 1000, std::int64_t{1} << 53};
    Program program = stepper.program({1, 0}, steps, {.alpha = -1e155});
    program.force = Force::linear;
    auto rows = rows_of(program);  // omega is 1e155, then theta is too, then omega is infinite
    EXPECT_EQ(rows[2].theta, 1e155 + 1);
    for (std::size_t i = 3; i < 5; ++i) EXPECT_TRUE(std::isnan(rows[i].theta) && std::isnan(rows[i].omega)) << i;
    for (double bad : {nan, inf, -inf}) {
        for (const State& row : rows_of(stepper.program({bad, 0}, steps))) EXPECT_TRUE(std::isnan(row.theta + row.omega));
        rows = rows_of(stepper.program({1, 0}, steps, {.torque = bad}));
        EXPECT_EQ(rows[0].theta, 1);
        for (std::size_t i = 1; i < 5; ++i) EXPECT_TRUE(std::isnan(rows[i].theta) && std::isnan(rows[i].omega)) << i;
    }
    program.is_single = true;  // 1e155 is no float
    EXPECT_TRUE(std::isnan(rows_of(program)[1].omega));
}

/// What a call with this program behind a legal one is refused for.
Refusal refusal_of(const Program& program, std::size_t values = 100) {
    static const auto stepper = euler(0.1);
    static const std::int64_t steps[] = {0, 1};
    const Program programs[] = {stepper.program({1, 0}, steps), program};
    std::vector<double> theta(values, 7), omega(values, 7);
    const Outcome outcome = replay(programs, {theta, omega});
    if (outcome.refusal) {
        for (double x : theta) EXPECT_EQ(x, 7);  // nothing was done
    }
    return outcome.refusal;
}

TEST(Replay, RefusesWhatIsNotLegal) {
    using enum Refusal::Reason;
    const auto expect = [](const Refusal& refusal, Refusal::Reason reason, const std::string& name, std::size_t row) {
        EXPECT_EQ(refusal.reason, reason) << name << ": " << describe(refusal);
        EXPECT_EQ(refusal.name, name);
        EXPECT_EQ(refusal.row, row);
    };
    constexpr std::size_t nowhere = Refusal::no_member;
    const std::int64_t steps[] = {0, 1};
    const auto stepper = euler(0.1), longer = midpoint(0.1);
    const Program good = stepper.program({1, 0}, steps);
    EXPECT_FALSE(refusal_of(good, 4));
    expect(refusal_of(good, 3), length, "theta", nowhere);
    const auto with = [&](std::int64_t first, std::int64_t last) {
        const std::int64_t given[] = {first, last};
        return refusal_of(stepper.program({1, 0}, given));
    };
    expect(with(-1, 1), whole, "steps", 0);
    expect(with(2, 1), decreasing, "steps", 1);
    expect(with(0, (std::int64_t{1} << 53) + 1), too_many_steps, "steps", 1);
    expect(refusal_of(stepper.program({1, 0}, std::span(steps, 1))), length, "steps", nowhere);
    expect(refusal_of(longer.program({1, 0}, steps)), whole, "stages", nowhere);  // not as many as the first
    Program bad = good;
    bad.stages = 0;
    expect(refusal_of(bad), whole, "stages", nowhere);
    const std::vector<double> numbers(9 * (3 + 4 * 9));
    bad = {.stages = 9, .coefficients = numbers, .sums = std::span(numbers).first(36), .steps = steps};
    expect(refusal_of(bad), whole, "stages", nowhere);
    const Program alone[] = {bad};
    double theta[2], omega[2];
    expect(replay(alone, {theta, omega}).refusal, whole, "stages", nowhere);
    bad = good;
    bad.coefficients = bad.coefficients.first(6);
    expect(refusal_of(bad), length, "coefficients", nowhere);
    bad = good;
    bad.sums = {};
    expect(refusal_of(bad), length, "sums", nowhere);
    bad = good;
    bad.force = static_cast<Force>(5);
    expect(refusal_of(bad), not_among, "force", nowhere);
    EXPECT_EQ(refusal_of(bad).member, 1u);
    expect(replay(std::span(&good, 1), {theta, omega}, {-1}).refusal, whole, "threads", nowhere);
    EXPECT_TRUE(replay({}, {}).is_done());
}

}  // namespace
