"""The marking of coursework: tables that students' programs have printed, beside what the core gives for their problems."""

from pendula.check._finding import Finding, Where
from pendula.check._judge import Judgement, judge
from pendula.check._match import match
from pendula.check._program import Problem, Start, problems
from pendula.check._table import Table, UnreadableError, decoded, read_file, tables
from pendula.check._view import Deviation

__all__ = [
    "Deviation",
    "Finding",
    "Judgement",
    "Problem",
    "Start",
    "Table",
    "UnreadableError",
    "Where",
    "decoded",
    "judge",
    "match",
    "problems",
    "read_file",
    "tables",
]
