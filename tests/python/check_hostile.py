"""Inputs that mean ill to pendula check: problems and tables that are too large, too many, or no numbers."""

from __future__ import annotations

import random
from collections.abc import Callable
from typing import NamedTuple

PROBLEM = "0.001 0.02 1 90 s 0 r 1"
HEADER = "t angulo velocidad funcionSinusoidal\n"
SOME_ROWS = "".join(f"{0.148326 * place:.6g} 1.5 -0.2 1.4\n" for place in range(51))

MILLION = 10**6


class Hostile(NamedTuple):
    table: Callable[[], bytes]
    problems: str = PROBLEM


def repeated(text: str, times: int) -> Callable[[], bytes]:
    return lambda: text.encode() * times


def rows(values: str, count: int = 51) -> Callable[[], bytes]:
    """Of the same values at times one after another."""
    return lambda: (HEADER + "".join(f"{place} {values}\n" for place in range(count))).encode()


usual = repeated(HEADER + SOME_ROWS, 1)

HOSTILE = {
    "empty": Hostile(repeated("", 0)),
    "noise": Hostile(lambda: random.Random(1).randbytes(MILLION)),
    "only a header": Hostile(repeated(HEADER, 1)),
    "headers": Hostile(repeated(HEADER, 100_000)),
    "ones": Hostile(repeated("1 1 1 1\n", 51)),
    "no numbers": Hostile(rows("nan nan nan")),
    "huge numbers": Hostile(repeated("1e308 -1e308 1e308 -1e308\n-1e308 1e308 -1e308 1e308\n", 100)),
    "huge times": Hostile(lambda: (HEADER + "".join(f"{place}e306 1 0 1\n" for place in range(100))).encode()),
    "tiny times": Hostile(lambda: (HEADER + "".join(f"{place}e-320 1 0 1\n" for place in range(100))).encode()),
    "a line of numbers": Hostile(repeated("0.5 ", 10 * MILLION // 4)),
    "a line of commas": Hostile(repeated("1,", 10 * MILLION // 2)),
    "a line of brackets": Hostile(repeated("[", 10 * MILLION)),
    "a line of quotation marks": Hostile(repeated('"', 10 * MILLION)),
    "a long number": Hostile(lambda: b"0 1 1 1\n1 " + b"9" * (10 * MILLION) + b" 1 1\n"),
    "empty lines": Hostile(repeated("\n", 10 * MILLION)),
    "a million rows": Hostile(rows("1 0 1", MILLION)),
    "many tables": Hostile(repeated(HEADER + "0 1 2 3\n1 1 2 3\n", 50_000)),
    "many widths": Hostile(lambda: "".join("1 " * (place % 300) + "\n" for place in range(5000)).encode()),
    "wide rows": Hostile(repeated("1 " * 5000 + "\n", 300)),
    "stiff": Hostile(usual, "0.001 0.02 1 1 r 0 r 1e308"),
    "soft": Hostile(usual, "0.001 0.02 1 1 r 0 r 1e-308"),
    "10^15 steps": Hostile(usual, "1e-15 0.02 1 90 s 0 r 1"),
    "10^15 steps between rows": Hostile(usual, "0.001 1e12 5e13 90 s 0 r 1"),
    "10^9 rows": Hostile(usual, "0.001 1e-9 1 90 s 0 r 1"),
    "a thousand problems": Hostile(usual, "\n".join(f"0.001 0.02 1 {place}e-3 r 0 r 1" for place in range(1, 1001))),
}
