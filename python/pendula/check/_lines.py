"""What the lines of a text are: rows of numbers, headers, or other words."""

from __future__ import annotations

import re
from collections import Counter
from typing import TYPE_CHECKING, NamedTuple

from pendula.check._columns import headers_of, role_of, roles_of
from pendula.check._text import MOST_COLUMNS, MOST_KINDS, MOST_LETTERS, MOST_LINES, MOST_NUMBERS, UnreadableError

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

ROW, WORDED, TEXT, BLANK = "row", "worded", "text", "blank"


class Kind(NamedTuple):
    """What a line is, whatever its numbers are."""

    name: str
    """A ROW of numbers, one with words among them, TEXT without numbers, or BLANK."""
    separator: str = ""
    """Between the numbers; empty for white space."""
    is_bare: bool = False
    """Whether a comma without a space stands between numbers, so that it could be a decimal one."""
    has_brackets: bool = False
    last_bracket: str = ""
    """The last square one."""
    fields: int = 0
    """Of numbers and words."""
    is_led: bool = False
    """Whether a number comes first."""
    labels: tuple[str, ...] = ()
    """The words before the numbers."""
    is_prompted: bool = False
    """Whether words stand only before the first number."""
    headers: tuple[tuple[str, ...], ...] = ()
    """The words of the header that the line may be, separated in several ways."""
    named: int = 0
    """How many quantities they name."""


class Line(NamedTuple):
    """A line that is not blank; one with several rows in brackets is several of these."""

    place: int
    """In the file, from 1."""
    numbers: str
    """As Python spells them, with spaces between."""
    size: int
    """How many numbers there are."""
    kind: Kind


def width_of(rows: Sequence[Line]) -> int:
    """How many numbers most rows have."""
    return Counter(line.size for line in rows).most_common(1)[0][0]


PLAIN = Kind(ROW)
NOTHING = Kind(BLANK)

# Every repetition is possessive or bounded, so that nothing is tried twice.
EXPONENT = r"(?:[eEdD][+-]?[0-9]{1,4}+|(?<=[0-9.])[+-][0-9]{3}(?![0-9.]))"
NUMBER = rf"[+-]?+(?:(?:[0-9]++\.[0-9]*+|\.[0-9]++){EXPONENT}?+|[0-9]++(?:[eEdD][+-]?[0-9]{{1,4}}+)?+)"
# How C, Microsoft's C, Python, Fortran and spreadsheets print what is no finite number or does not fit.
NOT_FINITE = (
    r"[+-]?+(?:(?:nan(?:\([a-z0-9]{0,9}\))?+|inf(?:inity)?+|none|null)(?!\w)|1[.,]#[a-z]++[0-9]*+|\*{2,}+)"
    r"|#[\w¡/]{1,9}+[!?]"
)
TOKEN = re.compile(rf"((?=[0-9.+\-*#ni])(?<![\w.^+\-])(?:{NOT_FINITE}|{NUMBER}))(?![0-9_]|\.\S)", re.IGNORECASE)
USUAL = re.compile(r"[+-]?+[0-9.]++(?: [+-]?+[0-9.]++)*+")
LETTERLESS = re.compile(r"(?<=[0-9.])(?=[+-][0-9]{3}$)")
OTHER_SEPARATORS = re.compile(r"[\s;|&]")
TWO_POINTS = re.compile(r"\.[0-9]++\.")
DECIMAL_COMMA = re.compile(r"(?<=[0-9]),(?=[0-9])")

# Between numbers: a unit, brackets, quotes, and one separator at most, which is repeated where cells are empty.
UNIT = r"(?:\s?+(?:(?:rad|radianes|seg|s|deg|grados|J)(?!\w)|[º°])(?:/s(?:eg)?+(?!\w))?+)?+"
AROUND = r"[\s\[\](){}\"'$]*+"
BETWEEN = re.compile(rf"{UNIT}{AROUND}([,;|&:]?+){AROUND}(?:\1{AROUND}){{0,3}}")
BEFORE = re.compile(r"[\s\[\](){}\"'$#%!>|&*;/,]*+")
AFTER = re.compile(rf"{UNIT}[\s\[\](){{}}\"'$|&;,.]*+")
WORD = re.compile(r"[^\W0-9][\w'\u2032\u2019\u0307]*+")

# What stands for a space, a minus sign, a comma, or nothing at all.
SPELLINGS = (
    ("\N{MINUS SIGN}", "-"),
    ("\N{EN DASH}", "-"),
    ("\N{BOX DRAWINGS LIGHT VERTICAL}", "|"),
    ("\N{BOX DRAWINGS HEAVY VERTICAL}", "|"),
    ("\N{BOX DRAWINGS DOUBLE VERTICAL}", "|"),
    ("\N{NO-BREAK SPACE}", " "),
    ("\N{ZERO WIDTH NO-BREAK SPACE}", ""),
    ("\0", ""),
    ("\x1a", " "),
    ("{,}", ","),
)
# What is replaced in lines with these letters: colours of a terminal, types of Python, columns that touch, Fortran's repeated
# numbers, and quoted decimal commas.
WRITINGS = (
    ("\x1b", re.compile(r"\x1b\[[0-9;]{0,16}[A-Za-z]"), ""),
    ("(", re.compile(r"(?:np\.|numpy\.)?(?:float[0-9]{0,3}|int[0-9]{0,3}|Decimal)\(([^()]{0,60})\)"), r"\1"),
    ("-", re.compile(r"(?<=[0-9])(?=-[0-9]{0,9}\.[0-9])"), " "),
    ("2*", re.compile(r"(?<![\w.*])2\*([+-]?[0-9.]{1,40}(?:[eEdD][+-]?[0-9]{1,4})?)"), r"\1 \1"),
    ("3*", re.compile(r"(?<![\w.*])3\*([+-]?[0-9.]{1,40}(?:[eEdD][+-]?[0-9]{1,4})?)"), r"\1 \1 \1"),
    ('"', re.compile(r'"(\s{0,9}[+-]?[0-9]{0,40}),([0-9]{1,40}(?:[eE][+-]?[0-9]{1,4})?\s{0,9})"'), r"\1.\2"),
)
ROW_ENDS = re.compile(r"(?<=[\])}])[\s,]{0,9}(?=[\[({])")
LATEX_COMMANDS = re.compile(
    r"\\(?:(?:hline|toprule|midrule|bottomrule)(?![a-z])|(?:begin|end|cline|cmidrule)(?:\{[^{}]{0,60}\}){0,2})"
)


AT_A_TIME = 1 << 16  # letters


class Lines:
    """The lines of a text that are not blank."""

    def __init__(self, text: str) -> None:
        self._text = text
        self._kinds: dict[str, Kind] = {}

    def __iter__(self) -> Iterator[Line]:
        """Raises UnreadableError where there is more than a table has."""
        numbers = 0
        for rows, (place, text) in enumerate(_rows_of_all(self._text)):
            if rows >= MOST_LINES:
                raise UnreadableError("many lines", MOST_LINES)
            if len(text) > MOST_LETTERS:
                raise UnreadableError("long line", place, MOST_LETTERS)
            line = self._read(place, text)
            numbers += line.size
            if line.size > MOST_COLUMNS:
                raise UnreadableError("wide", place, MOST_COLUMNS)
            if numbers > MOST_NUMBERS:
                raise UnreadableError("many numbers", MOST_NUMBERS)
            if line.kind.name != BLANK:
                yield line

    def _read(self, place: int, text: str) -> Line:
        if text.isascii() and "_" not in text:
            words = text.split()
            try:
                for _ in map(float, words):
                    pass
            except ValueError:
                pass
            else:
                return Line(place, text, len(words), PLAIN if words else NOTHING)
        for spelling, plain in SPELLINGS:
            if spelling in text:
                text = text.replace(spelling, plain)
        for spelling, expression, plain in WRITINGS:
            if spelling in text:
                text = expression.sub(plain, text)
        return self._with_commas(place, text) if "," in text else self._split(place, text)

    def _with_commas(self, place: int, text: str) -> Line:
        """Commas between digits are decimal ones where something else separates the numbers."""
        decimal = DECIMAL_COMMA.sub(".", text) if OTHER_SEPARATORS.search(text.strip()) or text.count(",") == 1 else text
        if decimal == text or TWO_POINTS.search(decimal):
            return self._split(place, text)
        line = self._split(place, decimal)
        if line.kind.name == ROW and not line.kind.is_bare:
            return line
        other = self._split(place, text)
        return line if other.kind.name != ROW and line.kind.name == WORDED else other

    def _split(self, place: int, text: str) -> Line:
        parts = TOKEN.split(text)
        shape = "\0".join(parts[::2])
        kind = self._kinds.get(shape)
        if kind is None:
            if len(self._kinds) >= MOST_KINDS:
                raise UnreadableError("many kinds", MOST_KINDS)
            kind = self._kinds[shape] = _kind(parts[::2])
        numbers = " ".join(parts[1::2])
        if not USUAL.fullmatch(numbers):
            numbers = " ".join(map(_spelled, parts[1::2]))
        return Line(place, numbers, len(parts) // 2, kind)


def _rows_of_all(text: str) -> Iterator[tuple[int, str]]:
    """The place and the text of every row."""
    is_latex = "\\\\" in text
    for place, line in enumerate(_lines_of(text), start=1):
        if is_latex or "]" in line or ")" in line or "}" in line:
            yield from ((place, row) for row in _rows_of(line, is_latex))
        else:
            yield place, line


def _lines_of(text: str) -> Iterator[str]:
    """The lines of a text; some at a time, for a line alone takes more memory than its letters."""
    end = "\n" if "\n" in text else "\r"
    start = 0
    while start <= len(text):
        stop = text.find(end, start + AT_A_TIME)
        stop = len(text) if stop < 0 else stop
        part = text[start:stop]
        if end == "\n" and "\r" in part:
            part = part.replace("\r\n", "\n").replace("\r", "\n")
        yield from part.rstrip("\r").split("\n" if end == "\n" else end, MOST_LINES)
        start = stop + 1


def _rows_of(line: str, is_latex: bool) -> list[str]:
    """The rows of a line: brackets may hold several, and so may LaTeX."""
    if is_latex and "\\" in line:
        rows = LATEX_COMMANDS.sub(" ", line).split("\\\\", MOST_LINES)
        return rows if len(rows) == 1 or rows[-1].strip() else rows[:-1]
    if ROW_ENDS.search(line):
        rows = ROW_ENDS.split(line, MOST_LINES)
        if sum(len(TOKEN.findall(row, 0, MOST_LETTERS)) > 1 for row in rows[:4]) > 1:
            return rows
    return [line]


def _spelled(number: str) -> str:
    """A number as Python spells it."""
    if number[-1] not in "0123456789.":
        return "nan"
    if "#" in number:
        return "nan"
    number = number.replace("D", "e").replace("d", "e")
    return number if "e" in number or "E" in number else LETTERLESS.sub("e", number)


def _kind(parts: list[str]) -> Kind:
    """What a line is that has these parts before, between and after its numbers."""
    if len(parts) == 1:
        is_text = "..." in parts[0] or any(map(str.isalnum, parts[0]))  # else it is a rule
        return _with_headers(Kind(TEXT), parts[0]) if is_text else NOTHING
    between = [BETWEEN.fullmatch(part) for part in parts[1:-1]]
    is_clean = all(match and match[0] for match in between) and AFTER.fullmatch(parts[-1])
    separators = {match[1] for match in between if match} - {":", ""}
    found = Kind(
        ROW,
        separator="".join(sorted(separators)),
        is_bare=any(part.strip("\"'") == "," for part in parts[1:-1]),
        has_brackets=any(letter in part for part in parts for letter in "[](){}"),
        last_bracket=next((letter for part in parts[::-1] for letter in part[::-1] if letter in "[]"), ""),
        is_led=bool(BEFORE.fullmatch(parts[0])),
        fields=len(re.split(r"[\s,;|&]+", "0".join(parts).strip())),
    )
    if is_clean and found.is_led:
        return found
    labels = tuple(map(_label, parts[:-1]))
    return _with_headers(found._replace(name=WORDED, labels=labels, is_prompted=bool(is_clean)), parts[-1])


def _with_headers(kind: Kind, words: str) -> Kind:
    headers = headers_of(words)
    return kind._replace(headers=headers, named=max((len(roles_of(header)) for header in headers), default=0))


def _label(words: str) -> str:
    """The word that names the number behind it: the last one of a quantity, or else the last one."""
    found = WORD.findall(words)[::-1]
    return next((word for word in found if role_of(word)), found[0] if found else "")
