// Carried sweeps: hysteresis, and the parameters at which a branch ends.
#include "pendula/carry.hpp"

#include "flocks.hpp"
#include "pendula/angle.hpp"

namespace {

using namespace reference;

Table carried(Measure what, const Flock& flock, std::size_t line, Carry carry, const Strobe& strobe,
              const Control& control = {}) {
    return filled(what, flock, strobe, [&](const Ensemble& e, const Results& r) {
        return measure_carried(what, e, line, carry, strobe, r, control);
    });
}

/// A Josephson junction: alpha = 1, beta = 0.2.
Flock junction(std::vector<double> torques, State initial = {}) {
    return {.theta = {initial.theta}, .omega = {initial.omega}, .beta = {0.2}, .torque = std::move(torques)};
}

/// Lines of the torque for several frictions.
Flock junctions(const std::vector<double>& frictions, const std::vector<double>& torques) {
    Flock flock;
    flock.beta.clear();
    flock.torque.clear();
    for (double beta : frictions)
        for (double torque : torques) {
            flock.beta.push_back(beta);
            flock.torque.push_back(torque);
        }
    return flock;
}

constexpr Strobe quick{.transient = 40, .periods = 20};

TEST(CarriedSweep, OfOneMemberIsTheMeasure) {
    Flock flock = published({0.9, 1.07, 1.15, 1.35});
    flock.drive_phase = {1};
    for (const auto& info : measures) {
        const auto alone = measured(info.measure, flock, quick);
        EXPECT_TRUE(same_bits(carried(info.measure, flock, 1, Carry::up, quick), alone)) << info.name;
    }
}

TEST(CarriedSweep, StartsEachMemberWhereItsNeighbourEnded) {
    const Flock flock = published({0.9, 1.0, 1.07});
    for (Carry carry : {Carry::up, Carry::down}) {
        const auto section = carried(Measure::section, flock, 3, carry, quick);
        State end{0.2, 0};
        double phase = 0;
        for (int done = 0; done < 3; ++done) {
            const std::size_t k = static_cast<std::size_t>(carry == Carry::up ? done : 2 - done);
            Flock alone = published({flock.drive_amplitude[k]});
            alone.theta = {end.theta};
            alone.omega = {end.omega};
            alone.drive_phase = {phase};
            const auto points = section_of(alone, quick);
            for (const char* name : {"theta", "omega"})
                for (std::size_t row = 0; row < points[name].size(); ++row)
                    EXPECT_EQ(section[name][3 * row + k], points[name][row]);
            end = {points["theta"].back(), points["omega"].back()};
            phase = quick.phase;
        }
    }
}

TEST(CarriedSweep, HasTheSameBitsFromAnyThreadsAndBesideAnyLines) {
    std::vector<double> frictions;
    for (int i = 0; i < 150; ++i) frictions.push_back(0.2 + 0.002 * i);
    const auto torques = linspace(0.9, 1.1, 4);
    const Flock flock = junctions(frictions, torques);
    for (Measure what : {Measure::mean_velocity, Measure::attractors}) {
        const auto one = carried(what, flock, 4, Carry::up, quick, {.threads = 1});
        const auto many = carried(what, flock, 4, Carry::up, quick, {.threads = 7});
        EXPECT_TRUE(same_bits(one, many));
        for (std::size_t l : {0, 77, 149}) {
            const auto alone = carried(what, junctions({frictions[l]}, torques), 4, Carry::up, quick);
            for (std::size_t i = 0; i < one.columns.size(); ++i)
                EXPECT_EQ(std::memcmp(alone.columns[i].data(), one.columns[i].data() + 4 * l, 4 * sizeof(double)), 0)
                    << l << ' ' << i;
        }
    }
}

TEST(CarriedSweep, OfAJunctionHasHysteresis) {
    const auto torques = linspace(0.05, 1.15, 12);
    const auto up = carried(Measure::mean_velocity, junction(torques), 12, Carry::up, {100, 100})["mean_velocity"];
    const auto down = carried(Measure::mean_velocity, junction(torques), 12, Carry::down, {100, 100})["mean_velocity"];
    for (std::size_t i = 0; i < 12; ++i) {
        const double torque = torques[i];
        EXPECT_EQ(up[i] > 0.5, torque > 1) << torque;               // the fixed point vanishes at alpha
        EXPECT_EQ(down[i] > 0.5, torque > 4 * 0.2 / pi) << torque;  // to first order in beta
    }
}

TEST(CarriedSweep, LeavesAStateOfRestThatHasBecomeUnstable) {
    // The bottom is unstable near twice the natural frequency if the pivot's amplitude is above 2 beta, to first order.
    const Flock flock{
        .theta = {0.1}, .beta = {0.2}, .pivot_amplitude = {0, 0.1, 0.2, 0.3, 0.5, 0.7, 0.9}, .drive_frequency = {2}};
    const auto points = carried(Measure::attractors, flock, 7, Carry::up, {300, 100});
    for (std::size_t i = 0; i < 7; ++i) {
        const double size = std::abs(points["theta"][i]) + std::abs(points["omega"][i]);
        EXPECT_EQ(size > 0.1, flock.pivot_amplitude[i] > 0.4) << i;
        EXPECT_EQ(size < 1e-6, flock.pivot_amplitude[i] <= 0.4) << i;
    }
}

TEST(CarriedSweep, StartsAgainBehindALostMotion) {
    // Without friction, a torque of 1e308 leaves the range of doubles within 2 s.
    Flock flock{.theta = {0.5}, .beta = {0.5}, .torque = {0.1, 1e308, 0.1}};
    flock.beta = {0.5, 0, 0.5};
    const auto points = carried(Measure::section, flock, 3, Carry::up, quick);
    EXPECT_TRUE(std::isnan(points["theta"][1]));
    EXPECT_EQ(points["theta"][0], points["theta"][2]);
}

TEST(CarriedSweep, TellsItsProgressAndStops) {
    double latest = 0;
    bool is_monotonic = true;
    const auto torques = linspace(0.05, 1.15, 12);
    const Control control{1, [&](double done) {
                              is_monotonic = is_monotonic && done >= latest && done <= 1;
                              latest = done;
                              return done < 0.5;
                          }};
    std::vector<double> columns[5];
    for (auto& column : columns) column.resize(12);
    const auto flock = junction(torques);
    const auto outcome = measure_carried(Measure::mean_velocity, flock.ensemble(), 12, Carry::up, quick,
                                         {columns[0], columns[1], columns[2], columns[3], columns[4]}, control);
    EXPECT_EQ(outcome.kind, Outcome::Kind::stopped);
    EXPECT_TRUE(is_monotonic);
    EXPECT_GE(latest, 0.5);
    EXPECT_LT(latest, 0.6);
}

TEST(CarriedSweep, RefusesPartsOfLinesAndPlanes) {
    std::vector<double> columns[4];
    for (auto& column : columns) column.resize(1000);
    const auto flock = junction(linspace(0.1, 1.2, 5));
    Strobe strobe = quick;
    const auto refusal_of = [&](std::size_t line) {
        return measure_carried(Measure::section, flock.ensemble(), line, Carry::up, strobe,
                               {columns[0], columns[1], columns[2], columns[3]})
            .refusal;
    };
    EXPECT_EQ(refusal_of(0).reason, Refusal::Reason::whole);
    EXPECT_EQ(refusal_of(2).reason, Refusal::Reason::length);
    EXPECT_EQ(refusal_of(2).least, 6);
    EXPECT_FALSE(refusal_of(5));
    strobe.plane = Plane::theta;
    EXPECT_STREQ(refusal_of(5).name, "plane");
}

}  // namespace
