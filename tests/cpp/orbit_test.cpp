// Periodic orbits by Newton's method, stable or not: points, multipliers and exponents against other integrators.
#include "pendula/orbit.hpp"

#include "flocks.hpp"
#include "pendula/angle.hpp"

namespace {

using namespace reference;

constexpr double two_thirds = 2.0 / 3;

struct Known {
    Pendulum pendulum;
    State guess;
    double period;
    State point;
    double turns;
    double multiplier[2];
    double imaginary;
    double exponent;
    bool is_fixed_point = false;
};

// By SciPy 1.17: DOP853 with rtol = atol = 1e-13 for the motion and two displacements, and Newton's method from their monodromy
// matrix.
const Known known[] = {
    // stable foci of the map, and nodes
    {{1, 0.5, 0, 0.9, 0, two_thirds},
     {-0.56, 1.93},
     1,
     {-0.56022832906507, 1.9335855133168},
     0,
     {-0.02483155297302, -0.02483155297302},
     0.09146958509842,
     -0.25},
    {{1, 0.5, 0, 1.35, 0, two_thirds},
     {-0.05, 0.76},
     1,
     {-0.048146537978665, 0.76264858065722},
     -1,
     {0.01738846837809, 0.01738846837809},
     0.09317152026555,
     -0.25},
    {{1, 0.5, 0, 1.07, 0, two_thirds},
     {-2.21, 1.35},
     2,
     {-2.207694744964, 1.346101590112},
     0,
     {0.4711043594111, 0.0001712986007417},
     0,
     -0.03993068286419},
    {{1, 0.5, 0, 1.45, 0, two_thirds},
     {0.12, 0.48},
     2,
     {0.11791787240298, 0.47684087395498},
     -2,
     {-0.4525633755513, -0.000178316500914},
     0,
     -0.0420608035798},
    {{1, 3.0, 0, 1.5, 0, 0.5},
     {0.37, 0.41},
     1,
     {0.36790680916355, 0.41328962041764},
     0,
     {0.02389719922803, 0},
     0,
     -0.2971418024037},
    {{1, 4.0, 0.3, 0.5, 0, 0.9},
     {0.31, 0.12},
     1,
     {0.31170282726646, 0.12448055561107},
     0,
     {0.1706368653947, 4.366538380873e-12},
     0,
     -0.2532785107259},
    {{1, 0.1, 0, 0, 2.0, 2.5},
     {-0.31, 3.16},
     1,
     {-0.31059170029252, 3.1561489320847},
     1,
     {-0.762511858394, -0.762511858394},
     0.4431064713817,
     -0.05},
    // the same orbit before and after its period doubles
    {{1, 0.5, 0, 1.05, 0, two_thirds},
     {-0.29, 1.97},
     1,
     {-0.29368983032762, 1.9746375627509},
     0,
     {-0.4210474452647, -0.02133557897609},
     0,
     -0.09178038556021},
    {{1, 0.5, 0, 1.065, 0, two_thirds},
     {-0.23, 1.96},
     1,
     {-0.22660120174126, 1.9609591298319},
     0,
     {-0.9511495681462, -0.009444667087039},
     0,
     -0.005314072587159},
    {{1, 0.5, 0, 1.07, 0, two_thirds},
     {-0.21, 1.96},
     1,
     {-0.20859899056932, 1.9562084402134},
     0,
     {-1.129628972333, -0.00795242618696},
     0,
     0.01293284958515},
    // the saddle that swings about the top, the top of a shaken pivot on either side of its stability, and the bottom in and
    // beside Mathieu's tongue
    {{1, 0.2, 0, 0.3, 0, 1.5},
     {3, 0},
     1,
     {3.050034139897, 0.012683399838343},
     0,
     {44.09727885352, 0.009811931660465},
     0,
     0.9039359555942},
    {{1, 0.1, 0, 0, 20, 10}, {3.1, 0}, 1, {-pi, 0}, 0, {0.7759535873231, 0.7759535873231}, 0.5805147696181, -0.05, true},
    {{1, 0.1, 0, 0, 8, 10}, {-3.1, 0}, 1, {-pi, 0}, 0, {1.634324074954, 0.5746114750534}, 0, 0.7818157272811, true},
    {{1, 0.1, 0, 0, 0.6, 2}, {0.05, 0}, 1, {0, 0}, 0, {-1.363050006251, -0.5358590570403}, 0, 0.09858847870035, true},
    {{1, 0.1, 0, 0, 0.6, 1}, {0.05, 0}, 1, {0, 0}, 0, {0.8945943130356, 0.5963463922332}, 0, -0.01772746458195, true},
};

PeriodicOrbit refined(const Pendulum& pendulum, State guess, const Strobe& strobe) {
    PeriodicOrbit orbit;
    EXPECT_TRUE(refine(pendulum, guess, strobe, orbit).is_done());
    EXPECT_TRUE(orbit.is_found) << pendulum.drive_amplitude << ' ' << pendulum.pivot_amplitude;
    return orbit;
}

/// `slack` is what the reference and the method may err.
void expect_orbit(const Known& k, const PeriodicOrbit& o, double slack) {
    const auto& p = k.pendulum;
    const double time = 2 * pi * k.period / p.drive_frequency;
    SCOPED_TRACE(testing::Message() << p.beta << ' ' << p.drive_amplitude << ' ' << p.pivot_amplitude);
    EXPECT_NEAR(wrap(o.point.theta - k.point.theta), 0, o.error + slack);
    EXPECT_NEAR(o.point.omega, k.point.omega, (o.error + slack) * p.drive_frequency);
    EXPECT_LE(o.error, 1e-11);
    EXPECT_EQ(o.turns, k.turns);
    const double multiplier_slack = slack + o.exponent_error * time, size = std::abs(k.multiplier[0]);
    for (int i : {0, 1}) EXPECT_NEAR(o.multiplier[i], k.multiplier[i], multiplier_slack * (1 + size)) << i;
    EXPECT_NEAR(o.imaginary, k.imaginary, multiplier_slack);
    EXPECT_NEAR(o.exponent[0], k.exponent, o.exponent_error + slack);
    EXPECT_EQ(o.exponent[1], -p.beta - o.exponent[0]);
    EXPECT_LE(o.exponent_error, 1e-10);
    EXPECT_EQ(o.is_stable, k.exponent < 0);
    // Liouville: the product of the multipliers, and the measured determinant.
    const double modulus = std::hypot(o.multiplier[0], o.imaginary);
    if (k.imaginary > 0) {
        EXPECT_NEAR(modulus, std::exp(-0.5 * p.beta * time), 1e-15);
    }
    EXPECT_NEAR(o.determinant / std::exp(-p.beta * time), 1, 1e-14);
    EXPECT_LE(o.mismatch, 1e-11 + 0.1 * slack);
}

TEST(PeriodicOrbits, ByTaylorAreThoseOfDop853) {
    for (const auto& k : known) expect_orbit(k, refined(k.pendulum, k.guess, {.orbit_period = k.period}), 2e-12);
}

TEST(PeriodicOrbits, ByRk4AreThoseOfDop853) {
    // rk4 errs by some h^4/120 in a unit of time: h is at most 0.0063, and an orbit at most 19 long.
    for (const auto& k : known)
        expect_orbit(
            k, refined(k.pendulum, k.guess, {.steps_per_period = 2000, .method = Method::rk4, .orbit_period = k.period}), 1e-9);
}

TEST(PeriodicOrbits, OfTheMeasureAreThoseOfRefine) {
    for (const auto& k : known) {
        const auto& p = k.pendulum;
        const Strobe strobe{.orbit_period = k.period};
        const auto o = refined(p, k.guess, strobe);
        const auto found = measured(Measure::orbit,
                                    {.theta = {k.guess.theta},
                                     .omega = {k.guess.omega},
                                     .beta = {p.beta},
                                     .torque = {p.torque},
                                     .drive_amplitude = {p.drive_amplitude},
                                     .pivot_amplitude = {p.pivot_amplitude},
                                     .drive_frequency = {p.drive_frequency}},
                                    strobe);
        const double values[] = {o.point.theta,   o.point.omega, o.error,       o.turns / o.period, o.multiplier[0],
                                 o.multiplier[1], o.imaginary,   o.exponent[0], o.exponent_error};
        for (std::size_t i = 0; i < std::size(values); ++i) EXPECT_EQ(found.columns[i][0], values[i]) << i;
    }
}

TEST(PeriodicOrbits, ThatAttractHaveTheExponentsOfTheMeasureFromFarAway) {
    for (const auto& k : known) {
        const auto& p = k.pendulum;
        if (!(k.exponent < 0) || k.is_fixed_point) continue;
        const auto found = exponent_of({.theta = {k.guess.theta},
                                        .omega = {k.guess.omega},
                                        .beta = {p.beta},
                                        .torque = {p.torque},
                                        .drive_amplitude = {p.drive_amplitude},
                                        .pivot_amplitude = {p.pivot_amplitude},
                                        .drive_frequency = {p.drive_frequency}},
                                       {});
        EXPECT_EQ(found.kind(0), Kind::periodic);
        EXPECT_NEAR(found["exponent"][0], k.exponent, found["error"][0] + 1e-12);
    }
}

TEST(PeriodicOrbits, WhoseDisplacementsOverflowHaveTheirExponents) {
    // Gravity turns round for half of a slow period. By mpmath: Hill's equation x'' = -(1 - 10 cos(Omega t)) x with series of
    // order 40 and 30 digits.
    const double frequencies[] = {0.1, 0.01, 0.001};
    const double exponents[] = {1.0828421836720419762, 1.0765596228396931118, 1.0756166468394370127};
    for (int i : {0, 1, 2}) {
        const Pendulum p{.pivot_amplitude = -10, .drive_frequency = frequencies[i]};
        const auto o = refined(p, {0, 0}, {});
        EXPECT_NEAR(o.exponent[0], exponents[i], o.exponent_error + 2e-15) << i;
        EXPECT_LE(o.exponent_error, 1e-13) << i;
        EXPECT_FALSE(o.is_stable);
        const auto found = exponent_of({.pivot_amplitude = {-10}, .drive_frequency = {frequencies[i]}}, {});
        EXPECT_EQ(found["exponent"][0], o.exponent[0]);
        EXPECT_EQ(found.kind(0), Kind::fixed_point);
    }
}

TEST(PeriodicOrbits, OfSlowDrivesAndStrongFrictionHaveTheExponentOfTheSlowNode) {
    // By SciPy: Radau with rtol = 1e-11 for the motion and Riccati's equation u' = -beta u - cos(theta) - u^2, whose mean is
    // the exponent.
    const struct {
        double torque, amplitude, frequency, exponent;
    } cases[] = {{0, 0.5, 0.001, -0.094314125042},
                 {0, 0.9, 0.001, -0.075204198546},
                 {0.4, 0.3, 0.001, -0.089411016076},
                 {0, 0.5, 0.01, -0.094387376784}};
    for (const auto& c : cases) {
        const auto found = exponent_of(
            {.beta = {10}, .torque = {c.torque}, .drive_amplitude = {c.amplitude}, .drive_frequency = {c.frequency}}, {});
        EXPECT_NEAR(found["exponent"][0], c.exponent, found["error"][0] + 1e-11) << c.amplitude;
        EXPECT_EQ(found.kind(0), Kind::periodic) << c.amplitude;
        EXPECT_LE(found["error"][0], 1e-11) << c.amplitude;
    }
}

TEST(PeriodicOrbits, ThatRestDoNotExistBeyondTheSaddleNode) {
    // sin(theta) = torque/alpha has no solution; at the next double below it has the double root pi/2.
    for (const double beta : {0.5, 3.0}) {
        PeriodicOrbit orbit;
        ASSERT_TRUE(refine({.beta = beta, .torque = 1 + 0x1p-52}, {1.5, 0}, {}, orbit).is_done());
        EXPECT_FALSE(orbit.is_found) << beta;
    }
    const auto node = refined({.beta = 0.5, .torque = 1}, {1.5, 0}, {});
    EXPECT_NEAR(node.point.theta, 0.5 * pi, node.error);
    EXPECT_LT(node.error, 1e-6);  // a double root of a rounded function is known to the root of the rounding, 2^-26, times some
}

TEST(PeriodicOrbits, AreRefusedAsMeasuresAre) {
    PeriodicOrbit orbit;
    const auto name = [&](const Pendulum& p, State guess, const Strobe& strobe) {
        return std::string(refine(p, guess, strobe, orbit).refusal.name);
    };
    EXPECT_EQ(name({.alpha = -1}, {}, {}), "alpha");
    EXPECT_EQ(name({}, {std::nan(""), 0}, {}), "theta0");
    EXPECT_EQ(name({}, {}, {.method = Method::euler}), "method");
    EXPECT_EQ(name({}, {}, {.orbit_period = 0.5}), "orbit_period");
    EXPECT_EQ(name({.drive_amplitude = 1}, {}, {}), "drive_frequency");
}

}  // namespace
