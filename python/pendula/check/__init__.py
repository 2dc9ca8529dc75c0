"""The marking of coursework: tables that students' programs have printed, beside what the core gives for their problems."""

from pendula.check._findings import Finding
from pendula.check._judge import Judgement, judge
from pendula.check._problem import Asked, Start, asked
from pendula.check._table import Table, UnreadableError, decoded, read_file, tables

__all__ = [
    "Asked",
    "Finding",
    "Judgement",
    "Start",
    "Table",
    "UnreadableError",
    "asked",
    "decoded",
    "judge",
    "read_file",
    "tables",
]
