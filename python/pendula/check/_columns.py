"""Which quantity each column holds: by the words above it, or by its place."""

from __future__ import annotations

import re
import unicodedata
from functools import lru_cache
from itertools import islice, product
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from pendula.check._digits import Floats, Integers
    from pendula.check._table import Table

ROLES = ("t", "theta", "omega", "sine")  # in the assignment's order
WORDS = ("t", "angulo", "velocidad", "funcionSinusoidal")
STATE = ROLES[:3]

# What a word names, once accents, units, quotes and underscores are cut; the first that fits decides.
# "other" are quantities that are none of the four; x and y are positions.
ANGLE = "(?:theta|θ|th|angulo|angle|ang|tita|phi|φ)"
WAVE = "(?:sin|sen|seno|sine|seno?idal|sinusoidal|sinusoide|lineal|linear|lin|small|aprox|approx|arm|armonico|harmonic|mas|shm)"
APPROXIMATION = "(?:armonic|harmonic|oscilador|aprox|approx|lineal|linear)"
NAMES = tuple(
    (role, re.compile(expression))
    for role, expression in (
        ("x", "x$"),
        ("y", "y$"),
        ("other", r"e$|e[cpktm]$|u$|energ|kinetic|potential|cinetic|potencial|total|acel|accel|alfa|alpha|error|err$|dif"),
        ("other", rf"(?:n|i|j|k)$|num|paso|step|row|fila|serie|index|tau|periodo|period|d?d?{ANGLE}''|{ANGLE}(?:m|max|0)$"),
        ("sine", rf"funcion|function|fun$|func$|f?(?:sin|sen)|{ANGLE}{WAVE}$|(?:theta|θ)s$|{APPROXIMATION}"),
        ("omega", rf"vel|omega|ω|d{ANGLE}|dot{ANGLE}|{ANGLE}(?:dot|punto|prima|prime|p$|')|rapidez|angular(?:vel|speed|rate)"),
        ("omega", r"ang(?:vel|speed)|speed|w$|v$"),
        ("theta", rf"{ANGLE}(?!ular)|angularpos|posicion|position|pos$|fi$"),
        ("t", r"tiempo|time|instant|t$|ts$|seg(?:undos)?$"),
    )
)
DOT_ABOVE = "\N{COMBINING DOT ABOVE}"
LETTERS = re.compile("[a-zα-ω']*")  # what follows is a unit or an index
UNIT = re.compile(r"[(\[][^()\[\]]{0,20}[)\]]")
LATEX = re.compile(r"\\(?:mathrm|text|math\w\w|textbf|frac|mathbf)(?![a-z])|[\\${}\"`*#%|&]")


def roles_of(header: Sequence[str]) -> dict[str, int]:
    """The place of each column whose word is known; the first of those of one kind."""
    places: dict[str, int] = {}
    for place, word in enumerate(header):
        role = role_of(word)
        if role in ROLES:
            places.setdefault(role, place)
    return places


@lru_cache(maxsize=4096)
def role_of(word: str) -> str:
    """What a word names: one of ROLES, "x", "y", "other" for quantities that are none of these, and "" for unknown words."""
    decomposed = unicodedata.normalize("NFD", word.lower()[:60])
    if DOT_ABOVE in decomposed:
        return "omega"
    plain = "".join(letter for letter in decomposed if not unicodedata.combining(letter))
    plain = LATEX.sub("", plain).strip()
    if plain.startswith("d(") and "/dt" in plain:
        plain = plain.replace("(", "").replace(")", "")
    plain = UNIT.sub("", SPACED_UNIT.sub("", plain)).split(",")[0].replace("\u2032", "'").replace("\u2019", "'")
    if len(plain) > 1 and plain[0] == plain[-1] == "'":
        plain = plain[1:-1]
    letters = LETTERS.match(re.sub(r"[\s_.\-^]", "", plain))
    return next((role for role, expression in NAMES if letters and expression.match(letters[0])), "")


def is_timeless(header: Sequence[str], width: int) -> bool:
    """Whether a header names an angle and a velocity, and of all its columns none as a time."""
    roles = roles_of(header)
    return len(header) >= width and "t" not in roles and {"theta", "omega"} <= roles.keys()


# Names of several words; what they are joined with is no space.
JOINED = "\0"
PHRASES = re.compile(
    r"""(?:velocidad|posicion|posición|aceleracion|aceleración|rapidez)[ ]+(?:angular|inicial)
      | angular[ ]+(?:velocity|speed|position|acceleration) | d[ ]?theta[ ]?/[ ]?dt
      | (?:kinetic|potential|total)[ ]+energy | energ[ií]a[ ]+(?:cin[eé]tica|potencial|total|mec[aá]nica)
      | (?:funci[oó]n|theta|[aá]ngulo|solucion|solución|oscilador|onda)[ ]+(?:seno?\b|sinusoidal|senoidal|arm[oó]nic[oa]|lineal)
      | (?:sine|sinusoidal|harmonic|small)[ ]+(?:function|wave|angle|solution)
      | (?:theta|θ|[aá]ngulo)[ ]+(?:punto|dot|prima)""",
    re.IGNORECASE | re.VERBOSE,
)
SPACED_UNIT = re.compile(
    r"""(?:[ \t]{1,9}/?[ ]? | (?<=\w)) [(\[][^()\[\]]{0,20}[)\]]
      | [ \t]{1,9}(?:/[ ]?|(?:en|in)[ ])?(?:rad|radianes|radians|grados|degrees|deg|º|°)(?:[ ]?/[ ]?s(?:eg)?)?(?![^\s,;|&])
      | [ \t]{1,9}(?:/[ ]?|(?:en|in)[ ]|(?<=\bt[ ])|(?<=tiempo[ ])|(?<=time[ ]))(?:segundos|seconds|seg|s)(?![^\s,;|&])""",
    re.IGNORECASE | re.VERBOSE,
)
STRONG = re.compile(r"\t+|[;|&,]|\s{2,}")
# What follows the last of these is no longer a question for the user.
PROMPT = re.compile(
    r"[:?>=](?=\s|\w|$)|\b(?:introduzca|introduce|introducir|datos|data|enter|input|dame|escribe|tabla|table|resultados|"
    r"results|columnas|columns|valores|values|inicial|iniciales|initial|unidades|units|y(?=\s+(?:la|el|los|las|velocidad|angulo|ángulo)\b)|and|de|del|el|la|los|las|the|of)\b",
    re.IGNORECASE,
)
PAIRED_QUOTES = re.compile(r"^([\"'])(.*)\1$")
AROUND_ALL = re.compile(r"[\[(][^\])]*(?:[\[(]|[\])]?$)")
LONGEST_HEADER = 400  # letters


def headers_of(line: str) -> tuple[tuple[str, ...], ...]:
    """The words of the header that a line may be, separated in each way that names two quantities or more."""
    if len(line) > LONGEST_HEADER:
        return ()
    text = _without_brackets(line.strip("#%/!|&\\ \t\r"))
    found: list[tuple[str, ...]] = []
    for part in (text, _after_prompt(text)):
        for words in (STRONG.split(part), _weakly_split(part)):
            header = tuple(PAIRED_QUOTES.sub(r"\2", word.strip()) for word in words if word.strip())
            if _is_known(header) and header not in found:
                found.append(header)
    return tuple(found) if _is_header(text) else ()


def _without_brackets(text: str) -> str:
    """Without those around the whole, which are not those of a unit at its ends."""
    while AROUND_ALL.match(text):
        text = text[1:-1].strip() if text[-1] in "])" else text[1:].strip()
    return text


def _after_prompt(text: str) -> str:
    ends = [match.end() for match in PROMPT.finditer(text)]
    return text[ends[-1] :].strip() if ends else text


def _is_header(text: str) -> bool:
    """Whether two quantities are named after what is asked of the user; a line that asks for them names none."""
    return _is_known(_weakly_split(_after_prompt(text)))


def _is_known(words: Sequence[str]) -> bool:
    return len({role_of(word) for word in words} - {"", "other"}) >= 2


def _weakly_split(text: str) -> list[str]:
    """Words at any separator; those of one name stay together."""
    joined = PHRASES.sub(_joined, SPACED_UNIT.sub(_joined, text))
    return [word.replace(JOINED, " ") for word in re.split(r"[\s,;|&]+", joined)]


def _joined(match: re.Match[str]) -> str:
    return match[0].replace(" ", JOINED).replace("\t", JOINED)


def fitting(headers: Sequence[tuple[str, ...]], width: int) -> tuple[str, ...]:
    """The header that has a word for each column, or else the one that names most, from its time on where it is too long."""
    if not headers:
        return ()

    def rank(header: tuple[str, ...]) -> tuple[int, int]:
        return len(roles_of(header)) + (2 if len(header) == width else 0), -abs(len(header) - width)

    header = max(headers, key=rank)
    if len(header) > width:
        first = min(roles_of(header).values())
        if first >= len(header) - width:
            return header[first:]
    return header


# Columns of a table.


class Column(NamedTuple):
    """What was printed of a quantity."""

    values: Floats
    units: Floats
    """Of the last digits."""

    def nearby(self) -> tuple[Floats, Floats, Floats]:
        """The values, and those one unit of the last digit below and above."""
        return self.values, self.values - self.units, self.values + self.units

    def at(self, rows: slice) -> Column:
        """The column in some rows."""
        return Column(self.values[rows], self.units[rows])

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
    elif is_timeless(table.header, width):
        return
    if width < len(STATE):
        return
    has_sine = oscillates and width > len(STATE)
    if not oscillates and width == len(ROLES) and (not named or "sine" in named):
        has_sine = True  # one too many
    in_order = dict(zip(ROLES[: 4 if has_sine else 3], range(width), strict=False))
    if is_named and all(named[role] == in_order[role] for role in STATE):
        in_order = named  # the header may be wrong in the order of these, not in the sinusoid's place
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
