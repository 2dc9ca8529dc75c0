"""Numbers as programs and spreadsheets print them, and how finely they are printed."""

from __future__ import annotations

import math
import re
from typing import NamedTuple

NUMBER = re.compile(r"[+-]?(\d*)(?:\.(\d*)|,(\d+))?(?:[eEdD]([+-]?\d{1,4}))?", re.ASCII)
# C's, Microsoft's and Python's ways to say that there is no number.
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
