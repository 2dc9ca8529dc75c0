// Solves a fixed set of problems and prints, for each section, a hash of the bits of all its results. The hashes are the same
// for every build of the core: see tests/bits/test_bits.py. `golden SECTION` prints the results instead of their hash. This
// file includes only headers of the language and of pendula, because a WebAssembly module without imports has no others.
#include <bit>
#include <cstddef>
#include <cstdint>

#include "pendula/pendula.hpp"

#ifdef __wasm__
#define EXPORT(name) __attribute__((export_name(#name)))
#else
#define EXPORT(name)
#endif

using namespace pendula;

namespace {

void (*listener)(double) = nullptr;

// The hash FNV-1a with 64 bits, over the bytes of doubles, least significant first. -0 and 0 differ; all NaNs are equal.
struct Hash {
    std::uint64_t value = 0xcbf29ce484222325;

    void operator()(double x) {
        if (listener) listener(x);
        std::uint64_t bits = x == x ? std::bit_cast<std::uint64_t>(x) : 0x7ff8000000000000;
        for (int byte = 0; byte < 8; ++byte, bits >>= 8) value = (value ^ (bits & 255)) * 0x100000001b3;
    }
    void operator()(const Analysis& a) {
        (*this)(static_cast<double>(a.regime));
        (*this)(a.theta_max);
        (*this)(a.tau);
    }
    void operator()(const Sample& s) {
        (*this)(s.t);
        (*this)(s.theta);
        (*this)(s.omega);
        (*this)(s.turns);
    }
};

// Random numbers in [0, 1) by Knuth's MMIX generator, which uses only integers and gives the same numbers everywhere.
struct Random {
    std::uint64_t state = 1;

    double operator()() {
        state = state * 6364136223846793005u + 1442695040888963407u;
        return static_cast<double>(state >> 11) * 0x1p-53;
    }
    double operator()(double first, double last) { return first + (last - first) * (*this)(); }
    // 2^n times a number in [1, 2), of either sign; n is uniform in [first, last].
    double wide(int first, int last) {
        const auto n = first + static_cast<int>((*this)() * (last - first + 1));
        const double power = std::bit_cast<double>(static_cast<std::uint64_t>(1023 + n) << 52);
        const double x = (1 + (*this)()) * power;
        return (*this)() < 0.5 ? -x : x;
    }
};

constexpr double inf = __builtin_huge_val();
constexpr double nan = __builtin_nan("");
constexpr double largest = 0x1.fffffffffffffp1023;
constexpr double hostile[] = {0,    -0.0, 1,      -1,   pi,     -pi,     pi / 2,   2 * pi, 0x1p-1074, -0x1p-1074, 0x1p-1022,
                              1e-9, 1e15, 0x1p53, 1e22, -1e300, largest, -largest, inf,    -inf,      nan};

constexpr double alphas[] = {1, 9.81, 0x1p-40};

// Initial states, omega in units of sqrt(alpha): small and large, on the separatrix and on either side of it, and slow, fast
// and backward rotations.
constexpr State states[] = {
    {0, 0},       {1e-9, 0},  {0.001, 0}, {pi / 2, 0}, {2.5, -0.3},  {3, 0},      {3.14159, 0}, {0, 1.999999895801368},
    {0, 2},       {0, -2},    {1, -1.75}, {pi, 0},     {-pi, 1e-12}, {3.1, 0.1},  {0.001, 2},   {0, 2.0000000000001},
    {0.1, -2.01}, {-2, 1.99}, {1, 2},     {50, -3},    {0, 1e6},     {1e10, 0.5}, {-1, 1e-300}};

template <class Visit>
void for_each_problem(Visit visit) {
    for (double alpha : alphas)
        for (State s : states) visit(alpha, State{s.theta, s.omega * __builtin_sqrt(alpha)});
}

void angles(Hash& hash) {
    const auto visit = [&](double x) {
        hash(wrap(x));
        hash(to_radians(x));
        const Angle angle = split_turns(x);
        hash(angle.theta);
        hash(angle.turns);
        hash(phase(x, 1));
        hash(phase(x, -1));
    };
    for (double x : hostile) visit(x);
    Random random;
    for (int i = 0; i < 2000; ++i) {
        visit(random(-10, 10));
        visit(random.wide(-1022, 1023));
        visit(i * pi / 2);
    }
}

void energies(Hash& hash) {
    Random random;
    for (int i = 0; i < 2000; ++i) {
        const State s{random.wide(-30, 60), random.wide(-30, 10)};
        hash(energy(9.81, s));
        hash(acceleration({.alpha = 9.81,
                           .beta = 0.5,
                           .torque = 0.1,
                           .drive_amplitude = 1.5,
                           .drive_frequency = 2.0 / 3,
                           .drive_phase = 0.25},
                          s, random(0, 1000)));
        hash(unwrapped({0, s.theta, s.omega, random(-1e6, 1e6)}));
    }
}

void analyses(Hash& hash) {
    for_each_problem([&](double alpha, State s) {
        hash(analyze(alpha, s));
        const double terms = series_terms(alpha, s, 1e-7);
        hash(terms);
        Analysis by_series;
        if (terms < 1e5 && analyze_by_series(alpha, s, 1e-7, by_series).is_done()) hash(by_series);
    });
    Random random;
    for (int i = 0; i < 5000; ++i) {
        const double alpha = random(0.1, 10);
        const State s{random(-4, 4), random(-8, 8)};  // braces evaluate from left to right, function arguments in any order
        hash(analyze(alpha, s));
    }
    for (int i = 0; i < 5000; ++i) {  // near the separatrix
        const double theta = random(-pi, pi);
        const double omega = 2 * __builtin_sqrt(1 - energy(1, {theta, 0}) / 2);
        hash(analyze(1, {theta, omega * (1 + random.wide(-52, -3))}));
    }
    for (double alpha : hostile)
        for (double theta : hostile)
            for (double omega : hostile) hash(analyze(alpha, {theta, omega}));
}

constexpr std::size_t times = 1003;  // not a multiple of the width of any pack

template <class Visit>
void for_each_orbit(Visit visit) {
    static double t[times];
    for_each_problem([&](double alpha, State s) {
        const Exact orbit = make_exact(alpha, s);
        Random random;
        for (std::size_t i = 0; i < times; ++i)
            t[i] = orbit.analysis.tau * (i % 4 == 0   ? random(0, 30)
                                         : i % 4 == 1 ? random(-1e6, 1e6)
                                                      : static_cast<double>(i) / 8);
        t[0] = 0;
        t[1] = -0.0;
        t[2] = random.wide(-1022, -1000);
        t[3] = 1e300;
        t[4] = inf;
        t[5] = nan;
        visit(orbit, t);
    });
}

void exact_one_by_one(Hash& hash) {
    for_each_orbit([&](const Exact& orbit, const double* t) {
        for (std::size_t i = 0; i < times; ++i) hash(at(orbit, t[i]));
    });
}

void exact_in_packs(Hash& hash) {
    static double theta[times], omega[times], turns[times];
    for_each_orbit([&](const Exact& orbit, const double* t) {
        at(orbit, times, t, theta, omega, turns);
        for (std::size_t i = 0; i < times; ++i) hash(Sample{t[i], theta[i], omega[i], turns[i]});
    });
}

void sinusoids(Hash& hash) {
    for_each_orbit([&](const Exact& orbit, const double* t) {
        for (std::size_t i = 0; i < times; ++i) hash(sinusoid(orbit, t[i]));
    });
}

// Hashes all rows of a problem whose times are factors of tau, computed by calls for `group` rows and `budget` steps each.
void rows(Hash& hash, Method method, double alpha, State initial, Times factors, std::size_t group, double budget) {
    const double tau = analyze(alpha, initial).tau;
    Trajectory run = begin({.pendulum = {.alpha = alpha},
                            .initial = initial,
                            .method = method,
                            .schedule = make_schedule({factors.dt * tau, factors.every * tau, factors.until * tau})});
    static Sample samples[64];
    while (!run.is_finished()) {
        const std::size_t n = advance(run, std::span(samples).first(group), budget);
        for (std::size_t i = 0; i < n; ++i) hash(samples[i]);
    }
}

void method_rows(Hash& hash, Method method) {
    for_each_problem([&](double alpha, State s) { rows(hash, method, alpha, s, {0.004, 0.05, 20}, 64, 1e9); });
    rows(hash, method, 1, {3, 0}, {1e-4, 0.02, 2}, 64, 1e9);
    rows(hash, method, 1, {0.1, -2.01}, {0.3, 1, 2000}, 64, 1e9);
    rows(hash, method, 1, {pi / 2, 0}, {0.004, 0.05, 20}, 7, 13);
}

void euler_rows(Hash& hash) { method_rows(hash, Method::euler); }
void verlet_rows(Hash& hash) { method_rows(hash, Method::verlet); }
void rk4_rows(Hash& hash) { method_rows(hash, Method::rk4); }
void exact_rows(Hash& hash) { method_rows(hash, Method::exact); }

void assignment(Hash& hash) {
    for_each_problem([&](double alpha, State s) {
        double theta = s.theta, theta_max = 0, tau = 0;
        int k = 0;
        hash(actividad3::validaAngulo(theta, 's'));
        hash(theta);
        hash(actividad3::fase(s.theta, s.omega));
        hash(actividad3::normaliza(s.theta));
        actividad3::analisis(alpha, s.theta, s.omega, 1e-7, theta_max, tau, k);
        hash(theta_max);
        hash(tau);
        hash(k);
        for (int i = 0; i < 100; ++i) actividad3::RungeKutta(alpha, s.theta, s.omega, i * 0.01 * tau, 0.01 * tau);
        hash(s.theta);
        hash(s.omega);
    });
}

// Pendulums with friction, torque and drive, by rk4 and by taylor, and conservative ones by the closed form. Member 100 is
// hashed as NaN.
template <int threads>
void ensembles(Hash& hash) {
    constexpr std::size_t size = 307, row_count = 5;
    static double theta[size], omega[size], alpha[size], beta[size], drive[size];
    static double row_theta[size * row_count], row_omega[size * row_count], row_turns[size * row_count];
    Random random;
    for (std::size_t i = 0; i < size; ++i) {
        theta[i] = random(-10, 10);
        omega[i] = random(-3, 3);
        alpha[i] = random(0.5, 2);
        beta[i] = random(0, 1);
        drive[i] = random(0, 2);
    }
    const EnsembleTimes when{.first = 1.5, .every = 3 * pi, .rows = row_count, .steps_to_first = 333, .steps_per_row = 333};
    const auto visit = [&](const Ensemble& ensemble, Method method) {
        const auto outcome = solve(ensemble, method, 1e-15, when, {row_theta, row_omega, row_turns}, {.threads = threads});
        if (!outcome.is_done()) hash(nan);
        for (std::size_t i = 0; i < size * row_count; ++i)
            hash(i % size == 100 ? Sample{0, nan, nan, nan} : Sample{0, row_theta[i], row_omega[i], row_turns[i]});
    };
    const Ensemble forced{.size = size,
                          .theta = theta,
                          .omega = omega,
                          .alpha = alpha,
                          .beta = beta,
                          .torque = 0.1,
                          .drive_amplitude = drive,
                          .drive_frequency = 2.0 / 3,
                          .drive_phase = 0.25};
    visit(forced, Method::rk4);
    visit(forced, Method::taylor);
    visit({.size = size, .theta = theta, .omega = omega, .alpha = alpha}, Method::exact);
}

// The driven pendulum of Baker and Blackburn, regular and chaotic, over 1,000 periods of its drive: by then a difference in the
// last bit has changed the whole result.
constexpr double amplitudes[] = {0.9, 1.07, 1.15, 1.35, 1.45, 1.47, 1.5, 1.5};
constexpr std::size_t driven = sizeof(amplitudes) / sizeof(*amplitudes);

Ensemble published() {
    return {.size = driven, .theta = 0.2, .beta = 0.5, .drive_amplitude = amplitudes, .drive_frequency = 2.0 / 3};
}

// All columns of a measure of the published pendulums, with one row each.
void measured(Hash& hash, Measure what, const Strobe& strobe, const Control& control = {}) {
    constexpr std::size_t most = 10;
    static double values[most][driven];
    const auto& columns = measures[static_cast<int>(what)].columns;
    std::span<double> results[most];
    for (std::size_t i = 0; i < columns.size(); ++i) results[i] = {values[i], rows_of(columns[i], strobe) * driven};
    if (!measure(what, published(), strobe, std::span<const std::span<double>>(results, columns.size()), control).is_done())
        hash(nan);
    for (std::size_t i = 0; i < columns.size(); ++i)
        for (double x : results[i]) hash(x);
}

template <Method method>
void thousand_periods(Hash& hash) {
    measured(hash, Measure::section, {.transient = 1000, .periods = 1, .steps_per_period = 300, .method = method},
             {.threads = 2});
}

template <Method method>
void diagnostics(Hash& hash) {
    const Strobe strobe{.transient = 50, .periods = 64, .steps_per_period = 300, .method = method, .budget = 200};
    for (const auto& info : measures)
        if (info.measure != Measure::section) measured(hash, info.measure, strobe);
}

void taylor_rows(Hash& hash) {
    Random random;
    for (int i = 0; i < 20; ++i) {
        const Pendulum p{.alpha = random(0.5, 2),
                         .beta = random(0, 1),
                         .torque = random(-1, 1),
                         .drive_amplitude = random(0, 2),
                         .drive_frequency = random(0.3, 2),
                         .drive_phase = random(-3, 3)};
        auto run = begin({p, {random(-10, 10), random(-3, 3)}, Method::taylor, make_schedule({1, 0.5, 40}), 1e-15});
        for (Sample row; !run.is_finished();)
            if (advance(run, {&row, 1}, 1000) == 1) hash(row);
    }
}

struct Section {
    const char* name;
    void (*solve)(Hash&);
};

constexpr Section sections[] = {{"angles", angles},
                                {"energies", energies},
                                {"analyses", analyses},
                                {"exact", exact_one_by_one},
                                {"exact_in_packs", exact_in_packs},
                                {"sinusoids", sinusoids},
                                {"euler", euler_rows},
                                {"verlet", verlet_rows},
                                {"rk4", rk4_rows},
                                {"exact_rows", exact_rows},
                                {"assignment", assignment},
                                {"taylor", taylor_rows},
                                {"thousand_periods_rk4", thousand_periods<Method::rk4>},
                                {"thousand_periods_taylor", thousand_periods<Method::taylor>},
                                {"diagnostics_rk4", diagnostics<Method::rk4>},
                                {"diagnostics_taylor", diagnostics<Method::taylor>},
                                {"ensembles_1_thread", ensembles<1>},
                                {"ensembles_2_threads", ensembles<2>},
                                {"ensembles_3_threads", ensembles<3>},
                                {"ensembles_7_threads", ensembles<7>}};
constexpr int section_count = sizeof(sections) / sizeof(*sections);

}  // namespace

// Returns "name hash" for a section, or nullptr after the last section.
extern "C" EXPORT(report) const char* report(int section) {
    if (section >= section_count) return nullptr;
    Hash hash;
    sections[section].solve(hash);
    static char line[64];
    char* end = line;
    for (const char* c = sections[section].name; *c; ++c) *end++ = *c;
    *end++ = ' ';
    for (int shift = 60; shift >= 0; shift -= 4) *end++ = "0123456789abcdef"[hash.value >> shift & 15];
    *end = 0;
    return line;
}

#ifndef __wasm__
#include <cstdio>
#include <cstring>

#include "pendula/version.hpp"

// `golden --isa` prints the instruction set in use.
int main(int argc, char** argv) {
    if (argc > 1 && std::strcmp(argv[1], "--isa") == 0) {
        const char* const isa = instruction_set();
        if (isa) return std::puts(isa) < 0;
        std::fputs("PENDULA_ISA names no instruction set of this processor\n", stderr);
        return 1;
    }
    if (argc > 1) listener = [](double x) { std::printf("%a\n", x); };
    for (int i = 0; i < section_count; ++i)
        if (argc < 2)
            std::puts(report(i));
        else if (std::strcmp(argv[1], sections[i].name) == 0)
            report(i);
}
#endif
