# Error: de grados a radianes con 180/pi, al revés.
import math
import sys
from math import cos, pi, sin, sqrt


def valida_angulo(texto, unidades):
    if unidades not in ("r", "s"):
        sys.exit("Unidades incorrectas: " + unidades)
    angulo = float(texto)
    return angulo * 180 / pi if unidades == "s" else angulo


def normaliza(theta):
    return theta - 2 * pi * math.floor((theta + pi) / (2 * pi))


def fase(s, r):
    if s >= 1:
        return pi / 2
    if s <= -1:
        return -pi / 2
    return math.asin(s) if r >= 0 else pi - math.asin(s)


def cuadratura(r):
    # La media de 1 / raíz(1 - r² sen² x): la regla de los trapecios, con el doble de puntos cada vez
    antes, media, n = 0, 1, 8
    while abs(media - antes) > 1e-12 * media:
        n *= 2
        antes, media = media, sum(1 / sqrt(1 - (r * sin(pi * i / n)) ** 2) for i in range(n)) / n
    return media


def analisis(alfa, theta, omega):
    e = omega**2 / (2 * alfa) - cos(theta)
    if abs(e - 1) < 1e-9:
        signo = 1 if omega >= 0 else -1
        c = 1 / math.tan(theta / 4 + pi / 4)
        return signo * pi, signo * math.log(c * math.tan(signo * 0.999 * pi / 4 + pi / 4)) / sqrt(alfa), 0
    if e < 1:
        theta_m = math.acos(cos(theta) - omega**2 / (2 * alfa))
        return theta_m, 2 * pi / sqrt(alfa) * cuadratura(sin(theta_m / 2)), -1
    a = sqrt(omega**2 + 2 * alfa * (1 - cos(theta))) / 2
    return pi, pi / a * cuadratura(sqrt(alfa) / a), 1


def runge_kutta(alfa, theta, omega, dt):
    kt, kw = [0.0] * 4, [0.0] * 4
    kt[0] = omega
    kw[0] = -alfa * sin(theta)
    kt[1] = omega + kw[0] * dt / 2
    kw[1] = -alfa * sin(theta + kt[0] * dt / 2)
    kt[2] = omega + kw[1] * dt / 2
    kw[2] = -alfa * sin(theta + kt[1] * dt / 2)
    kt[3] = omega + kw[2] * dt
    kw[3] = -alfa * sin(theta + kt[2] * dt)
    theta += dt / 6 * (kt[0] + 2 * kt[1] + 2 * kt[2] + kt[3])
    omega += dt / 6 * (kw[0] + 2 * kw[1] + 2 * kw[2] + kw[3])
    return theta, omega


cifras = int(sys.argv[1]) if len(sys.argv) == 2 else 6
palabras = sys.stdin.read().split()
for i in range(0, len(palabras), 8):
    f_dt, f_cout, f_simul, alfa = (float(palabras[i + j]) for j in (0, 1, 2, 7))
    theta = normaliza(valida_angulo(palabras[i + 3], palabras[i + 4]))
    omega = valida_angulo(palabras[i + 5], palabras[i + 6])
    theta_m, tau, k = analisis(alfa, theta, omega)
    phi = fase(theta / theta_m, omega)
    print("\n\n" if i else "", "t angulo velocidad", " funcionSinusoidal" if k < 0 else "", sep="")
    fila, pasos_por_fila = 0, round(f_cout / f_dt)
    while fila * f_cout <= f_simul * (1 + 1e-9):
        t = fila * f_cout * tau
        numeros = [t, normaliza(theta), omega] + ([theta_m * sin(2 * pi / tau * t + phi)] if k < 0 else [])
        print(" ".join(format(x, f".{cifras}g") for x in numeros))
        for _ in range(pasos_por_fila):
            theta, omega = runge_kutta(alfa, theta, omega, f_dt * tau)
        fila += 1
