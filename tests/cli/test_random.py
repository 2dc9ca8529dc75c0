"""Random legal problems of every size never crash, hang or give an angle outside [-pi, pi).

PENDULA_RANDOM_PROBLEMS=10000000 pytest tests/cli/test_random.py    tries as many; the seed of each block is its name.
"""

import math
import os
import random

import pytest

COUNT = int(os.environ.get("PENDULA_RANDOM_PROBLEMS", "20000"))
BLOCK = min(COUNT, 5000)


def size(chance, low, high):
    return chance.choice((-1, 1)) * 10 ** chance.uniform(low, high)


def angle(chance):
    """Radians or degrees: of any size, on top, or at a whole number of quarter turns."""
    kind = chance.randrange(4)
    if kind == 0:
        return f"{size(chance, -320, 308)!r} {chance.choice('rs')}"
    if kind == 1:
        return f"{chance.uniform(-math.pi, math.pi)!r} r"
    if kind == 2:
        return f"{math.nextafter(math.pi, chance.choice((0, 9)))!r} r"
    return f"{90 * chance.randrange(-8, 9)} s"


# Steps and times between rows from a hundredth of the characteristic time to far beyond it; at most twenty rows.
FACTORS = [
    f"{dt} {every} {until}"
    for dt in (0.01, 0.3, 7, 1e9)
    for every in (0.1, 0.3, 1, 1e12)
    for until in (0.2, 1, 1e12)
    if until / every <= 20 and every / dt <= 20
]


def problem(chance):
    alpha = abs(size(chance, -300, 300)) if chance.random() < 0.5 else 1.0
    omega = size(chance, -320, 300) if chance.random() < 0.5 else chance.choice((-2, 0, 2)) * math.sqrt(alpha)
    if chance.random() < 0.5:
        omega *= 1 + size(chance, -17, -1)
    return f"{chance.choice(FACTORS)} {angle(chance)} {omega!r} r {alpha!r}\n"


@pytest.mark.parametrize("seed", range(COUNT // BLOCK))
def test_random_problems_stay_on_the_circle(pendula, seed):
    chance = random.Random(seed)
    text = "".join(problem(chance) for _ in range(BLOCK))
    method = chance.choice(("rk4", "euler", "verlet", "exact"))
    done = pendula("--method", method, "--columns", "theta", "--precision", "full", text=text)
    tables = done.stdout.split(b"\n\n\n")
    remarks = done.stderr.splitlines()
    assert done.returncode == 0 and all(line.endswith(b": there is one row") for line in remarks)
    assert len(remarks) == sum(len(rows.split()) == 2 for rows in tables)
    assert len(tables) == BLOCK
    for line, rows in zip(text.splitlines(), tables, strict=True):
        header, *angles = rows.split()
        assert header == b"angulo" and angles
        assert all(-math.pi <= float(theta) < math.pi for theta in angles), (method, line)
