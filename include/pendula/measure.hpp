// Long-time measures of many pendulums: stroboscopic sections, mean velocities, Lyapunov exponents, attractors. Trajectories
// are not stored: memory is the results and a constant for each thread.
#pragma once

#include <initializer_list>

#include "pendula/ensemble.hpp"

namespace pendula {

/// How trajectories are sampled: once per period of the drive (or of the shaken pivot), at the times t_n = (2 pi n -
/// drive_phase)/drive_frequency >= 0, where the phase of the drive is 0; with drive_frequency = 0, at t_n = 2 pi n/sqrt(alpha).
///
/// The equation is the same after every t_n. So the time is counted from 0 again in each period, and no rounding errors of
/// times add up. At each t_n theta and omega are rounded to doubles, which are the reported ones. An orbit is thus the
/// iteration of a map from doubles to doubles, and can be continued from any of its points with the same bits.
struct Strobe {
    double transient = 200;          ///< periods before the measurement; a whole number >= 0
    double periods = 100;            ///< measured periods; a whole number >= 1
    double steps_per_period = 1000;  ///< for method `rk4`; a whole number >= 1
    Method method = Method::rk4;     ///< `rk4` or `taylor`
    double tolerance = 1e-15;        ///< for method `taylor`, in (0, 1)
    double history_rows = 0;         ///< for `lyapunov`: rows of the history; a whole number from 0 to periods
    double match = 1e-6;             ///< for `attractors`: the distance at which an orbit has returned; > 0
};

/// The angular frequency of the strobe [rad/s]: drive_frequency, or sqrt(alpha) if that is 0. NaN for a driven pendulum with
/// drive_frequency = 0.
double strobe_frequency(const Pendulum& pendulum) noexcept;

/// The smallest number of steps per period for which `rk4` is stable: beta h <= 2.78 and sqrt(alpha + |pivot_amplitude|) h <=
/// 2.82, the bounds of its stability region on the real and the imaginary axis (Hairer & Wanner II, IV.2). `taylor` takes about
/// that many. Accurate results need tens of steps for each turn and each oscillation. NaN where `strobe_frequency` is NaN.
double fewest_steps(const Pendulum& pendulum) noexcept;

/// Why the pendulum cannot be measured with these settings, or no refusal: an illegal parameter, count or method, steps too
/// long for `rk4` to be stable, or more than 2^53 steps.
Refusal check(const Pendulum& pendulum, const Strobe& strobe) noexcept;

enum class Measure {
    section,        ///< states at `periods` successive t_n, the first after the transient
    mean_velocity,  ///< mean angular velocity
    lyapunov,       ///< largest Lyapunov exponent
    attractors,     ///< the periodic orbits on which the members end
};

/// A column of results.
struct ResultColumn {
    enum class Rows { one, periods, history };  ///< how many values there are for each member
    const char* name;
    const char* symbol;
    const char* unit;
    Words meaning;
    Rows rows = Rows::one;
    const char* header = nullptr;  ///< in the tables of the program; null for a column that they omit
};

/// The properties of a measure. The program, the bindings and the stub loop over `measures`.
struct MeasureInfo {
    Measure measure;
    const char* name;
    Words meaning;
    std::span<const ResultColumn> columns;
    double periods;         ///< the default number of measured periods
    bool compares_members;  ///< the results depend on which members are measured together
};

inline constexpr ResultColumn section_columns[] = {
    {"theta", "θ", "rad", {"angle in [-π, π)", "ángulo en [-π, π)"}, ResultColumn::Rows::periods, "theta"},
    {"omega", "ω", "rad/s", {"angular velocity", "velocidad angular"}, ResultColumn::Rows::periods, "omega"},
    {"turns", "", "1", {"whole turns", "vueltas enteras"}, ResultColumn::Rows::periods},
};
inline constexpr ResultColumn mean_velocity_columns[] = {
    {"mean_velocity",
     "⟨ω⟩",
     "rad/s",
     {"mean angular velocity", "velocidad angular media"},
     ResultColumn::Rows::one,
     "mean_velocity"},
};
inline constexpr ResultColumn lyapunov_columns[] = {
    {"exponent", "λ", "s⁻¹", {"largest Lyapunov exponent", "mayor exponente de Lyapunov"}, ResultColumn::Rows::one, "lyapunov"},
    {"error", "", "s⁻¹", {"its standard error", "su error típico"}, ResultColumn::Rows::one, "error"},
    {"horizon",
     "",
     "s",
     {"when rounding has grown to the size of the state", "cuándo el redondeo alcanza el tamaño del estado"},
     ResultColumn::Rows::one,
     "horizon"},
    {"history",
     "λ",
     "s⁻¹",
     {"estimates from growing parts of the periods", "estimaciones con cada vez más periodos"},
     ResultColumn::Rows::history},
};
inline constexpr ResultColumn attractors_columns[] = {
    {"label",
     "",
     "1",
     {"number of the attractor, 0 for none", "número del atractor, 0 si no lo hay"},
     ResultColumn::Rows::one,
     "label"},
    {"period",
     "",
     "1",
     {"in periods of the strobe, 0 for none", "en periodos del estroboscopio, 0 si no lo hay"},
     ResultColumn::Rows::one,
     "period"},
    {"rotation",
     "",
     "1",
     {"turns a period of the strobe", "vueltas por periodo del estroboscopio"},
     ResultColumn::Rows::one,
     "rotation"},
    {"theta", "θ", "rad", {"a point of the orbit", "un punto de la órbita"}, ResultColumn::Rows::one, "theta"},
    {"omega", "ω", "rad/s", {"its angular velocity", "su velocidad angular"}, ResultColumn::Rows::one, "omega"},
};

/// In the order of the enumerators.
inline constexpr MeasureInfo measures[] = {
    {Measure::section,
     "section",
     {"states once a period of the drive", "estados, uno por periodo del forzamiento"},
     section_columns,
     100,
     false},
    {Measure::mean_velocity,
     "mean_velocity",
     {"mean angular velocity", "velocidad angular media"},
     mean_velocity_columns,
     100,
     false},
    {Measure::lyapunov,
     "lyapunov",
     {"largest Lyapunov exponent", "mayor exponente de Lyapunov"},
     lyapunov_columns,
     1000,
     false},
    {Measure::attractors,
     "attractors",
     {"periodic orbits that pendulums settle on", "órbitas periódicas en las que acaban los péndulos"},
     attractors_columns,
     100,
     true},
};

/// The number of rows of a column of results; each row has `size` values.
std::size_t rows_of(const ResultColumn& column, const Strobe& strobe) noexcept;

/// The arrays that receive the results: one for each column of the measure, with rows x size values, row by row.
class Results {
  public:
    Results(std::initializer_list<std::span<double>> columns) noexcept : columns_(columns.begin(), columns.size()) {}
    Results(std::span<const std::span<double>> columns) noexcept : columns_(columns) {}
    std::span<const std::span<double>> columns() const noexcept { return columns_; }

  private:
    std::span<const std::span<double>> columns_;
};

/// Computes a measure of every member of an ensemble.
///
/// A member's bits depend only on its own parameters, and not on the number of threads or the instruction set
/// (tests/cpp/measure_test.cpp). Labels of attractors depend also on the members with the same parameters. Where a member's
/// motion overflows, its own values become NaN and no others. The whole call is refused if a member, a setting or the length of
/// a result is not legal.
///
/// *section*: theta in [-pi, pi) [rad], omega [rad/s] and whole turns at the times t_n.
///
/// *mean_velocity* [rad/s]: the difference of the unwrapped angles at the end and at the start of the measured periods, divided
/// by the time between them. Divided by drive_frequency it is the rotation number; for a Josephson junction it is the voltage.
///
/// *lyapunov*: the largest exponent [s^-1]. It is the mean growth rate of ln |(d theta, d omega/sqrt(alpha))| over the measured
/// periods. The displacement (d theta, d omega) follows the linearised equation and is rescaled to length 1 every period or
/// more often (Benettin et al., Meccanica 15, 1980). It is integrated from the first t_n on, so that after the transient it
/// points in the direction of fastest growth.
///
/// The standard error [s^-1] is that of the mean of 32 blocks of periods, or of as many as there are periods if these are
/// fewer; it is NaN for one period. It assumes independent blocks: a block must be longer than the correlation time of the
/// growth, which is some periods. On a regular orbit the estimate differs from the exponent by a term of order 1/t, or ln(t)/t
/// where neighbouring orbits separate linearly in time; the standard error is then of the size of that difference.
///
/// The horizon [s] is ln(2^52)/exponent, the time in which a rounding error grows to the size of the state; infinite if the
/// exponent is not positive. The other exponent is -beta minus this one. Row j of the history [s^-1] is the estimate from the
/// first floor((j + 1) periods/history_rows) periods; the array is empty if history_rows is 0.
///
/// *attractors*: an orbit is periodic if it returns to one of its points, up to whole turns, with theta [rad] and
/// omega/strobe_frequency each within `match`; its period is the number of strobe periods until the first return. An orbit that
/// has settled after a third of the measured periods is recognised if its period is not longer than another third.
///
/// Two members that differ only in theta and omega are on the same attractor if their period and rotation are equal and one
/// orbit passes within `match` of a point of the other. Attractors are numbered 1, 2, ... in the order of period, rotation,
/// theta and omega, where theta and omega are those of the orbit's point of smallest theta in [-pi, pi); that point is also the
/// result.
///
/// For an orbit that is not periodic label and period are 0, theta and omega are its last point, and rotation is the mean
/// velocity divided by strobe_frequency. For each set of parameters the first 256 attractors found are numbered; members on
/// others have label 0.
Outcome measure(Measure what, const Ensemble& ensemble, const Strobe& strobe, const Results& results,
                const Control& control = {}) noexcept;

}  // namespace pendula
