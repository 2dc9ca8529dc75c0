"""Whether the stated errors of the long-time measures cover the truths of tests/data/truths.txt.

    python tests/python/calibration.py > docs/calibration.md     (some minutes)

The truths come from tools/make_truths.py, which does not use pendula.
"""

from __future__ import annotations

import warnings
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from pendula import measure

TABLE = Path(__file__).parents[1] / "data" / "truths.txt"
NAMES = (
    "theta0", "omega0", "alpha", "beta", "torque", "drive_amplitude", "pivot_amplitude", "drive_frequency", "drive_phase",
)  # fmt: skip
TRUTHS = ("velocity", "velocity_error", "exponent", "exponent_error")
EXACT = ("fixed_point", "rotating", "conservative", "near_saddle_node", "locked")  # what is known is not estimated
LAST_ROUNDING = 2.0**-52  # of the value and of the truth, relative


@dataclass
class Table:
    group: np.ndarray
    problem: dict[str, np.ndarray]
    truth: dict[str, np.ndarray]
    kind: np.ndarray


def read() -> Table:
    rows = [line.split() for line in TABLE.read_text().splitlines() if line and not line.startswith("#")]
    group, *numbers, kind = zip(*rows, strict=True)
    columns = [np.array(column, dtype=float) for column in numbers]
    problem, truth = dict(zip(NAMES, columns, strict=False)), dict(zip(TRUTHS, columns[len(NAMES) :], strict=True))
    return Table(np.array(group), problem, truth, np.array(kind))


@dataclass
class Judged:
    """One number of every problem beside its truth."""

    value: np.ndarray
    error: np.ndarray  # as stated
    distance: np.ndarray  # from the truth; nan if the truth or the number is unknown
    is_covered: np.ndarray
    is_missing: np.ndarray  # there is a truth and no number with an error
    kind: np.ndarray


def judged(table: Table, result, value: np.ndarray, truth: str) -> Judged:
    expected = table.truth[truth]
    distance = np.abs(value - expected)
    slack = table.truth[truth + "_error"] + LAST_ROUNDING * np.abs(expected)
    is_missing = np.isfinite(expected) & ~(np.isfinite(value) & np.isfinite(result.error))
    kind = np.array([measure.Kind(k).name for k in result.kind])
    return Judged(value, result.error, distance, distance <= result.error + slack, is_missing, kind)


def mean_velocities(table: Table) -> Judged:
    result = silently(measure.mean_velocity, table)
    return judged(table, result, result.mean_velocity, "velocity")


def exponents(table: Table) -> Judged:
    result = silently(measure.lyapunov, table)
    return judged(table, result, result.exponent, "exponent")


def silently(function, table: Table):
    """Without the warning that some numbers are NaN."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", RuntimeWarning)
        return function(**table.problem)


def share(table: Table, result: Judged, group: str) -> float:
    """The share of the problems of a group, whose truth and number are known, that the stated errors cover."""
    counted = (table.group == group) & np.isfinite(result.distance) & ~result.is_missing
    return float(result.is_covered[counted].mean())


def _row(table: Table, result: Judged, group: str, name: str) -> str:
    of_group = table.group == group
    counted = of_group & np.isfinite(result.distance) & ~result.is_missing
    estimated = counted & (result.error > 0)
    ratio = result.distance[estimated] / result.error[estimated]
    numbers = ["–", "–", "–"]
    if estimated.any():
        numbers = [f"{np.median(ratio):.2g}", f"{ratio.max():.2g}", f"{np.median(result.error[estimated]):.1e}"]
    certain = of_group & (table.kind != "-")
    wrong = int((result.kind[certain] != table.kind[certain]).sum())
    unsettled = int((result.kind[of_group] == "unsettled").sum())
    cells = [group, name, counted.sum(), result.is_covered[counted].sum(), *numbers]
    cells += [(result.is_missing & of_group).sum(), certain.sum() - wrong, wrong, unsettled]
    return "| " + " | ".join(map(str, cells)) + " |"


HEAD = """\
# Calibration of the errors

The long-time measures beside the truths of `tests/data/truths.txt`. The truths are closed formulas and the results of other
integrators: `tools/make_truths.py` says how each was found. All settings are the defaults. Made by
`python tests/python/calibration.py`; held by `tests/python/test_calibration.py`.

- covered: the truth, which has a bound of its own, is within the stated error. Where the stated error is 0, it is within the last rounding, 2⁻⁵² of the value.
- median and largest ratio: of the distance from the truth to the stated error, where that is not 0. It may exceed 1 by the truth's own bound.
- not given: there is a truth, but the number or its error is NaN. These are not counted as cases.
- kinds: right and wrong where the kind is certain; unsettled ones are wrong there.

| group | measure | cases | covered | median ratio | largest ratio | median error | not given | kinds right | wrong | unsettled |
|---|---|---|---|---|---|---|---|---|---|---|"""


def main() -> None:
    table = read()
    results = {"mean velocity [rad/s]": mean_velocities(table), "exponent [s⁻¹]": exponents(table)}
    print(HEAD)
    for group in dict.fromkeys(table.group):
        for name, result in results.items():
            print(_row(table, result, group, name))


if __name__ == "__main__":
    main()
