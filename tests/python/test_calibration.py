"""The errors of the long-time measures, and published shares of basins, beside truths that do not come from pendula."""

from pathlib import Path

import calibration
import numpy as np
import pytest
from pendula import measure

# What is known is not estimated, so that its errors are bounds. Of the errors of means, 95 % are promised.
LEAST = dict.fromkeys(calibration.EXACT, 1.0) | {"quasi_periodic": 0.95, "chaotic": 0.95}


@pytest.fixture(scope="module")
def table():
    return calibration.read()


@pytest.fixture(scope="module", params=[calibration.mean_velocities, calibration.exponents], ids=["velocity", "exponent"])
def result(request, table):
    return request.param(table)


@pytest.mark.parametrize("group", LEAST)
def test_stated_errors_cover_the_truth(table, result, group):
    assert calibration.share(table, result, group) >= LEAST[group]


@pytest.mark.parametrize("group", LEAST)
def test_what_has_a_truth_gets_a_number(table, result, group):
    of_group = table.group == group
    settled = of_group & ~np.isin(result.kind, ["unsettled", "unbounded"])
    assert settled.sum() >= 0.9 * of_group.sum()
    assert not result.is_missing[settled].any()


@pytest.mark.parametrize("group", LEAST)
def test_a_kind_that_is_stated_is_right(table, result, group):
    stated = (table.group == group) & (table.kind != "-") & (result.kind != "unsettled")
    wrong = stated & (result.kind != table.kind)
    assert wrong.sum() <= (0 if LEAST[group] == 1 else 0.05 * stated.sum())


def test_shares_of_basins_are_those_published_for_a_constant_torque():
    """One random start in each of 100 x 100 cells: their own scatter is far below that of the 10,000 independent starts of the
    table, whose standard error is sqrt(share (1 - share)/10,000)."""
    torque, at_rest = np.loadtxt(Path(__file__).parents[1] / "data" / "basin_stability.txt", unpack=True)
    cells = np.stack(np.meshgrid(np.arange(100), np.arange(100)), axis=-1).reshape(-1, 2)
    place = (cells + np.random.default_rng(1).uniform(size=cells.shape)) / 100
    found = measure.attractors(2 * np.pi * place[:, 0], 20 * place[:, 1] - 10, beta=0.1, torque=torque[:, np.newaxis])
    rests, rotates = (found.kind == kind for kind in (measure.Kind.fixed_point, measure.Kind.rotating))
    assert (rests | rotates).all()
    for kinds, labels in zip(rests, found.label, strict=True):  # each is one attractor
        assert [len(set(labels[kinds])), len(set(labels[~kinds]))] == [1, int((~kinds).any())]
    distance = abs(rests.mean(axis=1) - at_rest)
    assert (distance <= 3 * np.sqrt(at_rest * (1 - at_rest) / 10_000)).all()
