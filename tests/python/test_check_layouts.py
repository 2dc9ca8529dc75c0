"""A table is the same however it is laid out."""

import math

import numpy as np
import pytest
from check_layouts import LAYOUTS
from check_marking import columns_of
from pendula.check import decoded, tables

TIMES = [0.0, *(0.148326 * place for place in range(1, 30))]
OSCILLATION = [(t, math.cos(t), -math.sin(t), 1.01 * math.cos(t)) for t in TIMES]
ROTATION = [(t, math.remainder(1.3 * t, math.tau), 1.3 + 0.1 * math.cos(t), None) for t in TIMES]
SMALL = [(t, 2e-6 * math.cos(t), -2e-6 * math.sin(t), 2e-6 * math.cos(t)) for t in TIMES]
ALL = {"oscillation": OSCILLATION, "rotation": ROTATION, "small": SMALL}


def are(columns, wanted):
    """Whether columns are these rows: half a unit of the last digit is lost in printing, and bits in reading."""
    quantities = np.array([[value for value in row if value is not None] for row in wanted]).T
    return len(columns) == len(quantities) and all(
        column.values.shape == values.shape and np.all(np.abs(column.values - values) <= 0.501 * column.units + 1e-14)
        for column, values in zip(columns, quantities, strict=True)
    )


@pytest.mark.parametrize("digits", [5, 6, 10, 15])
@pytest.mark.parametrize("name", LAYOUTS)
@pytest.mark.parametrize("rows", ALL)
def test_a_table_is_read_from_every_layout(name, rows, digits):
    wanted = ALL[rows]
    found = columns_of(LAYOUTS[name](wanted, digits), wanted[0][3] is not None)
    # Where no header tells, the columns are at one of several places.
    assert any(are(columns, wanted) for columns in found)


@pytest.mark.parametrize("name", LAYOUTS)
def test_tables_one_below_another_are_told_apart(name):
    data = [LAYOUTS[name](rows, 6) for rows in (OSCILLATION, ROTATION, OSCILLATION)]
    if name == "utf_16":  # a file has one mark
        data = [data[0], *(each[2:] for each in data[1:])]
    assert [table.values.shape[0] for table in tables(*decoded(b"".join(data)))] == [len(TIMES)] * 3
