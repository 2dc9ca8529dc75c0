# Mistake: the half is forgotten in the acceleration of stage B alone.
import math
import sys


class Pendulum:
    def __init__(self, alpha, theta, omega):
        self.alpha = alpha
        self.theta = (theta + math.pi) % (2 * math.pi) - math.pi
        self.omega = omega
        self.analyse()

    def analyse(self):
        e = self.omega**2 / (2 * self.alpha) - math.cos(self.theta)
        self.phase = 0
        self.limit = math.pi
        if abs(e - 1) < 1e-9:
            self.k = 0
            self.limit = math.copysign(math.pi, self.omega)
            ratio = math.tan(0.999 * self.limit / 4 + math.pi / 4) / math.tan(self.theta / 4 + math.pi / 4)
            self.tau = abs(math.log(ratio)) / math.sqrt(self.alpha)
        elif e < 1:
            self.k = -1
            self.limit = math.acos(math.cos(self.theta) - self.omega**2 / (2 * self.alpha))
            self.tau = 2 * math.pi / math.sqrt(self.alpha) / self.agm(1, math.cos(self.limit / 2))
            self.phase = math.asin(max(-1, min(1, self.theta / self.limit)))
            if self.omega < 0:
                self.phase = math.pi - self.phase
        else:
            self.k = 1
            a = math.sqrt(self.omega**2 + 2 * self.alpha * (1 - math.cos(self.theta))) / 2
            self.tau = math.pi / self.agm(a, math.sqrt(a**2 - self.alpha))

    def agm(self, a, b, epsilon=1e-15):
        while abs(a - b) > epsilon * a:
            a, b = (a + b) / 2, math.sqrt(a * b)
        return a

    def acceleration(self, theta):
        return -self.alpha * math.sin(theta)

    def step(self, dt):
        th, w = self.theta, self.omega
        th_a = w * dt
        w_a = self.acceleration(th) * dt
        th_b = (w + w_a / 2) * dt
        w_b = self.acceleration(th + th_a) * dt
        th_c = (w + w_b / 2) * dt
        w_c = self.acceleration(th + th_b / 2) * dt
        th_d = (w + w_c) * dt
        w_d = self.acceleration(th + th_c) * dt
        self.theta = th + th_a / 6 + th_b / 3 + th_c / 3 + th_d / 6
        self.omega = w + w_a / 6 + w_b / 3 + w_c / 3 + w_d / 6

    def rows(self, f_dt, f_cout, f_simul):
        every = round(f_cout / f_dt)
        for n in range(round(f_simul / f_dt) + 1):
            if n % every == 0:
                t = n * f_dt * self.tau
                row = [t, (self.theta + math.pi) % (2 * math.pi) - math.pi, self.omega]
                if self.k == -1:
                    row.append(self.limit * math.sin(2 * math.pi / self.tau * t + self.phase))
                yield row
            self.step(f_dt * self.tau)


digits = int(sys.argv[1]) if len(sys.argv) > 1 else 6
first = True
for line in sys.stdin:
    if not line.strip():
        continue
    f_dt, f_cout, f_simul, theta0, unit1, omega0, unit2, alpha = line.split()
    theta0 = math.radians(float(theta0)) if unit1 == "s" else float(theta0)
    omega0 = math.radians(float(omega0)) if unit2 == "s" else float(omega0)
    pendulum = Pendulum(float(alpha), theta0, omega0)
    if not first:
        print("\n")
    first = False
    print("t angulo velocidad" + (" funcionSinusoidal" if pendulum.k == -1 else ""))
    for row in pendulum.rows(float(f_dt), float(f_cout), float(f_simul)):
        print(*(f"{x:.{digits}g}" for x in row))
