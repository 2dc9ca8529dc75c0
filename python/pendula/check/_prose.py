"""Sources, reports and pages: texts of many words, in which numbers are a table only where they look like one."""

from __future__ import annotations

from bisect import bisect
from heapq import nsmallest
from itertools import pairwise
from typing import TYPE_CHECKING

from pendula.check._columns import STATE, fitting, roles_of
from pendula.check._lines import ROW, width_of
from pendula.check._records import time_of

if TYPE_CHECKING:
    from collections.abc import Sequence

    from pendula.check._lines import Line
    from pendula.check._records import Run

MANY_WORDS = 10  # lines; fewer are questions and messages of a program
MOST_ROWS = 20  # for each line of words; where there are more, the words are headers and questions
FEW, MANY = 3, 10  # rows; among words, there are often fewer than FEW by chance, and seldom MANY
MOST_BETWEEN = 2  # lines of words between two rows of a table
MOST_STEPS = 1.5  # of time between them, where there are more words


def has_many_words(runs: Sequence[Run]) -> bool:
    """Whether a text has many lines of words, also for the rows that it has."""
    rows = [line for run in runs for line in run.rows]
    plain = sum(map(_is_plain, rows))
    words = sum(len(run.others) + len(run.header_lines) for run in runs) + len(rows) - plain
    return words >= MANY_WORDS and MOST_ROWS * words > plain


def _is_plain(row: Line) -> bool:
    """Whether a row is numbers only, or its words name them."""
    return row.kind.name == ROW or len(roles_of(row.kind.labels)) > 1


def _words_of(row: Line) -> tuple[str, ...]:
    """What the rows of a table have in common."""
    return row.kind.name, *row.kind.labels


def pieces_of(rows: Sequence[Line], others: Sequence[Line]) -> list[list[Line]]:
    """Rows that are alike, with hardly a line of words between, or with times that go on behind it."""
    places = [line.place for line in others]
    pieces: list[list[Line]] = []
    for line in rows:
        before = pieces[-1][-1] if pieces else line
        is_near = bisect(places, line.place) - bisect(places, before.place) <= MOST_BETWEEN
        if not pieces or _words_of(line) != _words_of(before) or not (is_near or _goes_on(pieces[-1], line)):
            pieces.append([])
        pieces[-1].append(line)
    return pieces


def _goes_on(piece: Sequence[Line], line: Line) -> bool:
    """Whether the time of a row is that of the next one."""
    first, last = time_of(piece[0], 0), time_of(piece[-1], 0)
    return 0 < (time_of(line, 0) - last) * (len(piece) - 1) < MOST_STEPS * (last - first)


def lines_below_header(run: Run) -> list[int]:
    """The places of the first lines below the header."""
    above = run.header_lines[0].place if run.header_lines else 0
    return nsmallest(2, (line.place for line in [*run.rows, *run.others] if line.place > above))


def is_table(run: Run, rows: Sequence[Line], nearest: Sequence[int]) -> bool:
    """Whether rows among many lines of words are a table: right below its header, or one below another.

    `nearest` are the places of the first lines below the header.
    """
    width = width_of(rows)
    if run.header_lines and _is_headed(rows, fitting(run.headers, width), nearest):
        return True
    if len(rows) < FEW:
        return False
    is_plain = _is_plain(rows[0])
    rises = all(one < other for one, other in pairwise(time_of(line, 0) for line in rows))
    signs = is_plain + rises + (len(rows) >= MANY)  # numbers in code or in sentences have one of these
    return signs > (1 if width >= len(STATE) else 2)


def _is_headed(rows: Sequence[Line], header: tuple[str, ...], nearest: Sequence[int]) -> bool:
    """Whether a header that names little but angles, velocities and times stands right above the rows."""
    roles = roles_of(header)
    if "theta" not in roles or 2 * len(roles) < max(len(header), 4):
        return False
    if rows[0].kind.name == ROW:
        return rows[0].place in nearest  # one line may hold the units
    return rows[0].place == nearest[0] and len(rows) >= FEW  # else it is a line of code below a declaration
