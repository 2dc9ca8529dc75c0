"""Every program that makes a mistake is told its name, and every layout is read; check_matrix.py shows all of it."""

import check_programs
import pytest
from check_layouts import LAYOUTS, comma
from check_marking import told
from check_matrix import ROTATION, cells_of_layout, cells_of_program, right


def wrong(cells):
    return [(each.column, each.said) for each in cells if each.mark == "x"]


@pytest.mark.parametrize("name", check_programs.names("right"))
def test_a_right_program_is_right(name):
    assert wrong(cells_of_program(name)) == []


@pytest.mark.parametrize("name", check_programs.names())
def test_the_mistake_of_a_program_is_told_wherever_it_shows(name):
    cells = list(cells_of_program(name))
    assert wrong(cells) == []
    assert {each.mark for each in cells} != {"."}, "it shows nowhere"


@pytest.mark.parametrize("name", LAYOUTS)
def test_right_tables_are_right_and_mistakes_are_told_in_every_layout(name):
    assert wrong(cells_of_layout(name)) == []


def test_a_comma_that_is_decimal_and_separates_is_said():
    lines = [",".join(map(comma(6), row[:3])) for row in right(ROTATION)]
    found = told(ROTATION, "\n".join(["t,angulo,velocidad", *lines]).encode())
    assert "comma_ambiguous" in found.errors | found.remarks
