// The manual page, in both languages.
#include "cli/commands.hpp"

namespace pendula::cli {

namespace {

constexpr Text page{
    R"(pendula - the pendulum, exactly and step by step:
          theta'' = -alpha sin(theta) - beta theta' + N + A cos(W t + P)

USAGE
  pendula [OPTIONS] < problems        solve problems from standard input
  pendula solve --theta0 ANGLE ...    solve one problem given by options
  pendula analyze [OPTIONS]           regime, limit angle, characteristic time
  pendula section [OPTIONS]           states once a period of the drive
  pendula velocity [OPTIONS]          mean angular velocity
  pendula lyapunov [OPTIONS]          largest Lyapunov exponent
  pendula NAME ...                    run pendula-NAME, beside pendula or on PATH

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

OPTIONS OF solve
  --theta0 ANGLE        initial angle: 1.5 (radians) or 90deg; has to be given
  --omega0 VELOCITY     initial angular velocity: 0.2 or 10deg/s    [0]
  --alpha A             stiffness g/l, 1/s²                         [1]
  --gravity G --length L    the same as --alpha G/L
  --beta B --torque N   friction, 1/s, and constant torque, 1/s²    [0, 0]
  --drive-amplitude A --drive-frequency W --drive-phase P             [0, 0, 0]
                        adds A cos(W t + P), 1/s²; P: 1.5 or 90deg
                        With any of these, τ is the period of the drive or, where
                        there is none, 2π/√α.
  --dt-factor F         longest step, as a factor of τ              [0.0001]
  --dt S                the same in seconds
  --every-factor F      time between rows, as a factor of τ         [0.02]
  --every S             the same in seconds
  --until-factor F      length of the run, as a factor of τ         [1]
  --until S             the same in seconds

OPTIONS OF solve AND OF PROBLEMS ON STANDARD INPUT
  --method M            rk4, euler, verlet, taylor, or exact: the closed form [rk4]
                        exact has no friction or forcing, verlet no friction;
                        taylor chooses its own steps from
  --tolerance E         the relative error of a step of taylor       [1e-15]
  --columns LIST        of these, with commas between [t,theta,omega and sine]:
                          t       time, s
                          theta   angle in [-π, π), rad
                          omega   angular velocity, rad/s
                          sine    the sinusoid; nan where it does not oscillate
                          exact   angle of the closed form
                          error   theta less exact, in [-π, π)
                          energy  ω²/2 + α(1 - cos θ), 1/s²
                          turns   whole turns: θ + 2π turns counts them all

OPTIONS OF EVERY COMMAND
  --format F            text, csv, or json: an object a line, each problem's own
                        before its rows                              [text]
  --precision N         significant digits from 1 to 17, or full: the shortest
                        that read back to the same double            [6]
  --output FILE         write to FILE; untouched if the first problem is bad
  --lang L              messages in en or es  [from LC_ALL, LC_MESSAGES or LANG]
  -h, --help            this page
  --version             the version

pendula analyze
  Takes --theta0, --omega0 and --alpha as solve does; or lines "θ0 unit ω0 unit α"
  on standard input. Prints "k thetaM tau" for each: k is -1 if it oscillates,
  0 on the separatrix, 1 if it rotates. A bad line becomes a line "ERROR: ..."
  --method agm|series   arithmetic-geometric mean, or the power series of the
                        period, which may need many terms            [agm]
  --epsilon E           relative error of the series                 [1e-7]

pendula section, pendula velocity, pendula lyapunov
  Measure theta'' = -alpha sin(theta) - beta theta' + N + A cos(W t + P).
  Each of these is a value or a range first:last:count:
  --theta0 --omega0 --alpha --gravity --length        as in solve     [0, 0, 1]
  --beta B --torque N                                 1/s, 1/s²       [0, 0]
  --drive-amplitude A --drive-frequency W --drive-phase P             [0, 0, 0]
  Ranges multiply; the last varies fastest, and in text an empty line ends it.
  --transient N         periods of the drive that pass first; without a drive,
                        periods of 2π/√alpha                         [200]
  --periods N           that are measured        [100, of lyapunov 1000]
  --method M            rk4 or taylor                                [rk4]
  --steps N             of each period, by rk4                       [1000]
  --tolerance E         of taylor                                    [1e-15]
  --threads N           [one a processor]; results do not depend on them
  Lines begin with the values of the ranges. Behind them come, of a section,
  theta omega for each period, at W t + P = 2πn; or velocity (rad/s); or
  lyapunov error horizon: the exponent (1/s), its standard error, and the time
  (s) after which a double's rounding has grown to all there is.

EXIT STATUS
  0 done   1 bad data, or a run that is too long   2 bad usage
  3 the output could not be written   130 interrupted; all rows are whole

EXAMPLES
  echo "0.0001 0.02 1 90 s 0 r 1" | pendula
  pendula solve --theta0 90deg --gravity 9.81 --length 0.5 --every 0.01 --until 10
  pendula solve --theta0 3 --columns t,theta,error --precision full --format csv
  pendula analyze --theta0 0 --omega0 2
  pendula section --beta 0.5 --drive-amplitude 0.9:1.5:601 --drive-frequency 0.6667
)",
    R"(pendula - el péndulo, exacto y paso a paso:
          theta'' = -alpha sen(theta) - beta theta' + N + A cos(W t + P)

USO
  pendula [OPCIONES] < problemas       resuelve problemas de la entrada estándar
  pendula solve --theta0 ÁNGULO ...    resuelve un problema dado con opciones
  pendula analyze [OPCIONES]           régimen, ángulo límite, tiempo característico
  pendula section [OPCIONES]           estados, uno por periodo de la fuerza
  pendula velocity [OPCIONES]          velocidad angular media
  pendula lyapunov [OPCIONES]          mayor exponente de Lyapunov
  pendula NOMBRE ...                   ejecuta pendula-NOMBRE, junto a pendula o en PATH

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

OPCIONES DE solve
  --theta0 ÁNGULO       ángulo inicial: 1.5 (radianes) o 90deg; es obligatorio
  --omega0 VELOCIDAD    velocidad angular inicial: 0.2 o 10deg/s    [0]
  --alpha A             rigidez g/l, 1/s²                           [1]
  --gravity G --length L    lo mismo que --alpha G/L
  --beta B --torque N   rozamiento, 1/s, y par constante, 1/s²      [0, 0]
  --drive-amplitude A --drive-frequency W --drive-phase P             [0, 0, 0]
                        suma A cos(W t + P), 1/s²; P: 1.5 o 90deg
                        Con cualquiera de ellos, τ es el periodo del forzamiento
                        o, si no lo hay, 2π/√α.
  --dt-factor F         paso máximo, como factor de τ               [0.0001]
  --dt S                lo mismo en segundos
  --every-factor F      tiempo entre filas, como factor de τ        [0.02]
  --every S             lo mismo en segundos
  --until-factor F      duración, como factor de τ                  [1]
  --until S             lo mismo en segundos

OPCIONES DE solve Y DE LOS PROBLEMAS EN LA ENTRADA ESTÁNDAR
  --method M            rk4, euler, verlet, taylor o exact: la solución exacta [rk4]
                        exact no admite rozamiento ni fuerzas, verlet no admite
                        rozamiento; taylor elige sus pasos según
  --tolerance E         el error relativo de un paso de taylor       [1e-15]
  --columns LISTA       de estas, separadas por comas [t,theta,omega y sine]:
                          t       tiempo, s
                          theta   ángulo en [-π, π), rad
                          omega   velocidad angular, rad/s
                          sine    la sinusoide; nan si no oscila
                          exact   ángulo de la solución exacta
                          error   theta menos exact, en [-π, π)
                          energy  ω²/2 + α(1 - cos θ), 1/s²
                          turns   vueltas enteras: θ + 2π turns las cuenta todas

OPCIONES DE TODAS LAS ÓRDENES
  --format F            text, csv o json: un objeto por línea, el de cada
                        problema antes que sus filas                 [text]
  --precision N         cifras significativas, de 1 a 17, o full: las mínimas
                        que se releen como el mismo double           [6]
  --output FICHERO      escribe en FICHERO; no lo toca si el primer problema es
                        incorrecto
  --lang L              mensajes en en o es  [según LC_ALL, LC_MESSAGES o LANG]
  -h, --help            esta página
  --version             la versión

pendula analyze
  Acepta --theta0, --omega0 y --alpha como solve; o líneas "θ0 unidad ω0 unidad α"
  en la entrada estándar. Escribe "k thetaM tau" para cada una: k es -1 si oscila,
  0 en la separatriz, 1 si rota. Una línea incorrecta se convierte en una línea
  "ERROR: ..."
  --method agm|series   media aritmético-geométrica, o la serie de potencias del
                        periodo, que puede necesitar muchos términos  [agm]
  --epsilon E           error relativo de la serie                   [1e-7]

pendula section, pendula velocity, pendula lyapunov
  Miden theta'' = -alpha sen(theta) - beta theta' + N + A cos(W t + P).
  Cada una de estas es un valor o un rango primero:último:cuántos:
  --theta0 --omega0 --alpha --gravity --length        como en solve   [0, 0, 1]
  --beta B --torque N                                 1/s, 1/s²       [0, 0]
  --drive-amplitude A --drive-frequency W --drive-phase P             [0, 0, 0]
  Los rangos se multiplican; el último es el que más deprisa varía, y en texto
  termina con una línea vacía.
  --transient N         periodos de la fuerza que pasan antes; sin fuerza,
                        periodos de 2π/√alpha                        [200]
  --periods N           los que se miden         [100; de lyapunov, 1000]
  --method M            rk4 o taylor                                 [rk4]
  --steps N             de cada periodo, con rk4                     [1000]
  --tolerance E         de taylor                                    [1e-15]
  --threads N           [uno por procesador]; los resultados no dependen de ellos
  Las líneas empiezan por los valores de los rangos. Tras ellos van, de una
  sección, theta omega de cada periodo, cuando W t + P = 2πn; o velocity
  (rad/s); o lyapunov error horizon: el exponente (1/s), su error típico y el
  tiempo (s) en que el redondeo de un double crece hasta cubrirlo todo.

ESTADO DE SALIDA
  0 hecho   1 datos incorrectos, o una simulación demasiado larga
  2 uso incorrecto   3 no se ha podido escribir la salida
  130 interrumpido; todas las filas están enteras

EJEMPLOS
  echo "0.0001 0.02 1 90 s 0 r 1" | pendula
  pendula solve --theta0 90deg --gravity 9.81 --length 0.5 --every 0.01 --until 10
  pendula solve --theta0 3 --columns t,theta,error --precision full --format csv
  pendula analyze --theta0 0 --omega0 2
  pendula section --beta 0.5 --drive-amplitude 0.9:1.5:601 --drive-frequency 0.6667
)"};

}  // namespace

std::string manual() { return say(page); }

}  // namespace pendula::cli
