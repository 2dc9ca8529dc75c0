# The angle is printed in [0, 2π).
import math
import sys

deg = math.pi / 180
wrap = lambda x: (x + math.pi) % (2 * math.pi) - math.pi
sign = lambda x: -1 if x < 0 else 1


def integral(f, a, b, n):
    """Midpoint rule, which converges very fast for a periodic function."""
    h = (b - a) / n
    return h * sum(f(a + (i + 0.5) * h) for i in range(n))


def analysis(theta0, omega0, alpha):
    m = omega0**2 / (4 * alpha) + math.sin(theta0 / 2) ** 2  # energy over 2mgl
    if abs(m - 1) < 1e-9:
        limit = sign(omega0) * math.pi
        F = lambda x: math.log(math.tan(x / 4 + math.pi / 4)) / math.sqrt(alpha)
        return 0, limit, abs(F(0.999 * limit) - F(theta0))
    if m < 1:
        quarter = integral(lambda u: 1 / math.sqrt(1 - m * math.sin(u) ** 2), 0, math.pi / 2, 100000)
        return -1, 2 * math.asin(math.sqrt(m)), 4 * quarter / math.sqrt(alpha)
    half = integral(lambda u: 1 / math.sqrt(m - math.sin(u) ** 2), 0, math.pi / 2, 100000)
    return 1, math.pi, 2 * half / math.sqrt(alpha)


def phase(s, r):
    if abs(s) >= 1:
        return sign(s) * math.pi / 2
    return math.asin(s) if r >= 0 else math.pi - math.asin(s)


def step(f, y, h):
    add = lambda c, k: [a + c * b for a, b in zip(y, k)]
    k1 = f(y)
    k2 = f(add(h / 2, k1))
    k3 = f(add(h / 2, k2))
    k4 = f(add(h, k3))
    return [a + h / 6 * (p + 2 * q + 2 * r + s) for a, p, q, r, s in zip(y, k1, k2, k3, k4)]


def table(dt, every, until, theta0, omega0, alpha):
    k, limit, tau = analysis(theta0, omega0, alpha)
    pendulum = lambda y: [y[1], -alpha * math.sin(y[0])]
    phi = phase(theta0 / limit, omega0)
    y, rows = [theta0, omega0], []
    n = round(every / dt)
    for j in range(int(until / every + 1e-9) + 1):
        t = j * every * tau
        rows.append([t, y[0] % (2 * math.pi), y[1]] + ([limit * math.sin(2 * math.pi * t / tau + phi)] if k < 0 else []))
        for _ in range(n):
            y = step(pendulum, y, every * tau / n)
    return ["t", "angulo", "velocidad", "funcionSinusoidal"][: len(rows[0])], rows


digits = sys.argv[1] if len(sys.argv) > 1 else "6"
tokens = sys.stdin.read().split()
problems = [tokens[i : i + 8] for i in range(0, len(tokens), 8)]
texts = []
for dt, every, until, theta0, u, omega0, v, alpha in problems:
    theta0 = wrap(float(theta0) * (deg if u == "s" else 1))
    omega0 = float(omega0) * (deg if v == "s" else 1)
    header, rows = table(float(dt), float(every), float(until), theta0, omega0, float(alpha))
    lines = [" ".join(header)] + [" ".join(format(x, "." + digits + "g") for x in row) for row in rows]
    texts.append("\n".join(lines) + "\n")
print("\n\n".join(texts), end="")
