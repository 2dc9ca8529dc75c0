// Prints the largest errors measured against the reference tables as the tables of docs/numerics.md:
//     cmake --build build/dev --target accuracy
#include <cstdio>

#include "closed_form_errors.hpp"
#include "rk4_rounding.hpp"
#include "stated_errors.hpp"

namespace {

using namespace reference;

void print_stated(const std::vector<Stated>& functions) {
    for (const auto& f : functions)
        std::printf("| %s | %s | %.2g %s | %.3g %s |\n", f.name, f.domain, f.stated, f.unit[0] == '1' ? "" : f.unit, f.measured,
                    f.unit[0] == '1' ? "" : f.unit);
}

struct Group {
    std::string name;
    int cases = 0, wrong_regimes = 0;
    Largest theta_max, tau, theta, omega, late_theta, late_omega;

    void add(const Case& c) {
        const auto solution = pendula::make_exact(c.alpha, c.initial);
        ++cases;
        wrong_regimes += static_cast<int>(solution.analysis.regime) != c.k;
        theta_max(ulps(solution.analysis.theta_max, c.theta_max));
        tau(ulps(solution.analysis.tau, c.tau));
        for (const auto& i : c.instants) {
            const auto e = error_at(c, solution, i);
            (is_late(c, i) ? late_theta : theta)(e.theta);
            (is_late(c, i) ? late_omega : omega)(e.omega);
        }
    }

    void print() const {
        std::printf("| %s | %d | %d | %.2f | %.2f | %.1e | %.1e | %.1e | %.1e |\n", name.c_str(), cases, wrong_regimes,
                    theta_max.value, tau.value, theta.value, omega.value, late_theta.value, late_omega.value);
    }
};

void print_closed_form() {
    std::vector<Group> groups;
    Group all{.name = "all"};
    for (const auto& c : closed_form()) {
        if (groups.empty() || groups.back().name != c.group) groups.push_back({.name = c.group});
        groups.back().add(c);
        all.add(c);
    }
    for (const auto& g : groups) g.print();
    all.print();
}

void print_late() {
    for (const char* group : {"clear", "near", "separatrix"}) {
        Largest theta, omega, tail;
        int cases = 0;
        for (const auto& c : closed_form("late.txt")) {
            if (c.group != group) continue;
            ++cases;
            const auto solution = pendula::make_exact(c.alpha, c.initial);
            for (const auto& i : c.instants) {
                const auto e = error_at(c, solution, i);
                theta(e.theta);
                omega(e.omega);
                if (c.k == 0) tail(error(pendula::at(solution, i.t).omega, i.omega) / stated_tail_error(c, i));
            }
        }
        std::printf("| %s | %d | %.1e | %.1e | ", group, cases, theta.value, omega.value);
        std::printf(tail.value > 0 ? "%.2g |\n" : "|\n", tail.value);
    }
}

void print_rounding() {
    for (const auto& r : stepped()) {
        if (!r.is_long()) continue;
        const auto rounding = rounding_of(r);
        std::printf("| α = %g, θ0 = %.6g, ω0 = %g, h = %.6g | %.1e | %.1e |\n", r.alpha, r.initial.theta, r.initial.omega, r.h,
                    rounding.own, rounding.plain);
    }
}

}  // namespace

int main() {
    std::puts("| function | domain | stated | measured |\n|---|---|---|---|");
    print_stated(elementary_errors());
    print_stated(angle_errors());
    std::puts("\n| group | cases | wrong k | θM [ulp] | τ [ulp] | θ to 30 τ | ω to 30 τ | θ to 10⁶ τ | ω to 10⁶ τ |");
    std::puts("|---|---|---|---|---|---|---|---|---|");
    print_closed_form();
    std::puts("\n| late times | cases | θ | ω | relative error of ω, in units of its bound |\n|---|---|---|---|---|");
    print_late();
    std::puts("\n| RK4, 10⁶ steps | pendula | plain formulas |\n|---|---|---|");
    print_rounding();
}
