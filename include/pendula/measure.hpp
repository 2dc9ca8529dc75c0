// What becomes of many pendulums in the long run: stroboscopic sections, mean velocities, Lyapunov exponents, attractors.
// Nothing is stored on the way: memory is the results and a constant for each thread.
#pragma once

#include <initializer_list>

#include "pendula/ensemble.hpp"

namespace pendula {

/// How members are looked at: once a period of the drive, at t_n = (2 pi n - drive_phase)/drive_frequency >= 0, where its
/// phase is 0; where drive_frequency is 0, at t_n = 2 pi n/sqrt(alpha).
///
/// The equation is the same at every t_n, so that each period is computed as if it were the first, and no rounding of times
/// adds up. There theta and omega are rounded to the doubles that are reported: an orbit is one of a map of doubles, and
/// may be taken up again from any of its points.
struct Strobe {
    double transient = 200;          ///< periods before what is measured begins; a whole number >= 0
    double periods = 100;            ///< that are measured; a whole number >= 1
    double steps_per_period = 1000;  ///< of `rk4`; a whole number >= 1
    Method method = Method::rk4;     ///< `rk4` or `taylor`
    double tolerance = 1e-15;        ///< of `taylor`, in (0, 1)
    double history_rows = 0;         ///< of `lyapunov`; a whole number from 0 to periods
    double match = 1e-6;             ///< of `attractors`: how near an orbit comes back, in theta [rad] and omega/frequency; > 0
};

/// The angular frequency of the strobe [rad/s]: drive_frequency, or sqrt(alpha) where it is 0. NaN where a driven pendulum has
/// none.
double strobe_frequency(const Pendulum& pendulum) noexcept;

/// The fewest steps a period with which `rk4` is stable: beta h <= 2.78 and sqrt(alpha + |pivot_amplitude|) h <= 2.82, the bounds
/// of its region on the two axes (Hairer & Wanner II, IV.2). `taylor` takes about as many. Accuracy needs tens of steps for each
/// turn and swing.
double fewest_steps(const Pendulum& pendulum) noexcept;

/// What is wrong with measuring a pendulum so: parameters, counts, the method, steps too long for `rk4` to be stable, or more
/// than 2^53 of them.
Refusal check(const Pendulum& pendulum, const Strobe& strobe) noexcept;

enum class Measure {
    section,        ///< states at `periods` successive t_n, the first after the transient
    mean_velocity,  ///< mean angular velocity
    lyapunov,       ///< largest Lyapunov exponent
    attractors,     ///< the periodic orbits that members settle on
};

/// A column of results.
struct ResultColumn {
    enum class Rows { one, periods, history };  ///< how many values a member has
    const char* name;
    const char* symbol;
    const char* unit;
    Words meaning;
    Rows rows = Rows::one;
    const char* header = nullptr;  ///< in the program's tables; null where they leave the column out
};

/// What there is to know of a measure; faces loop over `measures`.
struct MeasureInfo {
    Measure measure;
    const char* name;
    Words meaning;
    std::span<const ResultColumn> columns;
    double periods;         ///< measured where nothing else is asked for
    bool compares_members;  ///< results depend on which members are measured together
};

inline constexpr ResultColumn section_columns[] = {
    {"theta", "θ", "rad", {"angle in [-π, π)", "ángulo en [-π, π)"}, ResultColumn::Rows::periods, "theta"},
    {"omega", "ω", "rad/s", {"angular velocity", "velocidad angular"}, ResultColumn::Rows::periods, "omega"},
    {"turns", "", "1", {"whole turns", "vueltas enteras"}, ResultColumn::Rows::periods},
};
inline constexpr ResultColumn mean_velocity_columns[] = {
    {"mean_velocity", "⟨ω⟩", "rad/s", {"mean angular velocity", "velocidad angular media"}, ResultColumn::Rows::one, "mean_velocity"},
};
inline constexpr ResultColumn lyapunov_columns[] = {
    {"exponent", "λ", "s⁻¹", {"largest Lyapunov exponent", "mayor exponente de Lyapunov"}, ResultColumn::Rows::one, "lyapunov"},
    {"error", "", "s⁻¹", {"its standard error", "su error típico"}, ResultColumn::Rows::one, "error"},
    {"horizon", "", "s", {"when rounding has grown to the size of the state", "cuándo el redondeo alcanza el tamaño del estado"},
     ResultColumn::Rows::one, "horizon"},
    {"history", "λ", "s⁻¹", {"estimates from growing parts of the periods", "estimaciones con cada vez más periodos"},
     ResultColumn::Rows::history},
};
inline constexpr ResultColumn attractors_columns[] = {
    {"label", "", "1", {"number of the attractor, 0 for none", "número del atractor, 0 si no lo hay"}, ResultColumn::Rows::one, "label"},
    {"period", "", "1", {"in periods of the strobe, 0 for none", "en periodos del estroboscopio, 0 si no lo hay"}, ResultColumn::Rows::one, "period"},
    {"rotation", "", "1", {"turns a period of the strobe", "vueltas por periodo del estroboscopio"}, ResultColumn::Rows::one, "rotation"},
    {"theta", "θ", "rad", {"a point of the orbit", "un punto de la órbita"}, ResultColumn::Rows::one, "theta"},
    {"omega", "ω", "rad/s", {"its angular velocity", "su velocidad angular"}, ResultColumn::Rows::one, "omega"},
};

/// In the order of the enumerators.
inline constexpr MeasureInfo measures[] = {
    {Measure::section, "section", {"states once a period of the drive", "estados, uno por periodo del forzamiento"}, section_columns, 100, false},
    {Measure::mean_velocity, "mean_velocity", {"mean angular velocity", "velocidad angular media"}, mean_velocity_columns, 100, false},
    {Measure::lyapunov, "lyapunov", {"largest Lyapunov exponent", "mayor exponente de Lyapunov"}, lyapunov_columns, 1000, false},
    {Measure::attractors, "attractors", {"periodic orbits that pendulums settle on", "órbitas periódicas en las que acaban los péndulos"}, attractors_columns, 100, true},
};

/// How many rows of `size` values a column of results has.
std::size_t rows_of(const ResultColumn& column, const Strobe& strobe) noexcept;

/// Where results go: an array for each column of the measure, of rows x size values, row by row.
class Results {
  public:
    Results(std::initializer_list<std::span<double>> columns) noexcept : columns_(columns.begin(), columns.size()) {}
    Results(std::span<const std::span<double>> columns) noexcept : columns_(columns) {}
    std::span<const std::span<double>> columns() const noexcept { return columns_; }

  private:
    std::span<const std::span<double>> columns_;
};

/// Measures every member of an ensemble.
///
/// A member's bits depend on its own parameters only (and, for the labels of attractors, on the members that share them), not on
/// the number of threads or the instruction set. A member whose motion leaves the doubles becomes NaN in its own places. Refused
/// as a whole where a member, a setting or the length of a result is not legal: each member is checked as if it stood alone.
///
/// *section*: theta in [-pi, pi) [rad], omega [rad/s] and whole turns at t_n.
///
/// *mean_velocity* [rad/s] over the periods measured, from turns and the difference of two angles: nothing is summed. Over
/// drive_frequency it is the rotation number; for a Josephson junction it is the voltage.
///
/// *lyapunov*: the mean growth, over the periods measured, of ln |(d theta, d omega/sqrt(alpha))|, where the displacement
/// follows the linearised equation and is brought back to length 1 every period, or sooner (Benettin et al., Meccanica 15,
/// 1980). It begins with the transient, so that it has turned to the direction that grows. The standard error is that of the mean
/// of 32 blocks (fewer if there are fewer periods; NaN from a single one), and holds where a block is longer than the growth's
/// memory, some periods. On regular orbits the estimate oscillates about the exponent by no more than a constant over the time, or
/// falls like ln(t)/t where neighbours drift apart evenly; the error is then of the size of the departure. The horizon is
/// ln(2^52)/exponent [s], infinite where the exponent is not positive. The other exponent is -beta less this one. Row j of the
/// history [s^-1] is the estimate from the first floor((j + 1) periods/history_rows) periods; its array is empty where
/// history_rows is 0.
///
/// *attractors*: an orbit is periodic when it comes back, up to whole turns, within `match`; the period is the smallest such, found
/// if it began to come back before half of the periods measured and is no longer than a quarter of them. Members that differ in
/// theta and omega alone are on the same attractor if period and rotation are equal and one passes within `match` of the other;
/// their attractors are numbered 1, 2, ... by period, rotation, theta and omega of the point of smallest theta in [-pi, pi), which
/// is what theta and omega report. Where an orbit is not periodic label and period are 0, theta and omega the last point, and
/// rotation the mean velocity over strobe_frequency; label is 0, too, beyond the first 256 attractors of a pendulum.
Outcome measure(Measure what, const Ensemble& ensemble, const Strobe& strobe, const Results& results,
                const Control& control = {}) noexcept;

}  // namespace pendula
