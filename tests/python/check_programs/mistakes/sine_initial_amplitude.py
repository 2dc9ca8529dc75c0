# The amplitude is θ0.
import sys
from math import *

# Una hoja de calculo: las columnas son listas que se rellenan hacia abajo.
CIFRAS = int(sys.argv[1]) if len(sys.argv) > 1 else 6


def celda(x):
    return ("%.*g" % (CIFRAS, x)).replace(".", ",")


def radianes(valor, unidad):
    if unidad not in "rs":
        sys.exit("unidades incorrectas")
    return radians(valor) if unidad == "s" else valor


def hoja(fd, fc, fs, theta0, omega0, alpha):
    E = omega0**2 / (2 * alpha) - cos(theta0)
    if abs(E - 1) < 1e-9:
        k = 0
        thetaM = copysign(pi, omega0)
        tau = abs(log(tan(0.999 * thetaM / 4 + pi / 4) / tan(theta0 / 4 + pi / 4))) / sqrt(alpha)
    else:
        if E < 1:
            k = -1
            thetaM = acos(-E)
            T0, r = 2 * pi / sqrt(alpha), sin(thetaM / 2)
        else:
            k = 1
            thetaM = pi
            A = sqrt(omega0**2 + 2 * alpha * (1 - cos(theta0))) / 2
            T0, r = pi / A, sqrt(alpha) / A
        coeficientes = [1.0]
        while coeficientes[-1] > 1e-8 * (1 - r * r):
            n = len(coeficientes)
            coeficientes.append(coeficientes[-1] * ((2 * n - 1) / (2 * n) * r) ** 2)
        tau = T0 * sum(coeficientes)

    n = round(fc / fd)  # pasos por fila
    dt = fc * tau / n
    columna_t, columna_theta, columna_omega = [0.0], [theta0], [omega0]
    x, v = theta0, omega0
    while len(columna_t) <= floor(fs / fc + 1e-9):
        for _ in range(n):
            a1 = -alpha * sin(x)
            a2 = -alpha * sin(x + v * dt / 2)
            a3 = -alpha * sin(x + v * dt / 2 + a1 * dt**2 / 4)
            a4 = -alpha * sin(x + v * dt + a2 * dt**2 / 2)
            x = x + v * dt + (a1 + a2 + a3) * dt**2 / 6
            v = v + (a1 + 2 * a2 + 2 * a3 + a4) * dt / 6
        columna_t.append(len(columna_t) * fc * tau)
        columna_theta.append(x)
        columna_omega.append(v)

    s = theta0 / thetaM
    phi0 = asin(max(-1, min(1, s)))
    if omega0 < 0 and abs(s) < 1:
        phi0 = pi - phi0
    print("t;angulo;velocidad" + (";funcionSinusoidal" if k < 0 else ""))
    for t, theta, omega in zip(columna_t, columna_theta, columna_omega):
        theta -= 2 * pi * floor((theta + pi) / (2 * pi))
        fila = [t, theta, omega]
        if k < 0:
            fila += [theta0 * sin(2 * pi * t / tau + phi0)]
        print(";".join(map(celda, fila)))


datos = sys.stdin.read().split()
while datos:
    fd, fc, fs, theta0, ut, omega0, uw, alpha = datos[:8]
    theta0 = radianes(float(theta0), ut)
    theta0 -= 2 * pi * floor((theta0 + pi) / (2 * pi))
    hoja(float(fd), float(fc), float(fs), theta0, radianes(float(omega0), uw), float(alpha))
    datos = datos[8:]
    if datos:
        print("\n")
