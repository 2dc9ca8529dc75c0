"""What pendula.check says of a table, as the tests of whole programs, layouts and random tables ask for it."""

from __future__ import annotations

import functools
import tempfile
from collections.abc import Iterator
from typing import NamedTuple

from pendula import _command
from pendula.check import Asked, Judgement, asked, decoded, judge, tables
from pendula.check._table import Column, columns_at, placements


class Told(NamedTuple):
    """The names of findings."""

    errors: frozenset[str]
    remarks: frozenset[str]
    options: tuple[frozenset[str], ...]
    """For each error, its name and those of its alternatives."""

    @property
    def is_right(self) -> bool:
        return not self.errors


def solved(text: str, *arguments: str) -> _command.Solved:
    """What the program gives for one problem, to the last bit."""
    with tempfile.TemporaryFile() as file:
        file.write(text.encode())
        file.seek(0)
        return _command.solve(arguments, file)[0]


@functools.lru_cache(maxsize=64)
def problem(text: str) -> Asked:
    return asked(solved(text))


def told(text: str, data: bytes) -> Told:
    """What is said of a file with the table of one problem."""
    found = tables(decoded(data))
    if len(found) != 1:
        several = frozenset({f"{len(found)}_tables"})
        return Told(several, frozenset(), (several,))
    return names(judge(problem(text), found[0]))


def names(judgement: Judgement) -> Told:
    errors, remarks, options = set(), set(), []
    for finding in judgement.findings:
        name = finding.name.replace(" ", "_")
        (errors if finding.severity == "error" else remarks).add(name)
        if finding.severity == "error":
            options.append(frozenset({name, *(each.name for each in getattr(finding, "alternatives", ()))}))
    return Told(frozenset(errors), frozenset(remarks), tuple(options))


def columns_of(data: bytes, oscillates: bool) -> Iterator[list[Column]]:
    """t, theta, omega and, where there is one, the sinusoid, at each place where they may be in a file with one table."""
    (table,) = tables(decoded(data))
    for _, places in placements(table, oscillates):
        columns = columns_at(table, places)
        if columns is not None:
            yield [each for each in (columns.t, columns.theta, columns.omega, columns.sine) if each is not None]
