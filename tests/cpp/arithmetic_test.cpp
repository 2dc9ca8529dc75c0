// The one arithmetic against arbitrary precision: each function is held to the error it states.
#include <gtest/gtest.h>

#include <cstring>

#include "arithmetic/arctangent.hpp"
#include "arithmetic/exponential.hpp"
#include "arithmetic/trigonometric.hpp"
#include "reference_table.hpp"

namespace {

namespace own = pendula::arithmetic;  // named at each call: C's functions of the same names are about
using reference::Largest;
using reference::table;
using reference::ulps;
using Wide = own::Pack<8>;

constexpr double inf = HUGE_VAL;
const double nan = std::nan("");

template <class F>
double largest_ulps(const char* name, F f) {
    Largest worst;
    for (const auto& row : table("elementary.txt", name)) worst(ulps(f(row[0]), row.value(1)));
    return worst.value;
}

double sincos_ulps() {
    Largest worst;
    for (const auto& row : table("elementary.txt", "sincos")) {
        const auto r = own::sincos(row[0]);
        worst(ulps(r.sin, row.value(1)));
        worst(ulps(r.cos, row.value(3)));
    }
    return worst.value;
}

TEST(Arithmetic, SinAndCosAreWithin0p95UlpForEveryDouble) { EXPECT_LE(sincos_ulps(), 0.95); }
TEST(Arithmetic, ExpIsWithin0p9Ulp) {
    Largest normal, denormal;
    for (const auto& row : table("elementary.txt", "exp"))
        (row[0] > -708.4 ? normal : denormal)(ulps(own::exp(row[0]), row.value(1)));
    EXPECT_LE(normal.value, 0.9);
    EXPECT_LE(denormal.value, 1.0);
}
TEST(Arithmetic, LogIsWithin0p9Ulp) {
    EXPECT_LE(largest_ulps("log", [](double x) { return own::log(x); }), 0.9);
}
TEST(Arithmetic, Log1pIsWithin1p2Ulp) {
    EXPECT_LE(largest_ulps("log1p", [](double x) { return own::log1p(x); }), 1.2);
}
TEST(Arithmetic, AsinhIsWithin1p8Ulp) {
    EXPECT_LE(largest_ulps("asinh", [](double x) { return own::asinh(x); }), 1.8);
}
TEST(Arithmetic, AtanIsWithin0p9Ulp) {
    EXPECT_LE(largest_ulps("atan", [](double x) { return own::atan(x); }), 0.9);
}
TEST(Arithmetic, Atan2IsWithin0p9Ulp) {
    Largest worst;
    for (const auto& row : table("elementary.txt", "atan2")) worst(ulps(own::atan2(row[0], row[1]), row.value(2)));
    EXPECT_LE(worst.value, 0.9);
}

TEST(Arithmetic, SincosOfHalfTurnIsWithin3UlpInSinAnd3em16InCos) {
    Largest sine, cosine;
    for (const auto& row : table("elementary.txt", "sincos_of_half_turn")) {
        const auto r = own::sincos_of_half_turn(row[0]);
        sine(ulps(r.sin, row.value(1)));
        cosine(reference::error(r.cos, row.value(3)));
    }
    EXPECT_LE(sine.value, 3);
    EXPECT_LE(cosine.value, 3e-16);
}

TEST(Arithmetic, SincosDoubleDoubleIsWithinTwoToTheMinus103) {
    Largest worst;
    for (const auto& row : table("elementary.txt", "sincos_double_double")) {
        const auto r = own::sincos_double_double(row[0]);
        // The table's second parts are whole doubles here: the first differences are exact.
        worst(std::fabs((r.sin.hi - row[1]) + (r.sin.lo - row[2])));
        worst(std::fabs((r.cos.hi - row[3]) + (r.cos.lo - row[4])));
    }
    EXPECT_LE(worst.value, 0x1p-103);
}

bool same(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0 || (std::isnan(a) && std::isnan(b)); }

struct Special {
    const char* name;
    double got, want;
};

TEST(Arithmetic, SpecialValuesAreThoseOfC) {
    const double top = std::numeric_limits<double>::max();
    const double quarter = 0x1.921fb54442d18p-1, half = 0x1.921fb54442d18p+0, whole = 0x1.921fb54442d18p+1;
    const Special specials[] = {
        {"sin 0", own::sin(0.0), 0.0},
        {"sin -0", own::sin(-0.0), -0.0},
        {"cos 0", own::cos(0.0), 1},
        {"cos -0", own::cos(-0.0), 1},
        {"sin inf", own::sin(inf), nan},
        {"cos -inf", own::cos(-inf), nan},
        {"sin nan", own::sin(nan), nan},
        {"cos nan", own::cos(nan), nan},
        {"sin denormal", own::sin(-5e-324), -5e-324},
        {"exp 0", own::exp(0.0), 1},
        {"exp -0", own::exp(-0.0), 1},
        {"exp inf", own::exp(inf), inf},
        {"exp -inf", own::exp(-inf), 0.0},
        {"exp nan", own::exp(nan), nan},
        {"exp max", own::exp(top), inf},
        {"exp -max", own::exp(-top), 0.0},
        {"log 1", own::log(1.0), 0.0},
        {"log 0", own::log(0.0), -inf},
        {"log -0", own::log(-0.0), -inf},
        {"log inf", own::log(inf), inf},
        {"log -1", own::log(-1.0), nan},
        {"log -inf", own::log(-inf), nan},
        {"log nan", own::log(nan), nan},
        {"log1p 0", own::log1p(0.0), 0.0},
        {"log1p -0", own::log1p(-0.0), -0.0},
        {"log1p -1", own::log1p(-1.0), -inf},
        {"log1p -2", own::log1p(-2.0), nan},
        {"log1p inf", own::log1p(inf), inf},
        {"log1p nan", own::log1p(nan), nan},
        {"asinh 0", own::asinh(0.0), 0.0},
        {"asinh -0", own::asinh(-0.0), -0.0},
        {"asinh nan", own::asinh(nan), nan},
        {"atan 0", own::atan(0.0), 0.0},
        {"atan -0", own::atan(-0.0), -0.0},
        {"atan inf", own::atan(inf), half},
        {"atan -inf", own::atan(-inf), -half},
        {"atan nan", own::atan(nan), nan},
        {"atan2 0 0", own::atan2(0.0, 0.0), 0.0},
        {"atan2 -0 0", own::atan2(-0.0, 0.0), -0.0},
        {"atan2 0 -0", own::atan2(0.0, -0.0), whole},
        {"atan2 -0 -0", own::atan2(-0.0, -0.0), -whole},
        {"atan2 0 1", own::atan2(0.0, 1.0), 0.0},
        {"atan2 -0 -1", own::atan2(-0.0, -1.0), -whole},
        {"atan2 1 0", own::atan2(1.0, 0.0), half},
        {"atan2 -1 -0", own::atan2(-1.0, -0.0), -half},
        {"atan2 1 inf", own::atan2(1.0, inf), 0.0},
        {"atan2 1 -inf", own::atan2(1.0, -inf), whole},
        {"atan2 inf 1", own::atan2(inf, 1.0), half},
        {"atan2 inf inf", own::atan2(inf, inf), quarter},
        {"atan2 -inf -inf", own::atan2(-inf, -inf), -3 * quarter},
        {"atan2 nan 1", own::atan2(nan, 1.0), nan},
        {"atan2 1 nan", own::atan2(1.0, nan), nan},
        {"atan2 inf nan", own::atan2(inf, nan), nan},
    };
    for (const auto& s : specials) EXPECT_TRUE(same(s.got, s.want)) << s.name << " = " << s.got << ", not " << s.want;
}

// A pack of eight neighbours of every table, specials among them, lane by lane against the scalar form.
template <class F>
void expect_packs_like_scalars(const char* name, F f) {
    std::vector<double> xs{0.0, -0.0, inf, -inf, nan, 5e-324, -1.0, 1e300};
    for (const auto& row : table("elementary.txt", name)) xs.push_back(row[0]);
    while (xs.size() % 8) xs.push_back(1.0);
    for (std::size_t i = 0; i < xs.size(); i += 8) {
        Wide x{};
        for (int j = 0; j < 8; ++j) x[j] = xs[i + static_cast<std::size_t>(j)];
        const Wide y = f(x);
        for (int j = 0; j < 8; ++j) EXPECT_TRUE(same(y[j], f(double{x[j]}))) << name << ' ' << x[j];
    }
}

TEST(Arithmetic, PacksGiveTheBitsOfScalars) {
    expect_packs_like_scalars("sincos", [](auto x) { return own::sin(x); });
    expect_packs_like_scalars("sincos", [](auto x) { return own::cos(x); });
    expect_packs_like_scalars("exp", [](auto x) { return own::exp(x); });
    expect_packs_like_scalars("log", [](auto x) { return own::log(x); });
    expect_packs_like_scalars("log1p", [](auto x) { return own::log1p(x); });
    expect_packs_like_scalars("asinh", [](auto x) { return own::asinh(x); });
    expect_packs_like_scalars("atan", [](auto x) { return own::atan(x); });
    expect_packs_like_scalars("atan2", [](auto x) { return own::atan2(x, 0.75 * x - 1.0); });
}

TEST(Arithmetic, OddFunctionsAreOddToTheBit) {
    for (const auto& row : table("elementary.txt")) {
        const double x = row[0];
        EXPECT_TRUE(same(own::sin(-x), -own::sin(x)) && same(own::cos(-x), own::cos(x)) && same(own::atan(-x), -own::atan(x)) &&
                    same(own::asinh(-x), -own::asinh(x)))
            << x;
    }
}

}  // namespace
