"""The contract's types over the judge of today. To be replaced by imports of _program, _judge and _pages."""

from __future__ import annotations

import string
from typing import TYPE_CHECKING, NamedTuple

from pendula._command import BAD_DATA, RefusedError, say, solve
from pendula.check import _findings, _judge
from pendula.check._problem import Deviation, asked
from pendula.check._table import UnreadableError, columns_at, opened, placements

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from pendula.check._findings import Value
    from pendula.check._problem import Asked
    from pendula.check._table import Columns, Table

REMARK, ERROR = "remark", "error"
OWN = {
    "table_spare": (
        "The table that begins in line {line} belongs to no problem.",
        "La tabla que empieza en la línea {line} sobra.",
    ),
    "tables_exchanged": (
        "The table of problem {problem} comes in place {place}: the tables are in another order.",
        "La tabla del problema {problem} está en el lugar {place}: las tablas están en otro orden.",
    ),
}
TEXTS = {name.replace(" ", "_"): text for name, text in _findings.FINDINGS.items()} | OWN


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


class Page(NamedTuple):
    name: str
    title: str
    says: str
    looks: str
    why: str
    find: str


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
        findings.append(Finding(name.replace(" ", "_"), values, severity, where))
    return Judgement(findings, found.deviations, columns, columns.digits if columns else 6)


def match(problems: Sequence[Problem], tables: Sequence[Table]) -> tuple[list[Table | None], list[Table]]:
    few = [None] * (len(problems) - len(tables))
    return [*tables[: len(problems)], *few], list(tables[len(problems) :])


def names() -> list[str]:
    return list(TEXTS)


def page(name: str, lang: str) -> Page:
    text = say(TEXTS[name], lang, **dict.fromkeys(_fields(TEXTS[name][0]), _Blank())).split(".")[0]
    return Page(name, text, text, f"looks of {name}", f"why <{name}>", "int a = 1 / 6;  // <b>")


def as_text(page: Page) -> str:
    return "\n\n".join(page) + "\n"


def says(name: str, lang: str, values: Mapping[str, Value], digits: int) -> str:
    shown = {key: f"{value:.{digits}g}" if isinstance(value, float) else value for key, value in values.items()}
    en, es = (text.replace(":.6g", "").replace(":.2g", "") for text in TEXTS[name])
    return say((en, es), lang, **shown, regime=shown.get("k")).split(" First in")[0].split(" Se ve primero")[0]


def _fields(text: str) -> list[str]:
    return [name for _, name, _, _ in string.Formatter().parse(text) if name]


class _Blank:
    def __format__(self, spec: str) -> str:
        return "…"

    def __repr__(self) -> str:
        return "…"
