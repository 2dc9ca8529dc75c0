"""What the columns of a table are, by the words above them or by their order."""

from __future__ import annotations

import re
import unicodedata
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Sequence

ROLES = ("t", "theta", "omega", "sine")  # in the assignment's order
WORDS = ("t", "angulo", "velocidad", "funcionSinusoidal")

# Beginnings of words without accents and underscores; the first that fits decides.
BEGINNINGS = (
    ("sine", ("funcion", "sin", "sen", "thetasin", "thetasen", "θsin", "θsen", "fsin", "fsen")),
    ("omega", ("velocidad", "vel", "omega", "ω", "dtheta", "dθ", "thetadot", "thetap", "θp", "thetaprima")),
    ("theta", ("angulo", "ang", "theta", "θ", "tita", "phi")),
    ("t", ("tiempo", "time")),
)
LETTERS = {"t": "t", "w": "omega"}
DOT_ABOVE = "\N{COMBINING DOT ABOVE}"


def roles_of(header: Sequence[str]) -> dict[str, int]:
    """The place of each column that a word tells; the first of those of one kind."""
    places: dict[str, int] = {}
    for place, word in enumerate(header):
        role = _role(word)
        if role is not None:
            places.setdefault(role, place)
    return places


def _role(word: str) -> str | None:
    spread = unicodedata.normalize("NFD", word.lower())
    if DOT_ABOVE in spread:
        return "omega"
    plain = "".join(letter for letter in spread if not unicodedata.combining(letter)).strip("\"'$\\ ").replace("_", "")
    letters = re.sub(r"[^a-zα-ω].*$", "", plain, flags=re.DOTALL)  # what follows is a unit or an index
    for role, beginnings in BEGINNINGS:
        if letters.startswith(beginnings):
            return role
    return LETTERS.get(letters)
