"""The errors of the long-time measures, and published shares of basins, beside truths that do not come from pendula."""

from pathlib import Path

import calibration
import numpy as np
import pytest
from pendula import measure

# What is known is not estimated, so that its errors are bounds. Of the errors of means, 95 % are promised.
LEAST = {group: 1.0 for group in calibration.EXACT} | {"quasi_periodic": 0.95, "chaotic": 0.95}


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
