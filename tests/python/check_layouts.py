"""How programs print a table: each layout takes rows and significant digits, and returns the file.

Written from what compilers, spreadsheets and students' programs print, not from what pendula.check reads.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from typing import TypeAlias

import numpy as np

Row: TypeAlias = tuple[float, float, float, float | None]
"""t, theta, omega and, where the pendulum oscillates, the sinusoid."""
Layout: TypeAlias = Callable[[Sequence[Row], int], bytes]

LAYOUTS: dict[str, Layout] = {}
WORDS = ("t", "angulo", "velocidad", "funcionSinusoidal")


def layout(write: Layout) -> Layout:
    LAYOUTS[write.__name__] = write
    return write


def cells(row: Row) -> list[float]:
    return [value for value in row if value is not None]


def words(rows: Sequence[Row], names: Sequence[str] = WORDS) -> list[str]:
    return list(names[: len(cells(rows[0]))])


def short(digits: int) -> Callable[[float], str]:
    """As C++ with setprecision: zeros at the end are left out."""
    return lambda value: f"{value:.{digits}g}"


def comma(digits: int) -> Callable[[float], str]:
    return lambda value: f"{value:.{digits}g}".replace(".", ",")


def text(lines: Iterable[str], end: str = "\n") -> str:
    return "".join(line + end for line in lines)


def joined(between: str, rows: Iterable[Iterable[float]], number: Callable[[float], str]) -> list[str]:
    return [between.join(map(number, row)) for row in rows]


def plain(rows: Sequence[Row], digits: int, header: Sequence[str] | None = WORDS, between: str = " ") -> list[str]:
    first = [between.join(words(rows, header))] if header else []
    return first + joined(between, map(cells, rows), short(digits))


# The assignment's own, and its nearest relatives.


@layout
def assignment(rows, digits):
    return text(plain(rows, digits)).encode()


@layout
def headless(rows, digits):
    return text(plain(rows, digits, None)).encode()


@layout
def carriage_returns(rows, digits):
    return text(plain(rows, digits), "\r\n").encode()


@layout
def blank_lines_between(rows, digits):
    return text(plain(rows, digits), "\n\n").encode()


@layout
def comment_header(rows, digits):
    return ("# " + text(plain(rows, digits))).encode()


@layout
def tabs(rows, digits):
    return text(plain(rows, digits, between="\t")).encode()


@layout
def padded(rows, digits):
    """setw."""
    width = digits + 8
    lines = ["".join(f"{word:>{width}}" for word in words(rows, ("t", "theta", "omega", "theta_seno")))]
    lines += ["".join(f"{value:{width}.{digits}g}" for value in cells(row)) for row in rows]
    return text(lines).encode()


@layout
def scientific(rows, digits):
    lines = [" ".join(words(rows))]
    lines += joined(" ", map(cells, rows), lambda value: f"{value:.{digits - 1}e}")
    return text(lines).encode()


@layout
def fixed_decimals(rows, digits):
    lines = ["   ".join(words(rows))]
    lines += joined("   ", map(cells, rows), lambda value: f"{value:.{digits}f}")
    return text(lines).encode()


@layout
def spaces_in_names(rows, digits):
    names = words(rows, ("Tiempo (s)", "Ángulo (rad)", "Velocidad angular (rad/s)", "Función sinusoidal (rad)"))
    lines = ["".join(f"{name:<28}" for name in names)]
    lines += ["".join(f"{value:<28.{digits}g}" for value in cells(row)) for row in rows]
    return text(lines).encode()


# Spreadsheets.


@layout
def csv(rows, digits):
    return text(plain(rows, digits, between=",")).encode()


@layout
def csv_with_a_mark(rows, digits):
    return text(plain(rows, digits, ("tiempo", "ángulo", "velocidad", "seno"), ","), "\r\n").encode("utf-8-sig")


@layout
def semicolons_decimal_commas(rows, digits):
    lines = [";".join(words(rows)), *joined(";", map(cells, rows), comma(digits))]
    return text(lines).encode()


@layout
def spaces_decimal_commas(rows, digits):
    lines = [" ".join(words(rows)), *joined(" ", map(cells, rows), comma(digits))]
    return text(lines).encode()


@layout
def quoted_csv_decimal_commas(rows, digits):
    """Only what has a comma needs quotation marks."""

    def quoted(value):
        number = comma(digits)(value)
        return f'"{number}"' if "," in number else number

    lines = [",".join(words(rows)), *joined(",", map(cells, rows), quoted)]
    return text(lines, "\r\n").encode()


@layout
def all_quoted_csv(rows, digits):
    lines = [",".join(f'"{word}"' for word in words(rows))]
    lines += joined(",", map(cells, rows), lambda value: f'"{comma(digits)(value)}"')
    return text(lines).encode()


@layout
def latin_1(rows, digits):
    names = ("Tiempo", "Ángulo", "Velocidad angular", "Función sinusoidal")
    lines = [";".join(words(rows, names)), *joined(";", map(cells, rows), comma(digits))]
    return text(lines, "\r\n").encode("latin-1")


@layout
def utf_16(rows, digits):
    """What `>` writes in older Windows shells."""
    return text(plain(rows, digits), "\r\n").encode("utf-16")


@layout
def utf_16_without_a_mark(rows, digits):
    return text(plain(rows, digits, between="\t"), "\r\n").encode("utf-16-le")


@layout
def utf_16_without_a_mark_other_order(rows, digits):
    return text(plain(rows, digits)).encode("utf-16-be")


# Documents.


@layout
def latex(rows, digits):
    names = words(rows, (r"$t$", r"$\theta$", r"$\dot{\theta}$", r"$\theta_{\mathrm{seno}}$"))
    lines = [rf"\begin{{tabular}}{{{'c' * len(names)}}}", r"\hline", " & ".join(names) + r" \\ \hline"]
    lines += [line + r" \\" for line in joined(" & ", map(cells, rows), short(digits))]
    return text([*lines, r"\hline", r"\end{tabular}"]).encode()


@layout
def latex_rows(rows, digits):
    lines = [" & ".join(words(rows)) + r" \\"]
    lines += [line + r" \\ \hline" for line in joined(" & ", map(cells, rows), short(digits))]
    return text(lines).encode()


@layout
def markdown(rows, digits):
    names = words(rows, ("t", "θ", "ω", "θ seno"))
    lines = [f"| {' | '.join(names)} |", "|" + "---|" * len(names)]
    lines += [f"| {line} |" for line in joined(" | ", map(cells, rows), short(digits))]
    return text(lines).encode()


# Other languages.


@layout
def fortran(rows, digits):  # noqa: ARG001
    """`print *` of gfortran, with all digits that a double has: fields of 24 characters and a space between."""
    lines = [" " + " ".join(words(rows))]
    lines += [" " + " ".join(map(_gfortran, cells(row))).rstrip() for row in rows]
    return text(lines).encode()


def _gfortran(value: float) -> str:
    """17 digits, with an exponent only below 0.1 and from 1e17; that takes the four places behind a number without one."""
    if value == 0:
        return "  0.0000000000000000     "
    if not 0.1 <= abs(value) < 1e17:
        mantissa, exponent = f"{value:.16E}".split("E")
        return f"{mantissa:>19}E{exponent[0]}{int(exponent[1:]):03}"
    decimals = 17 - len(str(int(abs(value))).lstrip("0"))
    return f"{value:{20}.{decimals}f}     "


@layout
def fortran_folded(rows, digits):  # noqa: ARG001
    """`print *` of Intel's compiler: 15 digits and no more than 80 characters a line; a row of four takes two."""
    lines = [" " + " ".join(words(rows))]
    for row in rows:
        fields = list(map(_ifort, cells(row)))
        lines += [" " + "".join(fields[:3]), *([" " + "".join(fields[3:])] if fields[3:] else [])]
    return text(lines).encode()


def _ifort(value: float) -> str:
    if value == 0 or not 0.1 <= abs(value) < 1e7:
        mantissa, exponent = f"{value:.15E}".split("E")
        return f"{mantissa:>18}E{exponent[0]}{int(exponent[1:]):03} "
    decimals = 15 - len(str(int(abs(value))).lstrip("0"))
    return f"{value:{18}.{decimals}f}      "


@layout
def numpy_array(rows, digits):
    """`print(table)`."""
    with np.printoptions(precision=digits, threshold=len(rows) * 4 + 1):
        return text([str(np.array([cells(row) for row in rows]))]).encode()


@layout
def numpy_rows(rows, digits):
    """`print(row)` for each row of an array, by default in lines of 75 characters."""
    with np.printoptions(precision=digits):
        return text(str(np.array(cells(row))) for row in rows).encode()


@layout
def python_lists(rows, digits):
    """`print([t, theta, omega])`."""
    return text(str([float(short(digits)(value)) for value in cells(row)]) for row in rows).encode()


@layout
def python_tuples(rows, digits):
    lines = [" ".join(words(rows))]
    return text(lines + [str(tuple(float(short(digits)(value)) for value in cells(row))) for row in rows]).encode()


@layout
def labelled(rows, digits):
    names = words(rows, ("t=", "theta=", "omega=", "seno="))
    number = short(digits)
    return text(" ".join(name + number(value) for name, value in zip(names, cells(row), strict=True)) for row in rows).encode()


@layout
def labelled_with_units(rows, digits):
    names, number = words(rows, ("t = {} s", "theta = {} rad", "omega = {} rad/s", "seno = {} rad")), short(digits)
    lines = [", ".join(name.format(number(value)) for name, value in zip(names, cells(row), strict=True)) for row in rows]
    return text(lines).encode()


# More than was asked for, and in another order.


@layout
def english_in_another_order(rows, digits):
    names = ["time", "angular velocity", "angle", *(["sine"] if rows[0][3] is not None else [])]
    turned = [[t, omega, theta, *rest] for t, theta, omega, *rest in map(cells, rows)]
    return text([",".join(names), *joined(",", turned, short(digits))]).encode()


@layout
def english_primes(rows, digits):
    names = words(rows, ("t", "theta", "theta'", "theta_sine"))
    return text(plain(rows, digits, names)).encode()


@layout
def omega_first(rows, digits):
    names = ["t", "velocidad", "angulo", *(["funcionSinusoidal"] if rows[0][3] is not None else [])]
    turned = [[t, omega, theta, *rest] for t, theta, omega, *rest in map(cells, rows)]
    return text([" ".join(names), *joined(" ", turned, short(digits))]).encode()


def energies(row: Row) -> list[float]:
    """Kinetic, potential and total, of a pendulum of α = 1: readers cannot know what a program takes for its mass."""
    kinetic, potential = row[2] ** 2 / 2, 1 - math.cos(row[1])
    return [kinetic, potential, kinetic + potential]


@layout
def energies_behind(rows, digits):
    lines = [" ".join([*words(rows), "Ecinetica", "Epotencial", "Etotal"])]
    lines += joined(" ", ([*cells(row), *energies(row)] for row in rows), short(digits))
    return text(lines).encode()


@layout
def energies_behind_headless(rows, digits):
    return text(joined(" ", ([*cells(row), *energies(row)] for row in rows), short(digits))).encode()


@layout
def energies_before(rows, digits):
    lines = [",".join(["kinetic energy", "potential energy", "energy", *words(rows, ("time", "angle", "velocity", "sine"))])]
    lines += joined(",", ([*energies(row), *cells(row)] for row in rows), short(digits))
    return text(lines).encode()


@layout
def energy_before_the_sinusoid(rows, digits):
    table = [[*row[:3], energies(row)[2], *cells(row)[3:]] for row in rows]
    lines = [";".join(["t", "angulo", "velocidad", "energia", *words(rows)[3:]]), *joined(";", table, short(digits))]
    return text(lines).encode()


@layout
def place_behind(rows, digits):
    table = [[*cells(row), math.sin(row[1]), -math.cos(row[1])] for row in rows]
    return text(["\t".join([*words(rows), "x", "y"]), *joined("\t", table, short(digits))]).encode()


@layout
def two_methods(rows, digits):
    """The second is less exact, and is not what was asked for."""
    table = [[*cells(row), row[1] * 1.001, row[2] * 1.001] for row in rows]
    lines = [" ".join([*words(rows), "angulo_Euler", "velocidad_Euler"]), *joined(" ", table, short(digits))]
    return text(lines).encode()


@layout
def row_numbers(rows, digits):
    table = [[place, *cells(row)] for place, row in enumerate(rows)]
    return text([" ".join(["n", *words(rows)]), *joined(" ", table, short(digits))]).encode()


@layout
def row_numbers_headless(rows, digits):
    return text(joined("\t", ([place, *cells(row)] for place, row in enumerate(rows, start=1)), short(digits))).encode()


# Text around the table.


@layout
def prompt(rows, digits):
    """The answer to a question comes from a file and leaves no line end."""
    return ("Introduce los datos: " + text(plain(rows, digits))).encode()


@layout
def prompt_that_names_columns(rows, digits):
    question = "Introduce factorDelta, factorcout, factortSimul, el angulo, la velocidad y alfa: "
    return (question + text(plain(rows, digits))).encode()


def analysis(rows: Sequence[Row]) -> list[float]:
    """k, a limit angle and a characteristic time, as far as rows tell."""
    return [1 if rows[0][3] is None else -1, max(abs(row[1]) for row in rows), rows[-1][0]]


@layout
def analysis_before(rows, digits):
    return text([*joined(" ", [analysis(rows)], short(digits)), *plain(rows, digits)]).encode()


@layout
def analysis_in_words_before(rows, digits):
    values = zip(("k", "thetaM", "tau"), analysis(rows), strict=True)
    lines = [f"{name} = {short(digits)(value)}" for name, value in values]
    return text([*lines, "", *plain(rows, digits)]).encode()


@layout
def farewell(rows, digits):
    return text([*plain(rows, digits), "", "Fin de la simulacion. Presione una tecla para continuar . . ."]).encode()


@layout
def changing_separators(rows, digits):
    kinds = (" ", "\t", "  ", " \t")
    lines = [kinds[place % 4].join(map(short(digits), cells(row))) for place, row in enumerate(rows)]
    return text([" ".join(words(rows)), *lines]).encode()


@layout
def commas_and_spaces(rows, digits):
    """A comma is forgotten in every other line."""
    kinds = (", ", " ")
    lines = [kinds[place % 2].join(map(short(digits), cells(row))) for place, row in enumerate(rows)]
    return text([", ".join(words(rows)), *lines]).encode()
