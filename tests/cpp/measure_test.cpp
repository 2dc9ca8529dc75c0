// Sections, and what holds for every measure: the same bits on any threads and beside any neighbours.
#include "flocks.hpp"
#include "pendula/angle.hpp"
#include "pendula/exact.hpp"

namespace {

using namespace reference;

TEST(Section, IsTheSolutionAtTheDrivesPhaseZero) {
    for (double phase : {0.0, 1.0, -2.0, 100.0}) {
        Flock flock = published({0.9, 1.35});
        flock.drive_phase = {phase};
        const double period = 2 * pi / (2.0 / 3);
        double first = std::remainder(-phase / (2 * pi), 1.0);
        first = (first < 0 ? first + 1 : first) * period;
        const auto points = section_of(flock, by_rk4(3, 4, 1000));
        double theta[14], omega[14], turns[14];
        const EnsembleTimes times{.first = first, .every = period, .rows = 7, .steps_to_first = 1000, .steps_per_row = 1000};
        ASSERT_TRUE(solve(flock.ensemble(), Method::rk4, 1e-15, times, {theta, omega, turns}).is_done());
        for (int i = 0; i < 8; ++i) {
            EXPECT_NEAR(points["theta"][i] + 2 * pi * points["turns"][i], theta[6 + i] + 2 * pi * turns[6 + i], 1e-7) << phase;
            EXPECT_NEAR(points["omega"][i], omega[6 + i], 1e-7);
            EXPECT_GE(points["theta"][i], -pi);
            EXPECT_LT(points["theta"][i], pi);
        }
    }
}

TEST(Section, WithoutADriveIsTheClosedFormAtPeriodsOfSmallSwings) {
    const auto points = section_of({.theta = {2.5}, .alpha = {4}}, by_rk4(0, 5, 2000));
    const auto solution = make_exact(4, {2.5, 0});
    for (int n = 0; n < 5; ++n) {
        const double t = n * pi;
        double theta, omega, turns;
        at(solution, 1, &t, &theta, &omega, &turns);
        EXPECT_NEAR(points["theta"][n], theta, 1e-9);
        EXPECT_NEAR(points["omega"][n], omega, 1e-9);
    }
}

TEST(Section, GoesOnFromAnyOfItsPointsWithTheSameBits) {
    Flock flock = published({1.5});
    const auto whole = section_of(flock, by_rk4(0, 40, 150));
    flock.theta = {whole["theta"][15]};
    flock.omega = {whole["omega"][15]};
    const auto rest = section_of(flock, by_rk4(0, 25, 150));
    for (const char* name : {"theta", "omega"})
        EXPECT_TRUE(same_bits(rest[name], {whole[name].begin() + 15, whole[name].end()})) << name;
}

TEST(Section, StartsAtAnyPhaseBesideMembersThatStartAtZero) {
    Flock flock = published({1.2});
    flock.drive_phase = {0, 1};
    const auto both = section_of(flock, by_rk4(0, 2, 100));
    flock.drive_phase = {0};
    const auto alone = section_of(flock, by_rk4(0, 2, 100));
    for (int row : {0, 1}) EXPECT_EQ(both["theta"][2 * row], alone["theta"][row]);
}

TEST(Section, OfTaylorIsThatOfFineSteps) {
    Flock flock = published({0.9, 1.07, 1.35});
    flock.drive_phase = {1};
    const auto taylor = section_of(flock, {.transient = 20, .periods = 3});
    const auto rk4 = section_of(flock, by_rk4(20, 3, 8000));
    for (int i = 0; i < 9; ++i) {
        EXPECT_NEAR(taylor["theta"][i], rk4["theta"][i], 1e-9);
        EXPECT_NEAR(taylor["omega"][i], rk4["omega"][i], 1e-9);
    }
}

/// Shaken, driven, both and neither, side by side: regular, chaotic and undriven.
Flock of_all_kinds(std::size_t size) {
    Flock flock = published(linspace(0.9, 1.5, size));
    flock.drive_frequency = linspace(0.3, 1, size);
    flock.torque = linspace(0.4, 1.2, size);
    flock.pivot_amplitude.assign(size, 0);
    for (std::size_t i = 0; i < size; ++i) {
        if (i % 3 == 1) flock.pivot_amplitude[i] = 0.4;
        if (i % 4 == 1) flock.drive_amplitude[i] = 0;
        if (i % 5 < 3) flock.torque[i] = 0;
    }
    return flock;
}

Flock member_of(const Flock& flock, std::size_t i) {
    Flock alone = published({flock.drive_amplitude[i]});
    alone.drive_frequency = {flock.drive_frequency[i]};
    alone.torque = {flock.torque[i]};
    alone.pivot_amplitude = {flock.pivot_amplitude[i]};
    return alone;
}

/// The results of member i of a flock are those of `alone`.
void expect_member(const Table& all, std::size_t i, std::size_t size, const Table& alone) {
    for (std::size_t c = 0; c < all.columns.size(); ++c)
        for (std::size_t row = 0; row < alone.columns[c].size(); ++row)
            EXPECT_TRUE(same_bits({all.columns[c][row * size + i]}, {alone.columns[c][row]})) << i << ' ' << c << ' ' << row;
}

constexpr Measure every_measure[] = {Measure::section, Measure::mean_velocity, Measure::lyapunov, Measure::attractors,
                                     Measure::orbit};

TEST(Measures, HaveTheSameBitsWhateverTheNeighboursAndTheNumberOfThreads) {
    constexpr std::size_t size = 75;
    const auto flock = of_all_kinds(size);
    for (auto strobe : {by_taylor(5, 20), by_rk4(5, 20, 100)}) {
        strobe.budget = 60;
        strobe.history_rows = 3;
        for (const auto what : every_measure) {
            const auto all = measured(what, flock, strobe, {1});
            for (int threads : {2, 5}) EXPECT_TRUE(same_bits(measured(what, flock, strobe, {threads}), all)) << threads;
            for (std::size_t i : {0u, 1u, 5u, 7u, 9u, 40u, 74u})
                expect_member(all, i, size, measured(what, member_of(flock, i), strobe, {1}));
        }
    }
}

TEST(Measures, AreNaNWhereTheMotionLeavesTheDoublesAndNowhereElse) {
    Flock flock = published({0.1, 0.1, 0.1});
    flock.torque = {0, 1e308, -1e308};
    for (auto strobe : {by_taylor(2, 8), by_rk4(2, 8, 100)}) {
        strobe.history_rows = 2;
        for (const auto what : every_measure) {
            const auto all = measured(what, flock, strobe);
            expect_member(all, 0, 3, measured(what, published({0.1}), strobe));
            for (std::size_t c = 0; c < all.columns.size(); ++c) {
                const std::string name = measures[static_cast<int>(what)].columns[c].name;
                if (name == "t") continue;
                EXPECT_FALSE(std::isnan(all.columns[c].front())) << name;
                for (std::size_t i : {1u, 2u}) {
                    if (name == "kind")
                        EXPECT_EQ(all.kind(i), Kind::lost);
                    else if (name == "label")
                        EXPECT_EQ(all["label"][i], 0);
                    else
                        EXPECT_TRUE(std::isnan(all.columns[c][all.columns[c].size() - 3 + i])) << name;
                }
            }
        }
    }
}

TEST(ShareError, IsWilsonsInterval) {
    // By SciPy: binomtest(count, trials).proportion_ci(method="wilson"), the farther end from count/trials.
    const struct {
        double count, trials, error;
    } cases[] = {{0, 10, 0.27753279986288926},     {1, 10, 0.3041500267952385},      {5, 10, 0.26340690948743606},
                 {123, 256, 0.061037474653622525}, {256, 256, 0.014783856425871433}, {3, 10000, 0.0005817357722363798},
                 {1, 1, 0.7934506856227626},       {40, 100, 0.09799741320893818}};
    for (const auto& c : cases)
        EXPECT_NEAR(share_error(c.count, c.trials), c.error, 4e-5 * c.error) << c.count;  // 1.96 for 1.959964
}

}  // namespace
