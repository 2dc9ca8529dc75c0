# Mistake: the initial angle is converted with degrees(), the wrong way round.
import csv
import sys
from dataclasses import dataclass
from math import acos, asin, cos, degrees, floor, log, pi, radians, sin, sqrt, tan

A = [[], [1 / 2], [0, 1 / 2], [0, 0, 1]]
B = [1 / 6, 1 / 3, 1 / 3, 1 / 6]


@dataclass
class State:
    theta: float
    omega: float

    def slope(self, alpha):
        return State(self.omega, -alpha * sin(self.theta))

    def plus(self, h, weights, slopes):
        theta = self.theta + h * sum(w * s.theta for w, s in zip(weights, slopes))
        omega = self.omega + h * sum(w * s.omega for w, s in zip(weights, slopes))
        return State(theta, omega)


def step(state, alpha, h):
    slopes = []
    for row in A:
        slopes.append(state.plus(h, row, slopes).slope(alpha))
    return state.plus(h, B, slopes)


def wrapped(x):
    return x - 2 * pi * floor((x + pi) / (2 * pi))


def mean(values):
    low, high = min(values), max(values)
    return high if high - low < 1e-15 * high else mean((sqrt(low * high), (low + high) / 2))


def series(r):
    """The sum of (3.6), which is slow where r is nearly 1: by Gauss's mean of 1 and sqrt(1 - r*r)."""
    return 1 / mean((1, sqrt((1 + r) * (1 - r))))


def characteristic(start, alpha):
    x, v = start.theta, start.omega
    e = v * v / (2 * alpha) - cos(x)
    if abs(e - 1) < 1e-9:
        limit = pi if v >= 0 else -pi
        return 0, limit, abs(log(tan(0.999 * limit / 4 + pi / 4)) - log(tan(x / 4 + pi / 4))) / sqrt(alpha)
    if e < 1:
        return -1, acos(-e), 2 * pi / sqrt(alpha) * series(sqrt((1 + e) / 2))
    a = sqrt(v * v + 2 * alpha * (1 - cos(x))) / 2
    return 1, pi, pi / a * series(sqrt(alpha) / a)


def tables(words):
    while words:
        (fd, fc, fs, x, u, v, w, alpha), words = words[:8], words[8:]
        x = degrees(float(x)) if u == "s" else float(x)
        v = radians(float(v)) if w == "s" else float(v)
        state, alpha = State(wrapped(x), v), float(alpha)
        k, limit, tau = characteristic(state, alpha)
        s = state.theta / limit
        phase = asin(max(-1.0, min(1.0, s)))
        if state.omega < 0 and abs(s) < 1:
            phase = pi - phase
        h, table = float(fd) * tau, []
        for n in range(round(float(fs) / float(fd)) + 1):
            if n % round(float(fc) / float(fd)) == 0:
                sine = [limit * sin(2 * pi * n * h / tau + phase)] if k == -1 else []
                table.append([n * h, wrapped(state.theta), state.omega, *sine])
            state = step(state, alpha, h)
        yield table


digits = int(sys.argv[1]) if sys.argv[1:] else 6
out = csv.writer(sys.stdout, lineterminator="\n")
for number, table in enumerate(tables(sys.stdin.read().split())):
    if number:
        print("\n")
    out.writerow(["t", "angulo", "velocidad", "funcionSinusoidal"][: len(table[0])])
    out.writerows([f"{x:.{digits}g}" for x in row] for row in table)
