"""The assignment's own figures, to the byte."""

import math

import pytest

ANALYSIS = """\
0.001 0 -1 0.001 6.28319
0.5 0 -1 0.5 6.38279
1 0 -1 1 6.69998
1.5 0 -1 1.5 7.30086
2 0 -1 2 8.34975
2.5 0 -1 2.5 10.3232
3 0 -1 3 16.1555
0 2 0 3.14159 7.14932
0 -2 0 -3.14159 7.14932
0.001 2 1 3.14159 17.9744
0.01 2 1 3.14159 13.3692
0.1 2 1 3.14159 8.76067
1 2 1 3.14159 4.12642
"""

FIVE_ROWS = """\
t angulo velocidad funcionSinusoidal
0 1.5708 0 1.5708
0.148326 1.5598 -0.148324 1.55841
0.296652 1.5268 -0.296595 1.52145
0.444978 1.47183 -0.444542 1.46049
0.593304 1.39497 -0.591471 1.3765
"""

FIGURES = [
    "0.0001 0.02 1 90 s 0 r 1",
    "0.0001 0.005 1 0 r 1.999999895801368 r 1",
    "0.0001 0.02 1 0 r -2 r 1",
    "0.0001 0.02 1 0 r 2.01 r 1",
]


def test_analyze_gives_the_thirteen_rows(pendula):
    lines = [line.split() for line in ANALYSIS.splitlines()]
    done = pendula("analyze", text="".join(f"{theta} r {omega} r 1\n" for theta, omega, *_ in lines))
    assert done.stdout.decode() == "".join(" ".join(line[2:]) + "\n" for line in lines)
    assert (done.returncode, done.stderr) == (0, b"")


@pytest.mark.parametrize("line", ANALYSIS.splitlines())
def test_analyze_gives_each_row_from_options(pendula, line):
    theta, omega, *expected = line.split()
    assert pendula("analyze", "--theta0", theta, "--omega0", omega).stdout.decode().split() == expected


@pytest.mark.parametrize("line", [line for line in ANALYSIS.splitlines() if line.split()[2] != "0"])
def test_the_series_gives_the_same_rows_and_says_how_many_terms(pendula, line):
    theta, omega, *expected = line.split()
    done = pendula("analyze", "--method", "series", "--theta0", theta, "--omega0", omega)
    assert done.stdout.decode().split() == expected
    assert done.stderr.decode().startswith("pendula: the series needs ")


def test_the_five_sample_rows_are_the_assignments(pendula):
    assert pendula(text=FIGURES[0]).stdout.decode().startswith(FIVE_ROWS)


@pytest.mark.parametrize("problem, rows, columns", list(zip(FIGURES, [51, 201, 51, 51], [4, 4, 3, 3], strict=True)))
def test_each_example_has_its_rows_and_columns(table, problem, rows, columns):
    lines = table(text=problem)
    assert len(lines) == rows
    assert {len(line) for line in lines} == {columns}


def test_the_four_examples_together_are_the_four_tables_two_blank_lines_apart(pendula):
    tables = [pendula(text=problem).stdout for problem in FIGURES]
    together = pendula(text="\n".join(FIGURES))
    assert together.stdout == b"\n\n".join(tables)


def test_the_period_of_figure_2_is_12_pi(table):
    assert table(text=FIGURES[1])[-1][0] == f"{12 * math.pi:.6g}"


def test_white_space_comments_and_line_ends_do_not_matter(pendula):
    plain = pendula(text=FIGURES[0]).stdout
    for same in (
        "0.0001\n0.02\t1 90\n\n s\v0\fr 1",
        "# times\n0.0001 0.02 1# factors\n90 s#\n0 r 1 # 2 3",
        "0.0001 0.02 1 90 s 0 r 1\r\n",
        "\ufeff0.0001 0.02 1 90 s 0 r 1\n",
        "+1e-4 2.0E-2 1. +90 s -0 r .1e1",
    ):
        assert pendula(text=same).stdout == plain


def test_solve_takes_the_same_problem_from_options(pendula):
    expected = pendula(text=FIGURES[0]).stdout
    assert pendula("solve", "--theta0", "90deg").stdout == expected
    assert (
        pendula("solve", "--theta0=90deg", "--dt-factor=0.0001", "--every-factor", "0.02", "--until-factor", "1").stdout
        == expected
    )
    assert pendula("solve", "--theta0", "90deg", "--gravity", "9.81", "--length", "9.81").stdout == expected


def test_degrees_per_second_are_degrees(table):
    assert table("solve", "--theta0", "0", "--omega0", "90deg/s")[0][2] == "1.5708"
    assert table(text="0.1 0.1 1 0 r 90 s 1")[0][2] == "1.5708"


def test_zero_is_never_negative(pendula):
    for problem in ("0.01 0.25 1 -0 r -0 r 1", "0.01 0.25 2 -90 s -0 r 1", "0.01 0.25 3 0 r -1 r 1"):
        for precision in ("6", "full"):
            words = pendula(
                "--precision", precision, "--columns", "t,theta,omega,sine,exact,error,energy,turns", text=problem
            ).stdout.split()
            assert words and b"-0" not in words


def test_upright_at_rest_is_a_constant_table(table):
    rows = table("solve", "--theta0", "180deg", "--until-factor", "1")
    assert {(theta, omega) for _, theta, omega in rows} == {("-3.14159", "0")}


def test_exact_stays_on_top_for_as_long_as_one_likes(table):
    rows = table(
        "solve", "--theta0", "0", "--omega0", "-2", "--method", "exact", "--every-factor", "1e5", "--until-factor", "1e6"
    )
    assert {theta for _, theta, _ in rows[1:]} == {"-3.14159"}
