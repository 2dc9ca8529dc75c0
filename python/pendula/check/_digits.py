"""Numbers as they were printed: their values, and how exact they are."""

from __future__ import annotations

from typing import TYPE_CHECKING, TypeAlias

import numpy as np
import numpy.typing as npt

if TYPE_CHECKING:
    from collections.abc import Sequence

Floats: TypeAlias = npt.NDArray[np.float64]
Integers: TypeAlias = npt.NDArray[np.int64]

CHUNK = 20_000  # cells that are taken apart at once, to save memory
LETTERS = 32  # of a number that are looked at; a double has no more digits


def cells_of(rows: Sequence[str], width: int) -> tuple[Floats, Integers, Integers]:
    """Values, NaN where there is none; significant digits; and digits behind the point, less the exponent."""
    size = len(rows), width
    values, digits, decimals = np.full(size, np.nan), np.zeros(size, np.int64), np.zeros(size, np.int64)
    step = max(1, CHUNK // width)
    for start in range(0, len(rows), step):
        flat = _padded(rows[start : start + step], width)
        shape = len(flat) // width, width
        part = slice(start, start + shape[0])
        values[part] = np.array(list(map(float, flat))).reshape(shape)
        found = _digits(flat)
        digits[part], decimals[part] = found[0].reshape(shape), found[1].reshape(shape)
    bad = ~np.isfinite(values)
    values[bad], digits[bad], decimals[bad] = np.nan, 0, 0
    return values, digits, decimals


def _padded(rows: Sequence[str], width: int) -> list[str]:
    """The numbers of rows that are made equally long."""
    words = [row.split() for row in rows]
    if any(len(row) != width for row in words):
        words = [(row + ["nan"] * width)[:width] for row in words]
    return [word for row in words for word in row]


def _digits(numbers: Sequence[str]) -> tuple[Integers, Integers]:
    """Significant digits, and digits behind the point, less the exponent."""
    most = min(max(map(len, numbers)), LETTERS)
    letters = np.array(numbers, f"S{most}").view(np.uint8).reshape(len(numbers), most)
    is_exponent = np.logical_or.accumulate((letters | 32) == ord("e"), axis=1)
    is_digit = (letters - ord("0") < 10) & ~is_exponent
    is_behind = np.logical_or.accumulate(letters == ord("."), axis=1)
    is_significant = np.logical_or.accumulate(is_digit & (letters != ord("0")), axis=1)
    decimals = (is_digit & is_behind).sum(axis=1)
    for place in np.flatnonzero(is_exponent.any(axis=1)).tolist():
        decimals[place] -= int(numbers[place].lower().partition("e")[2][:5] or 0)
    return (is_digit & is_significant).sum(axis=1), decimals


# Zeros at the end may be left out, in a tenth of all numbers; so a way to print them that most do not show is none.
MOST = 0.5
MANY = 20  # rows that show whether zeros are left out


def units_of(values: Floats, digits: Integers, decimals: Integers) -> Floats:
    """Units of the last digits. A column was printed with as many significant digits as its longest number, as %g does, or with
    as many decimals; zeros at the end may have been left out. Where both may be, it is the larger unit.
    """
    cut = [not _is_fixed(column[np.isfinite(value)]) for value, column in zip(values.T, decimals.T, strict=True)]
    longest = [_longest(column[column > 0]) for column in digits.T]
    # A stream prints all columns alike: one of round numbers has as many digits as those beside it.
    beside = max((most for most, is_cut in zip(longest, cut, strict=True) if is_cut), default=0)
    powers = np.zeros(values.shape, np.int64)
    for place, (value, digit, decimal) in enumerate(zip(values.T, digits.T, decimals.T, strict=True)):
        significant = max(longest[place], beside) if cut[place] else longest[place]
        is_even = cut[place] and significant > longest[place] and _is_even(value, decimal)
        powers[:, place] = _powers(value, digit, decimal, significant, is_even)
    with np.errstate(over="ignore"):
        return np.power(10.0, powers)


def _powers(value: Floats, digit: Integers, decimal: Integers, significant: int, is_even: bool) -> Integers:
    """Powers of ten of a column's units."""
    is_number = digit > 0
    # Zero is as exact as the number of the same digits that is nearest to it.
    nearest = max(significant - 1, int(decimal.max()))
    found = np.where(is_number, digit - decimal - significant, -nearest)
    fixed = _longest(decimal[np.isfinite(value)])
    shown = decimal[is_number]
    is_shown = shown.size == 0 or (np.mean(shown == fixed) >= MOST and np.sum(shown > fixed) <= 1)
    if is_shown and not is_even:
        found = np.maximum(found, -fixed)
    found = np.minimum(found, -decimal, where=is_number, out=found)
    if len(decimal) >= MANY and is_number[0] and decimal[0] < fixed and _is_fixed(decimal[1:]):
        found[0] = -decimal[0]  # the initial state, printed as it was given
    return found


def _is_fixed(decimals: Integers) -> bool:
    """Whether all numbers but the first have as many decimals."""
    others = decimals[1:] if len(decimals) > MANY else decimals
    return len(others) > 0 and bool(others[0] > 0 and np.all(others == others[0]))


def _is_even(values: Floats, decimals: Integers) -> bool:
    """Whether round numbers follow each other at equal distances, so that nothing was rounded."""
    with np.errstate(all="ignore"):
        steps = np.diff(values) * 10.0 ** min(int(decimals.max()), 300)
        return len(steps) > 2 and bool(np.ptp(steps) < 0.5)


def _longest(counts: Integers) -> int:
    """The largest; among many not one that stands alone, which was printed in another way."""
    if counts.size < MANY:
        return int(counts.max(initial=0))
    second, first = map(int, np.partition(counts, -2)[-2:])
    return second if first > second + 1 else first
