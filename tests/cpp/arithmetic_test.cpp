// The one arithmetic against arbitrary precision: each function is held to the error it states.
#include <gtest/gtest.h>

#include <cstring>

#include "stated_errors.hpp"

namespace {

namespace own = reference::own;
using reference::table;

constexpr double inf = HUGE_VAL;
const double nan = std::nan("");

TEST(Arithmetic, StaysWithinItsStatedErrors) {
    for (const auto& f : reference::elementary_errors()) EXPECT_LE(f.measured, f.stated) << f.name << ", " << f.domain;
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

// Neighbours of every table, specials among them, lane by lane against the scalar form.
template <int width, class F>
void expect_packs_like_scalars(const char* name, const std::vector<double>& xs, F f) {
    for (std::size_t i = 0; i + width <= xs.size(); i += width) {
        own::Pack<width> x{};
        for (int j = 0; j < width; ++j) own::lane(x, j) = xs[i + static_cast<std::size_t>(j)];
        const own::Pack<width> y = f(x);
        for (int j = 0; j < width; ++j)
            EXPECT_TRUE(same(own::lane(y, j), f(double{own::lane(x, j)}))) << name << ' ' << own::lane(x, j);
    }
}

template <class F>
void expect_packs_like_scalars(const char* name, F f) {
    std::vector<double> xs{0.0, -0.0, inf, -inf, nan, 5e-324, -1.0, 1e300};
    for (const auto& row : table("elementary.txt", name)) xs.push_back(row[0]);
    while (xs.size() % 16) xs.push_back(1.0);
    expect_packs_like_scalars<2>(name, xs, f);
    expect_packs_like_scalars<8>(name, xs, f);
    expect_packs_like_scalars<16>(name, xs, f);
}

TEST(Arithmetic, PacksGiveTheBitsOfScalars) {
    expect_packs_like_scalars("sincos", [](auto x) { return own::sin(x); });
    expect_packs_like_scalars("sincos", [](auto x) { return own::cos(x); });
    expect_packs_like_scalars("exp", [](auto x) { return own::exp(x); });
    expect_packs_like_scalars("log", [](auto x) { return own::log(x); });
    expect_packs_like_scalars("log1p", [](auto x) { return own::log1p(x); });
    expect_packs_like_scalars("asinh", [](auto x) { return own::asinh(x); });
    expect_packs_like_scalars("atan", [](auto x) { return own::atan(x); });
    expect_packs_like_scalars("sincos_of_half_turn", [](auto f) { return own::sincos_of_half_turn(f).cos; });
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
