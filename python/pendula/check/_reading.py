"""Tables out of what a program has left in a file, however it spells them."""

from __future__ import annotations

import codecs
import re
import sys
from collections import Counter
from contextlib import contextmanager, nullcontext
from pathlib import Path
from typing import TYPE_CHECKING, Any, BinaryIO, NamedTuple

import numpy as np

from pendula.check._columns import roles_of
from pendula.check._numbers import Number, number

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

MOST_BYTES = 1 << 24  # some 500,000 rows; more is no coursework
SAMPLE = 200  # lines that the separator is guessed from
SEPARATORS = (r"\s*;\s*", r"\t", r"\s*\|\s*", r"\s+", r"\s*,\s*")


class UnreadableError(Exception):
    """There is no table; the name of the reason in TEXTS, and its values."""

    def __init__(self, name: str, *values: object) -> None:
        super().__init__(name)
        self.name, self.values = name, values


class Table(NamedTuple):
    """Numbers in columns, as they were printed."""

    header: tuple[str, ...]
    """The words above the columns; empty where there are none."""
    values: Any
    """[row, column]; NaN where a row has no finite number."""
    units: Any
    """[row, column]: the unit of the last digit that was printed."""
    digits: Any
    """[column]: the most significant digits."""
    lines: Any
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
        numbers = [number(field) for field in fields]
        if len(fields) >= 2 and None not in numbers:
            row = [each for each in numbers if each is not None]
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
    """The words of a header, which some separate otherwise than the rows below; none where less than two are known."""
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
    return Table(rows.header, values, units, digits.max(axis=0).astype(int), np.array(rows.lines), ragged)


def _units(values: Any, digits: Any, decimals: Any) -> Any:
    """Of a column that has as many digits, or as many decimals, as its longest number; zeros at the end may be left out."""
    with np.errstate(divide="ignore"):
        magnitude = np.floor(np.log10(np.abs(values)))
    unit = 10.0 ** (magnitude + 1 - digits.max())
    return np.maximum(np.where(np.isfinite(unit), unit, 0.0), 10.0 ** -decimals.max())
