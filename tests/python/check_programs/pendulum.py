"""An independent solution that the right programs in Python print, each in its own style: problems from standard input."""

import math
import sys


def step(alpha, x, v, h):
    k1, l1 = v, -alpha * math.sin(x)
    k2, l2 = v + h / 2 * l1, -alpha * math.sin(x + h / 2 * k1)
    k3, l3 = v + h / 2 * l2, -alpha * math.sin(x + h / 2 * k2)
    k4, l4 = v + h * l3, -alpha * math.sin(x + h * k3)
    return x + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4), v + h / 6 * (l1 + 2 * l2 + 2 * l3 + l4)


def series(first, r):
    total = term = 1.0
    for n in range(1, math.ceil(math.log(1e-7 * (1 - r * r)) / (2 * math.log(r))) + 1):
        term *= ((2 * n - 1) / (2 * n) * r) ** 2
        total += term
    return first * total


def analysis(alpha, x, v):
    e = v * v / (2 * alpha) - math.cos(x)
    if abs(e - 1) < 1e-13:
        limit = math.copysign(math.pi, v)
        ratio = math.tan(0.999 * limit / 4 + math.pi / 4) / math.tan(x / 4 + math.pi / 4)
        return 0, limit, abs(math.log(ratio)) / math.sqrt(alpha)
    if e < 1:
        limit = math.acos(-e)
        return -1, limit, series(2 * math.pi / math.sqrt(alpha), math.sin(limit / 2))
    a = math.sqrt(v * v + 2 * alpha * (1 - math.cos(x))) / 2
    return 1, math.pi, series(math.pi / a, math.sqrt(alpha) / a)


def wrapped(x):
    return (x + math.pi) % (2 * math.pi) - math.pi


def problems():
    """Yields (k, rows of [t, theta, omega and, if k is -1, the sinusoid])."""
    words = sys.stdin.read().split()
    for i in range(0, len(words), 8):
        f_dt, f_cout, f_simul, x, unit_x, v, unit_v, alpha = (w if w in "rs" else float(w) for w in words[i : i + 8])
        x = math.radians(x) if unit_x == "s" else x
        v = math.radians(v) if unit_v == "s" else v
        k, limit, tau = analysis(alpha, x, v)
        phase = 0.0
        if k == -1:
            phase = math.asin(max(-1, min(1, x / limit)))
            phase = math.pi - phase if v < 0 else phase
        per_row, h = round(f_cout / f_dt), f_dt * tau
        rows = []
        for n in range(round(f_simul / f_dt) + 1):
            if n % per_row == 0:
                sine = [limit * math.sin(2 * math.pi * n * h / tau + phase)] if k == -1 else []
                rows.append([n * h, wrapped(x), v, *sine])
            x, v = step(alpha, x, v, h)
        yield k, rows
