// Long-time measures of many pendulums: sections, mean velocities, Lyapunov exponents, attractors, periodic orbits.
// Trajectories are not stored: memory is the results and a constant for each thread.
#pragma once

#include <initializer_list>

#include "pendula/ensemble.hpp"
#include "pendula/strobe.hpp"

namespace pendula {

/// What becomes of a motion in the long run. Every measure gives the kind, since its numbers depend on it.
enum class Kind {
    unsettled,       ///< none of the others up to the budget
    fixed_point,     ///< at rest: at the bottom, at the angle where torque and gravity balance, or at the top
    periodic,        ///< a periodic orbit of the strobe map
    rotating,        ///< without drive, friction and torque: a limit cycle that turns over and over
    quasi_periodic,  ///< an orbit that fills a curve: exponent 0 within its error, and a rotation number
    chaotic,         ///< an exponent above three times its error
    conservative,    ///< without friction, drive and shaken pivot: the energy stays, and nothing is approached
    unbounded,       ///< without friction: a torque accelerates the motion for ever
    lost,            ///< the motion leaves the range of doubles
};
inline constexpr const char* kind_names[] = {"unsettled", "fixed_point",  "periodic",  "rotating", "quasi_periodic",
                                             "chaotic",   "conservative", "unbounded", "lost"};

enum class Measure {
    section,        ///< `periods` successive states on a surface of section, the first after the transient
    mean_velocity,  ///< mean angular velocity
    lyapunov,       ///< both Lyapunov exponents
    attractors,     ///< the orbits on which the members end
    orbit,          ///< the periodic orbit to which Newton's method leads from the initial state
};

/// A column of results.
struct ResultColumn {
    enum class Rows { one, periods, history };  ///< how many values there are for each member
    const char* name;
    const char* symbol;
    const char* unit;
    Words meaning;
    Rows rows = Rows::one;
    bool is_detail = false;                   ///< the program prints it only on request
    std::span<const char* const> words = {};  ///< the values are indices in this list
    const char* header = nullptr;             ///< in the tables of the program, if it is not the name
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

/// The state that a motion has reached at the end: a point of its orbit if it has settled on one, else its last state. A
/// carried sweep goes on from it.
inline constexpr ResultColumn end_angle = {
    "theta", "θ", "rad", {"angle at the end", "ángulo al final"}, ResultColumn::Rows::one, true};
inline constexpr ResultColumn end_velocity = {
    "omega", "ω", "rad/s", {"angular velocity at the end", "velocidad angular al final"}, ResultColumn::Rows::one, true};
inline constexpr ResultColumn kind_of_motion = {
    "kind", "", "1", {"what becomes of the motion", "qué es del movimiento"}, ResultColumn::Rows::one, true, kind_names};

inline constexpr ResultColumn section_columns[] = {
    {"theta", "θ", "rad", {"angle in [-π, π)", "ángulo en [-π, π)"}, ResultColumn::Rows::periods},
    {"omega", "ω", "rad/s", {"angular velocity", "velocidad angular"}, ResultColumn::Rows::periods},
    {"turns", "", "1", {"whole turns", "vueltas enteras"}, ResultColumn::Rows::periods, true},
    {"t", "t", "s", {"time", "tiempo"}, ResultColumn::Rows::periods, true},
};
inline constexpr ResultColumn mean_velocity_columns[] = {
    {"mean_velocity", "⟨ω⟩", "rad/s", {"mean angular velocity", "velocidad angular media"}},
    {"error", "", "rad/s", {"a bound of its error", "una cota de su error"}},
    kind_of_motion,
    end_angle,
    end_velocity,
};
inline constexpr ResultColumn lyapunov_columns[] = {
    {"exponent",
     "λ",
     "s⁻¹",
     {"largest Lyapunov exponent", "mayor exponente de Lyapunov"},
     ResultColumn::Rows::one,
     false,
     {},
     "lyapunov"},
    {"error", "", "s⁻¹", {"a bound of its error", "una cota de su error"}},
    {"horizon",
     "",
     "s",
     {"when rounding has grown to the size of the state", "cuándo el redondeo alcanza el tamaño del estado"}},
    {"second",
     "λ₂",
     "s⁻¹",
     {"the other exponent, -β - λ, with the same error", "el otro exponente, -β - λ, con el mismo error"},
     ResultColumn::Rows::one,
     true},
    {"dimension",
     "D",
     "1",
     {"Kaplan and Yorke's dimension in the plane of the section", "dimensión de Kaplan y Yorke en el plano de la sección"},
     ResultColumn::Rows::one,
     true},
    {"dimension_error", "", "1", {"a bound of its error", "una cota de su error"}, ResultColumn::Rows::one, true},
    kind_of_motion,
    end_angle,
    end_velocity,
    {"history",
     "λ",
     "s⁻¹",
     {"estimates from growing parts of the periods", "estimaciones con cada vez más periodos"},
     ResultColumn::Rows::history,
     true},
};
inline constexpr ResultColumn attractors_columns[] = {
    {"label", "", "1", {"number of the attractor, 0 for none", "número del atractor, 0 si no lo hay"}},
    {"kind", "", "1", {"what becomes of the motion", "qué es del movimiento"}, ResultColumn::Rows::one, false, kind_names},
    {"period", "", "1", {"in periods of the strobe, 0 for none", "en periodos del estroboscopio, 0 si no lo hay"}},
    {"rotation", "", "1", {"turns in a period of the strobe", "vueltas por periodo del estroboscopio"}},
    {"theta", "θ", "rad", {"a point of the orbit", "un punto de la órbita"}},
    {"omega", "ω", "rad/s", {"its angular velocity", "su velocidad angular"}},
    {"error", "", "1", {"a bound of the error of rotation", "una cota del error de rotation"}, ResultColumn::Rows::one, true},
    {"exponent", "λ", "s⁻¹", {"largest Lyapunov exponent", "mayor exponente de Lyapunov"}, ResultColumn::Rows::one, true},
    {"exponent_error", "", "s⁻¹", {"a bound of its error", "una cota de su error"}, ResultColumn::Rows::one, true},
};
inline constexpr ResultColumn orbit_columns[] = {
    {"theta", "θ", "rad", {"a point of the orbit", "un punto de la órbita"}},
    {"omega", "ω", "rad/s", {"its angular velocity", "su velocidad angular"}},
    {"error", "", "rad", {"a bound of the error of theta and omega/Ω", "una cota del error de theta y omega/Ω"}},
    {"rotation", "", "1", {"turns in a period of the strobe", "vueltas por periodo del estroboscopio"}},
    {"first", "m₁", "1", {"real part of Floquet's larger multiplier", "parte real del mayor multiplicador de Floquet"}},
    {"second", "m₂", "1", {"real part of the other multiplier", "parte real del otro multiplicador"}},
    {"imaginary",
     "",
     "1",
     {"imaginary part of the first, minus that of the second", "parte imaginaria del primero, opuesta a la del segundo"}},
    {"exponent", "λ", "s⁻¹", {"largest exponent of Floquet", "mayor exponente de Floquet"}},
    {"exponent_error", "", "s⁻¹", {"a bound of its error", "una cota de su error"}},
};

/// In the order of the enumerators.
inline constexpr MeasureInfo measures[] = {
    {Measure::section,
     "section",
     {"states once a period of the drive, or on a plane", "estados, uno por periodo del forzamiento o en un plano"},
     section_columns,
     100,
     false},
    {Measure::mean_velocity,
     "mean_velocity",
     {"mean angular velocity", "velocidad angular media"},
     mean_velocity_columns,
     400,
     false},
    {Measure::lyapunov, "lyapunov", {"Lyapunov exponents", "exponentes de Lyapunov"}, lyapunov_columns, 1000, false},
    {Measure::attractors,
     "attractors",
     {"orbits that pendulums settle on", "órbitas en las que acaban los péndulos"},
     attractors_columns,
     400,
     true},
    {Measure::orbit,
     "orbit",
     {"periodic orbits near the initial states, stable or not",
      "órbitas periódicas cerca de los estados iniciales, estables o no"},
     orbit_columns,
     1,
     false},
};

/// The bits of measures that use a setting.
constexpr unsigned bits_of(std::initializer_list<Measure> users) noexcept {
    unsigned bits = 0;
    for (const Measure measure : users) bits |= 1u << static_cast<unsigned>(measure);
    return bits;
}
inline constexpr unsigned settling_measures = bits_of({Measure::mean_velocity, Measure::lyapunov, Measure::attractors});
inline constexpr unsigned all_measures = settling_measures | bits_of({Measure::section, Measure::orbit});

/// In the order in which the interfaces list them. The default of `periods` is that of the measure.
inline constexpr Setting settings[] = {
    {"transient",
     "1",
     {"periods before the measurement", "periodos antes de la medida"},
     &Strobe::transient,
     settling_measures | bits_of({Measure::section})},
    {"periods",
     "1",
     {"measured periods", "periodos medidos"},
     &Strobe::periods,
     settling_measures | bits_of({Measure::section})},
    {"budget",
     "1",
     {"periods after which a motion that has not settled is given up",
      "periodos tras los que se abandona un movimiento no asentado"},
     &Strobe::budget,
     settling_measures | bits_of({Measure::section})},
    {"steps_per_period",
     "1",
     {"steps of rk4 in a period", "pasos de rk4 por periodo"},
     &Strobe::steps_per_period,
     all_measures},
    {"tolerance", "1", {"of taylor", "de taylor"}, &Strobe::tolerance, all_measures},
    {"strobe_phase",
     "rad",
     {"phase of the drive at the times of the strobe", "fase del forzamiento en los instantes del estroboscopio"},
     &Strobe::phase,
     all_measures,
     true},
    {"level",
     "rad or rad/s",
     {"where a section cuts theta or omega", "dónde corta una sección a theta u omega"},
     &Strobe::level,
     bits_of({Measure::section}),
     true},
    {"rows",
     "1",
     {"rows of the history of estimates", "filas de la historia de estimaciones"},
     &Strobe::history_rows,
     bits_of({Measure::lyapunov})},
    {"match",
     "rad",
     {"the distance at which a motion is on a periodic orbit",
      "la distancia a la que un movimiento está en una órbita periódica"},
     &Strobe::match,
     settling_measures},
    {"orbit_period",
     "1",
     {"periods after which the orbit closes", "periodos tras los que se cierra la órbita"},
     &Strobe::orbit_period,
     bits_of({Measure::orbit})},
};

/// The number of rows of a column of results; each row has `size` values.
std::size_t rows_of(const ResultColumn& column, const Strobe& strobe) noexcept;

/// The arrays that receive the results: one for each column of the measure, with rows x size values, row by row. A column that
/// is a detail may be left out, by an empty array or at the end.
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
/// motion leaves the range of doubles, its own values become NaN and no others. The whole call is refused if a member, a
/// setting or the length of a result is not legal.
///
/// *section*: theta in [-pi, pi) [rad], omega [rad/s], whole turns and the time [s]: at the times t_n, or at the successive
/// crossings of a plane (crossings.hpp) after the transient, which begins at t = 0 then. Rows of crossings that do not come
/// within `budget` periods after the transient are NaN. A plane needs method `taylor`.
///
/// The other measures follow each motion until its kind is known (`Kind`, docs/measures.md), or for the transient and the
/// measured periods, and further up to the budget if these do not decide. Their numbers follow from the kind:
///
/// - What is known is not estimated. At a fixed point the velocity is 0 and the exponents are the real parts of the
///   eigenvalues. On a periodic orbit the velocity is a ratio of whole numbers times the frequency, and the exponents are
///   Floquet's. The limit cycle of an undriven pendulum has the velocity 2 pi/period and the exponents 0 and -beta. A
///   conservative motion has the exponents 0 (on the separatrix +-sqrt(alpha)) and the velocity of the closed form.
/// - On all other orbits the numbers are means over the measured periods, with errors from their scatter and their drift.
///
/// An error is a bound that covers the true value of the equation for the doubles given; a pendulum that `rests_on_top`
/// (analysis.hpp) counts as exactly there. Means are covered in at least 95 % of the cases of each kind (docs/calibration.md),
/// everything else always. With method `rk4` it covers the value of the map that rk4 makes; the error of the method itself is
/// not included. It is 0 where only the last rounding is left. A number that cannot be had is NaN, and the kind says why.
///
/// *mean_velocity* [rad/s]: divided by drive_frequency it is the rotation number; for a Josephson junction it is the voltage.
///
/// *lyapunov* [s^-1]: the larger exponent; the other is -beta minus this one, with the same error. The horizon [s] is
/// ln(2^52)/exponent, the time in which a rounding error grows to the size of the state; infinite unless the exponent is above
/// three times its error. The dimension is 1 + exponent/|second| for a chaotic motion, by Kaplan and Yorke; 0 for a point, 1
/// for a curve. Row j of the history [s^-1] is the estimate from the first floor((j + 1) periods/history_rows) periods, or the
/// exponent if it is not estimated; the array is empty if history_rows is 0.
///
/// *attractors*: members that differ only in theta and omega are on the same attractor if their kind, period and rotation are
/// equal and one orbit passes within `match` of a point of the other, in theta [rad] and omega/frequency. Attractors are
/// numbered 1, 2, ... in the order of period, rotation, theta and omega. The state is the point of the orbit with the smallest
/// theta in [-pi, pi); for a rotating limit cycle that at theta = 0; for other kinds, whose label and period are 0, the last
/// state. The period of a limit cycle is in periods of the strobe, and no whole number. For each set of parameters the first
/// 256 attractors found are numbered; members on others have label 0.
///
/// *orbit*: `refine` (orbit.hpp) from the initial state; NaN if Newton's method does not converge.
Outcome measure(Measure what, const Ensemble& ensemble, const Strobe& strobe, const Results& results,
                const Control& control = {}) noexcept;

/// Half the width of an interval that covers the share of a basin, or any probability, in at least 95 % of the cases, when
/// `count` of `trials` independent members are in it: Wilson, J. Am. Stat. Assoc. 22 (1927), about count/trials.
double share_error(double count, double trials) noexcept;

}  // namespace pendula
