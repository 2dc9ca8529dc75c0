"""Numbers as they were printed: their values, and how exact they are."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

if TYPE_CHECKING:
    from collections.abc import Sequence

Floats: TypeAlias = npt.NDArray[np.float64]
Integers: TypeAlias = npt.NDArray[np.int64]
Flags: TypeAlias = npt.NDArray[np.bool_]

CHUNK = 20_000  # cells that are taken apart at once, to save memory
LETTERS = 32  # of a number that are looked at; a double has no more digits


class Cells(NamedTuple):
    """Numbers in rows and columns, and what was printed of them."""

    values: Floats
    """NaN where there is no finite one."""
    digits: Integers
    """Significant ones."""
    decimals: Integers
    """Digits behind the point, less the exponent."""
    has_exponent: Flags

    def at(self, rows: Flags) -> Cells:
        """Those of some rows."""
        return Cells(self.values[rows], self.digits[rows], self.decimals[rows], self.has_exponent[rows])


def cells_of(rows: Sequence[str], width: int) -> Cells:
    """The first numbers of each row, `width` of them."""
    size = len(rows), width
    cells = Cells(np.full(size, np.nan), np.zeros(size, np.int64), np.zeros(size, np.int64), np.zeros(size, bool))
    step = max(1, CHUNK // width)
    for start in range(0, len(rows), step):
        flat = _padded(rows[start : start + step], width)
        for whole, part in zip(cells, _chunk(flat), strict=True):
            whole[start : start + step] = part.reshape(-1, width)
    bad = ~np.isfinite(cells.values)
    cells.values[bad], cells.digits[bad], cells.decimals[bad] = np.nan, 0, 0
    return cells


def _padded(rows: Sequence[str], width: int) -> list[str]:
    """The numbers of rows that are made equally long."""
    words = [row.split() for row in rows]
    if any(len(row) != width for row in words):
        words = [(row + ["nan"] * width)[:width] for row in words]
    return [word for row in words for word in row]


def _chunk(numbers: Sequence[str]) -> Cells:
    most = min(max(map(len, numbers)), LETTERS)
    letters = np.array(numbers, f"S{most}").view(np.uint8).reshape(len(numbers), most)
    is_exponent = np.logical_or.accumulate((letters | 32) == ord("e"), axis=1)
    is_digit = (letters - ord("0") < 10) & ~is_exponent
    is_behind = np.logical_or.accumulate(letters == ord("."), axis=1)
    is_significant = np.logical_or.accumulate(is_digit & (letters != ord("0")), axis=1)
    decimals = (is_digit & is_behind).sum(axis=1)
    has_exponent = np.asarray(is_exponent.any(axis=1))
    for place in np.flatnonzero(has_exponent).tolist():
        decimals[place] -= int(numbers[place].lower().partition("e")[2][:5] or 0)
    return Cells(np.array(list(map(float, numbers))), (is_digit & is_significant).sum(axis=1), decimals, has_exponent)


# Zeros at the end may be left out, in a tenth of all numbers; so a way to print them that most do not show is none.
MOST = 0.5
LARGE = 1e4  # whole numbers below are more likely to be exact
MANY = 20  # rows that show whether zeros are left out


def units_of(cells: Cells) -> Floats:
    """Units of the last digits. A column was printed with as many significant digits as its longest number, as %g does, or with
    as many decimals; zeros at the end may have been left out. Where both may be, it is the larger unit.
    """
    cells = _without_point_zero(cells)
    # NumPy prints an array, so a row, with exponents in all of its numbers or in none; with them it leaves out no digits.
    is_scientific = np.asarray((cells.has_exponent | np.isnan(cells.values)).all(axis=1))
    is_alike = not cells.has_exponent[~is_scientific].any() and not is_scientific.all()
    apart = is_scientific if is_alike else np.zeros_like(is_scientific)
    powers = -cells.decimals
    powers[~apart] = _powers(cells.at(~apart))
    powers[apart] = np.where(cells.digits[apart] > 0, powers[apart], powers.min(axis=0))
    with np.errstate(over="ignore"):
        return np.power(10.0, powers)


def _without_point_zero(cells: Cells) -> Cells:
    """Python shows a whole number with a zero behind the point, which no rounding has left there."""
    values, digits, decimals, _ = cells
    is_whole = (decimals == 1) & (np.abs(values) >= LARGE) & (values == np.rint(values))
    return cells._replace(digits=digits - is_whole, decimals=decimals - is_whole)


def _powers(cells: Cells) -> Integers:
    """Powers of ten of the units of rows that were printed alike."""
    values, digits, decimals, has_exponent = cells
    cut = [not _is_fixed(column[np.isfinite(value)]) for value, column in zip(values.T, decimals.T, strict=True)]
    # Intel's Fortran shows a digit more in numbers with an exponent.
    is_more = _longest(digits[has_exponent]) == _longest(digits[~has_exponent]) + 1
    longest = [_longest(column[column > 0]) for column in (digits - is_more * has_exponent).T]
    # A stream prints all columns alike: one of round numbers has as many digits as those beside it.
    beside = max((most for most, is_cut in zip(longest, cut, strict=True) if is_cut), default=0)
    # NumPy prints all columns with as many decimals.
    is_number = digits > 0
    common = _longest(decimals[is_number])
    are_fixed = values.shape[1] > 1 and _are_shown(digits[is_number], decimals[is_number], common)
    powers = np.zeros(values.shape, np.int64)
    for place, (value, digit, decimal) in enumerate(zip(values.T, digits.T, decimals.T, strict=True)):
        significant = max(longest[place], beside) if cut[place] else longest[place]
        # A digit less than others have may also be the zero before the point of numbers with fixed decimals.
        is_even = cut[place] and significant > longest[place] + 1 and _is_even(value, decimal)
        powers[:, place] = _powers_of_column(value, digit, decimal, significant, is_even)
        if are_fixed and cut[place]:
            powers[:, place] = np.maximum(powers[:, place], -common)
    return powers


def _powers_of_column(value: Floats, digit: Integers, decimal: Integers, significant: int, is_even: bool) -> Integers:
    is_number = digit > 0
    # Zero is as exact as the number of the same digits that is nearest to it.
    nearest = max(significant - 1, int(decimal.max()))
    found = np.where(is_number, digit - decimal - significant, -nearest)
    fixed = _longest(decimal[np.isfinite(value)])
    if fixed > 0 and not is_even and _are_shown(digit[is_number], decimal[is_number], fixed):
        found = np.maximum(found, -fixed)
    found = np.minimum(found, -decimal, where=is_number, out=found)
    if len(decimal) >= MANY and is_number[0] and decimal[0] < fixed and _is_fixed(decimal[1:]):
        found[0] = -decimal[0]  # the initial state, printed as it was given
    return found


def _are_shown(digits: Integers, decimals: Integers, fixed: int) -> bool:
    """Whether numbers were printed with so many decimals: most show them, or small ones do, which then have fewer digits."""
    if digits.size == 0:
        return True
    shown = digits[decimals == fixed]
    # One small number alone may have as many because %g has cut a zero.
    is_usual = shown.size >= MOST * digits.size or bool(np.sum(shown < _longest(digits)) > 1)
    return is_usual and bool(np.sum(decimals > fixed) <= 1)


def _is_fixed(decimals: Integers) -> bool:
    """Whether all numbers but the first have as many decimals."""
    others = decimals[1:] if len(decimals) > MANY else decimals
    return len(others) > 0 and bool(others[0] > 0 and np.all(others == others[0]))


def _is_even(values: Floats, decimals: Integers) -> bool:
    """Whether round numbers follow each other at equal distances, so that nothing was rounded."""
    with np.errstate(all="ignore"):
        steps = np.diff(values) * 10.0 ** min(_longest(decimals), 300)
        return len(steps) > 2 and bool(np.ptp(steps) < 0.5)


def _longest(counts: Integers) -> int:
    """The largest; among many not one that stands alone, which was printed in another way."""
    if counts.size < MANY:
        return int(counts.max(initial=0))
    second, first = map(int, np.partition(counts, -2)[-2:])
    return second if first > second + 1 else first
