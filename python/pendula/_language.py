"""The language of messages, chosen as the program chooses it."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Sequence

LANGUAGES = ("en", "es")


def language(arguments: Sequence[str]) -> str:
    """The one of --lang, wherever it stands among the arguments, else the environment's: Spanish if it begins with "es"."""
    for argument, following in zip(arguments, (*arguments[1:], ""), strict=False):
        name, _, value = argument.partition("=")
        if name == "--lang" and (value or following) in LANGUAGES:
            return value or following
    for variable in ("LC_ALL", "LC_MESSAGES", "LANG"):
        if os.environ.get(variable):
            return "es" if os.environ[variable].startswith("es") else "en"
    return "en"
