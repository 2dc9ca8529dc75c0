"""The words above columns, and which quantity each names."""

from __future__ import annotations

import re
import unicodedata
from functools import lru_cache
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Sequence

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
    plain = UNIT.sub("", plain).split(",")[0].replace("\u2032", "'").replace("\u2019", "'")
    if len(plain) > 1 and plain[0] == plain[-1] == "'":
        plain = plain[1:-1]
    letters = LETTERS.match(re.sub(r"[\s_.\-^]", "", plain))
    return next((role for role, expression in NAMES if letters and expression.match(letters[0])), "")


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
SPACED_UNIT = re.compile(r" {1,9}([(\[][^()\[\]]{0,20}[)\]])")
STRONG = re.compile(r"\t+|[;|&,]|\s{2,}")
# What follows the last of these is no longer a question for the user.
PROMPT = re.compile(
    r"[:?>=](?=\s|\w|$)|\b(?:introduzca|introduce|introducir|datos|data|enter|input|dame|escribe|tabla|table|resultados|"
    r"results|columnas|columns|valores|values|inicial|iniciales|initial|unidades|units|y(?=\s+(?:la|el|los|las|velocidad|angulo|ángulo)\b)|and|de|del|el|la|los|las|the|of)\b",
    re.IGNORECASE,
)
PAIRED_QUOTES = re.compile(r"^([\"'])(.*)\1$")
LONGEST_HEADER = 400  # letters


def headers_of(line: str) -> tuple[tuple[str, ...], ...]:
    """The words of the header that a line may be, separated in each way that names two quantities or more."""
    if len(line) > LONGEST_HEADER:
        return ()
    text = line.strip().strip("#%/!|&\\ \t[]")
    found: list[tuple[str, ...]] = []
    for part in (text, _after_prompt(text)):
        for words in (STRONG.split(part), _weakly_split(part)):
            header = tuple(PAIRED_QUOTES.sub(r"\2", word.strip()) for word in words if word.strip())
            if _is_known(header) and header not in found:
                found.append(header)
    return tuple(found) if _is_header(text) else ()


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
    joined = PHRASES.sub(lambda match: match[0].replace(" ", JOINED), SPACED_UNIT.sub(JOINED + r"\1", text))
    return [word.replace(JOINED, " ") for word in re.split(r"[\s,;|&]+", joined)]


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
