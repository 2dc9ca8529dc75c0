"""What a student's program has printed: tables of numbers, and which of their columns is which."""

from __future__ import annotations

import codecs
import math
import re
import sys
import unicodedata
from collections import Counter
from contextlib import contextmanager, nullcontext
from pathlib import Path
from typing import TYPE_CHECKING, BinaryIO, NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from pendula._command import BAD_USAGE, RefusedError, Text

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

Floats: TypeAlias = npt.NDArray[np.float64]
Integers: TypeAlias = npt.NDArray[np.int64]

MOST_BYTES = 1 << 24  # some 500,000 rows; more is no coursework

UNREADABLE: dict[str, Text] = {
    "directory": ("{0!r} is a directory, no table", "{0!r} es un directorio, no una tabla"),
    "no file": ("{0!r} does not exist", "{0!r} no existe"),
    "no permission": ("{0!r} may not be read", "no hay permiso para leer {0!r}"),
    "not read": ("{0!r} could not be read: {1}", "no se ha podido leer {0!r}: {1}"),
    "too large": ("{0!r} is larger than {1} MiB", "{0!r} ocupa más de {1} MiB"),
    "empty": ("{0!r} is empty", "{0!r} está vacío"),
    "binary": ("{0!r} is no text: it holds control characters", "{0!r} no es texto: contiene caracteres de control"),
    "no table": (
        "there is no table: no line of two numbers or more",
        "no hay ninguna tabla: ninguna línea de dos números o más",
    ),
    "no problems": ("{0!r} holds no problem that could be read", "{0!r} no trae ningún problema que se pueda leer"),
}


class UnreadableError(RefusedError):
    """There is nothing to mark; the name of the reason in UNREADABLE, and its values."""

    def __init__(self, name: str, *values: object) -> None:
        super().__init__(BAD_USAGE, UNREADABLE[name], *values)
        self.name = name


# Numbers, as programs and spreadsheets print them.

NUMBER = re.compile(r"[+-]?(\d*)(?:\.(\d*)|,(\d+))?(?:[eEdD]([+-]?\d{1,4}))?", re.ASCII)
# How C, Microsoft's C and Python print what is no finite number.
NOT_FINITE = re.compile(r"[+-]?(nan|inf|infinity|1[.,]#[a-z]+)(\([a-z0-9]*\))?", re.IGNORECASE)


class Number(NamedTuple):
    """A printed number."""

    value: float
    digits: int
    """Significant digits."""
    decimals: int
    """Digits behind the point, less the exponent."""


def number(text: str) -> Number | None:
    """The number that all of the text spells, with a decimal point or comma; NaN for one that is not finite; else None."""
    text = text.replace("\N{MINUS SIGN}", "-")
    match = NUMBER.fullmatch(text)
    if match is None:
        return Number(math.nan, 0, 0) if NOT_FINITE.fullmatch(text) else None
    whole, point, comma, exponent = match.groups()
    decimals = point or comma or ""
    if not whole and not decimals:
        return None
    value = float(text.replace(",", ".").replace("d", "e").replace("D", "e"))
    digits = len((whole + decimals).lstrip("0"))
    return Number(value if math.isfinite(value) else math.nan, digits, len(decimals) - int(exponent or 0))


# Files and their tables.

SAMPLE = 200  # lines that the separator is guessed from
SEPARATORS = (r"\s*;\s*", r"\t", r"\s*\|\s*", r"\s+", r"\s*,\s*")


class Table(NamedTuple):
    """Numbers in columns, as they were printed."""

    header: tuple[str, ...]
    """The words above the columns; empty where there are none."""
    values: Floats
    """[row, column]; NaN where a row has no finite number."""
    units: Floats
    """[row, column]: the unit of the last digit that was printed."""
    digits: Integers
    """[column]: the largest number of significant digits."""
    lines: Integers
    """[row]: the line of the file, from 1."""
    ragged: tuple[int, ...]
    """Lines with more or fewer columns than most."""


def read_file(path: str) -> list[Table]:
    """The tables of a file. Raises UnreadableError."""
    with opened(path) as file:
        data = file.read(MOST_BYTES + 1)
    if len(data) > MOST_BYTES:
        raise UnreadableError("too large", path, MOST_BYTES >> 20)
    return tables(decoded(data, path))


@contextmanager
def opened(path: str) -> Iterator[BinaryIO]:
    """The file, or standard input for "-". Raises UnreadableError, also for what goes wrong while it is read."""
    try:
        with nullcontext(sys.stdin.buffer) if path == "-" else Path(path).open("rb") as file:
            yield file
    except FileNotFoundError:
        raise UnreadableError("no file", path) from None
    except IsADirectoryError:
        raise UnreadableError("directory", path) from None
    except PermissionError:
        raise UnreadableError("no permission", path) from None
    except (OSError, ValueError) as error:
        raise UnreadableError("not read", path, error) from None


def decoded(data: bytes, path: str = "") -> str:
    """UTF-8, UTF-16 with its mark, or else Latin-1, in which only letters of a header can be wrong."""
    if not data.strip():
        raise UnreadableError("empty", path)
    if data.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)):
        return data.decode("utf-16", errors="replace")
    if re.search(rb"[\0-\x08\x0e-\x1a\x1c-\x1f]", data):
        raise UnreadableError("binary", path)
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError:
        return data.decode("latin-1")


def tables(text: str) -> list[Table]:
    """The tables of a text. A new one begins at a header, or where time falls back. UnreadableError if there is none."""
    lines = text.splitlines()
    separator = _separator(lines)
    found = [_Rows()]
    for place, line in enumerate(lines, start=1):
        fields = _fields(line, separator)
        row = [each for each in map(number, fields) if each is not None]
        if len(row) == len(fields) >= 2:
            if found[-1].is_past(row):
                found.append(_Rows())
            found[-1].rows.append(row)
            found[-1].lines.append(place)
        elif header := _header(line, fields):
            if found[-1].rows:
                found.append(_Rows())
            found[-1].header = header
            found[-1].time = roles_of(header).get("t", 0)
    complete = [_table(rows) for rows in found if rows.rows]
    if not complete:
        raise UnreadableError("no table")
    return complete


class _Rows:
    """A table that is being read."""

    def __init__(self) -> None:
        self.header: tuple[str, ...] = ()
        self.time = 0
        self.rows: list[list[Number]] = []
        self.lines: list[int] = []

    def is_past(self, row: Sequence[Number]) -> bool:
        """Whether a row is earlier than the last one. A NaN is neither before nor after any."""
        if not self.rows or self.time >= min(len(row), len(self.rows[-1])):
            return False
        return row[self.time].value < self.rows[-1][self.time].value


def _separator(lines: Sequence[str]) -> str:
    """The one that makes rows of numbers of the most lines; where several do, of the widest."""
    sample = [line for line in lines if any(letter.isdigit() for letter in line)][:SAMPLE]

    def score(separator: str) -> tuple[int, int]:
        rows = [fields for line in sample if len(fields := _fields(line, separator)) >= 2 and all(map(number, fields))]
        return len(rows), sum(map(len, rows))

    return max(SEPARATORS, key=score)


def _fields(line: str, separator: str) -> list[str]:
    words = re.split(separator, line.strip().lstrip("#").strip(" |" if "|" in line else None))
    while words and not words[-1]:  # rows may end with a separator
        words.pop()
    return [word.strip().strip('"') for word in words]


def _header(line: str, fields: Sequence[str]) -> tuple[str, ...]:
    """The words of a header, whose separator may be another than that of the rows; none where fewer than two are known."""
    for words in (fields, re.split(r"[\s,;|]+", line.strip(" \t#|"))):
        if len(roles_of(words)) >= 2:
            return tuple(words)
    return ()


def _table(rows: _Rows) -> Table:
    width = Counter(map(len, rows.rows)).most_common(1)[0][0]
    ragged = tuple(line for line, row in zip(rows.lines, rows.rows, strict=True) if len(row) != width)
    nothing = Number(np.nan, 0, 0)
    cells = np.array([(row + [nothing] * width)[:width] for row in rows.rows], float)
    values, digits, decimals = np.moveaxis(cells, -1, 0)
    units = np.stack([_units(*column) for column in zip(values.T, digits.T, decimals.T, strict=True)], axis=1)
    return Table(rows.header, values, units, digits.max(axis=0).astype(np.int64), np.array(rows.lines), ragged)


def _units(values: Floats, digits: Floats, decimals: Floats) -> Floats:
    """Units of the last digits of a column, in which all numbers have as many significant digits, or as many decimals, as the
    longest one: zeros at the end may be left out.
    """
    with np.errstate(divide="ignore"):
        magnitude = np.floor(np.log10(np.abs(values)))
    unit = np.power(10.0, magnitude + 1 - digits.max())
    units: Floats = np.maximum(np.where(np.isfinite(unit), unit, 0.0), np.power(10.0, -decimals.max()))
    return units


# Columns, by the words above them or by their order.

ROLES = ("t", "theta", "omega", "sine")  # in the assignment's order
WORDS = ("t", "angulo", "velocidad", "funcionSinusoidal")
STATE = ROLES[:3]

# Beginnings of words without accents and underscores; the first that fits decides.
BEGINNINGS = (
    ("sine", ("funcion", "sin", "sen", "thetasin", "thetasen", "θsin", "θsen", "fsin", "fsen")),
    ("omega", ("velocidad", "vel", "omega", "ω", "dtheta", "dθ", "thetadot", "thetap", "θp", "thetaprima")),
    ("theta", ("angulo", "ang", "theta", "θ", "tita", "phi")),
    ("t", ("tiempo", "time")),
)
LETTERS = {"t": "t", "w": "omega"}
DOT_ABOVE = "\N{COMBINING DOT ABOVE}"


class Column(NamedTuple):
    """What was printed of a quantity."""

    values: Floats
    units: Floats
    """Of the last digits."""

    def nearby(self) -> tuple[Floats, Floats, Floats]:
        """The values, and those one unit of the last digit below and above."""
        return self.values, self.values - self.units, self.values + self.units

    def scaled(self, unit: float) -> Column:
        """The column in another unit."""
        return Column(self.values * unit, self.units * unit)


class Columns(NamedTuple):
    """What was printed, in rows that have a time and a state."""

    t: Column
    theta: Column
    omega: Column
    sine: Column | None
    lines: Integers
    """The rows' lines in the file."""
    digits: int
    """Significant ones of the states."""


def roles_of(header: Sequence[str]) -> dict[str, int]:
    """The place of each column whose word is known; the first of those of one kind."""
    places: dict[str, int] = {}
    for place, word in enumerate(header):
        role = _role(word)
        if role is not None:
            places.setdefault(role, place)
    return places


def _role(word: str) -> str | None:
    decomposed = unicodedata.normalize("NFD", word.lower())
    if DOT_ABOVE in decomposed:
        return "omega"
    plain = "".join(letter for letter in decomposed if not unicodedata.combining(letter)).strip("\"'$\\ ").replace("_", "")
    letters = re.sub(r"[^a-zα-ω].*$", "", plain, flags=re.DOTALL)  # what follows is a unit or an index
    for role, beginnings in BEGINNINGS:
        if letters.startswith(beginnings):
            return role
    return LETTERS.get(letters)


def placements(table: Table, oscillates: bool) -> Iterator[tuple[str, dict[str, int]]]:
    """Where the columns may be, and the mistake that puts them there: as the header says, in order, and swapped."""
    width = table.values.shape[1]
    named = {role: place for role, place in roles_of(table.header).items() if place < width}
    in_order = dict(zip(ROLES, range(width), strict=False))
    if not oscillates and (width > len(ROLES) or (named and "sine" not in named)):
        in_order.pop("sine", None)  # the fourth column is something else
    is_named = set(STATE) <= named.keys()
    if is_named:
        yield "", named
    if not set(STATE) <= in_order.keys():
        return
    yield "header order" if is_named else "", in_order
    if not is_named and width > len(ROLES):  # the first column may number the rows
        yield "", {role: place + 1 for role, place in in_order.items()}
    yield "swapped", in_order | {"theta": in_order["omega"], "omega": in_order["theta"]}


def columns_at(table: Table, places: dict[str, int]) -> Columns | None:
    """The columns at these places, in whole rows that have a time and a state; None if there are none."""
    state = [places[role] for role in STATE]
    rows = np.isfinite(table.values[:, state]).all(axis=1) & ~np.isin(table.lines, table.ragged)
    if not rows.any():
        return None
    found = {role: Column(table.values[rows, place], table.units[rows, place]) for role, place in places.items()}
    digits = int(table.digits[state[1:]].min())
    return Columns(found["t"], found["theta"], found["omega"], found.get("sine"), table.lines[rows], digits)
