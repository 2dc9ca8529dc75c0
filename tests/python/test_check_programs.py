"""The programs that make a mistake run, print whole tables, and make a difference."""

import math
import re

import pytest
from check_matrix import ELSEWHERE
from check_programs import command, findings, names, run_program, source
from processes import finished

PROBLEMS = {  # and how many rows their tables have
    "0.0005 0.02 1 0.5 r -0.4 r 2.5": 51,
    "0.0002 0.01 2 20 s -100 s 9.81": 201,
    "0.0001 0.02 1 0 r 2.01 r 1": 51,
}
ALL = "\n".join(PROBLEMS) + "\n"
UNEVEN = "0.0003 0.02 1 1 r 0.5 r 2"  # 66.7 steps between rows
DIGITS = 10

# Of mistakes that are not in the numbers, but in the text or in which rows there are.
TEXT = {
    *("other_header", "no_header", "header_order", "mixed_separators", "comma_ambiguous", "no_mark_utf16", "folded_records"),
    *("brackets", "latex", "extra_text", "few_digits", "ragged", "not_numbers", "columns", "no_time", "cartesian", "swapped"),
    *("extra_columns", "table_missing", "table_spare", "tables_exchanged"),
}
ROWS = {
    *(
        "late_start",
        "starts_at_step",
        "starts_at_interval",
        "first_row_twice",
        "every_step",
        "seconds",
        "uneven_rows",
        "one_row",
    ),
    *("last_row_lost", "last_row_won", "early_end", "late_end", "tau", "period_doubled", "period_halved"),
    "interval_of_run",
    "interval_miscounted",
}


def tables(text):
    """Of a plain table or one with commas or semicolons: rows of numbers."""
    if ";" in text:
        text = text.replace(",", ".").replace(";", " ")
    blocks = re.split(r"\n\n+", text.strip().replace(",", " "))
    return [[list(map(float, line.split())) for line in block.splitlines()[1:]] for block in blocks]


def differ(one, other):
    """By more than ten units of the last digit, somewhere."""
    flat, wanted = ([x for row in table for x in row] for table in (one, other))
    return len(flat) != len(wanted) or not all(
        math.isclose(x, y, rel_tol=10.0 ** (1 - DIGITS), abs_tol=10.0**-DIGITS) for x, y in zip(flat, wanted, strict=True)
    )


@pytest.mark.parametrize("name", [name for name in names() if not {*TEXT, "interval_rounded"} & {*findings(name)}])
def test_a_program_makes_its_mistake(program, name):
    asked = "\n".join([*PROBLEMS, *ELSEWHERE.get(name, ())]) + "\n"
    found = tables(run_program(name, asked, DIGITS).decode())
    right = tables(program("--precision", str(DIGITS), text=asked))
    assert len(found) == len(right)
    if not ROWS & {*findings(name)}:
        assert [len(table) for table in found[: len(PROBLEMS)]] == [*PROBLEMS.values()]
    assert any(differ(one, other) for one, other in zip(found, right, strict=True))


def test_a_rounded_interval_shows_only_where_it_is_no_whole_number_of_steps(program):
    found = tables(run_program("interval_rounded", ALL + UNEVEN, DIGITS).decode())
    *right, uneven = tables(program("--precision", str(DIGITS), text=ALL + UNEVEN))
    assert not any(differ(one, other) for one, other in zip(found[:-1], right, strict=True))
    assert differ(found[-1], uneven)


@pytest.mark.parametrize("name", names())
def test_a_program_prints_six_digits_if_it_is_not_told_how_many(name):
    assert finished(command(name), ALL.encode()).stdout == run_program(name, ALL) != b""


@pytest.mark.parametrize("name", names())
def test_a_program_says_in_its_first_line_what_is_wrong(name):
    first = source(name).read_text("utf-8").splitlines()[0]
    assert re.match(r"(//|/\*|#|!) .{15}", first)
