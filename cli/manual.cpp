// The manual page, in both languages. What it says of parameters and measures comes from their tables.
#include <algorithm>

#include "cli/commands.hpp"
#include "cli/settings.hpp"
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
  Numbers are typed as 1.5, 2e-3, 2/3, pi/2, 3pi/4 or -pi; angles are in radians,
  or in degrees as 90deg. One value each for solve; for the other commands also a
  range first:last:count. Ranges multiply; the last varies fastest, and in text an
  empty line ends it. Lines begin with the values of the ranges, in degrees where
  they were typed so.
  solve needs --theta0, analyze --theta0 or --tau; analyze takes no friction and
  no forcing.

METHODS
  solve: {2} [{6}]. exact is the closed form: no
  friction, no forcing; verlet: no friction; taylor chooses its own steps.
  Measures: {7} [{8}]. analyze: agm, the arithmetic-geometric
  mean, or series, which may need many terms [agm].

COLUMNS of solve and of problems on standard input [t,theta,omega and sine]
{3}
MEASURES
  Looked at once a period of the drive, at Ω t + φ = --strobe-phase; without a
  drive, of 2π/√α. Behind the values of the ranges come these columns, those with
  + only with --details. Errors are bounds. A result that cannot be had is nan;
  then the last line on standard error says why.
{4}  With --carry, the last range is followed up, or down, from state to state; both
  gives two blocks, with a column carry. With --locate TOL, each line is a place
  where a branch ends: the outer ranges, carry, the parameter there and its error,
  the gap, and the kinds before and after. With --shares, attractors has a line for
  each end of the starts --theta0 and --omega0: members, share, error of the share.

pendula analyze
  Takes parameters, or lines "θ0 unit ω0 unit α" on standard input. Prints
  "k thetaM tau" for each: k is -1 if it oscillates, 0 on the separatrix, 1 if it
  rotates. A bad line becomes a line "ERROR: ..." With --tau T in place of
  --theta0, T a value or a range in seconds, thetaM is the amplitude with that
  period.

OPTIONS; times are in seconds, or factors of τ: with friction or forcing the period
  of the drive or, where there is none, 2π/√α
{5}  -h, --help, --version

EXIT STATUS
  0 done   1 bad data, or results that are nan   2 bad usage
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
  Los números se escriben como 1.5, 2e-3, 2/3, pi/2, 3pi/4 o -pi; los ángulos, en
  radianes, o en grados como 90deg. Un solo valor para solve; para las demás
  órdenes, también un rango primero:último:cuántos. Los rangos se multiplican; el
  último es el que más deprisa varía, y en texto termina con una línea vacía. Las
  líneas empiezan por los valores de los rangos, en grados si así se escribieron.
  solve necesita --theta0, y analyze --theta0 o --tau; analyze no admite rozamiento
  ni fuerzas.

MÉTODOS
  solve: {2} [{6}]. exact es la solución exacta:
  sin rozamiento ni fuerzas; verlet: sin rozamiento; taylor elige sus pasos.
  Medidas: {7} [{8}]. analyze: agm, la media aritmético-geométrica,
  o series, que puede necesitar muchos términos [agm].

COLUMNAS de solve y de los problemas en la entrada estándar [t,theta,omega y sine]
{3}
MEDIDAS
  Miran una vez por periodo del forzamiento, cuando Ω t + φ = --strobe-phase; sin
  él, por periodo de 2π/√α. Tras los valores de los rangos vienen estas columnas,
  las de + solo con --details. Los errores son cotas. Un resultado que no se puede
  dar es nan; la última línea de la salida de errores dice por qué.
{4}  Con --carry el último rango se recorre hacia arriba (up) o hacia abajo (down), de
  estado en estado; both da dos bloques, con una columna carry. Con --locate TOL
  cada línea es un lugar donde acaba una rama: los rangos de fuera, carry, el valor
  del parámetro y su error, el salto, y las clases de antes y después. Con --shares,
  attractors da una línea por cada final de los comienzos --theta0 y --omega0:
  miembros, parte y error de la parte.

pendula analyze
  Acepta parámetros, o líneas "θ0 unidad ω0 unidad α" en la entrada estándar.
  Escribe "k thetaM tau" para cada una: k es -1 si oscila, 0 en la separatriz,
  1 si rota. Una línea incorrecta se convierte en una línea "ERROR: ..." Con
  --tau T en lugar de --theta0, T un valor o un rango en segundos, thetaM es la
  amplitud que tiene ese periodo.

OPCIONES; los tiempos son segundos, o factores de τ: con rozamiento o fuerzas, el
  periodo del forzamiento o, si no lo hay, 2π/√α
{5}  -h, --help, --version

ESTADO DE SALIDA
  0 hecho   1 datos incorrectos, o resultados que son nan
  2 uso incorrecto   3 no se ha podido escribir la salida
  130 interrumpido; todas las filas están enteras

EJEMPLOS
)"};

constexpr std::string_view examples = R"(  echo "0.0001 0.02 1 90 s 0 r 1" | pendula
  pendula solve --theta0 90deg --gravity 9.81 --length 0.5 --every 0.01 --until 10
  pendula solve --theta0 3 --columns t,theta,error --precision full --format csv
  pendula analyze --theta0 0 --omega0 2
  pendula analyze --tau 7 --alpha 1:2:11
  pendula section --beta 0.5 --drive-amplitude 0.9:1.5:601 --drive-frequency 2/3
  pendula mean-velocity --beta 0.2 --torque 0:1.5:151 --carry both
)";

/// The number of UTF-8 characters.
std::ptrdiff_t width_of(std::string_view text) {
    return std::ranges::count_if(text, [](char c) { return (c & 0xc0) != 0x80; });
}

/// The text and spaces behind it, up to a number of characters.
std::string padded(std::string text, std::ptrdiff_t width) {
    const auto spaces = std::max<std::ptrdiff_t>(1, width - width_of(text));
    return text.append(static_cast<std::size_t>(spaces), ' ');
}

/// The text with line ends before words beyond column 88; further lines are indented.
std::string wrapped(const std::string& text, std::size_t indent) {
    std::string lines;
    std::ptrdiff_t column = 0;
    for (std::size_t begin = 0; begin < text.size();) {
        const auto end = std::min(text.find(' ', begin + 1), text.size());
        const std::string word = text.substr(begin, end - begin);
        if (column + width_of(word) > 88) {
            lines += '\n' + std::string(indent - 1, ' ');
            column = static_cast<std::ptrdiff_t>(indent) - 1;
        }
        lines += word;
        column += width_of(word);
        begin = end;
    }
    return lines + '\n';
}

/// "angular velocity, rad/s" of a meaning and a unit.
std::string with_unit(const Words& meaning, std::string_view unit) {
    return say(meaning) + (unit == "1" ? "" : ", " + std::string(unit));
}

std::string parameter_lines() {
    std::string lines;
    for (const auto& p : parameters) {
        lines += padded("  " + option_of(p.name), 22) + padded(p.symbol, 4) + with_unit(p.meaning, p.unit);
        if (p.is_angle) lines += say({": 1.5 or 90", ": 1.5 o 90"}) + degrees_of(p.unit);
        lines += " [" + shown(p.otherwise) + "]\n";
    }
    return lines;
}

std::string usage_lines() {
    std::string lines;
    const std::string options = say({" [OPTIONS]", " [OPCIONES]"});
    const auto width = 28 + static_cast<std::ptrdiff_t>(options.size());
    for (const auto& info : measures)
        lines += wrapped(padded("  pendula " + hyphenated(info.name) + options, width) + say(info.meaning),
                         static_cast<std::size_t>(width));
    return lines;
}

/// What a line of each measure holds.
std::string measure_lines() {
    std::string lines;
    for (const auto& info : measures) {
        std::string lead = "  " + hyphenated(info.name);
        for (const auto& column : info.columns) {
            if (column.is_detail && !is_detail(column)) continue;
            const std::string name =
                std::string(column.is_detail ? "+ " : "  ") + (column.header ? column.header : column.name);
            lines += wrapped(padded(padded(lead, 17) + name, 36) + with_unit(column.meaning, column.unit), 36);
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

/// "all measures" or the commands of a mask.
std::string title_of(unsigned commands) {
    return commands == measure_commands ? say({"all measures", "todas las medidas"}) : typed_commands(commands, "");
}

/// The options that are no parameters, under the commands that take them.
std::string option_lines() {
    std::string lines;
    const auto options = std::span(known_options()).subspan(swept_count);
    std::vector<unsigned> masks;
    for (const auto& option : options)
        if (std::ranges::find(masks, option.commands) == masks.end()) masks.push_back(option.commands);
    for (const unsigned commands : masks) {
        lines += "  " + title_of(commands) + ":\n";
        for (const auto& option : options) {
            if (option.commands != commands) continue;
            std::string line = padded("    " + option.name + ' ' + option.value, 24) + say(option.meaning);
            if (!option.otherwise.empty()) line += " [" + option.otherwise + ']';
            lines += wrapped(line, 24);
        }
    }
    return lines;
}

}  // namespace

std::string manual() {
    const auto names = [](std::span<const char* const> words) { return joined({words.begin(), words.end()}); };
    return say(page, {usage_lines(), parameter_lines(), names(method_names), table_column_lines(), measure_lines(),
                      option_lines(), method_names[0], names(strobe_method_names), strobe_method_names[0]}) +
           std::string(examples);
}

}  // namespace pendula::cli
