# A right program: no steps at all, but the Fourier series of the elliptic functions.
import sys
from math import acos, asin, atan, cos, cosh, exp, floor, log, pi, sin, sinh, sqrt, tan


def agm(a, b):
    for _ in range(40):
        a, b = (a + b) / 2, sqrt(a * b)
    return a


def K(m):
    """The complete elliptic integral."""
    return pi / 2 / agm(1, sqrt(1 - m))


def amplitude(m):
    """am(u, m) and its derivative."""
    q, v = exp(-pi * K(1 - m) / K(m)), pi / K(m)
    n = [i for i in range(1, 2000) if q**i > 1e-18]
    am = lambda u: v * u / 2 + sum(2 * q**i / (i * (1 + q ** (2 * i))) * sin(i * v * u) for i in n)
    dn = lambda u: v / 2 + sum(2 * v * q**i / (1 + q ** (2 * i)) * cos(i * v * u) for i in n)
    return am, dn


def inverse(am, dn, phi, u):
    """Newton's method, kept within a turn."""
    low, high = u - 2 * abs(u) - 10, u + 2 * abs(u) + 10
    for _ in range(200):
        off = am(u) - phi
        low, high = (low, u) if off > 0 else (u, high)
        u -= off / dn(u)
        if not low <= u <= high:
            u = (low + high) / 2
    return u


def solve(theta0, omega0, alpha):
    """k, limit, tau, and the state as a function of time."""
    m, w, s = omega0**2 / (4 * alpha) + sin(theta0 / 2) ** 2, sqrt(alpha), -1 if omega0 < 0 else 1
    if abs(m - 1) < 1e-9:
        x0 = log(tan(s * theta0 / 4 + pi / 4))
        tau = (log(tan(0.999 * pi / 4 + pi / 4)) - x0) / w
        return 0, s * pi, tau, lambda t: (s * 2 * atan(sinh(x0 + w * t)), s * 2 * w / cosh(x0 + w * t))
    if m > 1:
        am, dn = amplitude(1 / m)
        v = w * sqrt(m)
        u0 = inverse(am, dn, s * theta0 / 2, s * theta0 / 2)
        return 1, pi, 2 * K(1 / m) / v, lambda t: (s * 2 * am(u0 + v * t), s * 2 * v * dn(u0 + v * t))
    am, dn = amplitude(m)
    ratio = max(-1, min(1, sin(theta0 / 2) / sqrt(m)))
    phi = asin(ratio) if omega0 >= 0 else pi - asin(ratio)
    u0 = inverse(am, dn, phi, phi)
    state = lambda u: (2 * asin(sqrt(m) * sin(am(u))), 2 * w * sqrt(m) * cos(am(u)))
    return -1, 2 * asin(sqrt(m)), 4 * K(m) / w, lambda t: state(u0 + w * t)


digits = int(sys.argv[1]) if len(sys.argv) > 1 else 6
words = sys.stdin.read().split()
for first in range(0, len(words), 8):
    fd, fc, fs, theta0, omega0, alpha = (float(words[first + i]) for i in (0, 1, 2, 3, 5, 7))
    theta0 *= pi / 180 if words[first + 4] == "s" else 1
    omega0 *= pi / 180 if words[first + 6] == "s" else 1
    theta0 -= 2 * pi * floor((theta0 + pi) / (2 * pi))
    k, limit, tau, state = solve(theta0, omega0, alpha)
    ratio = max(-1, min(1, theta0 / limit))
    phi = pi - asin(ratio) if omega0 < 0 and abs(ratio) < 1 else asin(ratio)
    print(("\n\n" if first else "") + "t angulo velocidad" + (" funcionSinusoidal" if k < 0 else ""))
    for j in range(floor(fs / fc + 1e-9) + 1):
        t = j * fc * tau
        theta, omega = state(t)
        row = [t, theta - 2 * pi * floor((theta + pi) / (2 * pi)), omega]
        if k < 0:
            row.append(limit * sin(2 * pi * t / tau + phi))
        print(*("%.*g" % (digits, x) for x in row))
