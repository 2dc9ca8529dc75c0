"""What `pendula check` says of angles and velocities, in both languages."""

WHERE = (
    " First in line {line}, t = {t:.6g}: {column} is {value:.6g} and should be {wanted:.6g}.",
    " Se ve primero en la línea {line}, t = {t:.6g}: {column} es {value:.6g} y debería ser {wanted:.6g}.",
)

STATES = {
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
