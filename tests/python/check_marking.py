"""What pendula.check says of a table, as the tests of whole programs, layouts and random tables ask for it."""

from __future__ import annotations

import functools
import json
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

from pendula import _command
from pendula.check import Judgement, Problem, decoded, judge, problems, tables
from pendula.check._table import Column, columns_at, placements
from processes import finished

COMMAND = (sys.executable, "-c", "import sys; from pendula.check._main import main; sys.exit(main())")


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
def problem(text: str) -> Problem:
    with tempfile.TemporaryFile() as file:
        file.write(text.encode())
        file.seek(0)
        return problems(file)[0]


def told(text: str, data: bytes) -> Told:
    """What is said of a file with the table of one problem."""
    found = tables(*decoded(data))
    if len(found) != 1:
        several = frozenset({f"{len(found)}_tables"})
        return Told(several, frozenset(), (several,))
    return names(judge(problem(text), found[0]))


def told_of_several(text: str, data: bytes) -> Told:
    """What the command says of a file for several problems, whose tables it has to tell apart."""
    with tempfile.TemporaryDirectory() as folder:
        table, problems = Path(folder, "table"), Path(folder, "problems")
        table.write_bytes(data)
        problems.write_text(text)
        done = finished([*COMMAND, table, "--input", problems, "--json"], b"")
    assert not done.stderr, done.stderr.decode()
    found = list(findings_in(json.loads(done.stdout)))
    errors, remarks = (
        frozenset(each["name"] for each in found if (each["severity"] == "error") == is_error) for is_error in (True, False)
    )
    return Told(errors, remarks, tuple(frozenset({name}) for name in errors))


def findings_in(report: Any) -> Iterator[dict[str, Any]]:
    """Those in a report for machines, wherever they are."""
    inner = report.values() if isinstance(report, dict) else report if isinstance(report, list) else ()
    if isinstance(report, dict) and {"name", "severity"} <= report.keys():
        yield report
    for each in inner:
        yield from findings_in(each)


def names(judgement: Judgement) -> Told:
    errors: set[str] = set()
    remarks: set[str] = set()
    options = []
    for finding in judgement.findings:
        name = finding.name.replace(" ", "_")
        (errors if finding.severity == "error" else remarks).add(name)
        if finding.severity == "error":
            options.append(frozenset({name, *(each.name for each in getattr(finding, "alternatives", ()))}))
    return Told(frozenset(errors), frozenset(remarks), tuple(options))


def columns_of(data: bytes, oscillates: bool) -> Iterator[list[Column]]:
    """t, theta, omega and, where there is one, the sinusoid, at each place where they may rightly be in a file with one table."""
    (table,) = tables(*decoded(data))
    for mistake, places in placements(table, oscillates):
        columns = columns_at(table, places)
        if columns is not None and not mistake:
            yield [each for each in (columns.t, columns.theta, columns.omega, columns.sine) if each is not None]
