// Where carried branches end: closed formulas, and the conditions that define the ends, solved by SciPy and mpmath.
#include "flocks.hpp"
#include "pendula/carry.hpp"
#include "reference_table.hpp"

namespace {

using namespace reference;

struct Jumps {
    std::vector<double> value, error, gap, before, after;

    std::vector<std::vector<double>*> columns() { return {&value, &error, &gap, &before, &after}; }
};

const Parameter& parameter(const char* name) {
    return *std::ranges::find_if(parameters, [&](const Parameter& p) { return std::strcmp(p.name, name) == 0; });
}

struct Sweep {
    Flock flock;
    const char* swept;
    std::size_t line;
    double tolerance = 1e-12;
    Strobe strobe{.transient = 100, .periods = 100};

    Outcome locate(Carry carry, Jumps& jumps, const Control& control = {}) const {
        for (auto* column : jumps.columns()) column->resize(flock.size());
        return locate_jumps(flock.ensemble(), line, carry, parameter(swept), tolerance, strobe,
                            {jumps.value, jumps.error, jumps.gap, jumps.before, jumps.after}, control);
    }
    Jumps jumps(Carry carry, const Control& control = {}) const {
        Jumps found;
        const auto outcome = locate(carry, found, control);
        EXPECT_TRUE(outcome.is_done()) << describe(outcome.refusal);
        return found;
    }
};

/// The only member that has a jump before it.
std::size_t only(const Jumps& jumps) {
    std::size_t found = jumps.value.size(), count = 0;
    for (std::size_t i = 0; i < jumps.value.size(); ++i)
        if (!std::isnan(jumps.value[i])) found = i, ++count;
    EXPECT_EQ(count, 1u);
    return count == 1 ? found : 0;
}

/// Expects a jump at `value`, to half the width of the interval and `more`.
std::size_t expect_jump(const Jumps& jumps, double value, double tolerance, double more) {
    const std::size_t i = only(jumps);
    EXPECT_LE(jumps.error[i], tolerance);
    EXPECT_LE(std::abs(jumps.value[i] - value), jumps.error[i] + more);
    return i;
}

constexpr double rest = static_cast<double>(Kind::fixed_point), turning = static_cast<double>(Kind::rotating),
                 orbit = static_cast<double>(Kind::periodic);

Sweep junction(double alpha, double beta) {
    const auto torques = linspace(0.02 * alpha, 1.12 * alpha, 12);
    return {{.alpha = {alpha}, .beta = {beta}, .torque = torques}, "torque", 12};
}

TEST(Jump, FromRestOfAJunctionIsWhereTheFixedPointVanishes) {
    for (double alpha : {1.0, 4.0}) {
        const auto jumps = junction(alpha, 0.2).jumps(Carry::up);
        const std::size_t i = expect_jump(jumps, alpha, 1e-12, 0);
        EXPECT_EQ(jumps.before[i], rest);
        EXPECT_EQ(jumps.after[i], turning);
    }
}

TEST(Jump, FromRestIsFoundWhereTheSweepHasAMemberExactlyThere) {
    for (double beta : {0.2, 0.5, 1.0, 2.0})
        for (double tolerance : {0.1, 1e-3, 1e-6, 1e-9}) {
            const Sweep sweep{{.beta = {beta}, .torque = {0.5, 1, 1.5}}, "torque", 3, tolerance};
            const auto jumps = sweep.jumps(Carry::up);
            const std::size_t i = expect_jump(jumps, 1, tolerance, 1e-15);  // of the rounding of the interval's middle
            EXPECT_EQ(jumps.before[i], rest);
            EXPECT_EQ(jumps.after[i], turning);
        }
}

TEST(Jump, ToRestOfAJunctionIsWhereTheCycleMeetsTheSaddle) {
    for (const Row& row : table("jumps.txt", "retrapping")) {
        const auto jumps = junction(1, row[0]).jumps(Carry::down);
        const std::size_t i = expect_jump(jumps, row[1], 1e-12, 1e-14);  // of the rounding of the turns
        EXPECT_EQ(jumps.before[i], turning);
        EXPECT_EQ(jumps.after[i], rest);
    }
}

Sweep resonance(double amplitude) {
    return {
        {.beta = {0.05}, .drive_amplitude = {amplitude}, .drive_frequency = linspace(0.805, 1.005, 9)}, "drive_frequency", 9};
}

TEST(Jump, OfADrivenResonanceIsASaddleNode) {
    const auto folds = table("jumps.txt", "fold");
    for (Carry carry : {Carry::up, Carry::down}) {
        const auto jumps = resonance(0.06).jumps(carry);
        const std::size_t i = expect_jump(jumps, folds.at(carry == Carry::up ? 0 : 1)[2], 1e-12, 1e-11);  // of both solutions
        EXPECT_EQ(jumps.before[i], orbit);
        EXPECT_EQ(jumps.after[i], orbit);
        EXPECT_GT(jumps.gap[i], 0.5);
    }
}

TEST(Jump, IsNoneWhereSweepsUpAndDownAgree) {
    const auto sweep = resonance(0.015);
    for (Carry carry : {Carry::up, Carry::down}) {
        auto jumps = sweep.jumps(carry);
        for (auto* column : jumps.columns())
            for (double x : *column) EXPECT_TRUE(std::isnan(x));
    }
    std::vector<double> columns[2][9];
    for (Carry carry : {Carry::up, Carry::down}) {
        auto& c = columns[static_cast<int>(carry)];
        for (auto& column : c) column.resize(9);
        ASSERT_TRUE(measure_carried(Measure::attractors, sweep.flock.ensemble(), 9, carry, sweep.strobe,
                                    {c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7], c[8]})
                        .is_done());
    }
    for (std::size_t i = 0; i < 9; ++i) EXPECT_NEAR(columns[0][4][i], columns[1][4][i], 1e-9);
}

TEST(Jump, IsFoundWhereAPeriodDoubles) {
    const auto doublings = table("jumps.txt", "doubling");
    const Sweep first{published({1.03, 1.05, 1.07}), "drive_amplitude", 3};
    const Sweep second{published({1.40, 1.43, 1.455}), "drive_amplitude", 3};
    for (int which : {0, 1}) {
        const double value = doublings.at(which)[2];
        const auto& sweep = which == 0 ? first : second;
        expect_jump(sweep.jumps(Carry::up), value, 1e-12, 1e-11);
        // The doubled orbit cannot be told from the other when they are near. They are apart by the square root of the distance
        // from `value`.
        const auto down = sweep.jumps(Carry::down);
        EXPECT_LT(down.gap[expect_jump(down, value, 1e-12, 1e-8)], 0.05);
    }
}

TEST(Jump, HasTheSameBitsFromAnyThreadsAndBesideAnyLines) {
    Sweep sweep = junction(1, 0.2);
    const auto alone = sweep.jumps(Carry::down);
    std::vector<double> torques, frictions;
    for (double beta : {0.1, 0.2, 0.4})
        for (double torque : sweep.flock.torque) {
            torques.push_back(torque);
            frictions.push_back(beta);
        }
    sweep.flock.torque = torques;
    sweep.flock.beta = frictions;
    auto one = sweep.jumps(Carry::down, {.threads = 1}), many = sweep.jumps(Carry::down, {.threads = 5});
    for (std::size_t c = 0; c < 5; ++c) EXPECT_TRUE(same_bits(*one.columns()[c], *many.columns()[c]));
    for (std::size_t i = 0; i < 12; ++i) {
        const double beside = one.value[12 + i], x = alone.value[i];
        EXPECT_TRUE(beside == x || (std::isnan(beside) && std::isnan(x)));
    }
}

TEST(Jump, IsRefusedWithoutAParameterOfThePendulumOrATolerance) {
    Jumps jumps;
    Sweep sweep = junction(1, 0.2);
    for (const char* name : {"theta0", "omega0", "drive_phase"}) {
        sweep.swept = name;
        EXPECT_STREQ(sweep.locate(Carry::up, jumps).refusal.name, "swept");
    }
    sweep.swept = "torque";
    sweep.line = 5;
    EXPECT_EQ(sweep.locate(Carry::up, jumps).refusal.reason, Refusal::Reason::length);
    sweep.line = 12;
    for (double tolerance : {0.0, -1.0, std::nan("")}) {
        sweep.tolerance = tolerance;
        EXPECT_STREQ(sweep.locate(Carry::up, jumps).refusal.name, "jump_tolerance");
    }
}

TEST(Jump, SearchTellsItsProgressAndStops) {
    double latest = 0;
    bool is_monotonic = true;
    const Control control{1, [&](double done) {
                              is_monotonic = is_monotonic && done >= latest && done <= 1;
                              latest = done;
                              return done < 0.6;
                          }};
    Jumps jumps;
    EXPECT_EQ(junction(1, 0.2).locate(Carry::up, jumps, control).kind, Outcome::Kind::stopped);
    EXPECT_TRUE(is_monotonic);
    EXPECT_LT(latest, 0.7);
}

}  // namespace
