"""Prints what pendula.check says of right programs, of those that make a mistake, and of tables in every layout.

python tests/python/check_matrix.py [--problems PROBLEM ...] [--digits 6,10] [--only NAME]

ok  told: exactly the mistakes in the program's name
~   told as well as others that explain the table equally well
.   does not show: to the digits printed, the table is the right one
x   anything else; the status is then 1
"""

from __future__ import annotations

import argparse
import sys
from collections import Counter
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np

sys.path.append(str(Path(__file__).parents[1]))
import check_programs
from check_layouts import LAYOUTS, Row
from check_marking import Told, columns_of, solved, told, told_of_several
from check_tables import Truth, doubts, rows, truth
from pendula import _core
from pendula.check._table import Column

START = "0.0005 0.02 1 0.5 r -0.4 r 2.5"
DEGREES = "0.0002 0.01 2 20 s -100 s 9.81"
QUARTER = "0.0001 0.02 1 90 s 0 r 1"
BOTH_IN_DEGREES = "0.0005 0.02 1 -60 s 30 s 2"
NEAR = "0.0001 0.02 1 0 r 1.99 r 1"
COARSE = "0.01 0.02 1 0.5 r -0.4 r 2.5"
WIDE = "0.0005 0.02 1 1 r 2 r 9.81"
UPRIGHT = "0.0005 0.02 1 180 s 1 r 1"
UPRIGHT_BACKWARDS = "0.0005 0.02 1 -180 s -1 r 1"
TURNED = "0.0005 0.02 1 7 r -0.4 r 2.5"
TURNED_IN_DEGREES = "0.0005 0.02 1 -400 s 30 s 2"
ROTATION = "0.0001 0.02 1 0 r 2.01 r 1"
TURNS = "0.0002 0.02 3 0 r 2.01 r 1"
BACKWARDS = "0.0002 0.02 3 1 r -4 r 1"
SOFT = "0.0005 0.02 1 0 r 1.2 r 0.25"
SEPARATRIX = "0.0001 0.02 1 0 r -2 r 1"
STIFF_SEPARATRIX = "0.0002 0.02 1 0 r 4 r 4"
ROUNDED_SEPARATRIX = "0.0002 0.02 1 0 r 2.8284271247461903 r 2"  # for doubles a little too fast
SLOW_SEPARATRIX = "0.0002 0.02 1 90 s 4.4294469180700204 r 9.81"  # and too slow
LONG_SEPARATRIX = "0.0005 0.05 8 0 r 2 r 1"
UNEVEN = "0.0003 0.02 1 1 r 0.5 r 2"
UNEVEN_TURNS = "0.0007 0.03 2 1 r 3.5 r 2"
SEVERAL = "\n".join((START, ROTATION, DEGREES))
NAMES = {
    problem: name.lower()
    for name, problem in list(globals().items())
    if name.isupper() and isinstance(problem, str) and problem[:2] == "0."
}

DIGITS = (6, 10)
USUAL = (START, DEGREES)

# Mistakes that only a file of several tables can have.
OF_SEVERAL = ("table_missing", "table_spare", "tables_exchanged")

# They are in the text, and show whatever the numbers are.
OF_TEXT = {
    "brackets", "cartesian", "columns", "extra_columns", "extra_text", "few_digits", "header_order", "latex", "mixed_separators",
    "no_header", "no_mark_utf16", "no_time", "not_numbers", "other_header", "swapped",
}  # fmt: skip

# Where mistakes show that do not in both of the usual two.
ELSEWHERE = {
    "alpha_gravity": (START, QUARTER),
    "alpha_product": (START, QUARTER),
    "both_as_degrees": (START, COARSE),
    "both_degrees_inverted": (DEGREES, BOTH_IN_DEGREES),
    "both_in_degrees": (DEGREES, BOTH_IN_DEGREES),
    "early_end": (DEGREES, BACKWARDS),
    "euler_cromer+not_normalised": (TURNS, BACKWARDS),
    "heun": (START, ROTATION),
    "interval_of_run": (DEGREES, BACKWARDS),
    "interval_rounded": (UNEVEN, UNEVEN_TURNS),
    "length_in_force": (START, QUARTER),
    "limit_099": (SEPARATRIX, STIFF_SEPARATRIX),
    "limit_not_0999": (SEPARATRIX, STIFF_SEPARATRIX),
    "logarithm_base_10": (SEPARATRIX, STIFF_SEPARATRIX),
    "midpoint": (START, ROTATION),
    "not_judged": (LONG_SEPARATRIX,),
    "not_normalised": (TURNS, BACKWARDS),
    "omega0_as_degrees": (START, SEPARATRIX),
    "omega0_degrees_inverted": (DEGREES, BOTH_IN_DEGREES),
    "omega0_in_degrees": (DEGREES, BOTH_IN_DEGREES),
    "omega0_integer": (DEGREES, ROTATION),
    "omega_normalised": (WIDE, BACKWARDS),
    "own_index": (START, COARSE),
    "period_a": (ROTATION, BACKWARDS),
    "period_a-half_inside": (ROTATION, BACKWARDS),
    "period_doubled": (ROTATION, BACKWARDS),
    "period_small": (ROTATION, BACKWARDS),
    "period_without_half": (ROTATION, BACKWARDS),
    "regime": (ROTATION, NEAR),
    "regime-equality": (ROUNDED_SEPARATRIX, SLOW_SEPARATRIX),
    "regime-no_alpha": (WIDE, SOFT),
    "rough_pi": (DEGREES, QUARTER),
    "runge_kutta_3": (START, COARSE),
    "sine_not_wrapped": (TURNED, TURNED_IN_DEGREES),
    "sine_too_many": (ROTATION, BACKWARDS),
    "stage_repeated": (START, COARSE),
    "stage_repeated-d": (START, COARSE),
    "step_is_interval": (START, ROTATION),
    "theta0_as_degrees": (START, COARSE),
    "theta0_degrees_inverted": (DEGREES, QUARTER),
    "theta0_in_degrees": (DEGREES, QUARTER),
    "theta0_in_degrees+euler": (DEGREES, QUARTER),
    "theta0_integer": (QUARTER, BOTH_IN_DEGREES),
    "velocity_along": (START, QUARTER),
    "times_nominal": (UNEVEN, UNEVEN_TURNS),
    "verlet": (START, COARSE),
    "weights_equal": (START, COARSE),
    "wraps_closed_above": (UPRIGHT, UPRIGHT_BACKWARDS),
    "wraps_fmod": (TURNS, BACKWARDS),
    "wraps_fmod-shifted": (TURNS, BACKWARDS),
    "wraps_one_side": (TURNS, BACKWARDS),
    "wraps_one_side-above": (TURNS, BACKWARDS),
    "wraps_zero_to_two_pi": (START, TURNS),
}


class Cell(NamedTuple):
    row: str
    column: str
    mark: str
    said: str
    """Where that is not what was wanted."""


# Programs.


def cells_of_program(name: str, problems: Sequence[str] = (), digits: Sequence[int] = DIGITS) -> Iterator[Cell]:
    """What is told of a program's tables of two problems."""
    wanted = () if name in check_programs.names("right") else check_programs.findings(name)
    problems = problems or ((SEVERAL,) if name in OF_SEVERAL else ELSEWHERE.get(name, USUAL))
    for problem in problems:
        for precision in digits:
            data = check_programs.run_program(name, problem, precision)
            yield cell(name, f"{NAMES.get(problem, problem)} {precision}", wanted, problem, data)


def cell(row: str, column: str, wanted: Sequence[str], problem: str, data: bytes) -> Cell:
    """A cell of the matrix: the mistakes `wanted` are to be told, or do not show."""
    try:
        found = told_of_several(problem, data) if problem == SEVERAL else told(problem, data)
        mark = mark_of(set(wanted), found)
        may_hide = problem != SEVERAL and not OF_TEXT & set(wanted)
        if mark == "x" and found.is_right and may_hide and is_the_right_table(truth(problem), data):
            mark = "."
    except Exception as error:  # of the checker; a matrix shows it and goes on
        return Cell(row, column, "x", f"{type(error).__name__}: {error}")
    return Cell(row, column, mark, "" if mark == "ok" else in_words(found))


def mark_of(wanted: set[str], found: Told) -> str:
    if found.errors <= wanted <= found.errors | found.remarks:
        return "ok"
    every = set().union(*found.options)
    if wanted <= every | found.remarks and all(option & wanted for option in found.options):
        return "~"
    return "x"


def in_words(found: Told) -> str:
    errors = ", ".join(sorted(" or ".join(sorted(option)) for option in found.options)) or "right"
    return errors + (f" (remarks: {', '.join(sorted(found.remarks))})" if found.remarks else "")


def is_the_right_table(known: Truth, data: bytes) -> bool:
    """Whether every number is that of the right program, but for a unit of the last digit and what is nobody's fault."""
    allowed = doubts(known)

    def is_same(columns: Sequence[Column]) -> bool:
        if len(columns) != len(known.columns) or columns[0].values.shape != known.columns[0].shape:
            return False
        off = [column.values - right for column, right in zip(columns, known.columns, strict=True)]
        off[1][1:] = _core.wrap(off[1][1:])  # from the first step on, rounding decides which of π and −π an angle is
        is_wrapped = bool(np.all(np.abs(columns[1].values) <= np.pi + columns[1].units))
        return is_wrapped and all(
            bool(np.all(np.abs(difference) <= column.units + doubt))
            for difference, column, doubt in zip(off, columns, allowed, strict=True)
        )

    return any(map(is_same, columns_of(data, known.regime == -1)))


# Layouts.


def euler(problem: str) -> list[Row]:
    solution = solved(problem, "--method", "euler").solution
    return rows(solution.t, solution.theta, solution.omega, *truth(problem).columns[3:])


def angle_in_degrees(problem: str) -> list[Row]:
    return [(t, float(np.degrees(theta)), omega, sine) for t, theta, omega, sine in right(problem)]


def sine_no_phase(problem: str) -> list[Row]:
    known = truth(problem)
    return [(*row[:3], known.theta_max * float(np.sin(2 * np.pi * row[0] / known.tau))) for row in right(problem)]


def early_end(problem: str) -> list[Row]:
    return right(problem)[:30]


def wrong_cell(problem: str) -> list[Row]:
    """0.001 is 100 units of the sixth digit, and of every later one more."""
    table = right(problem)
    t, theta, omega, sine = table[17]
    return [*table[:17], (t, theta + 0.001, omega, sine), *table[18:]]


def right(problem: str) -> list[Row]:
    return rows(*truth(problem).columns)


WRONG = (euler, angle_in_degrees, sine_no_phase, early_end, wrong_cell)


def cells_of_layout(name: str, digits: Sequence[int] = DIGITS) -> Iterator[Cell]:
    """What is told of right and wrong tables in a layout."""
    for problem in (START, ROTATION):
        for precision in digits:
            data = LAYOUTS[name](right(problem), precision)
            yield cell(name, f"right {NAMES[problem]} {precision}", [], problem, data)
    for table in WRONG:
        wanted = [table.__name__]
        yield cell(name, table.__name__, wanted, START, LAYOUTS[name](table(START), digits[0]))


# The picture.

WIDTH = 40  # of names


def main() -> int:
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--problems", nargs="+", default=())
    arguments.add_argument("--digits", type=lambda text: tuple(map(int, text.split(","))), default=DIGITS)
    arguments.add_argument("--only", help="programs and layouts with this in their names", default="")
    given = arguments.parse_args()
    found = []
    for names, cells_of, more in (
        (check_programs.names("right"), cells_of_program, {"problems": given.problems}),
        (check_programs.names(), cells_of_program, {"problems": given.problems}),
        (LAYOUTS, cells_of_layout, {}),
    ):
        for name in names:
            if given.only in name:
                cells = list(cells_of(name, digits=given.digits, **more))
                print_row(name, cells)
                found += cells
        print()
    for each in found:
        if each.mark in "~x":
            print(f"{each.mark} {each.row}, {each.column}: {each.said}")
    counts = Counter(each.mark for each in found)
    print(", ".join(f"{counts[mark]} {mark}" for mark in ("ok", "~", ".", "x")))
    return 1 if counts["x"] else 0


def print_row(name: str, cells: Sequence[Cell]) -> None:
    """One line: the columns' names are told only where they change."""
    said, text = "", ""
    for each in cells:
        *words, last = each.column.split(" ")
        text += f" {last if ' '.join(words) == said and words else '  ' + each.column} {each.mark}"
        said = " ".join(words)
    print(f"{name:{WIDTH}}{text}", flush=True)


if __name__ == "__main__":
    sys.exit(main())
