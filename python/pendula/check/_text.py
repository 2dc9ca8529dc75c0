"""Files and their characters, and why they cannot be read."""

from __future__ import annotations

import codecs
import os
import re
import stat
import sys
from contextlib import contextmanager, nullcontext
from select import select
from typing import TYPE_CHECKING, BinaryIO, TypeAlias

from pendula._command import BAD_USAGE, RefusedError, Text

if TYPE_CHECKING:
    from collections.abc import Iterator

    from pendula.check._finding import Value

Note: TypeAlias = "tuple[str, dict[str, Value]]"
"""The name of a finding, and its values."""

# Bounds that no coursework comes near to. They keep any file within two seconds and 200 MB.
MOST_BYTES = 1 << 23
MOST_LINES = 110_000
MOST_LETTERS = 1 << 13  # of a line
MOST_KINDS = 2_000  # of lines, numbers aside
MOST_NUMBERS = 1_000_000
MOST_COLUMNS = 64
MOST_TABLES = 1_000

UNREADABLE: dict[str, Text] = {
    "directory": ("{0!r} is a folder, not a file", "{0!r} es una carpeta, no un fichero"),
    "closed": ("standard input is closed", "la entrada estándar está cerrada"),
    "no writer": ("nobody writes to {0!r}, which is no file", "nadie escribe en {0!r}, que no es un fichero"),
    "no file": ("{0!r} does not exist", "{0!r} no existe"),
    "no permission": ("{0!r} may not be read", "no hay permiso para leer {0!r}"),
    "not read": ("{0!r} could not be read: {1}", "no se ha podido leer {0!r}: {1}"),
    "too large": ("{0!r} is larger than {1} MiB", "{0!r} ocupa más de {1} MiB"),
    "empty": ("{0!r} is empty", "{0!r} está vacío"),
    "binary": ("{0!r} is no text: it holds control characters", "{0!r} no es texto: contiene caracteres de control"),
    "many lines": ("there are more than {0} lines", "hay más de {0} líneas"),
    "long line": ("line {0} is longer than {1} characters", "la línea {0} tiene más de {1} caracteres"),
    "wide": ("line {0} has more than {1} numbers", "la línea {0} tiene más de {1} números"),
    "many numbers": ("there are more than {0} numbers", "hay más de {0} números"),
    "many kinds": (
        "this is no table but text: there are more than {0} different lines of words",
        "esto no es una tabla, sino texto: hay más de {0} líneas distintas con palabras",
    ),
    "many tables": ("there are more than {0} tables", "hay más de {0} tablas"),
    "no table": (
        "there is no table: no rows of numbers below a header or one below another",
        "no hay ninguna tabla: no tiene filas de números debajo de una cabecera ni unas debajo de otras",
    ),
    "no problems": ("the problems of {0!r} could not be read", "no se han podido leer los problemas de {0!r}"),
}


class UnreadableError(RefusedError):
    """There is nothing to mark; the name of the reason in UNREADABLE, and its values."""

    def __init__(self, name: str, *values: object) -> None:
        super().__init__(BAD_USAGE, UNREADABLE[name], *values)
        self.name = name

    def of(self, path: str) -> UnreadableError:
        """The same, said of a file by its name."""
        if path in self.values:
            return self
        assert self.text is not None
        named = UnreadableError(self.name, *self.values)
        english, spanish = (f"{{{len(self.values)}!r}}: {text}" for text in self.text)
        named.text, named.values = (english, spanish), (*self.values, path)
        return named


# Files.

MOST_SECONDS = 2  # until somebody writes to a pipe or at a terminal


def _opened(path: str, flags: int) -> int:
    """Like os.open, but does not wait for somebody who would write to a pipe or at a terminal."""
    descriptor = os.open(path, flags | os.O_NONBLOCK)
    try:
        if not stat.S_ISREG(os.fstat(descriptor).st_mode) and not _has_writer(descriptor):
            raise UnreadableError("no writer", path)
        os.set_blocking(descriptor, True)
    except BaseException:
        os.close(descriptor)
        raise
    return descriptor


def _has_writer(descriptor: int) -> bool:
    """Whether there is something to read, or somebody has the pipe open and may yet write."""
    if select([descriptor], [], [], MOST_SECONDS)[0]:
        return True
    try:
        os.read(descriptor, 1)
    except BlockingIOError:
        return stat.S_ISFIFO(os.fstat(descriptor).st_mode)
    return False


OPENER = None if sys.platform == "win32" else _opened  # Windows has no pipes among its files


@contextmanager
def opened(path: str) -> Iterator[BinaryIO]:
    """The file, or standard input for "-". Raises UnreadableError, also for what goes wrong while it is read."""
    if path == "-" and sys.stdin is None:
        raise UnreadableError("closed")
    try:
        with nullcontext(sys.stdin.buffer) if path == "-" else open(path, "rb", opener=OPENER) as file:
            yield file
    except FileNotFoundError:
        raise UnreadableError("no file", path) from None
    except IsADirectoryError:
        raise UnreadableError("directory", path) from None
    except PermissionError:
        raise UnreadableError("no permission", path) from None
    except OSError as error:
        raise UnreadableError("not read", path, error.strerror) from None
    except ValueError as error:  # a name with a zero byte
        raise UnreadableError("not read", path, error) from None


def contents(path: str) -> bytes:
    """All of a file. Raises UnreadableError."""
    with opened(path) as file:
        data = file.read(MOST_BYTES + 1)
    if len(data) > MOST_BYTES:
        raise UnreadableError("too large", path, MOST_BYTES >> 20)
    return data


SAMPLE = 4096  # bytes in which UTF-16 is looked for
MARKS = (
    (codecs.BOM_UTF32_LE, "utf-32"),
    (codecs.BOM_UTF16_LE, "utf-16"),
    (codecs.BOM_UTF16_BE, "utf-16"),
    (codecs.BOM_UTF8, "utf-8-sig"),
)
CONTROLS = re.compile(rb"[\0-\x08\x0e-\x19\x1c-\x1f]")
CONTROLS_READ = re.compile(r"[\0-\x08\x0e-\x19\x1c-\x1f]")


def _unmarked_utf16(data: bytes) -> str:
    """The encoding of UTF-16 without its mark, in which every other byte of digits is 0; "" for another one."""
    sample = data[:SAMPLE]
    for encoding, first in (("utf-16-le", 1), ("utf-16-be", 0)):
        others = sample[1 - first :: 2]
        if 4 * sample[first::2].count(0) > 3 * len(others) and others.count(0) == 0:
            return encoding
    return ""


def decoded(data: bytes, path: str = "") -> tuple[str, tuple[Note, ...]]:
    """UTF-8, UTF-16 with its mark or without, or else Latin-1, in which only letters of a header can be wrong.

    With what there is to say of it.
    """
    if not data.strip():
        raise UnreadableError("empty", path)
    marked = next((name for mark, name in MARKS if data.startswith(mark)), "")
    encoding = marked or _unmarked_utf16(data)
    if not encoding and CONTROLS.search(data):
        raise UnreadableError("binary", path)
    if encoding.startswith(("utf-16", "utf-32")):
        text = data.decode(encoding, errors="replace")
        if CONTROLS_READ.search(text):
            raise UnreadableError("binary", path)
        return text, () if marked else (("no_mark_utf16", {}),)
    try:
        return data.decode("utf-8-sig"), ()
    except UnicodeDecodeError:
        return data.decode("latin-1"), ()
