# Mistake: the last formula of omega: the sine of the estimate C alone.
"""A spreadsheet: one list a column, filled down, saved with semicolons and decimal commas."""
import math
import sys

RAD = math.pi / 180


def fill_down(alpha, theta, omega, dt, steps):
    """Columns of every step."""
    column_theta, column_omega = [theta], [omega]
    for _ in range(steps):
        th, om = column_theta[-1], column_omega[-1]
        b, c, d, e = om, -alpha * math.sin(th), om - dt / 2 * alpha * math.sin(th), -alpha * math.sin(th + dt / 2 * om)
        f, g = om + dt / 2 * e, -alpha * math.sin(th + dt / 2 * d)
        h, i = om + dt * g, -alpha * math.sin(dt * f)
        column_theta.append(th + dt * (b / 6 + d / 3 + f / 3 + h / 6))
        column_omega.append(om + dt * (c / 6 + e / 3 + g / 3 + i / 6))
    return column_theta, column_omega


def period(first, r):
    """Two columns filled down: the arithmetic and the geometric mean."""
    arithmetic, geometric = [1.0], [math.sqrt(1 - r * r)]
    for _ in range(12):
        a, g = arithmetic[-1], geometric[-1]
        arithmetic.append((a + g) / 2)
        geometric.append(math.sqrt(a * g))
    return first / arithmetic[-1]


def sheet(f_dt, f_cout, f_simul, theta, omega, alpha):
    level = omega**2 / (2 * alpha) - math.cos(theta)
    if abs(level - 1) < 1e-9:
        limit = math.pi if omega >= 0 else -math.pi
        tau = abs(math.log(math.tan((0.999 * limit + math.pi) / 4) / math.tan((theta + math.pi) / 4)) / alpha**0.5)
    elif level < 1:
        limit = math.acos(-level)
        tau = period(2 * math.pi / alpha**0.5, math.sin(limit / 2))
    else:
        limit, a = math.pi, (omega**2 + 2 * alpha * (1 - math.cos(theta))) ** 0.5 / 2
        tau = period(math.pi / a, alpha**0.5 / a)
    dt, steps, every = f_dt * tau, round(f_simul / f_dt), round(f_cout / f_dt)
    column_theta, column_omega = fill_down(alpha, theta, omega, dt, steps)
    times = [n * dt for n in range(0, steps + 1, every)]
    angles = [math.atan2(math.sin(x), math.cos(x)) for x in column_theta[::every]]
    columns = {"t": times, "angulo": angles, "velocidad": column_omega[::every]}
    if level < 1 - 1e-9:
        phase = math.asin(min(1, max(-1, theta / limit)))
        phase = math.pi - phase if omega < 0 else phase
        columns["funcionSinusoidal"] = [limit * math.sin(2 * math.pi / tau * t + phase) for t in times]
    return columns


def main():
    digits = int(sys.argv[1]) if len(sys.argv) > 1 else 6
    texts = []
    for line in sys.stdin.read().splitlines():
        if not line.split():
            continue
        *factors, theta, unit, omega, other, alpha = line.split()
        theta = float(theta) * (RAD if unit == "s" else 1)
        omega = float(omega) * (RAD if other == "s" else 1)
        theta = math.atan2(math.sin(theta), math.cos(theta))
        columns = sheet(*map(float, factors), theta, omega, float(alpha))
        rows = [";".join(columns)]
        for row in zip(*columns.values()):
            rows.append(";".join(f"{x:.{digits}g}".replace(".", ",") for x in row))
        texts.append("\n".join(rows) + "\n")
    print("\n\n".join(texts), end="")


main()
