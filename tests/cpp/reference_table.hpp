// Reads the tables of tests/data and measures errors against them, to a fraction of a unit in the last place.
#pragma once

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace reference {

/// A true value: the double nearest to it, and the rest to 9 bits.
struct Value {
    double hi;
    double lo;
};

/// One line: its words, and its numbers in order.
struct Row {
    std::vector<std::string> words;
    std::vector<double> numbers;

    double operator[](std::size_t i) const { return numbers.at(i); }
    Value value(std::size_t i) const { return {numbers.at(i), numbers.at(i + 1)}; }
};

inline Row parse(const std::string& line) {
    Row row;
    std::istringstream tokens(line);
    for (std::string token; tokens >> token;) {
        char* end = nullptr;
        const double number = std::strtod(token.c_str(), &end);  // reads C99's hexadecimals, inf and nan
        if (end == token.c_str() + token.size())
            row.numbers.push_back(number);
        else
            row.words.push_back(token);
    }
    return row;
}

/// The rows of a table whose first word is `kind`, or all of them.
inline std::vector<Row> table(const std::string& name, const std::string& kind = "") {
    std::ifstream file(PENDULA_TEST_DATA "/" + name);
    if (!file) throw std::runtime_error("no table " + name);
    std::vector<Row> rows;
    for (std::string line; std::getline(file, line);) {
        if (line.empty() || line[0] == '#') continue;
        Row row = parse(line);
        if (kind.empty() || row.words.at(0) == kind) rows.push_back(row);
    }
    if (rows.empty()) throw std::runtime_error("nothing of " + kind + " in " + name);
    return rows;
}

/// The distance from |x| to the next double; 2^-1074 at 0.
inline double ulp(double x) {
    const double a = std::fabs(x);
    return a >= std::numeric_limits<double>::max() ? std::ldexp(1.0, 971) : std::nextafter(a, HUGE_VAL) - a;
}

/// |got - want|; NaN where got is not a number.
inline double error(double got, Value want) {
    return got == want.hi && want.lo == 0 ? 0 : std::fabs((got - want.hi) - want.lo);
}

/// The error in units in the last place of the true value.
inline double ulps(double got, Value want) { return error(got, want) / ulp(want.hi); }

/// The error of an angle with whole turns beside it.
inline double angle_error(double got, double got_turns, Value want, double want_turns) {
    constexpr long double two_pi = 6.283185307179586476925286766559006L;
    const long double turns = static_cast<long double>(got_turns) - want_turns;
    return static_cast<double>(std::fabs((static_cast<long double>(got) - want.hi) + turns * two_pi - want.lo));
}

/// Largest of errors; a NaN counts as infinite, so that no comparison lets it pass.
struct Largest {
    double value = 0;
    void operator()(double e) { value = e <= value ? value : std::isnan(e) ? HUGE_VAL : e; }
};

}  // namespace reference
