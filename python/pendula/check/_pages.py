"""What is said of each finding, and its page; the texts are in findings.en.toml and findings.es.toml."""

from __future__ import annotations

import tomllib
from collections import defaultdict
from difflib import get_close_matches
from functools import cache
from importlib import resources
from textwrap import fill
from typing import TYPE_CHECKING, NamedTuple, TypeAlias

from pendula import _command
from pendula._command import BAD_USAGE, RefusedError, Text

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping

Value: TypeAlias = float | int | str

WIDTH = 80
ENOUGH = 6  # digits of a number in a sentence
MOST_DIGITS = 17  # that tell any two doubles apart
DIGITS_OF_PI = 10  # the student has typed them, however many the table has
INDENT = "    "  # what lines of code begin with

TEXTS: dict[str, Text] = {
    "unknown": ("there is no finding {0!r}", "no hay ningún diagnóstico {0!r}"),
    "nearest": ("there is no finding {0!r}; is it {1!r}?", "no hay ningún diagnóstico {0!r}; ¿es {1!r}?"),
    "looks": ("What it looks like", "Cómo se ve"),
    "why": ("Why", "Por qué"),
    "find": ("How to find it", "Cómo encontrarlo"),
}

ENERGY: dict[Value, Text] = {
    "grows": ("grows", "crece"),
    "falls": ("falls", "baja"),
    "kept": ("is kept", "se conserva"),
    "swings": ("swings", "sube y baja"),
}

# A sentence of its own, for there may be none to tell ("?").
ORDER: Text = (
    "The errors are as large as those of a method of order {0}.",
    "Los errores son tan grandes como los de un método de orden {0}.",
)


class Page(NamedTuple):
    """A finding's texts."""

    name: str
    title: str
    """A few words."""
    says: str
    """What stands in a report, with {names} of the finding's values."""
    looks: str
    """What it looks like in the table and in the figure."""
    why: str
    """Why physics, or arithmetic, says so."""
    find: str
    """How to find it in code."""
    lang: str


def names() -> tuple[str, ...]:
    """Of all findings, in the order of the parts of a program."""
    return tuple(_pages("en"))


def page(name: str, lang: str) -> Page:
    """A finding's page. Raises RefusedError, with the nearest name, where there is none."""
    pages = _pages(lang)
    if name not in pages:
        nearest = get_close_matches(name, pages, n=1)
        raise RefusedError(BAD_USAGE, TEXTS["nearest" if nearest else "unknown"], name, *nearest)
    return pages[name]


@cache
def _pages(lang: str) -> dict[str, Page]:
    text = resources.files("pendula.check").joinpath(f"findings.{lang}.toml").read_text("utf-8")
    return {name: Page(name, **fields, lang=lang) for name, fields in tomllib.loads(text).items()}


def say(name: str, lang: str, values: Mapping[str, Value], digits: int) -> str:
    """A finding in words; its floats have so many significant digits, or ENOUGH, and more where two would look the same."""
    floats = {key: value for key, value in values.items() if isinstance(value, float)}
    several = range(min(digits, ENOUGH), MOST_DIGITS + 1)
    texts = ({key: f"{value:.{each}g}" for key, value in floats.items()} for each in several)
    told = next((each for each in texts if len({*each.values()}) == len({*floats.values()})), {})
    shown: dict[str, Value] = {**values, **told}
    if "pi" in floats:
        shown["pi"] = f"{floats['pi']:.{DIGITS_OF_PI}g}"
    if "energy" in shown:
        shown["energy"] = _command.say(ENERGY[shown["energy"]], lang)
    if "order" in shown:
        shown["order"] = "" if shown["order"] == "?" else _command.say(ORDER, lang, shown["order"])
    return page(name, lang).says.format_map(shown).rstrip()


def blocks(text: str) -> Iterator[tuple[bool, str]]:
    """The parts of a page's text: whether each is code, and the code's lines or the paragraph in one line."""
    for block in text.strip("\n").split("\n\n"):
        is_code = block.startswith(INDENT)
        yield is_code, block if is_code else " ".join(block.split())


def as_text(shown: Page) -> str:
    """A page for the terminal, with dots for the values that a finding would have."""
    parts = [f"{shown.name}: {shown.title}", _wrapped(shown.says.format_map(defaultdict(lambda: "…")))]
    for heading, text in (("looks", shown.looks), ("why", shown.why), ("find", shown.find)):
        parts.append(_command.say(TEXTS[heading], shown.lang).upper())
        parts += [block if is_code else _wrapped(block) for is_code, block in blocks(text)]
    return "\n\n".join(parts) + "\n"


def _wrapped(paragraph: str) -> str:
    return fill(paragraph, WIDTH, break_long_words=False, break_on_hyphens=False)
