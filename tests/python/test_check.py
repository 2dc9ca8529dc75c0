"""`pendula check` on tables of the program itself, and what the whole programs of the matrix do not show."""

import numpy as np
import pytest
from check_marking import problem, told
from pendula import check

QUARTER = "0.0001 0.02 1 90 s 0 r 1"
BACKWARDS = "0.0005 0.02 1 0.5 r -0.4 r 2.5"
SEPARATRIX = "0.0001 0.02 1 0 r -2 r 1"
ROTATION = "0.0001 0.02 1 0 r 2.01 r 1"
DEGREES = "0.0002 0.01 2 20 s -100 s 9.81"
NEAR = "0.0001 0.02 1 0 r 1.99 r 1"
ALL = (QUARTER, BACKWARDS, SEPARATRIX, ROTATION, DEGREES, NEAR)


def judged(text, table):
    (found,) = check.tables(table)
    return check.judge(problem(text), found)


@pytest.mark.parametrize("precision", [4, 6, 10, "full"])
@pytest.mark.parametrize("text", ALL)
def test_the_programs_own_tables_are_right_at_any_precision(program, text, precision):
    judgement = judged(text, program("--precision", str(precision), text=text))
    assert judgement.is_right, judgement.findings
    assert all(off.right == judgement.columns.t.values.size for off in judgement.deviations.values())


@pytest.mark.parametrize("method", ["rk4", "taylor", "exact"])
def test_a_better_method_is_right_at_a_long_step(program, method):
    text = "0.05 0.1 3 2.5 r 0 r 1"
    assert judged(text, program("--method", method, text=text)).is_right


def test_one_digit_that_is_wrong_makes_a_table_wrong(program):
    text = program(text=QUARTER).replace("1.5268", "1.5267", 1)
    (finding,) = judged(QUARTER, text).findings
    assert (finding.name, finding.values) == ("wrong_cell", {"count": 1})
    assert finding.where == (4, 0.296652, "angulo", 1.5267, pytest.approx(1.5268, abs=1e-5))


@pytest.mark.parametrize("precision", ["6", "10"])
def test_euler_is_told_from_the_first_row_that_shows_it(program, precision):
    judgement = judged(BACKWARDS, program("--method", "euler", "--precision", precision, text=BACKWARDS))
    (finding,) = judgement.findings
    assert finding.name == "euler"
    assert finding.where.line == 3
    assert judgement.deviations["theta"].first_wrong == 1


def test_a_constant_is_not_right_after_the_fall_from_the_separatrix(program):
    # From some 25 τ on, rounding decides to which side a right program falls, and whatever it prints obeys the equation.
    text = "0.001 0.1 8 0 r -2 r 1"
    lines = program(text=text).splitlines()
    assert told(text, "\n".join(lines).encode()).is_right
    assert "not_judged" in told(text, "\n".join(lines).encode()).remarks
    t = [line.split()[0] for line in lines]
    garbage = [*lines[:60], *(f"{each} 1.25 0.5" for each in t[60:])]
    assert not told(text, "\n".join(garbage).encode()).is_right


def test_tables_go_to_the_problems_that_they_start_as(program):
    texts = [QUARTER, ROTATION, BACKWARDS]
    found = [check.tables(program(text=text))[0] for text in texts]
    asked = [problem(text) for text in texts]
    tables, spare = check.match(asked, [found[1], found[0], found[2]])
    assert [table is each for table, each in zip(tables, found, strict=True)] == [True] * 3
    assert spare == []
    tables, spare = check.match(asked, [found[0], found[2]])
    assert tables[1] is None
    assert tables[0] is found[0]
    assert tables[2] is found[2]
    tables, spare = check.match(asked[:2], found)
    assert len(spare) == 1
    assert spare[0] is found[2]


def test_numbers_that_are_not_finite_are_no_exception():
    table = "t angulo velocidad\n0 1e308 -1e308\n1 nan inf\n2 1e308 1e308\n"
    judgement = judged(ROTATION, table)
    assert not judgement.is_right
    assert all(
        np.isfinite(value) for finding in judgement.findings for value in finding.values.values() if isinstance(value, float)
    )


@pytest.mark.parametrize("lost", [(0, 1, 2, 3), (1, 2, 3), (1,), (0,)])
def test_a_table_without_a_number_in_any_row_has_no_numbers_where_they_should_be(program, lost):
    lines = program(text=QUARTER).splitlines()
    rows = [" ".join("nan" if place in lost else word for place, word in enumerate(line.split())) for line in lines[1:]]
    findings = judged(QUARTER, "\n".join([lines[0], *rows])).findings
    assert [(each.name, each.values) for each in findings] == [("not_numbers", {"line": 2, "count": len(rows)})]
