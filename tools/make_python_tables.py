"""Writes what Python's type checkers need to know of the core: python/pendula/_core.pyi and python/pendula/_tables.py.

    .venv/bin/pip install --no-build-isolation . && .venv/bin/python tools/make_python_tables.py

after a change of the bindings or of the core's tables. A test makes both again and compares.
"""

import re
import subprocess
import sys
from pathlib import Path

from nanobind.stubgen import ReplacePattern, StubGen
from pendula import _core, _words

PACKAGE = Path(__file__).resolve().parents[1] / "python" / "pendula"

# The values of the tables say no more than that they are tuples.
TUPLES = {"parameters": "Parameter", "measures": "Measure", "jump_columns": "ResultColumn"}
NAMES = {
    "Method": _core.method_names,
    "StrobeMethod": _core.strobe_method_names,
    "Plane": _core.plane_names,
    "Direction": _core.direction_names,
    "Carry": _words.CARRIES,
}
WHOLE = {"label"}  # columns of whole numbers, which are int64
ROWS = ", [..., row]"

HEAD = '''"""The core's tables of parameters and measures as types. Written by tools/make_python_tables.py."""

from typing import Literal, NamedTuple, TypedDict

import numpy as np
import numpy.typing as npt

from ._core import Kind

Array = npt.NDArray[np.float64]
'''


def stub() -> str:
    """nanobind's stub of the extension."""
    names = [name for name in dir(_core) if name.endswith("_names")]
    tuples = TUPLES | dict.fromkeys(names, "str")
    patterns = [
        ReplacePattern(re.compile(rf"pendula\._core\.{name}$"), [f"{name}: tuple[{item}, ...]", ""], 0)
        for name, item in tuples.items()
    ]
    patterns.append(ReplacePattern(re.compile(r"pendula\._core\.version$"), ["version: str", ""], 0))
    writer = StubGen(_core, patterns=patterns)
    writer.put(_core)
    return formatted(writer.get(), "_core.pyi")


def arguments(name: str, base: str, doc: str, fields: tuple[_words.Argument, ...], annotation: str | None = None) -> str:
    """Arguments by name as a TypedDict."""
    lines = [f'    {each.name}: {annotation or each.annotation}\n    """{each.line}."""\n' for each in fields]
    return f'\n\nclass {name}({base}, total=False):\n    """{doc}"""\n\n{"".join(lines)}'


def results(name: str) -> str:
    """The columns of a measure as a named tuple."""
    fields = []
    for column in _words.COLUMNS[name]:
        kind = "npt.NDArray[np.int64]" if column.name in WHOLE else "Kind | npt.NDArray[np.int8]" if column.is_kind else "Array"
        unit = "" if column.unit == "1" else f" [{column.unit}]"
        symbol = f"{column.symbol}, " if column.symbol else ""
        words = f"{symbol}{column.meaning}{unit}{ROWS if column.has_rows else ''}"
        if column.is_kind:
            words += "; Kind(k).name is the word for an element k"
        fields.append(f'    {column.name}: {kind}\n    """{words}."""\n')
    doc = f"What measure.{name} finds: numbers for one pendulum, arrays for several."
    return f'\n\nclass {class_name(name)}(NamedTuple):\n    """{doc}"""\n\n{"".join(fields)}'


def class_name(name: str) -> str:
    """As classes are named."""
    return name.title().replace("_", "")


def tables() -> str:
    """Arguments and results by name."""
    text = HEAD
    for name, values in NAMES.items():
        text += f"{name} = Literal[{', '.join(map(repr, values))}]\n"
    stiffness, pendulum = _words.STIFFNESS, _words.PENDULUM
    text += arguments("Stiffness", "TypedDict", "alpha, or gravity and length: numbers, or arrays that broadcast.", stiffness)
    text += arguments("FloatStiffness", "TypedDict", "alpha, or gravity and length of one pendulum.", stiffness, "float")
    text += arguments(
        "PendulumArguments",
        "Stiffness",
        "The parameters of pendulums: numbers, or arrays that broadcast.",
        tuple(each for each in pendulum if each not in stiffness),
    )
    text += (
        '\n\nclass ParameterValues(NamedTuple):\n    """Initial values and parameters: floats, or arrays that broadcast."""\n\n'
    )
    names = [each.name for each in _core.parameters]
    for each in (*_words.INITIAL, *pendulum):
        if each.name in names:
            text += f'    {each.name}: float | Array\n    """{each.meaning}."""\n'
    taken = {each.name: _words.settings_of(each.name) for each in _core.measures} | {"jumps": _words.JUMP_SETTINGS}
    for name, settings in taken.items():
        text += arguments(f"{class_name(name)}Arguments", "PendulumArguments", f"What measure.{name} takes by name.", settings)
    for name in taken:
        text += results(name)
    return formatted(text, "_tables.py")


def formatted(text: str, name: str) -> str:
    """As ruff has it."""
    for command in (("check", "--quiet", "--select", "I,C408", "--fix", "--unsafe-fixes"), ("format",)):
        arguments = [sys.executable, "-m", "ruff", *command, "--no-cache", "--stdin-filename", str(PACKAGE / name)]
        text = subprocess.run(arguments, input=text, capture_output=True, text=True, check=True, encoding="utf-8").stdout
    return text


FILES = {"_core.pyi": stub, "_tables.py": tables}

if __name__ == "__main__":
    for file, make in FILES.items():
        (PACKAGE / file).write_text(make(), encoding="utf-8")
