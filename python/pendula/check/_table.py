"""What a student's program has printed: tables of numbers, and which of their columns is which."""

from __future__ import annotations

from bisect import bisect
from collections import Counter
from itertools import islice, pairwise, product
from operator import attrgetter
from typing import TYPE_CHECKING, NamedTuple, TypeAlias

import numpy as np

from pendula.check._digits import Floats, Integers, cells_of, units_of
from pendula.check._lines import PLAIN, ROW
from pendula.check._records import Run, runs_of, starts_of, time_of
from pendula.check._text import MOST_TABLES, UNREADABLE, UnreadableError, contents, decoded, opened, unmarked_utf16
from pendula.check._words import ROLES, STATE, WORDS, fitting, role_of, roles_of

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from pendula.check._finding import Value
    from pendula.check._lines import Line

__all__ = [
    "ROLES",
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

Note: TypeAlias = "tuple[str, dict[str, Value]]"


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
    text, is_unmarked = decoded(data, path), unmarked_utf16(data)
    del data  # up to 16 MB
    found = tables(text)
    if is_unmarked:
        found = [table._replace(notes=(("no_mark_utf16", {}), *table.notes)) for table in found]
    return found


def tables(text: str) -> list[Table]:
    """The tables of a text. A new one begins at a header, or where time falls back. UnreadableError if there is none."""
    found: list[Table] = []
    before: list[Line] = []
    for run in runs_of(text):
        for part, (lines, others) in enumerate(_parts_of(run, before)):
            found.append(_table(run, lines, others, is_first=part == 0))
            if len(found) > MOST_TABLES:
                raise UnreadableError("many tables", MOST_TABLES)
    if not found:
        raise UnreadableError("no table")
    return found


# The tables of a run of lines.

JUDGED_BY = 200  # rows
PLACE = attrgetter("place")
SHORT = 3  # rows; fewer may be numbers that a program prints before its table


def _parts_of(run: Run, before: list[Line]) -> list[tuple[list[Line], list[Line]]]:
    """The rows of each table, and other lines before and among them. `before` are lines that belong to the next table."""
    rows = [line for line in run.rows if line.size >= 2]
    others = sorted([*run.others, *(line for line in run.rows if line.size < 2)], key=PLACE)
    parts = _split_at_falls(run, rows, others)
    kept: list[list[Line]] = []
    for place, part in enumerate(parts):
        following = parts[place + 1] if place + 1 < len(parts) else []
        while part and _is_preamble(part, following, run, has_tables=bool(kept)):
            others.append(part.pop(0))
        if part:
            kept.append(part)
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
    width = _width(rows)
    place = roles_of(fitting(run.headers, width)).get("t")
    if place is None:
        place = _place_of_time(rows, width)
    places = [line.place for line in rows]
    breaks = {bisect(places, line.place) for line in others}
    starts = starts_of([time_of(line, place) for line in rows], breaks)
    return [rows[start:stop] for start, stop in pairwise([*starts, len(rows)])]


def _width(rows: Sequence[Line]) -> int:
    return Counter(line.size for line in rows).most_common(1)[0][0]


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
    if run.is_before_header and len(part) < SHORT and (has_tables or not run.headers):
        return True
    whole = first.size <= 3 and first.numbers.split()[0] in ("-1", "0", "1")
    if len(part) == 1:  # time falls back after it
        return first.size <= 3 and len(following) >= SHORT and (whole or first.size != _width(following))
    return whole and len(part) > SHORT and (time_of(first, 0) < 0 or time_of(first, 0) >= time_of(part[1], 0))


def _table(run: Run, rows: list[Line], others: list[Line], is_first: bool) -> Table:
    width = _width(rows)
    damaged = [line for line in others if _is_damaged(line, rows, width, run.header_lines)]
    bad = {line.place for line in damaged} | {line.place for line in rows if line.size != width}
    rows = sorted([*rows, *damaged], key=PLACE) if damaged else rows
    values, digits, decimals = cells_of([line.numbers for line in rows], width)
    header = fitting(run.headers, width)
    if len(header) == width - 1 and role_of(header[0]) == "t" and _counts(values[:, 0]):
        header = ("", *header)  # above the numbers of rows there is no word
    extra = [line.place for line in others if line not in damaged]
    if is_first and _has_prompt(run.headers, header):
        extra += [line.place for line in run.header_lines]
    return Table(
        header,
        values,
        units_of(values, digits, decimals),
        digits.max(axis=0),
        np.array([line.place for line in rows]),
        tuple(sorted(bad)),
        tuple(_notes(run, rows, header, extra, width)),
    )


def _is_damaged(line: Line, rows: Sequence[Line], width: int, header: Sequence[Line]) -> bool:
    """Whether a line was to be a row."""
    first, last = rows[0].place, rows[-1].place
    is_inside = first < line.place < last
    if line.kind.name == ROW:
        return is_inside and line.size > 0
    if line.size == 0 or line.kind.fields != width:
        return False
    if line.size >= width - 1 >= 2 and (line.kind.is_led or line.size < width):
        return is_inside or line.place in (first - 1, last + 1) or (len(header) > 0 and header[0].place < line.place)
    return is_inside and line.kind.is_led and 2 * line.size >= width


def _has_prompt(headers: Sequence[tuple[str, ...]], header: tuple[str, ...]) -> bool:
    """Whether more words stand on the line of the header."""
    letters = [len("".join("".join(words).split())) for words in (header, *headers)]
    return letters[0] < max(letters)


def _counts(numbers: Floats) -> bool:
    return len(numbers) > 1 and numbers[0] in (0, 1) and bool(np.all(np.diff(numbers) == 1))


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
    elif "t" not in roles and len(header) >= width:
        yield "no_time", {}
    named = set(roles_of(header).values())
    extra = [word for place, word in enumerate(header) if word and place not in named and (roles[place] or "sine" in roles)]
    if extra and set(STATE) <= set(roles):
        yield "extra_columns", {"columns": " ".join(extra)}


# Columns, by the words above them or by their order.


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


MOST_PLACEMENTS = 12


def placements(table: Table, oscillates: bool) -> Iterator[tuple[str, dict[str, int]]]:
    """Where the columns may be, and the mistake that puts them there: as the header says, in order, beside others, swapped."""
    seen: list[dict[str, int]] = []
    for name, places in islice(_placements(table, oscillates), MOST_PLACEMENTS):
        if places not in seen:
            seen.append(places)
            yield name, places


def _placements(table: Table, oscillates: bool) -> Iterator[tuple[str, dict[str, int]]]:
    width = table.values.shape[1]
    named = {role: place for role, place in roles_of(table.header).items() if place < width}
    is_named = set(STATE) <= named.keys()
    if is_named:
        yield from (("", places) for places in _named_placements(table.header, named, width, oscillates))
    elif "theta" in named and "omega" in named and len(table.header) >= width:
        return  # a table without times
    if width < len(STATE):
        return
    has_sine = oscillates and width > len(STATE)
    if not oscillates and width == len(ROLES) and (not named or "sine" in named):
        has_sine = True  # one too many
    in_order = dict(zip(ROLES[: 4 if has_sine else 3], range(width), strict=False))
    yield "header_order" if is_named else "", in_order
    if not is_named:
        yield from (("", places) for places in _unnamed_placements(width, has_sine))
    yield "swapped", in_order | {"theta": in_order["omega"], "omega": in_order["theta"]}
    if is_named:
        yield "swapped", named | {"theta": named["omega"], "omega": named["theta"]}


def _named_placements(header: Sequence[str], named: dict[str, int], width: int, oscillates: bool) -> Iterator[dict[str, int]]:
    """As the header says; where it names the angle or the velocity twice, all pairs of them, Runge-Kutta's first."""
    roles = [role_of(word) for word in header[:width]]
    if "sine" not in named and oscillates:
        roles += [""] * (width - len(roles))
        # The first column without a known name, at the right, may be the sinusoid.
        unknown = [place for place, role in enumerate(roles) if not role and place > max(named[role] for role in STATE)]
        if len(unknown) == 1:
            named = named | {"sine": unknown[0]}
    angles, velocities = ([place for place, role in enumerate(roles) if role == wanted] for wanted in ("theta", "omega"))

    def rank(pair: tuple[int, int]) -> tuple[bool, bool, int]:
        words = [header[place].lower() for place in pair]
        is_asked = all("rk" in word or "runge" in word for word in words)
        return not is_asked, angles.index(pair[0]) != velocities.index(pair[1]), angles.index(pair[0])

    for angle, velocity in sorted(product(angles, velocities), key=rank):
        yield named | {"theta": angle, "omega": velocity}


def _unnamed_placements(width: int, has_sine: bool) -> Iterator[dict[str, int]]:
    """After a column that numbers the rows, with other columns before the sinusoid, and beside those of another method."""
    size = 4 if has_sine else 3
    if width > 3:
        yield dict(zip(ROLES[: min(size, width - 1)], range(1, width), strict=False))
    if has_sine:
        yield from ({"t": 0, "theta": 1, "omega": 2, "sine": place} for place in (width - 1, width - 2) if place > 3)
    if width > 4:
        yield {"t": 0, "theta": 3, "omega": 4} | ({"sine": 5} if has_sine and width > 5 else {})
        yield {"t": 0, "theta": 2, "omega": 4} | ({"sine": 5} if has_sine and width > 5 else {})
    if width > 6:
        yield {"t": 0, "theta": 4, "omega": 5} | ({"sine": 6} if has_sine else {})


def columns_at(table: Table, places: dict[str, int]) -> Columns | None:
    """The columns at these places, in whole rows that have a time and a state; None if there are none."""
    state = [places[role] for role in STATE]
    rows = np.isfinite(table.values[:, state]).all(axis=1) & ~np.isin(table.lines, table.ragged)
    if not rows.any():
        return None
    found = {role: Column(table.values[rows, place], table.units[rows, place]) for role, place in places.items()}
    digits = int(table.digits[state[1:]].min())
    return Columns(found["t"], found["theta"], found["omega"], found.get("sine"), table.lines[rows], digits)
