// Every elementary function and angle with the error it states and the largest over its reference table.
#pragma once

#include <vector>

#include "arithmetic/arctangent.hpp"
#include "arithmetic/elliptic.hpp"
#include "arithmetic/exponential.hpp"
#include "arithmetic/trigonometric.hpp"
#include "pendula/angle.hpp"
#include "reference_table.hpp"

namespace reference {

namespace own = pendula::arithmetic;  // named at each call: C's functions of the same names are about

struct Stated {
    const char* name;
    const char* domain;
    const char* unit;
    double stated;
    double measured;
};

/// The largest of an error over the rows of a function.
template <class Error>
double largest(const char* file, const char* kind, Error error_of) {
    Largest worst;
    for (const Row& row : table(file, kind)) worst(error_of(row));
    return worst.value;
}

/// pi is given as -pi, 2.4e-16 away around the circle: less than an ulp of it.
inline double wrap_ulps(double got, Value want) {
    return angle_error(got, want.hi > 0 && got == -pendula::pi ? 1 : 0, want, 0) / ulp(want.hi);
}

inline std::vector<Stated> elementary_errors() {
    using Wide = own::DoubleDouble<double>;
    const auto of = [](const char* name, auto error_of) { return largest("elementary.txt", name, error_of); };
    // A row of sincos_double_double holds whole doubles: hi and lo of the sine, then of the cosine.
    const auto rest = [](auto got, const Row& row, std::size_t i) {
        return std::fabs((got.hi - row[i]) + (got.lo - row[i + 1]));
    };
    return {
        {"sin", "all doubles", "ulp", 0.95, of("sincos", [](const Row& r) { return ulps(own::sin(r[0]), r.value(1)); })},
        {"cos", "all doubles", "ulp", 0.95, of("sincos", [](const Row& r) { return ulps(own::cos(r[0]), r.value(3)); })},
        {"exp", "normal results", "ulp", 0.9,
         of("exp", [](const Row& r) { return r[0] < -708.4 ? 0 : ulps(own::exp(r[0]), r.value(1)); })},
        {"exp", "denormal results", "ulp", 1,
         of("exp", [](const Row& r) { return r[0] < -708.4 ? ulps(own::exp(r[0]), r.value(1)) : 0; })},
        {"log", "x > 0", "ulp", 0.9, of("log", [](const Row& r) { return ulps(own::log(r[0]), r.value(1)); })},
        {"log1p", "x > -1", "ulp", 1.2, of("log1p", [](const Row& r) { return ulps(own::log1p(r[0]), r.value(1)); })},
        {"asinh", "\\|x\\| < 1e150", "ulp", 1.8, of("asinh", [](const Row& r) { return ulps(own::asinh(r[0]), r.value(1)); })},
        {"atan", "all doubles", "ulp", 0.9, of("atan", [](const Row& r) { return ulps(own::atan(r[0]), r.value(1)); })},
        {"atan2", "all doubles", "ulp", 1, of("atan2", [](const Row& r) { return ulps(own::atan2(r[0], r[1]), r.value(2)); })},
        {"sin πf", "\\|f\\| <= 1/2", "ulp", 3,
         of("sincos_of_half_turn", [](const Row& r) { return ulps(own::sincos_of_half_turn(r[0]).sin, r.value(1)); })},
        {"cos πf", "\\|f\\| <= 1/2", "ulp", 3,
         of("sincos_of_half_turn", [](const Row& r) { return ulps(own::sincos_of_half_turn(r[0]).cos, r.value(3)); })},
        {"R_F(x, y, 1)", "0, or 1e-32 to 1", "ulp", 8,
         of("carlson_rf", [](const Row& r) { return ulps(own::carlson_rf(r[0], r[1], r[2]), r.value(3)); })},
        {"R_F, double-double", "0, or 1e-32 to 1", "ulp", 3,
         of("carlson_rf", [](const Row& r) { return ulps(own::carlson_rf(Wide{r[0]}, Wide{r[1]}, Wide{r[2]}), r.value(3)); })},
        {"sin, double-double", "all doubles", "1", 0x1p-103,
         of("sincos_double_double", [&](const Row& r) { return rest(own::sincos_double_double(r[0]).sin, r, 1); })},
        {"cos, double-double", "all doubles", "1", 0x1p-103,
         of("sincos_double_double", [&](const Row& r) { return rest(own::sincos_double_double(r[0]).cos, r, 3); })},
    };
}

inline std::vector<Stated> angle_errors() {
    const auto of = [](const char* name, auto error_of) { return largest("angle.txt", name, error_of); };
    return {
        {"wrap", "\\|θ\\| <= 1e15", "ulp", 1,
         of("wrap", [](const Row& r) { return std::fabs(r[0]) <= 1e15 ? wrap_ulps(pendula::wrap(r[0]), r.value(1)) : 0; })},
        {"wrap", "all doubles", "ulp", 2, of("wrap", [](const Row& r) { return wrap_ulps(pendula::wrap(r[0]), r.value(1)); })},
        {"to_radians", "all doubles", "ulp", 1,
         of("to_radians", [](const Row& r) { return ulps(pendula::to_radians(r[0]), r.value(1)); })},
        {"phase", "\\|s\\| < 1", "ulp", 2,
         of("phase", [](const Row& r) { return ulps(pendula::phase(r[0], r[1]), r.value(2)); })},
    };
}

}  // namespace reference
