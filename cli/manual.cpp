// The manual page, in both languages. What it says of parameters and measures comes from their tables.
#include <algorithm>

#include "cli/commands.hpp"
#include "cli/table.hpp"

namespace pendula::cli {

namespace {

constexpr Words page{
    R"(pendula - the pendulum, exactly and step by step:
  θ'' = -(α + P cos(Ω t + φ)) sin θ - β θ' + μ + Γ cos(Ω t + φ)

USAGE
  pendula [OPTIONS] < problems        solve problems from standard input
  pendula solve --theta0 ANGLE ...    solve one problem given by options
  pendula analyze [OPTIONS]           regime, limit angle, characteristic time
{0}  pendula NAME ...                    run pendula-NAME, beside pendula or on PATH

PROBLEMS ON STANDARD INPUT
  Eight values in any white space; # starts a comment to the end of the line:

    factorΔ factorcout factortSimul θ0 unit ω0 unit α
    0.0001  0.02       1            90 s    0  r    1

  Step, time between rows and length of the run are the factors times τ, the
  pendulum's characteristic time: the period, or on the separatrix the time to
  0.999 of the limit angle. Units: r radians (rad/s), s sexagesimal degrees
  (degrees/s). α = g/l in 1/s². Numbers are decimal, with a point.

  Each problem gives a table: time, angle in [-π, π), angular velocity and, where
  the pendulum oscillates, the sinusoid of the same amplitude and period. Two
  blank lines separate tables. The first bad problem ends the program.

PARAMETERS
{1}  --gravity G --length L  the same as --alpha G/L
  One value each for solve; for the other commands also a range first:last:count.
  Ranges multiply; the last varies fastest, and in text an empty line ends it.
  solve and analyze need --theta0; analyze takes no friction and no forcing.

METHODS
  {2}. exact is the closed form: no friction, no
  forcing; verlet: no friction; taylor chooses its own steps. Measures: rk4, taylor.
  analyze: agm, the arithmetic-geometric mean, or series, which may need many terms.

COLUMNS of solve and of problems on standard input [t,theta,omega and sine]
{3}
MEASURES
  Looked at once a period of the drive, at Ω t + φ = 2πn; without a drive, of
  2π/√α. Lines begin with the values of the ranges. Behind them come:
{4}
pendula analyze
  Takes parameters, or lines "θ0 unit ω0 unit α" on standard input. Prints
  "k thetaM tau" for each: k is -1 if it oscillates, 0 on the separatrix, 1 if it
  rotates. A bad line becomes a line "ERROR: ..."

OPTIONS; times are in seconds, or factors of τ: with friction or forcing the period
  of the drive or, where there is none, 2π/√α
{5}  -h, --help, --version

EXIT STATUS
  0 done   1 bad data, or a motion out of the range of doubles   2 bad usage
  3 the output could not be written   130 interrupted; all rows are whole

EXAMPLES
)",
    R"(pendula - el péndulo, exacto y paso a paso:
  θ'' = -(α + P cos(Ω t + φ)) sen θ - β θ' + μ + Γ cos(Ω t + φ)

USO
  pendula [OPCIONES] < problemas       resuelve problemas de la entrada estándar
  pendula solve --theta0 ÁNGULO ...    resuelve un problema dado con opciones
  pendula analyze [OPCIONES]           régimen, ángulo límite, tiempo característico
{0}  pendula NOMBRE ...                   ejecuta pendula-NOMBRE, junto a pendula o en PATH

PROBLEMAS EN LA ENTRADA ESTÁNDAR
  Ocho valores separados por espacios o saltos de línea; # abre un comentario
  hasta el final de la línea:

    factorΔ factorcout factortSimul θ0 unidad ω0 unidad α
    0.0001  0.02       1            90 s      0  r      1

  El paso, el tiempo entre filas y la duración de la simulación son los factores
  por τ, el tiempo característico del péndulo: el periodo o, en la separatriz, lo
  que tarda en llegar a 0.999 del ángulo límite. Unidades: r radianes (rad/s),
  s grados sexagesimales (grados/s). α = g/l en 1/s². Los números son decimales,
  con punto.

  Cada problema da una tabla: tiempo, ángulo en [-π, π), velocidad angular y, si
  el péndulo oscila, la sinusoide de igual amplitud y periodo. Dos líneas en
  blanco separan las tablas. El primer problema incorrecto termina el programa.

PARÁMETROS
{1}  --gravity G --length L  lo mismo que --alpha G/L
  Un solo valor para solve; para las demás órdenes, también un rango
  primero:último:cuántos. Los rangos se multiplican; el último es el que más
  deprisa varía, y en texto termina con una línea vacía.
  solve y analyze necesitan --theta0; analyze no admite rozamiento ni fuerzas.

MÉTODOS
  {2}. exact es la solución exacta: sin rozamiento ni
  fuerzas; verlet: sin rozamiento; taylor elige sus pasos. Medidas: rk4, taylor.
  analyze: agm, la media aritmético-geométrica, o series, que puede necesitar muchos
  términos.

COLUMNAS de solve y de los problemas en la entrada estándar [t,theta,omega y sine]
{3}
MEDIDAS
  Miran una vez por periodo del forzamiento, cuando Ω t + φ = 2πn; sin él, por
  periodo de 2π/√α. Las líneas empiezan por los valores de los rangos. Siguen:
{4}
pendula analyze
  Acepta parámetros, o líneas "θ0 unidad ω0 unidad α" en la entrada estándar.
  Escribe "k thetaM tau" para cada una: k es -1 si oscila, 0 en la separatriz,
  1 si rota. Una línea incorrecta se convierte en una línea "ERROR: ..."

OPCIONES; los tiempos son segundos, o factores de τ: con rozamiento o fuerzas, el
  periodo del forzamiento o, si no lo hay, 2π/√α
{5}  -h, --help, --version

ESTADO DE SALIDA
  0 hecho   1 datos incorrectos, o un movimiento fuera del rango de double
  2 uso incorrecto   3 no se ha podido escribir la salida
  130 interrumpido; todas las filas están enteras

EJEMPLOS
)"};

constexpr std::string_view examples = R"(  echo "0.0001 0.02 1 90 s 0 r 1" | pendula
  pendula solve --theta0 90deg --gravity 9.81 --length 0.5 --every 0.01 --until 10
  pendula solve --theta0 3 --columns t,theta,error --precision full --format csv
  pendula analyze --theta0 0 --omega0 2
  pendula section --beta 0.5 --drive-amplitude 0.9:1.5:601 --drive-frequency 0.6667
)";

/// The text and spaces behind it, up to a number of UTF-8 characters.
std::string padded(std::string text, std::ptrdiff_t width) {
    const auto characters = std::ranges::count_if(text, [](char c) { return (c & 0xc0) != 0x80; });
    return text.append(static_cast<std::size_t>(std::max<std::ptrdiff_t>(1, width - characters)), ' ');
}

/// "angular velocity, rad/s" of a meaning and a unit.
std::string with_unit(const Words& meaning, std::string_view unit) {
    return say(meaning) + (unit == "1" ? "" : ", " + std::string(unit));
}

std::string parameter_lines() {
    std::string lines;
    for (const auto& p : parameters) {
        lines += padded("  " + option_of(p.name), 22) + padded(p.symbol, 4) + with_unit(p.meaning, p.unit);
        if (p.is_angle) lines += say({": 1.5 or 90deg", ": 1.5 o 90deg"}) + std::string(p.unit).substr(3);
        lines += " [" + shown(p.otherwise) + "]\n";
    }
    return lines;
}

std::string usage_lines() {
    std::string lines;
    const std::string options = say({" [OPTIONS]", " [OPCIONES]"});
    const auto width = 28 + static_cast<std::ptrdiff_t>(options.size());
    for (const auto& info : measures)
        lines += padded("  pendula " + hyphenated(info.name) + options, width) + say(info.meaning) + '\n';
    return lines;
}

/// What a line of each measure holds.
std::string measure_lines() {
    std::string lines;
    for (const auto& info : measures) {
        std::string lead = "  " + hyphenated(info.name);
        for (const auto& column : info.columns) {
            if (!column.header) continue;
            lines += padded(lead, 18) + padded(column.header, 15) + with_unit(column.meaning, column.unit) + '\n';
            lead.clear();
        }
    }
    return lines;
}

std::string table_column_lines() {
    std::string lines;
    for (const auto& column : table_columns) lines += padded(std::string("  ") + column.name, 18) + say(column.meaning) + '\n';
    return lines;
}

/// The options that are no parameters, under the commands that take them.
std::string option_lines() {
    std::string lines;
    unsigned commands = 0;
    for (const auto& option : known_options()) {
        if (!*option.value) continue;
        if (option.commands != commands) lines += "  " + typed_commands(option.commands, "") + ":\n";
        commands = option.commands;
        lines += padded("    " + option.name + ' ' + option.value, 24) + say(option.meaning);
        lines += option.otherwise.empty() ? "\n" : " [" + option.otherwise + "]\n";
    }
    return lines;
}

}  // namespace

std::string manual() {
    return say(page, {usage_lines(), parameter_lines(), joined({std::begin(method_names), std::end(method_names)}),
                      table_column_lines(), measure_lines(), option_lines()}) +
           std::string(examples);
}

}  // namespace pendula::cli
