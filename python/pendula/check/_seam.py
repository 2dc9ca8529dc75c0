"""The contract's types over the judge of today. To be replaced by imports of _program, _judge and _pages."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from pendula._command import BAD_DATA, RefusedError, solve
from pendula.check import _judge
from pendula.check._problem import Deviation, asked
from pendula.check._table import UnreadableError, columns_at, opened, placements

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from pendula.check._findings import Value
    from pendula.check._problem import Asked
    from pendula.check._table import Columns, Table

REMARK, ERROR = "remark", "error"
RENAMED = {
    "straightened": "linear",
    "other_sign_of_omega0": "omega0_sign",
    "other_sign_of_theta0": "theta0_sign",
    "root_of_alpha": "alpha_root",
    "square_of_alpha": "alpha_square",
    "alpha_of_1": "alpha_unused",
    "a_step_late": "step_late",
    "a_step_early": "step_early",
    "a_row_late": "row_late",
    "a_row_early": "row_early",
    "series_not_begun": "period_first_term",
    "times": "times_off",
}


class Where(NamedTuple):
    line: int
    t: float
    column: str
    value: float
    wanted: float


class Finding(NamedTuple):
    name: str
    values: Mapping[str, Value]
    severity: str = ERROR
    where: Where | None = None
    alternatives: tuple[Finding, ...] = ()


class Judgement(NamedTuple):
    findings: list[Finding]
    deviations: dict[str, Deviation]
    columns: Columns | None
    digits: int


class Problem(NamedTuple):
    theta0: float
    omega0: float
    alpha: float
    until: float
    tau: float
    rows: int
    asked: Asked


def problems(path: str, lang: str) -> list[Problem]:
    with opened(path) as file:
        try:
            solved = solve(["--lang", lang], file)
        except RefusedError as refused:
            if refused.status != BAD_DATA:
                raise
            raise UnreadableError("no problems", path) from None
    return [Problem(*each.start, each.until, each.tau, each.rows, each) for each in map(asked, solved)]


def judge(problem: Problem, table: Table) -> Judgement:
    found = _judge.judge(problem.asked, table)
    places = (columns_at(table, places) for _, places in placements(table, problem.asked.regime == -1))
    columns = next((each for each in places if each is not None), None) if found.deviations else None
    findings = []
    for name, values, severity in found.findings:
        where = Where(**{key: values[key] for key in Where._fields}) if "column" in values else None  # type: ignore[arg-type]
        new = name.replace(" ", "_")
        values = {"factor": "?", "order": "?", "energy": "grows"} | values
        findings.append(Finding(RENAMED.get(new, new), values, severity, where))
    return Judgement(findings, found.deviations, columns, columns.digits if columns else 6)


def match(problems: Sequence[Problem], tables: Sequence[Table]) -> tuple[list[Table | None], list[Table]]:
    few = [None] * (len(problems) - len(tables))
    return [*tables[: len(problems)], *few], list(tables[len(problems) :])
