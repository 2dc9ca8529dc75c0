"""Which lines belong together: those below a header, those of a table, and those that hold one row."""

from __future__ import annotations

import math
from collections import Counter
from itertools import pairwise
from typing import TYPE_CHECKING

from pendula.check._columns import roles_of
from pendula.check._lines import ROW, TEXT, Line, Lines
from pendula.check._text import MOST_TABLES, UnreadableError

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence


class Run:
    """Lines from a header to the next one, or to the end."""

    def __init__(self) -> None:
        self.headers: tuple[tuple[str, ...], ...] = ()
        self.named = 0
        """How many quantities the header names."""
        self.header_lines: list[Line] = []
        """The line of the header, if there is one."""
        self.rows: list[Line] = []
        self.others: list[Line] = []
        """Lines that are no rows."""
        self.is_before_header = False
        self.is_prose = False
        """Whether all of the text has many lines of words."""
        self.is_folded = False
        self.commas: tuple[int, int] | None = None
        """The first line with decimal commas among commas, and how many such lines cannot be read."""


def runs_of(text: str) -> list[Run]:
    """All of a text, at most one more than its headers."""
    runs = [Run()]
    for line in Lines(text):
        run = runs[-1]
        if line.kind.headers:
            if run.rows:
                run.is_before_header = True
                run = Run()
                runs.append(run)
                if len(runs) > 2 * MOST_TABLES:
                    raise UnreadableError("many tables", MOST_TABLES)
            if line.kind.named >= run.named:
                run.others += run.header_lines
                run.headers, run.named, run.header_lines = line.kind.headers, line.kind.named, [line]
            else:
                run.others.append(line)
        elif line.kind.name == TEXT:
            run.others.append(line)
        else:
            run.rows.append(line)
    for run in runs:
        _settle_words(run)
        _pair_commas(run)
        _unfold(run)
    return runs


# Words among numbers.


def _settle_words(run: Run) -> None:
    """Lines with words are rows where they come one after another, or name a time and an angle; the others are none."""
    if all(line.kind.name == ROW for line in run.rows):
        return
    labelled = Counter(one.kind.labels for one, other in pairwise(run.rows) if one.kind.labels == other.kind.labels != ())
    kept = []
    for place, line in enumerate(run.rows):
        labels = line.kind.labels
        if line.kind.name == ROW or labelled[labels] >= 2 or {"t", "theta"} <= roles_of(labels).keys():
            kept.append(line)
            if labels and not run.headers and len(roles_of(labels)) >= 2:
                run.headers = (labels,)
        elif line.kind.is_prompted and not kept and _begins(line, run.rows[place + 1 : place + 3]):
            kept.append(line)
            run.others.append(line._replace(size=0))
        else:
            run.others.append(line)
    run.rows = kept


def _begins(line: Line, following: Sequence[Line]) -> bool:
    """Whether a line that has a question before its numbers is the first row of a table."""
    if any(other.kind.name != ROW or other.size != line.size for other in following) or len(following) < 2:
        return False
    first, second, third = (time_of(each, 0) for each in (line, *following))
    return 0 <= first < second < third and second - first < 2 * (third - second)


def time_of(line: Line, place: int) -> float:
    """The number in a column; NaN where there is none."""
    words = line.numbers.split(maxsplit=place + 1)
    return float(words[place]) if place < len(words) else float("nan")


# Rows that are folded over several lines.

LONGEST_FOLD = 4  # lines
FEWEST_FOLDS = 3
LOOKS = 10  # at each line, on the average


def _unfold(run: Run) -> None:
    rows = _closed(run.rows)
    run.is_folded = len(rows) < len(run.rows)
    run.rows = rows
    sizes = [line.size for line in run.rows]
    if not sizes or min(sizes) == max(sizes) > 2 or _rises_each(run.rows):
        return
    headers = sorted(run.headers, key=lambda header: (-len(roles_of(header)), len(header)))
    widths = [len(header) for header in headers if len(header) >= 3]
    for width in widths:
        ends = _ends_by_width(sizes, width)
        if ends:
            parts = [run.rows[start:stop] for start, stop in pairwise([0, *ends])]
            run.rows = [*map(_joined, parts), *run.rows[ends[-1] :]]
            run.is_folded = True
            return
    if Counter(sizes).most_common(1)[0][0] not in widths:
        _unfold_periods(run, sizes)


def _closed(rows: Sequence[Line]) -> list[Line]:
    """Joins the lines from a square bracket to the one that closes it."""
    closed: list[Line] = []
    place = 0
    while place < len(rows):
        lines = 1
        if rows[place].kind.last_bracket == "[":
            brackets = [line.kind.last_bracket for line in rows[place + 1 : place + LONGEST_FOLD]]
            end = next((i for i, bracket in enumerate(brackets, start=1) if bracket), 0)
            lines += end if end and brackets[end - 1] == "]" else 0
        closed.append(_joined(rows[place : place + lines]) if lines > 1 else rows[place])
        place += lines
    return closed


def _ends_by_width(sizes: Sequence[int], width: int) -> list[int]:
    """Where rows of this many numbers end, if all lines are parts of such rows; else none."""
    if max(sizes) > width or 2 * sizes.count(width) >= len(sizes):
        return []
    ends, sum_ = [], 0
    for end, size in enumerate(sizes, start=1):
        sum_ += size
        if sum_ > width:
            return []
        if sum_ == width:
            ends.append(end)
            sum_ = 0
    return ends


def _unfold_periods(run: Run, sizes: Sequence[int]) -> None:
    """Joins lines whose numbers of numbers repeat, and whose first number grows from row to row and not from line to line."""
    rows: list[Line] = []
    place, looks = 0, 0
    while place < len(sizes):
        lines, stop = 1, place + 1
        for folds in range(2, LONGEST_FOLD + 1):
            end = _end_of_period(sizes, place, folds) if looks < LOOKS * len(sizes) else place
            looks += end - place
            if end - place >= FEWEST_FOLDS * folds and _rises_only_each(run.rows[place:end], folds):
                lines, stop = folds, end
                break
        if lines == 1:
            rows.append(run.rows[place])
        else:
            rows += [_joined(run.rows[start : start + lines]) for start in range(place, stop, lines)]
            run.is_folded = True
        place = stop
    run.rows = rows


def _end_of_period(sizes: Sequence[int], start: int, lines: int) -> int:
    """Where numbers of numbers no longer repeat after so many lines."""
    pattern = sizes[start : start + lines]
    if sum(pattern) < 3 or (min(pattern) == max(pattern) > 2):
        return start
    end = start
    while sizes[end : end + lines] == pattern:
        end += lines
    return end


def _rises_each(rows: Sequence[Line]) -> bool:
    """Whether the first number, which is then the time, grows from line to line."""
    return len(rows) > LONGEST_FOLD and all(one < other for one, other in pairwise(time_of(line, 0) for line in rows))


def _rises_only_each(rows: Sequence[Line], lines: int) -> bool:
    """Whether the first number grows from row to row, and not from line to line."""
    first = [time_of(line, 0) for line in rows]
    falls = sum(two < one for one, two in pairwise(first))
    rises = [one < two for one, two in pairwise(first[::lines])]
    return sum(rises) > 0.8 * len(rises) and 10 * falls > len(first)


def _joined(parts: Sequence[Line]) -> Line:
    numbers = " ".join(part.numbers for part in parts)
    return Line(parts[0].place, numbers, sum(part.size for part in parts), parts[0].kind)


# Commas that are decimal and separate numbers, too.

MOST_PAIRED = 8  # numbers of a row, after pairing
MOST_PAIRINGS = 1_000  # rows whose pairs are to be found


def _pair_commas(run: Run) -> None:
    bare = [line for line in run.rows if line.kind.is_bare]
    if not bare or 2 * len(bare) < len(run.rows) or any("." in line.numbers for line in bare):
        return
    most = max(line.size for line in bare)
    widths = {len(header) for header in run.headers} or {most // 2}
    width = next((width for width in widths if 2 * width == most and 3 <= width <= MOST_PAIRED), None)
    if width is None:
        return
    limits = [0] * width
    for line in bare:
        if line.size == most:
            digits = (len(whole.lstrip("+-")) for whole in line.numbers.split()[::2])
            limits = list(map(max, limits, digits))
    paired = [_in_pairs(line.numbers.split()) if line.kind.is_bare and line.size == most else "" for line in run.rows]
    tried = 0
    for place, line in enumerate(run.rows):
        if not paired[place] and line.kind.is_bare and width <= line.size < most and tried < MOST_PAIRINGS:
            tried += 1
            rows = [" ".join(row) for row in _pairings(line.numbers.split(), limits)]
            paired[place] = _likeliest(rows, [row for row in paired[max(0, place - 2) : place + 3] if row])
    lost = paired.count("") - len(run.rows) + len(bare)
    run.commas = bare[0].place, lost
    if 2 * lost < len(paired):
        run.rows = [
            line._replace(numbers=numbers or "nan nan", size=width if numbers else 2) if line.kind.is_bare else line
            for line, numbers in zip(run.rows, paired, strict=True)
        ]


def _in_pairs(fields: Sequence[str]) -> str:
    """The numbers of fields that are all whole and fraction in turn; "" for others."""
    wholes, fractions = fields[::2], fields[1::2]
    if all(whole.lstrip("+-").isdigit() for whole in wholes) and all(fraction[0].isdigit() for fraction in fractions):
        return " ".join(map(".".join, zip(wholes, fractions, strict=True)))
    return ""


def _likeliest(rows: Sequence[str], neighbours: Sequence[str]) -> str:
    """The only row, or else the one that is much nearer to one of its neighbours than the others; "" if there is none."""
    if len(rows) < 2 or not neighbours:
        return rows[0] if len(rows) == 1 else ""
    near = [list(map(float, row.split())) for row in neighbours]

    def off(row: str) -> float:
        numbers = list(map(float, row.split()))
        return min(math.dist(numbers, other) for other in near)

    first, second = sorted(rows, key=off)[:2]
    return first if 2 * off(first) < off(second) else ""


def _pairings(fields: Sequence[str], limits: Sequence[int]) -> Iterator[list[str]]:
    """All ways to make as many numbers as there are limits of their digits before the comma."""
    if not limits:
        yield []
        return
    first, others = fields[0], len(limits) - 1
    is_whole = first.lstrip("+-").isdigit()
    if is_whole and len(first.lstrip("+-")) > limits[0]:
        return
    if others <= len(fields) - 1 <= 2 * others:
        yield from ([first, *rest] for rest in _pairings(fields[1:], limits[1:]))
    if is_whole and others <= len(fields) - 2 <= 2 * others and fields[1][0].isdigit():
        yield from ([f"{first}.{fields[1]}", *rest] for rest in _pairings(fields[2:], limits[1:]))


# Where tables begin.


def starts_of(times: Sequence[float], breaks: set[int]) -> list[int]:
    """The rows at which time begins anew; a single time that is wrong among right ones is no beginning."""
    known: list[float] = []
    for time in times:
        known.append(known[-1] if math.isnan(time) and known else time)
    steps = enumerate(pairwise(known), start=1)
    falls = [row for row, (one, other) in steps if other < one or (row in breaks and other == one)]
    if 2 * len(falls) > len(known):
        return [0]  # time runs backwards, or is no time
    starts = [0]
    for row in falls:
        if row in breaks or not _is_resumed(known, starts[-1], row):
            starts.append(row)
    return starts


def _is_resumed(times: Sequence[float], start: int, row: int) -> bool:
    """Whether times go on after a wrong one, which is this row's or that of the row before."""
    for last, following in ((row - 1, row + 1), (row - 2, row)):
        if last - start >= 2 and following < len(times):
            step = (times[last] - times[start]) / (last - start)
            if 0 < times[following] - times[last] < 3 * step:
                return True
    return False
