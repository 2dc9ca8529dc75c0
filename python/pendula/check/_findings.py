"""What a judge finds in a table, and how it is said in both languages. Values are in seconds and radians, or as printed."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple, TypeAlias

from pendula._command import say

if TYPE_CHECKING:
    from pendula._command import Text

REMARK, ERROR = "remark", "error"

Value: TypeAlias = float | int | str


class Finding(NamedTuple):
    """Something to tell the student."""

    name: str
    """In FINDINGS."""
    values: dict[str, Value]
    """Numbers and words that stand in the text's places."""
    severity: str = ERROR
    """A remark does not make the table wrong."""


def error(name: str, **values: Value) -> Finding:
    """A mistake."""
    return Finding(name, values)


def remark(name: str, **values: Value) -> Finding:
    """Something that could be better, or that a teacher may want to know."""
    return Finding(name, values, REMARK)


def message(finding: Finding, lang: str) -> str:
    """A finding in words."""
    values = dict(finding.values)
    if "k" in values:
        values["regime"] = say(REGIMES[values["k"]], lang)
    return say(FINDINGS[finding.name], lang, **values)


REGIMES: dict[Value, Text] = {
    -1: ("it is smaller, the pendulum oscillates (k = −1)", "es menor, el péndulo oscila (k = −1)"),
    0: ("it is equal (k = 0)", "es igual (k = 0)"),
    1: ("it is larger, the pendulum turns over (k = 1)", "es mayor, el péndulo se voltea (k = 1)"),
}

WHERE: Text = (
    " First in line {line}, t = {t:.6g}: {column} is {value:.6g} and should be {wanted:.6g}.",
    " Se ve primero en la línea {line}, t = {t:.6g}: {column} es {value:.6g} y debería ser {wanted:.6g}.",
)

STATES: dict[str, Text] = {
    "theta0 in degrees": (
        "The initial angle is given in degrees and was taken as radians.",
        "El ángulo inicial está en grados y se ha tomado como radianes.",
    ),
    "omega0 in degrees": (
        "The initial velocity is given in degrees per second and was taken as radians per second.",
        "La velocidad inicial está en grados por segundo y se ha tomado como radianes por segundo.",
    ),
    "both in degrees": (
        "Initial angle and velocity are given in degrees and were taken as radians.",
        "El ángulo y la velocidad iniciales están en grados y se han tomado como radianes.",
    ),
    "theta0 as degrees": (
        "The initial angle is given in radians and was taken as degrees.",
        "El ángulo inicial está en radianes y se ha tomado como grados.",
    ),
    "omega0 as degrees": (
        "The initial velocity is given in radians per second and was taken as degrees per second.",
        "La velocidad inicial está en radianes por segundo y se ha tomado como grados por segundo.",
    ),
    "both as degrees": (
        "Initial angle and velocity are given in radians and were taken as degrees.",
        "El ángulo y la velocidad iniciales están en radianes y se han tomado como grados.",
    ),
    "euler": (
        "These are the numbers of Euler's method, not of Runge-Kutta's (3.10): energy is not conserved.",
        "Son los números del método de Euler, no del de Runge-Kutta (3.10): la energía no se conserva.",
    ),
    "euler cromer": (
        "These are the numbers of Euler's method with the velocity updated first, not of Runge-Kutta's (3.10).",
        "Son los números del método de Euler actualizando antes la velocidad, no del de Runge-Kutta (3.10).",
    ),
    "straightened": (
        "The acceleration is −αθ, that of small oscillations, instead of −α sin θ (3.1).",
        "La aceleración es −αθ, la de las pequeñas oscilaciones, en vez de −α sen θ (3.1).",
    ),
    "other sign of omega0": ("The initial velocity has the wrong sign.", "La velocidad inicial tiene el signo cambiado."),
    "other sign of theta0": ("The initial angle has the wrong sign.", "El ángulo inicial tiene el signo cambiado."),
    "upside down": (
        "The acceleration has the wrong sign: it is +α sin θ instead of −α sin θ (3.1).",
        "La aceleración tiene el signo cambiado: es +α sen θ en vez de −α sen θ (3.1).",
    ),
    "root of alpha": ("The motion is that of √α in place of α.", "El movimiento es el de √α en lugar de α."),
    "square of alpha": ("The motion is that of α² in place of α.", "El movimiento es el de α² en lugar de α."),
    "alpha of 1": ("The motion is that of α = 1: α is not used.", "El movimiento es el de α = 1: no se usa α."),
    "a step late": (
        "Rows at wrong times: angle and velocity are those of one step Δt after the time printed.",
        "Filas en tiempos equivocados: ángulo y velocidad son los de un paso Δt después del tiempo escrito.",
    ),
    "a step early": (
        "Rows at wrong times: angle and velocity are those of one step Δt before the time printed.",
        "Filas en tiempos equivocados: ángulo y velocidad son los de un paso Δt antes del tiempo escrito.",
    ),
    "a row late": (
        "Rows at wrong times: angle and velocity are those of the next row.",
        "Filas en tiempos equivocados: ángulo y velocidad son los de la fila siguiente.",
    ),
    "a row early": (
        "Rows at wrong times: angle and velocity are those of the row before.",
        "Filas en tiempos equivocados: ángulo y velocidad son los de la fila anterior.",
    ),
    "times in periods": (
        "The times are printed in units of τ; they must be in seconds.",
        "Los tiempos están en unidades de τ; deben estar en segundos.",
    ),
    "times": (
        "Rows at wrong times: angle and velocity are those of t = j·t_cout, but the column of times says otherwise.",
        "Filas en tiempos equivocados: ángulo y velocidad son los de t = j·t_cout, pero la columna del tiempo dice otra cosa.",
    ),
    "single precision": (
        "The numbers are as inaccurate as single precision makes them: use double instead of float.",
        "Los números son tan inexactos como los deja la simple precisión: usa double en vez de float.",
    ),
    "unexplained": (
        "Angle or velocity are wrong, and no known mistake explains them.",
        "El ángulo o la velocidad están mal, y ningún error conocido lo explica.",
    ),
}

TIMES: dict[str, Text] = {
    "one row": ("There is one row only, of {expected}.", "Solo hay una fila, de {expected}."),
    "uneven rows": (
        "Rows at wrong times: they are not evenly spaced (row {row}); there must be one each {every:.6g} s.",
        "Filas en tiempos equivocados: no están a intervalos iguales (fila {row}); debe haber una cada {every:.6g} s.",
    ),
    "late start": (
        "The table starts at t = {first:.6g}; the first row must be that of t = 0.",
        "La tabla empieza en t = {first:.6g}; la primera fila debe ser la de t = 0.",
    ),
    "last row lost": (
        "The last row, at t_simul = {until:.6g}, is missing; adding up Δt may lose it.",
        "Falta la última fila, la de t_simul = {until:.6g}; acumular Δt puede perderla.",
    ),
    "last row won": (
        "There is a row after t_simul = {until:.6g}, at {last:.6g}.",
        "Hay una fila después de t_simul = {until:.6g}, en {last:.6g}.",
    ),
    "early end": (
        "The table ends too early: at t = {last:.6g} of {until:.6g}, with {rows} rows of {expected}.",
        "La tabla termina antes de tiempo: en t = {last:.6g} de {until:.6g}, con {rows} filas de {expected}.",
    ),
    "late end": (
        "The table goes on too long: to t = {last:.6g} instead of {until:.6g}, with {rows} rows instead of {expected}.",
        "La tabla sigue demasiado: hasta t = {last:.6g} en vez de {until:.6g}, con {rows} filas en vez de {expected}.",
    ),
    "period doubled": (
        "The period is doubled: τ = {got:.6g} instead of {tau:.6g}. T0 is π/A where the pendulum turns over, 2π/√α where it "
        "oscillates (3.8).",
        "El periodo está duplicado: τ = {got:.6g} en vez de {tau:.6g}. T0 es π/A si se voltea y 2π/√α si oscila (3.8).",
    ),
    "period halved": (
        "The period is halved: τ = {got:.6g} instead of {tau:.6g}. T0 is π/A where the pendulum turns over, 2π/√α where it "
        "oscillates (3.8).",
        "El periodo es la mitad: τ = {got:.6g} en vez de {tau:.6g}. T0 es π/A si el péndulo se voltea y 2π/√α si oscila (3.8).",
    ),
    "series not begun": (
        "The period is T0, the first term of the series (3.6): τ = {got:.6g} instead of {tau:.6g}.",
        "El periodo es T0, el primer término de la serie (3.6): τ = {got:.6g} en vez de {tau:.6g}.",
    ),
    "series cut": (
        "The series (3.6) is cut too early, or τ is not accurate: τ = {got:.6g} instead of {tau:.6g}, a relative error of "
        "{relative:.2g} where (3.9) allows 1e-7.",
        "La serie (3.6) se corta demasiado pronto, o τ no es exacto: τ = {got:.6g} en vez de {tau:.6g}, un error relativo de "
        "{relative:.2g} cuando (3.9) permite 1e-7.",
    ),
    "regime": (
        "The regime is misjudged: τ = {got:.6g} instead of {tau:.6g}. Compare the energy with 2mgl: {regime}.",
        "El régimen está mal identificado: τ = {got:.6g} en vez de {tau:.6g}. Compara la energía con 2mgl: {regime}.",
    ),
    "seconds": (
        "t_cout is the factor itself in seconds; it must be factor times τ: {every:.6g} s instead of {spacing:.6g}.",
        "t_cout es el factor mismo en segundos; debe ser el factor por τ: {every:.6g} s en vez de {spacing:.6g}.",
    ),
    "every step": (
        "There is a row for every step Δt; there must be one each t_cout = {every:.6g} s.",
        "Hay una fila por cada paso Δt; debe haber una cada t_cout = {every:.6g} s.",
    ),
    "tau": (
        "Rows at wrong times: one each {spacing:.6g} s instead of {every:.6g}, as if τ were {got:.6g} and not {tau:.6g}.",
        "Filas en tiempos equivocados: una cada {spacing:.6g} s en vez de {every:.6g}, como con τ = {got:.6g} y no {tau:.6g}.",
    ),
}

COLUMNS: dict[str, Text] = {
    "no header": ("There is no header; it should be: {words}", "Falta la cabecera; debería ser: {words}"),
    "other header": ("The header is {header!r}; it should be: {words}", "La cabecera es {header!r}; debería ser: {words}"),
    "header order": (
        "The header names the columns in another order than that of the numbers: {header!r}.",
        "La cabecera nombra las columnas en otro orden que el de los números: {header!r}.",
    ),
    "swapped": ("Angle and velocity are swapped.", "El ángulo y la velocidad están intercambiados."),
    "columns": (
        "Time, angle and velocity are not all there: {found} columns, or none with numbers.",
        "No están el tiempo, el ángulo y la velocidad: hay {found} columnas, o ninguna con números.",
    ),
    "ragged": (
        "Line {line} has more or fewer columns than the others ({count} such lines).",
        "La línea {line} tiene más o menos columnas que las demás ({count} líneas así).",
    ),
    "not numbers": (
        "Line {line} has a nan or inf where a number should be ({count} such lines).",
        "La línea {line} tiene un nan o inf donde debería haber un número ({count} líneas así).",
    ),
    "not normalised": (
        "The angle is not normalised: line {line} has {value:.6g}, which in [−π, π) is {wanted:.6g} ({count} such lines).",
        "El ángulo no está normalizado: en la línea {line} es {value:.6g}, que en [−π, π) es {wanted:.6g} ({count} así).",
    ),
    "angle in degrees": (
        "The angle is printed in degrees; it must be in radians.",
        "El ángulo está en grados; debe estar en radianes.",
    ),
    "velocity in degrees": (
        "The velocity is printed in degrees per second; it must be in radians per second.",
        "La velocidad está en grados por segundo; debe estar en radianes por segundo.",
    ),
    "few digits": (
        "There are only {digits} significant digits; six tell more.",
        "Solo hay {digits} cifras significativas; seis dicen más.",
    ),
    "sine missing": (
        "The pendulum oscillates, and the column of the sinusoid (3.4) is missing.",
        "El péndulo oscila, y falta la columna de la función sinusoidal (3.4).",
    ),
    "sine too many": (
        "The regime is misjudged: there is a sinusoid (3.4), and the pendulum does not oscillate.",
        "El régimen está mal identificado: hay función sinusoidal (3.4), y el péndulo no oscila.",
    ),
    "sine not numbers": (
        "The sinusoid (3.4) is no number in line {line}: the phase is asin only where |θ0/θM| comes out below 1 (fase).",
        "La función sinusoidal (3.4) no es un número en la línea {line}: la fase es asin solo si |θ0/θM| sale menor que 1.",
    ),
    "sine other sign": (
        "The phase φ0 of the sinusoid has the wrong sign of its cosine, which must be that of the initial velocity (fase).",
        "La fase φ0 de la función sinusoidal tiene mal el signo del coseno, que debe ser el de la velocidad inicial (fase).",
    ),
    "sine no phase": ("The sinusoid lacks its phase φ0 (3.4).", "A la función sinusoidal le falta la fase φ0 (3.4)."),
    "sine quarter turn": (
        "The phase of the sinusoid is off by π/2: cosine in place of sine (3.4).",
        "La fase de la función sinusoidal está desplazada π/2: coseno en lugar de seno (3.4).",
    ),
    "sine initial amplitude": (
        "The amplitude of the sinusoid is θ0; it must be θM (3.4).",
        "La amplitud de la función sinusoidal es θ0; debe ser θM (3.4).",
    ),
    "sine small period": (
        "The period of the sinusoid is that of small oscillations; it must be the pendulum's own (3.4).",
        "El periodo de la función sinusoidal es el de las pequeñas oscilaciones; debe ser el del péndulo (3.4).",
    ),
    "sine double period": (
        "The period of the sinusoid is doubled (3.4).",
        "El periodo de la función sinusoidal está duplicado (3.4).",
    ),
    "sine is the angle": (
        "The column of the sinusoid repeats the angle (3.4).",
        "La columna de la función sinusoidal repite el ángulo (3.4).",
    ),
    "sine unexplained": (
        "The sinusoid (3.4) is wrong: line {line} has {value:.6g} and should have {wanted:.6g}.",
        "La función sinusoidal (3.4) está mal: en la línea {line} es {value:.6g} y debería ser {wanted:.6g}.",
    ),
    "table missing": ("There is no table for this problem.", "No hay tabla para este problema."),
}

FINDINGS = TIMES | COLUMNS | {name: (en + WHERE[0], es + WHERE[1]) for name, (en, es) in STATES.items()}
