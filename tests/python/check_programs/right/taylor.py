# A right program: Taylor's series to order 8 in each step, from the series of sine and cosine.
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
        medias = [(1.0, sqrt(1 - r * r))]
        while len(medias) < 30:
            medias.append((sum(medias[-1]) / 2, sqrt(medias[-1][0] * medias[-1][1])))
        tau = T0 / medias[-1][0]

    n = round(fc / fd)  # pasos por fila
    dt = fc * tau / n
    columna_t, columna_theta, columna_omega = [0.0], [theta0], [omega0]
    x, v = theta0, omega0
    while len(columna_t) <= floor(fs / fc + 1e-9):
        for _ in range(n):
            X, V, S, C = [x], [v], [sin(x)], [cos(x)]
            for i in range(8):
                X.append(V[i] / (i + 1))
                V.append(-alpha * S[i] / (i + 1))
                S.append(sum(C[j] * V[i - j] for j in range(i + 1)) / (i + 1))
                C.append(-sum(S[j] * V[i - j] for j in range(i + 1)) / (i + 1))
            x = sum(c * dt**i for i, c in enumerate(X))
            v = sum(c * dt**i for i, c in enumerate(V))
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
            fila += [thetaM * sin(2 * pi * t / tau + phi0)]
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
