"""What `pendula check` says of times, of the sinusoid and of how a table is printed, in both languages."""

TIMES = {
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

COLUMNS = {
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
}
