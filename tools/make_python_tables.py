"""Writes what Python's type checkers need to know of the core: python/pendula/_core.pyi and python/pendula/_tables.py.

    .venv/bin/pip install --no-build-isolation . && .venv/bin/python tools/make_python_tables.py

after a change of the bindings or of the core's tables. A test makes both again and compares.
"""

import re
import subprocess
import sys
from pathlib import Path

from nanobind.stubgen import ReplacePattern, StubGen
from pendula import _core

PACKAGE = Path(__file__).resolve().parents[1] / "python" / "pendula"

# The values of the tables say no more than that they are tuples.
TUPLES = {"parameters": "Parameter", "measures": "Measure", "method_names": "str"}
WHOLE = {"label"}  # columns of whole numbers, which are int64

ROWS = ", [..., row]"
INTERVALS = {"finite": "", "positive": ", positive", "not_negative": ", not negative", "fraction": ", between 0 and 1"}

HEAD = '''"""The core's tables of parameters and measures as types. Written by tools/make_python_tables.py."""

from typing import NamedTuple, TypedDict

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[np.float64]


class PendulumArguments(TypedDict, total=False):
    """The parameters of pendulums: numbers, or arrays that broadcast."""

'''
VALUES = '''

class ParameterValues(NamedTuple):
    """Initial values and parameters: floats, or arrays that broadcast."""

'''


def stub() -> str:
    """nanobind's stub of the extension."""
    patterns = [
        ReplacePattern(re.compile(rf"pendula\._core\.{name}$"), [f"{name}: tuple[{item}, ...]", ""], 0)
        for name, item in TUPLES.items()
    ]
    patterns.append(ReplacePattern(re.compile(r"pendula\._core\.version$"), ["version: str", ""], 0))
    writer = StubGen(_core, patterns=patterns)
    writer.put(_core)
    return formatted(writer.get(), "_core.pyi")


def words(parameter: _core.Parameter) -> str:
    """What a parameter is, in a line."""
    return f"{parameter.symbol}: {parameter.meaning} [{parameter.unit}]{INTERVALS[parameter.interval.name]}"


def results(measure: _core.Measure) -> str:
    """A measure of several columns as a named tuple."""
    lines, fields = [], []
    for column in measure.columns:
        kind = "npt.NDArray[np.int64]" if column.name in WHOLE else "Array"
        fields.append(f"    {column.name}: {kind}\n")
        unit = "" if column.unit == "1" else f" [{column.unit}]"
        symbol = f"{column.symbol}, " if column.symbol else ""
        lines.append(f"    {column.name}: {symbol}{column.meaning}{unit}{ROWS if column.has_rows else ''}\n")
    name = measure.name.title().replace("_", "")
    meaning = measure.meaning[:1].upper() + measure.meaning[1:]
    return f'\n\nclass {name}(NamedTuple):\n    """{meaning}.\n\n{"".join(lines)}    """\n\n{"".join(fields)}'


def tables() -> str:
    """Arguments and results by name."""
    text = HEAD
    for parameter in _core.parameters:
        if not parameter.is_initial:
            text += f'    {parameter.name}: npt.ArrayLike\n    """{words(parameter)}; {parameter.default:g} if left out."""\n'
    text += VALUES
    for parameter in _core.parameters:
        text += f'    {parameter.name}: float | Array\n    """{words(parameter)}."""\n'
    for measure in _core.measures:
        if len(measure.columns) > 1:
            text += results(measure)
    return formatted(text, "_tables.py")


def formatted(text: str, name: str) -> str:
    """As ruff has it."""
    for command in (("check", "--quiet", "--select", "I", "--fix"), ("format",)):
        arguments = [sys.executable, "-m", "ruff", *command, "--no-cache", "--stdin-filename", str(PACKAGE / name)]
        text = subprocess.run(arguments, input=text, capture_output=True, text=True, check=True, encoding="utf-8").stdout
    return text


FILES = {"_core.pyi": stub, "_tables.py": tables}

if __name__ == "__main__":
    for file, make in FILES.items():
        (PACKAGE / file).write_text(make(), encoding="utf-8")
