"""Students' files: which there are, what their tables are worth, and all of a class at once."""

from __future__ import annotations

import glob
import os
import re
import signal
import sys
import unicodedata
from concurrent.futures import ProcessPoolExecutor, as_completed
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager, suppress
from multiprocessing import active_children, get_context
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from pendula._command import BAD_DATA, BAD_USAGE, DONE, RefusedError, Text
from pendula.check._finding import ERROR, Finding
from pendula.check._judge import judge
from pendula.check._match import match
from pendula.check._picture import picture
from pendula.check._table import UnreadableError, read_file

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Sequence

    from pendula.check._judge import Judgement
    from pendula.check._program import Problem
    from pendula.check._table import Table

FEW_FILES = 3  # are marked before other processes would have started
MOST_PROCESSES = 16
NUMBERS = re.compile("([0-9]+)")
TILDE = "\N{COMBINING TILDE}"

EMPTY_FOLDER: Text = ("{0!r} holds no files to mark", "{0!r} no tiene ficheros que corregir")
FAILED: Text = (
    "{0!r} could not be marked, which is a mistake of this program: {1}",
    "no se ha podido corregir {0!r}, y es un error de este programa: {1}",
)
ENDED: Text = ("a process that marks files was ended from outside", "se ha terminado desde fuera un proceso que corregía")


class Fit(NamedTuple):
    """How a column fits."""

    right: int
    """Rows that are as they should be."""
    from_exact: float


class Mark(NamedTuple):
    """What came of a problem."""

    problem: int
    """Its number, from 1."""
    expected: int
    """Rows that there should be."""
    found: int | None
    """Rows that there are; None where there is no table."""
    columns: dict[str, Fit]
    """By their roles."""
    findings: list[Finding]
    digits: int
    """Significant ones of the table."""
    is_right: bool
    picture: str = ""
    """An SVG, where it was asked for and there is something to draw."""


class Student(NamedTuple):
    """A file, and what came of it."""

    name: str
    path: str
    marks: list[Mark]
    """One for each problem; none where the file is unreadable."""
    findings: list[Finding]
    """Those of the file as a whole."""
    tables: int = 0
    """How many there are in the file."""
    unreadable: UnreadableReason | None = None

    @property
    def right(self) -> int:
        """How many tables are right."""
        return sum(mark.is_right for mark in self.marks)

    @property
    def status(self) -> int:
        """Done where all is right, else bad data; bad usage where there is nothing to mark."""
        if self.unreadable:
            return BAD_USAGE
        return DONE if self.right == len(self.marks) and not self.findings else BAD_DATA


class UnreadableReason(NamedTuple):
    """Why a file could not be marked."""

    name: str
    text: Text
    values: tuple[object, ...]


class Task(NamedTuple):
    """What each file is marked by."""

    problems: Sequence[Problem]
    strict: bool
    """Whether remarks make a table wrong."""
    draws: bool
    lang: str
    """Of the pictures."""


# Files.


def files(words: Sequence[str], others: Iterable[str]) -> tuple[list[tuple[str, str]], bool]:
    """Names and paths of the students' files, and whether they are a class: several words, a folder or a pattern.

    others: files that have another part in the command. A class has them often in its folder, and they are no student's.
    """
    if len(words) == 1 and not _is_folder(words[0]) and not _is_pattern(words[0]):
        return _named(words), False
    paths = sorted({path for word in words for path in _expanded(word)}, key=_as_people_sort)
    left_out = {_real(path) for path in others}
    return _named([path for path in paths if _real(path) not in left_out]), True


def _is_folder(word: str) -> bool:
    return word != "" and Path(word).is_dir()  # Path("") is the current folder


def _real(path: str) -> str:
    """Without links; as it is where there is no current folder any more."""
    try:
        return os.path.realpath(path)
    except OSError:
        return path


def _is_pattern(word: str) -> bool:
    return glob.has_magic(word) and not os.path.lexists(word)


def _expanded(word: str) -> list[str]:
    """The files of a folder, or of a pattern that the shell has left alone, as that of Windows does."""
    if _is_folder(word):
        found = [str(path) for path in Path(word).iterdir() if not path.is_dir() and not path.name.startswith(".")]
        if not found:
            raise RefusedError(BAD_USAGE, EMPTY_FOLDER, word)
        return found
    if _is_pattern(word):
        matching = [path for path in glob.glob(word) if not Path(path).is_dir()]  # noqa: PTH207, it may begin anywhere
        return matching or [word]
    return [word]


def _as_people_sort(path: str) -> tuple[list[list[int | str]], str]:
    """Numbers by their size, letters whether large or small, with accents or without, but for ñ, which follows n."""
    letters = unicodedata.normalize("NFD", path.casefold())
    plain = "".join(letter for letter in letters if letter == TILDE or not unicodedata.combining(letter))
    # Every second piece is a number, so that only what is alike is compared.
    pieces = (enumerate(NUMBERS.split(part)) for part in Path(plain).parts)
    return [[int(piece) if place % 2 else piece for place, piece in each] for each in pieces], path


def _named(paths: Sequence[str]) -> list[tuple[str, str]]:
    """Each file's stem; its name or its path where others have the same stem. Names are UTF-8, whatever the locale says."""
    texts = [os.fsencode(path).decode(errors="replace") for path in paths]
    stems, names = [Path(text).stem or text for text in texts], [Path(text).name for text in texts]
    named = []
    for path, text, stem, name in zip(paths, texts, stems, names, strict=True):
        named.append((stem if stems.count(stem) == 1 else name if names.count(name) == 1 else text, path))
    return named


# Marks.


def mark_file(task: Task, name: str, path: str) -> Student:
    """A student's file, marked; or why it cannot be."""
    try:
        with np.errstate(all="ignore"):  # that numbers overflow is no news of a table that means ill
            return _marked(task, name, path)
    except UnreadableError as error:
        assert error.text is not None
        unreadable = UnreadableReason(error.name, error.text, error.values)
    except Exception as error:  # one file must not lose the class
        unreadable = UnreadableReason("failed", FAILED, (path, f"{type(error).__name__}: {error}"))
    return Student(name, path, [], [], unreadable=unreadable)


def _marked(task: Task, name: str, path: str) -> Student:
    tables = read_file(path)
    matched, spare = match(task.problems, tables)
    # Tables in another order than the problems: those that are not where they would be in order.
    at = {id(table): place for place, table in enumerate(tables, start=1)}
    places = [at[id(table)] for table in matched if table is not None]
    in_order = iter(zip(places, sorted(places), strict=True))
    marks = []
    for number, (problem, table) in enumerate(zip(task.problems, matched, strict=True), start=1):
        place, due = (0, 0) if table is None else next(in_order)
        exchanged = [Finding("tables_exchanged", {"problem": number, "place": place})] if place != due else []
        marks.append(_mark(task, number, problem, table, exchanged))
    return Student(name, path, marks, [Finding("table_spare", {"line": int(table.lines[0])}) for table in spare], len(tables))


def _mark(task: Task, number: int, problem: Problem, table: Table | None, findings: list[Finding]) -> Mark:
    if table is None:
        return Mark(number, int(problem.rows), None, {}, [Finding("table_missing", {})], 0, False)
    judgement: Judgement = judge(problem, table)
    fits = {role: Fit(off.right, off.from_exact) for role, off in judgement.deviations.items()}
    findings = [*findings, *judgement.findings]
    is_right = all(finding.severity != ERROR and not task.strict for finding in findings)
    drawn = picture(problem, judgement, task.lang) if task.draws else ""
    return Mark(number, int(problem.rows), len(table.values), fits, findings, judgement.digits, is_right, drawn)


def mark_all(task: Task, entries: Sequence[tuple[str, str]]) -> list[Student]:
    """All files, in their order, by as many processes as there are processors."""
    workers = min(os.cpu_count() or 1, len(entries), MOST_PROCESSES)
    is_alone = workers < 2 or len(entries) <= FEW_FILES or any(path == "-" for _, path in entries)
    pool = None if is_alone else _pool(workers)
    if pool is None:
        students = []
        for place, (name, path) in enumerate(entries):
            _count(place, len(entries))
            students.append(mark_file(task, name, path))
        _count(len(entries), len(entries))
        return students
    try:
        with _without_ctrl_c():
            futures = [pool.submit(mark_file, task, *entry) for entry in entries]
        for place, future in enumerate(as_completed(futures), start=1):
            future.result()
            _count(place, len(entries))
        return [future.result() for future in futures]
    except BrokenProcessPool:
        raise RefusedError(BAD_USAGE, ENDED) from None
    except BaseException:
        for process in active_children():
            process.terminate()
        raise
    finally:
        pool.shutdown(cancel_futures=True)


def _pool(workers: int) -> ProcessPoolExecutor | None:
    """Processes that are started anew and not forked, for the core has threads; None where the system has none to give."""
    try:
        return ProcessPoolExecutor(workers, get_context("spawn"), signal.signal, (signal.SIGINT, signal.SIG_IGN))
    except (ImportError, NotImplementedError, OSError):
        return None


@contextmanager
def _without_ctrl_c() -> Iterator[None]:
    """Processes started in here leave Ctrl-C to this one, which ends them, also before they have come to ignore it."""
    if sys.platform == "win32":
        yield
        return
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def _count(done: int, files: int) -> None:
    """Tells on a terminal's standard error how many files of a class are marked, and leaves no trace there."""
    if files > 1 and sys.stderr is not None and sys.stderr.isatty():
        text = f"{done}/{files}"
        with suppress(OSError):
            os.write(2, f"\r{text if done < files else ' ' * len(text)}\r".encode())
