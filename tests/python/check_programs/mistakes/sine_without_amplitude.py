# θM is forgotten in (3.4).
# A translation of a MATLAB script: column vectors, y = [theta omega], printed as save -ascii does.
import sys
from math import acos, asin, cos, floor, log, pi, sin, sqrt, tan


def ellipke(m):
    a, b = 1.0, sqrt(1 - m)
    while abs(a - b) > 1e-15 * a:
        a, b = (a + b) / 2, sqrt(a * b)
    return pi / (2 * a)


def linspace(a, b, n):
    return [a + (b - a) * i / (n - 1) if n > 1 else a for i in range(n)]


def ode4(f, tspan, y0, h):
    """y at every time of tspan, by the classical Runge-Kutta method with steps of about h."""
    Y = [y0]
    y = y0
    for t1, t2 in zip(tspan[:-1], tspan[1:]):
        n = max(1, round((t2 - t1) / h))
        hh = (t2 - t1) / n
        for i in range(n):
            s1 = f(y)
            s2 = f([y[0] + hh * s1[0] / 2, y[1] + hh * s1[1] / 2])
            s3 = f([y[0] + hh * s2[0] / 2, y[1] + hh * s2[1] / 2])
            s4 = f([y[0] + hh * s3[0], y[1] + hh * s3[1]])
            y = [
                y[0] + hh * (s1[0] + 2 * s2[0] + 2 * s3[0] + s4[0]) / 6,
                y[1] + hh * (s1[1] + 2 * s2[1] + 2 * s3[1] + s4[1]) / 6,
            ]
        Y.append(y)
    return Y


def pendulo(factor, theta0, omega0, alpha):
    E = omega0**2 / (2 * alpha) - cos(theta0)
    w = sqrt(alpha)
    if abs(E - 1) < 1e-9:
        k, thetaM = 0, (-pi if omega0 < 0 else pi)
        tau = abs(log(tan(0.999 * thetaM / 4 + pi / 4)) - log(tan(theta0 / 4 + pi / 4))) / w
    elif E < 1:
        k, thetaM = -1, acos(-E)
        tau = 4 / w * ellipke(sin(thetaM / 2) ** 2)
    else:
        k, thetaM = 1, pi
        tau = 2 / w * sqrt(2 / (1 + E)) * ellipke(2 / (1 + E))
    dt, tcout, tsimul = (f * tau for f in factor)
    n = floor(factor[2] / factor[1] + 1e-9)
    t = linspace(0, n * tcout, n + 1)
    y = ode4(lambda y: [y[1], -alpha * sin(y[0])], t, [theta0, omega0], dt)
    theta = [u[0] - 2 * pi * floor((u[0] + pi) / (2 * pi)) for u in y]
    omega = [u[1] for u in y]
    columns = [t, theta, omega]
    if k == -1:
        s = theta0 / thetaM
        phi = pi / 2 if s >= 1 else -pi / 2 if s <= -1 else asin(s)
        if omega0 < 0 and abs(s) < 1:
            phi = pi - phi
        columns.append([sin(2 * pi * x / tau + phi) for x in t])
    return columns


digits = int(sys.argv[1]) if len(sys.argv) > 1 else 6
data = sys.stdin.read().split()
for number in range(len(data) // 8):
    d = data[8 * number : 8 * number + 8]
    theta0 = float(d[3]) * (pi / 180 if d[4] == "s" else 1)
    theta0 -= 2 * pi * floor((theta0 + pi) / (2 * pi))
    omega0 = float(d[5]) * (pi / 180 if d[6] == "s" else 1)
    M = pendulo([float(x) for x in d[:3]], theta0, omega0, float(d[7]))
    print("\n\n" * (number > 0) + "  ".join(["t", "angulo", "velocidad", "funcionSinusoidal"][: len(M)]))
    for row in zip(*M):
        print("".join("%*.*e" % (digits + 9, digits - 1, x) for x in row))
