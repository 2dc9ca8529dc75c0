# Error: en la suma de theta falta xD.
import sys
from math import acos, asin, cos, floor, log, pi, sin, sqrt, tan


class Pendulo:
    def __init__(self, theta0, omega0, alpha):
        self.alpha = alpha
        self.theta0 = self.theta = theta0
        self.omega0 = self.omega = omega0
        self.analisis(1e-8)

    def analisis(self, epsilon):
        e = self.omega0**2 / (2 * self.alpha) - cos(self.theta0)
        if abs(e - 1) < 1e-9:
            self.k = 0
            self.theta_max = pi if self.omega0 >= 0 else -pi
            C = 1 / tan(self.theta0 / 4 + pi / 4)
            self.tau = abs(log(C * tan(0.999 * self.theta_max / 4 + pi / 4))) / sqrt(self.alpha)
        elif e < 1:
            self.k = -1
            self.theta_max = acos(cos(self.theta0) - self.omega0**2 / (2 * self.alpha))
            self.tau = self.serie(2 * pi / sqrt(self.alpha), sin(self.theta_max / 2), epsilon)
        else:
            self.k = 1
            self.theta_max = pi
            A = sqrt(self.omega0**2 + 2 * self.alpha * (1 - cos(self.theta0))) / 2
            self.tau = self.serie(pi / A, sqrt(self.alpha) / A, epsilon)

    def serie(self, T0, r, epsilon):
        N = log(epsilon * (1 - r**2)) / (2 * log(r)) if r > 0 else 0
        suma, a, n = 1, 1, 1
        while n <= N + 1:
            a *= ((2 * n - 1) / (2 * n) * r) ** 2
            suma += a
            n += 1
        return T0 * suma

    def aceleracion(self, theta):
        return -self.alpha * sin(theta)

    def runge_kutta(self, dt):
        x, v = self.theta, self.omega
        xA, vA = v * dt, self.aceleracion(x) * dt
        xB, vB = (v + vA / 2) * dt, self.aceleracion(x + xA / 2) * dt
        xC, vC = (v + vB / 2) * dt, self.aceleracion(x + xB / 2) * dt
        xD, vD = (v + vC) * dt, self.aceleracion(x + xC) * dt
        self.theta = x + xA / 6 + xB / 3 + xC / 3
        self.omega = v + vA / 6 + vB / 3 + vC / 3 + vD / 6

    def filas(self, f_delta, f_cout, f_simul):
        """Una fila (t, theta, omega) cada t_cout."""
        dt = f_cout * self.tau / round(f_cout / f_delta)
        t = 0.0
        proxima = 0.0
        while t <= f_simul * self.tau + dt / 2:
            if t >= proxima - dt / 2:
                yield t, normaliza(self.theta), self.omega
                proxima += f_cout * self.tau
            self.runge_kutta(dt)
            t += dt


def normaliza(theta):
    return theta - 2 * pi * floor((theta + pi) / (2 * pi))


def fase(s, r):
    if s >= 1:
        return pi / 2
    if s <= -1:
        return -pi / 2
    return asin(s) if r >= 0 else pi - asin(s)


cifras = int(sys.argv[1]) if len(sys.argv) > 1 else 6
datos = sys.stdin.read().split()
for i in range(0, len(datos), 8):
    f_delta, f_cout, f_simul, theta0, u1, omega0, u2, alpha = datos[i : i + 8]
    grados = {"r": 1, "s": pi / 180}
    p = Pendulo(normaliza(float(theta0) * grados[u1]), float(omega0) * grados[u2], float(alpha))
    phi0 = fase(p.theta0 / p.theta_max, p.omega0)
    if i > 0:
        print("\n")
    print("t angulo velocidad funcionSinusoidal" if p.k == -1 else "t angulo velocidad")
    for t, theta, omega in p.filas(float(f_delta), float(f_cout), float(f_simul)):
        fila = [t, theta, omega]
        if p.k == -1:
            fila.append(p.theta_max * sin(2 * pi / p.tau * t + phi0))
        print(" ".join(f"{x:.{cifras}g}" for x in fila))
