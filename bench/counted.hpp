// A number type that records the operations on it. The kernels are templates, so that the operations of their own code are
// counted. Only operations on which the results depend are counted, because a compiler removes the others.
#pragma once

#include <cmath>
#include <initializer_list>
#include <set>
#include <vector>

#include "arithmetic/pack.hpp"
#include "kernels/chunk.hpp"
#include "pendula/parameters.hpp"

namespace pendula::bench {

struct Operations {
    double multiplications = 0;
    double additions = 0;
    double divisions = 0;
};

struct Counted {
    struct Operation {
        double Operations::* kind;
        double a, b, result;
    };

    double value;

    static inline std::vector<Operation> trace;

    Counted() = default;
    Counted(double x) : value(x) {}

    friend Counted operator+(Counted a, Counted b) { return traced(&Operations::additions, a, b, a.value + b.value); }
    friend Counted operator-(Counted a, Counted b) { return traced(&Operations::additions, a, b, a.value - b.value); }
    friend Counted operator*(Counted a, Counted b) { return traced(&Operations::multiplications, a, b, a.value * b.value); }
    friend Counted operator/(Counted a, Counted b) { return traced(&Operations::divisions, a, b, a.value / b.value); }
    friend Counted operator-(Counted a) { return -a.value; }
    friend bool operator<(Counted a, Counted b) { return a.value < b.value; }
    friend bool operator<=(Counted a, Counted b) { return a.value <= b.value; }
    friend bool operator>(Counted a, Counted b) { return a.value > b.value; }
    friend bool operator>=(Counted a, Counted b) { return a.value >= b.value; }
    friend bool operator==(Counted a, Counted b) { return a.value == b.value; }
    friend bool operator!=(Counted a, Counted b) { return a.value != b.value; }

  private:
    static Counted traced(double Operations::* kind, Counted a, Counted b, double result) {
        trace.push_back({kind, a.value, b.value, result});
        return result;
    }
};

inline kernels::Parameters<Counted> counted_parameters(const Pendulum& p) {
    return {p.alpha, p.beta, p.torque, p.drive_amplitude, p.pivot_amplitude, p.drive_frequency, p.drive_phase};
}

/// An ensemble of pendulums released at rest from these angles.
inline Ensemble ensemble_of(const Pendulum& p, std::span<const double> theta) {
    Ensemble e{.size = theta.size(), .theta = theta};
    for (const auto& parameter : parameters)
        if (parameter.value) e.*parameter.column = p.*parameter.value;
    return e;
}

/// The recorded operations on which the results depend. A number is identified by its absolute value, which does not change
/// when it is selected or its sign changes.
inline Operations operations_behind(std::initializer_list<Counted> results) {
    std::set<double> needed;
    for (Counted x : results) needed.insert(std::fabs(x.value));
    Operations all;
    for (auto operation = Counted::trace.rbegin(); operation != Counted::trace.rend(); ++operation) {
        if (!needed.contains(std::fabs(operation->result))) continue;
        all.*(operation->kind) += 1;
        needed.insert({std::fabs(operation->a), std::fabs(operation->b)});
    }
    return all;
}

}  // namespace pendula::bench

namespace pendula::arithmetic::inline PENDULA_ISA {
template <>
struct BitsOf<bench::Counted> {
    using type = std::int64_t;
};
}  // namespace pendula::arithmetic::inline PENDULA_ISA
