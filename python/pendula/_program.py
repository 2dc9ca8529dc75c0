"""The program `pendula`: it reads problems, so that nothing else need do it, and prints them solved."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sysconfig
from typing import IO, TYPE_CHECKING, Any, NamedTuple

import numpy as np

from pendula._arguments import Parameters
from pendula._solution import Solution

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Sequence

COLUMNS = ("t", "theta", "omega", "turns")


class FailedError(Exception):
    """The program ended with this status; what it had to say stands on standard error."""

    def __init__(self, status: int) -> None:
        super().__init__(f"pendula ended with status {status}")
        self.status = status


class Solved(NamedTuple):
    """A problem as the program read it, and its solution."""

    problem: dict[str, Any]
    solution: Solution


def path() -> str:
    """The program among this Python's scripts, or the user's, or on PATH."""
    scripts = (sysconfig.get_path("scripts"), sysconfig.get_path("scripts", f"{os.name}_user"))
    found = shutil.which("pendula", path=os.pathsep.join((*scripts, os.environ.get("PATH", os.defpath))))
    if found is None:
        raise FileNotFoundError("the program pendula is neither among this Python's scripts nor on PATH")
    return found


def solve(arguments: Sequence[str], problems: IO[Any] | None = None) -> list[Solved]:
    """What the program prints, to the last bit, for these arguments and the problems in a file, else standard input."""
    options = ("--columns", ",".join(COLUMNS), "--format", "json", "--precision", "full")
    command = [path(), *arguments, *options]
    with subprocess.Popen(command, stdin=problems, stdout=subprocess.PIPE, encoding="utf-8") as process:
        solved = list(_solved(map(json.loads, process.stdout or ())))
    if process.returncode != 0:
        raise FailedError(process.returncode)
    return solved


def _solved(lines: Iterable[dict[str, Any]]) -> Iterator[Solved]:
    """Every problem with the rows that follow it."""
    problem: dict[str, Any] | None = None
    rows: list[list[float]] = []
    for line in lines:
        if "problem" in line:
            if problem is not None:
                yield Solved(problem, _solution(problem, rows))
            problem, rows = line, []
        else:
            rows.append([np.nan if line[name] is None else line[name] for name in COLUMNS])
    if problem is not None:
        yield Solved(problem, _solution(problem, rows))


def _solution(problem: dict[str, Any], rows: list[list[float]]) -> Solution:
    t, theta, omega, turns = np.array(rows, float).reshape(-1, len(COLUMNS)).T.copy()
    given = {name: float(problem[name]) for name in Parameters._fields if name in problem}
    tolerance = float(problem.get("tolerance", 1e-15))
    return Solution(t, theta, omega, turns, Parameters(**given), problem["method"], float(problem["dt"]), tolerance)
