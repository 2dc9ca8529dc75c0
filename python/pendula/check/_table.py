"""What a student's program has printed: tables of numbers, and which of their columns is which."""

from __future__ import annotations

from bisect import bisect
from collections import Counter
from itertools import pairwise
from operator import attrgetter
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from pendula.check._columns import (
    ROLES,
    STATE,
    WORDS,
    Column,
    Columns,
    columns_at,
    fitting,
    is_timeless,
    placements,
    role_of,
    roles_of,
)
from pendula.check._digits import Floats, Integers, cells_of, units_of
from pendula.check._lines import PLAIN, ROW, width_of
from pendula.check._prose import has_many_words, is_table, lines_below_header, pieces_of
from pendula.check._records import Run, runs_of, starts_of, time_of
from pendula.check._text import MOST_TABLES, UNREADABLE, Note, UnreadableError, contents, decoded, opened

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from pendula.check._lines import Line

__all__ = [
    "ROLES",
    "STATE",
    "UNREADABLE",
    "WORDS",
    "Column",
    "Columns",
    "Floats",
    "Integers",
    "Table",
    "UnreadableError",
    "columns_at",
    "decoded",
    "opened",
    "placements",
    "read_file",
    "roles_of",
    "tables",
]


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
    """Lines with more or fewer columns than most, or with words among their numbers."""
    notes: tuple[Note, ...] = ()
    """What there is to say of the text: names of findings, and their values."""


def read_file(path: str) -> list[Table]:
    """The tables of a file. Raises UnreadableError."""
    data = contents(path)
    try:
        return tables(*decoded(data, path))
    except UnreadableError as error:
        raise error.of(path) from None


def tables(text: str, notes: tuple[Note, ...] = ()) -> list[Table]:
    """The tables of a text. A new one begins at a header, or where time falls back. UnreadableError if there is none.

    `notes` are what there is to say of the whole text.
    """
    found: list[Table] = []
    before: list[Line] = []
    runs = runs_of(text)
    is_prose = has_many_words(runs)
    for run in runs:
        run.is_prose = is_prose
        for part, (lines, others) in enumerate(_parts_of(run, before)):
            found.append(_table(run, lines, others, notes, is_first=part == 0))
            if len(found) > MOST_TABLES:
                raise UnreadableError("many tables", MOST_TABLES)
    if not found:
        raise UnreadableError("no table")
    return found


# The tables of a run of lines.

JUDGED_BY = 200  # rows
PLACE = attrgetter("place")
LONGEST_SLIP = 3  # letters in the place of a first number; more are a word
SHORT = 3  # rows; fewer may be numbers that a program prints before its table


def _parts_of(run: Run, before: list[Line]) -> list[tuple[list[Line], list[Line]]]:
    """The rows of each table, and other lines before and among them. `before` are lines that belong to the next table."""
    rows = [line for line in run.rows if line.size >= 2]
    others = sorted([*run.others, *(line for line in run.rows if line.size < 2)], key=PLACE)
    pieces = pieces_of(rows, others) if run.is_prose else [rows]
    parts = [part for piece in pieces for part in _split_at_falls(run, piece, others)]
    nearest = lines_below_header(run)
    kept: list[list[Line]] = []
    for place, part in enumerate(parts):
        following = parts[place + 1] if place + 1 < len(parts) else []
        while part and _is_preamble(part, following, run, has_tables=bool(kept)):
            others.append(part.pop(0))
        if kept and _is_afterword(part, kept[-1]):
            others.append(part.pop())
        if part and not (run.is_prose and not is_table(run, part, nearest)):
            kept.append(part)
        else:
            others += part
    others = sorted([*before, *others], key=PLACE)
    before.clear()
    found = []
    for place, part in enumerate(kept):
        is_last = place + 1 == len(kept) and not run.is_before_header
        count = len(others) if is_last else bisect(others, part[-1].place, key=PLACE)
        found.append((part, others[:count]))
        del others[:count]
    before += others
    return found


def _split_at_falls(run: Run, rows: list[Line], others: list[Line]) -> list[list[Line]]:
    if not rows:
        return []
    width = width_of(rows)
    header = fitting(run.headers, width)
    if is_timeless(header, width):
        return [rows]
    place = roles_of(header).get("t")
    if place is None:
        place = _place_of_time(rows, width)
    places = [line.place for line in rows]
    breaks = {bisect(places, line.place) for line in others}
    starts = starts_of([time_of(line, place) for line in rows], breaks)
    return [rows[start:stop] for start, stop in pairwise([*starts, len(rows)])]


def _place_of_time(rows: Sequence[Line], width: int) -> int:
    """The first column, unless another one rises much more often."""
    sample = np.array([line.numbers.split() for line in rows if line.size == width][:JUDGED_BY], float)
    with np.errstate(invalid="ignore"):
        rises = (np.diff(sample, axis=0) > 0).sum(axis=0)
    best = int(rises.argmax())
    return best if rises[best] - rises[0] > 0.2 * len(sample) else 0


def _is_preamble(part: Sequence[Line], following: Sequence[Line], run: Run, has_tables: bool) -> bool:
    """Whether the first row is none: k, θM and τ before the table."""
    first = part[0]
    if is_timeless(fitting(run.headers, first.size), first.size):
        return False  # its first column may fall
    if run.is_before_header and len(part) < SHORT and (has_tables or not run.headers):
        return True
    whole = first.size <= 3 and first.numbers.split()[0] in ("-1", "0", "1")
    if len(part) == 1:  # time falls back after it
        return first.size <= 3 and len(following) >= SHORT and (whole or first.size != width_of(following))
    return whole and len(part) > SHORT and (time_of(first, 0) < 0 or time_of(first, 0) >= time_of(part[1], 0))


def _is_afterword(part: Sequence[Line], table: Sequence[Line]) -> bool:
    """Whether a row alone behind a table is none: k, θM and τ, or the like. A table may have one row, that of t = 0."""
    if len(part) != 1 or time_of(part[0], 0) == 0:
        return False
    is_analysis = part[0].size == 3 and part[0].numbers.split()[0] in ("-1", "1")
    return is_analysis or part[0].size != width_of(table)


def _table(run: Run, rows: list[Line], others: list[Line], notes: tuple[Note, ...], is_first: bool) -> Table:
    width = width_of(rows)
    damaged = [line for line in others if _is_damaged(line, rows, width, [] if run.is_prose else run.header_lines)]
    bad = {line.place for line in damaged} | {line.place for line in rows if line.size != width}
    rows = sorted([*rows, *damaged], key=PLACE) if damaged else rows
    cells = cells_of([line.numbers for line in rows], width)
    header = fitting(run.headers, width)
    if len(header) == width - 1 and role_of(header[0]) == "t" and _counts(cells.values[:, 0]):
        header = ("", *header)  # above the numbers of rows there is no word
    # What stands above a table harms nobody.
    extra = [line.place for line in others if line not in damaged and line.place >= rows[0].place]
    if is_first and _has_prompt(run.headers, header):
        extra += [line.place for line in run.header_lines]
    return Table(
        header,
        cells.values,
        units_of(cells),
        cells.digits.max(axis=0),
        np.array([line.place for line in rows]),
        tuple(sorted(bad)),
        (*notes, *_notes(run, rows, header, extra, width)),
    )


def _is_damaged(line: Line, rows: Sequence[Line], width: int, header: Sequence[Line]) -> bool:
    """Whether a line was to be a row."""
    first, last = rows[0].place, rows[-1].place
    is_inside = first < line.place < last
    if line.kind.name == ROW:
        return is_inside and line.size > 0
    if line.size == 0 or line.kind.fields != width or len(line.kind.labels[0]) > LONGEST_SLIP:
        return False
    if line.size >= width - 1 >= 2 and (line.kind.is_led or line.size < width):
        return is_inside or line.place in (first - 1, last + 1) or (len(header) > 0 and header[0].place < line.place)
    return is_inside and line.kind.is_led and 2 * line.size >= width


def _has_prompt(headers: Sequence[tuple[str, ...]], header: tuple[str, ...]) -> bool:
    """Whether more words stand on the line of the header."""
    letters = [len("".join("".join(words).split())) for words in (header, *headers)]
    return letters[0] < max(letters)


def _counts(numbers: Floats) -> bool:
    return len(numbers) > 1 and float(numbers[0]).is_integer() and bool(np.all(np.diff(numbers) == 1))


def _notes(run: Run, rows: Sequence[Line], header: tuple[str, ...], extra: Sequence[int], width: int) -> Iterator[Note]:
    kinds = {line.kind for line in rows} if any(line.kind is not PLAIN for line in rows) else {PLAIN}
    if extra:
        yield "extra_text", {"line": min(extra)}
    if run.is_folded:
        yield "folded_records", {}
    if run.commas:
        yield "comma_ambiguous", {"line": run.commas[0], "count": run.commas[1]}
    if any(kind.has_brackets for kind in kinds):
        yield "brackets", {}
    if any("&" in kind.separator for kind in kinds):
        yield "latex", {}
    if len({kind.separator for kind in kinds}) > 1:
        usual = Counter(line.kind.separator for line in rows).most_common(1)[0][0]
        yield "mixed_separators", {"line": next(line.place for line in rows if line.kind.separator != usual)}
    yield from _notes_on_header(header, width)


def _notes_on_header(header: tuple[str, ...], width: int) -> Iterator[Note]:
    roles = [role_of(word) for word in header]
    if "theta" not in roles:
        if {"x", "y"} <= set(roles):
            yield "cartesian", {}
    elif is_timeless(header, width):
        yield "no_time", {}
    named = set(roles_of(header).values())
    extra = [word for place, word in enumerate(header) if word and place not in named and (roles[place] or "sine" in roles)]
    if extra and set(STATE) <= set(roles) and len(header) <= width:
        yield "extra_columns", {"columns": " ".join(extra)}
