# The time is that of the next row, from the first row on.
"""Dictionaries and generators; the state is a complex number, angle + i velocity."""
import cmath
import itertools
import math
import sys

TURN = 2 * math.pi


def normalised(theta):
    return theta - TURN * ((theta + math.pi) // TURN)


def read(stream):
    names = "fd fc fs theta0 ut omega0 uo alpha".split()
    tokens = iter(stream.read().split())
    for first in tokens:
        values = dict(zip(names, [first, *itertools.islice(tokens, 7)]))
        units = {"r": 1.0, "s": math.pi / 180}
        theta0 = float(values["theta0"]) * units[values["ut"]]
        omega0 = float(values["omega0"]) * units[values["uo"]]
        yield {key: float(values[key]) for key in ("fd", "fc", "fs", "alpha")} | {"theta0": normalised(theta0), "omega0": omega0}


def agm(a, b):
    """The arithmetic-geometric mean; the series (3.6) is 1 / agm(1, sqrt(1 - r*r))."""
    while abs(a - b) > 1e-15 * a:
        a, b = (a + b) / 2, math.sqrt(a * b)
    return a


def analysis(p):
    theta0, omega0, alpha = p["theta0"], p["omega0"], p["alpha"]
    excess = omega0 * omega0 / (2 * alpha) - math.cos(theta0) - 1
    if abs(excess) < 1e-9:
        limit = -math.pi if omega0 < 0 else math.pi
        ratio = math.tan(0.999 * limit / 4 + math.pi / 4) / math.tan(theta0 / 4 + math.pi / 4)
        return {"k": 0, "limit": limit, "tau": abs(math.log(ratio)) / math.sqrt(alpha)}
    if excess < 0:
        limit = math.acos(-1 - excess)
        tau = TURN / math.sqrt(alpha) / agm(1, math.cos(limit / 2))
    else:
        limit = math.pi
        A = math.sqrt(omega0**2 + 2 * alpha * (1 - math.cos(theta0))) / 2
        tau = math.pi / agm(A, math.sqrt(A * A - alpha))
    return {"k": 1 if excess > 0 else -1, "limit": limit, "tau": tau}


def phase(s, r):
    if abs(s) >= 1:
        return math.copysign(math.pi / 2, s)
    return cmath.phase(complex(math.copysign(math.sqrt(1 - s * s), r), s))


def states(z, alpha, h):
    """The state after no, one, two, ... steps."""
    slope = lambda z: complex(z.imag, -alpha * math.sin(z.real))
    while True:
        yield z
        a = slope(z)
        b = slope(z + h / 2 * a)
        c = slope(z + h / 2 * b)
        d = slope(z + h * c)
        z += h / 6 * (a + 2 * b + 2 * c + d)


digits = int(sys.argv[1]) if len(sys.argv) > 1 else 6
for number, p in enumerate(read(sys.stdin)):
    p |= analysis(p)
    phi = phase(p["theta0"] / p["limit"], p["omega0"])
    every = round(p["fc"] / p["fd"])
    rows = math.floor(p["fs"] / p["fc"] + 1e-9) + 1
    dt = p["fc"] * p["tau"] / every
    words = ["t", "angulo", "velocidad"] + ["funcionSinusoidal"] * (p["k"] == -1)
    print("\n\n" if number else "", " ".join(words), sep="")
    path = states(complex(p["theta0"], p["omega0"]), p["alpha"], dt)
    for j, z in enumerate(itertools.islice(path, 0, (rows - 1) * every + 1, every)):
        t = (j + 1) * every * dt
        row = {"t": t, "theta": normalised(z.real), "omega": z.imag}
        if p["k"] == -1:
            row["sine"] = p["limit"] * math.sin(TURN * t / p["tau"] + phi)
        print(*(f"{value:.{digits}g}" for value in row.values()))
