"""Programs that each make a mistake, and right ones, whole and in many languages: the truth that the checker is tested against."""

import functools
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path

from processes import finished

FOLDER = Path(__file__).with_suffix("")

COMPILERS: dict[str, Sequence[str]] = {
    ".c": ["gcc", "-O2"],
    ".cpp": ["g++", "-O2"],
    ".f90": ["gfortran", "-O2"],
}


def names(folder: str = "mistakes") -> list[str]:
    """Of all programs of mistakes (euler, linear+euler, rough_pi-4_digits, …) or, in the folder "right", of none."""
    return sorted(path.stem for path in (FOLDER / folder).iterdir() if path.suffix in {*COMPILERS, ".py"})


def findings(name: str) -> list[str]:
    """What is to be found in a program's tables: its name's parts, without what tells it from another program of that mistake."""
    return name.split("-")[0].split("+")


def source(name: str) -> Path:
    """The file of a program."""
    (path,) = (path for path in FOLDER.glob("*/*") if path.stem == name)
    return path


def run_program(name: str, problem: str, digits: int = 6) -> bytes:
    """What a program prints for a problem, or for several, one a line."""
    done = finished([*command(name), str(digits)], problem.encode())
    assert (done.returncode, done.stderr) == (0, b""), (name, done.stderr)
    return done.stdout


@functools.cache
def command(name: str) -> list[str | Path]:
    """What starts a program, compiled the first time that it is asked for."""
    written = source(name)
    if written.suffix == ".py":
        return [sys.executable, written]
    target = Path(binaries().name) / name
    # Fortran's modules become files of the folder that it is compiled in.
    done = finished([*COMPILERS[written.suffix], written, "-o", target, "-lm"], b"", cwd=target.parent)
    assert done.returncode == 0, done.stderr.decode()
    return [target]


@functools.cache
def binaries() -> tempfile.TemporaryDirectory[str]:
    """A folder for what is compiled, gone when Python ends."""
    return tempfile.TemporaryDirectory()
