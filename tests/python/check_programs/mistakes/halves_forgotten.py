# Mistake: the second and the third stage take a whole step.
import sys
from itertools import islice
from math import acos, asin, atan2, cos, log, pi, sin, sqrt, tan

wrap = lambda x: atan2(sin(x), cos(x))
radians = lambda x, unit: float(x) * {"r": 1, "s": pi / 180}[unit]
axpy = lambda c, x, y: [c * a + b for a, b in zip(x, y)]


def rk4(f, y, h):
    k1 = f(y)
    k2 = f(axpy(h, k1, y))
    k3 = f(axpy(h, k2, y))
    k4 = f(axpy(h, k3, y))
    return [x + h / 6 * (a + 2 * b + 2 * c + d) for x, a, b, c, d in zip(y, k1, k2, k3, k4)]


def orbit(f, y, h):
    while True:
        yield y
        y = rk4(f, y, h)


def agm(a, b):
    return a if abs(a - b) < 1e-15 * a else agm((a + b) / 2, sqrt(a * b))


def analysis(alpha, theta, omega):
    """Regime, limit, tau."""
    level = omega * omega / (2 * alpha) - cos(theta)
    if abs(level - 1) < 1e-9:
        sign = -1 if omega < 0 else 1
        time = lambda x: log(tan(x / 4 + pi / 4))
        return 0, sign * pi, sign * (time(sign * 0.999 * pi) - time(theta)) / sqrt(alpha)
    if level < 1:
        return -1, acos(-level), 2 * pi / sqrt(alpha) / agm(1, cos(acos(-level) / 2))
    a = sqrt(omega * omega + 2 * alpha * (1 - cos(theta))) / 2
    return 1, pi, pi / agm(a, sqrt(a * a - alpha))


def phase(s, r):
    return pi / 2 if s >= 1 else -pi / 2 if s <= -1 else asin(s) if r >= 0 else pi - asin(s)


def main(digits=6):
    number = lambda x: f"{x:.{digits}g}".replace(".", ",")
    for count, line in enumerate(filter(str.split, sys.stdin)):
        fd, fc, fs, theta, unit, omega, unit2, alpha = line.split()
        fd, fc, fs, alpha = map(float, (fd, fc, fs, alpha))
        theta, omega = wrap(radians(theta, unit)), radians(omega, unit2)
        k, limit, tau = analysis(alpha, theta, omega)
        f = lambda y: [y[1], -alpha * sin(y[0])]
        phi = phase(theta / limit, omega)
        print("\n\n" * (count > 0) + "t;angulo;velocidad" + ";funcionSinusoidal" * (k == -1))
        every, rows = round(fc / fd), int(fs / fc + 1e-6) + 1
        states = islice(orbit(f, [theta, omega], fd * tau), 0, None, every)
        for j, (x, v) in zip(range(rows), states):
            t = j * fc * tau
            print(";".join(map(number, [t, wrap(x), v] + [limit * sin(2 * pi * t / tau + phi)] * (k == -1))))


main(*map(int, sys.argv[1:]))
