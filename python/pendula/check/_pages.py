"""What is said of each finding, and its page: what it looks like, why, how to find it in code. The texts are in findings.*.toml."""

from __future__ import annotations

import tomllib
from collections import defaultdict
from difflib import get_close_matches
from functools import cache
from importlib import resources
from textwrap import fill
from typing import TYPE_CHECKING, NamedTuple, TypeAlias

from pendula._command import BAD_USAGE, RefusedError, Text, say as say_text

if TYPE_CHECKING:
    from collections.abc import Mapping

Value: TypeAlias = float | int | str

WIDTH = 80
CODE = "    "  # what lines of code begin with; other lines of a text are paragraphs, apart by an empty line

TEXTS: dict[str, Text] = {
    "unknown": ("there is no finding {0!r}", "no hay ningún diagnóstico {0!r}"),
    "nearest": ("there is no finding {0!r}; is it {1}?", "no hay ningún diagnóstico {0!r}; ¿es {1}?"),
    "looks": ("What it looks like", "Cómo se ve"),
    "why": ("Why", "Por qué"),
    "find": ("How to find it", "Cómo encontrarlo"),
}


class Page(NamedTuple):
    """A finding's texts in a language."""

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


@cache
def _pages(lang: str) -> dict[str, Page]:
    text = resources.files("pendula.check").joinpath(f"findings.{lang}.toml").read_text("utf-8")
    return {name: Page(name, **{field: each.strip("\n") for field, each in texts.items()}) for name, texts in tomllib.loads(text).items()}


def names() -> tuple[str, ...]:
    """Of all findings."""
    return tuple(_pages("en"))


def page(name: str, lang: str) -> Page:
    """A finding's page. Raises RefusedError, with the name that is nearest, for one that there is not."""
    pages = _pages(lang)
    if name not in pages:
        nearest = get_close_matches(name, pages, n=1)
        raise RefusedError(BAD_USAGE, TEXTS["nearest" if nearest else "unknown"], name, *nearest)
    return pages[name]


def say(name: str, lang: str, values: Mapping[str, Value], digits: int) -> str:
    """A finding in words; its floats have so many significant digits."""
    shown = {key: f"{value:.{digits}g}" if isinstance(value, float) else value for key, value in values.items()}
    return page(name, lang).says.format_map(shown)


def as_text(page: Page, lang: str) -> str:
    """A page for the terminal, with dots for the values that a finding would have."""
    says = page.says.format_map(defaultdict(lambda: "…"))
    blocks = [f"{page.name}: {page.title}", says]
    for field in ("looks", "why", "find"):
        blocks += [say_text(TEXTS[field], lang).upper(), *getattr(page, field).split("\n\n")]
    return "\n\n".join(block if block.startswith(CODE) else _filled(block) for block in blocks) + "\n"


def _filled(paragraph: str) -> str:
    return fill(paragraph, WIDTH, break_long_words=False, break_on_hyphens=False)
