"""`pendula solve` with friction, torque and drive, and Taylor's method."""

import json
import math

import pytest

DRIVEN = ["--theta0", "0.2", "--beta", "0.5", "--drive-amplitude", "1.35", "--drive-frequency", "0.6666666666666666"]


def numbers(table, *arguments):
    """The rows of a run, in full precision."""
    return [[float(word) for word in row] for row in table("solve", *arguments, "--precision", "full")]


def test_times_are_periods_of_the_drive(table):
    rows = numbers(table, *DRIVEN, "--every-factor", "1", "--until-factor", "3")
    assert [row[0] for row in rows] == [j * (2 * math.pi / 0.6666666666666666) for j in range(4)]


def test_times_are_small_periods_without_a_drive(table):
    assert numbers(table, "--theta0", "1", "--alpha", "4", "--torque", "0.1", "--every-factor", "1")[1][0] == math.pi


def test_rk4_and_taylor_agree_on_every_term(table):
    """Steps of 1e-4 of a period leave rk4 an error of some 1e-13."""
    every_term = [*DRIVEN, "--torque", "0.1", "--drive-phase", "30deg", "--omega0", "-1", "--every-factor", "0.1"]
    by_rk4 = numbers(table, *every_term)
    by_taylor = numbers(table, *every_term, "--method", "taylor")
    assert len(by_rk4) == len(by_taylor) == 11
    for one, other in zip(by_rk4, by_taylor, strict=True):
        assert one == pytest.approx(other, abs=1e-11)


def test_taylor_follows_the_closed_form(table):
    """tau is some 2 ln(16/κ'), κ' = cos²(1.5): an ulp of energy moves three periods by 3 (2/κ') 2.2e-16 s, at up to 2 rad/s."""
    rows = numbers(table, "--theta0", "3", "--method", "taylor", "--columns", "error", "--until-factor", "3")
    assert max(abs(row[0]) for row in rows) < 5.3e-13


def test_json_says_which_equation_was_solved(pendula):
    head = json.loads(pendula("solve", *DRIVEN, "--format", "json", "--method", "taylor").stdout.decode().splitlines()[0])
    assert (head["beta"], head["drive_amplitude"], head["tolerance"]) == (0.5, 1.35, 1e-15)
    assert "k" not in head


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (
            ["--beta", "0.1", "--method", "exact"],
            "method exact needs a pendulum without friction, torque, drive and shaken pivot",
        ),
        (
            ["--torque", "1", "--columns", "t,sine"],
            "method exact (--columns sine) needs a pendulum without friction, torque, drive and shaken pivot",
        ),
        (["--beta", "0.1", "--method", "verlet"], "method verlet needs a pendulum without friction"),
        (["--pivot-amplitude", "1", "--drive-frequency", "1", "--method", "exact"], "method exact needs a pendulum without"),
        (
            ["--drive-amplitude", "1"],
            "a drive or a shaken pivot needs a frequency: --drive-frequency must be positive and finite, got 0",
        ),
        (
            ["--pivot-amplitude", "1"],
            "a drive or a shaken pivot needs a frequency: --drive-frequency must be positive and finite, got 0",
        ),
        (["--beta", "-1"], '--beta "-1" must be finite and not negative, got -1'),
        (["--tolerance", "1e-9"], "--tolerance does not go with --method rk4"),
        (["--tolerance", "1", "--method", "taylor"], '--tolerance "1" must be between 0 and 1, both excluded, got 1'),
        (["--dt", "1", "--method", "taylor"], "--dt does not go with --method taylor"),
        (["--dt-factor", "1", "--method", "exact"], "--dt-factor does not go with --method exact"),
        (["--torque", "0:1:3"], '--torque "0:1:3": solve takes one value; ranges are for analyze and the measures'),
        (["--torque", "1:1:1"], '--torque "1:1:1": solve takes one value'),
    ],
)
def test_what_cannot_be_done_is_refused(pendula, arguments, message):
    result = pendula("solve", "--theta0", "1", *arguments)
    assert (result.returncode, result.stdout) == (2, b"")
    assert message in result.stderr.decode()


def test_a_step_too_long_for_friction_is_refused_with_the_count_that_would_do(pendula, table):
    """rk4 needs beta h <= 2.78: a row each 0.02 of 2 pi, at beta = 1e6, takes 1e6 0.02 2 pi/2.78 = 45202.6 steps."""
    stiff = ["solve", "--theta0", "1", "--beta", "1e6", "--until-factor", "0.1"]
    done = pendula(*stiff)
    assert (done.returncode, done.stdout) == (2, b"")
    assert b"steps between rows must be at least 45203" in done.stderr and b"taylor" in done.stderr
    rows = table(*stiff, "--dt", repr(0.02 * 2 * math.pi / 45203))
    assert len(rows) == 6 and all(0.9 < float(row[1]) <= 1 for row in rows)


@pytest.mark.parametrize("frequency, t", [("1e-300", "1.25664e+299"), ("1e308", "1.25664e-309")])
def test_a_motion_that_leaves_the_doubles_ends_with_status_1_and_the_row(pendula, frequency, t):
    done = pendula("solve", "--theta0", "1", "--drive-amplitude", "1", "--drive-frequency", frequency)
    assert (done.returncode, done.stdout) == (1, b"t angulo velocidad\n0 1 0\n")
    assert done.stderr.decode() == (
        f"pendula: from row 2 on, t = {t} s, the motion is out of the range of doubles; the rows before it are printed\n"
    )


@pytest.mark.parametrize("problem", ["0.0001 0.02 1 90 s 1e308 r 1", "1e300 1e300 1e300 1 r 0 r 1", "1e16 1e16 1e16 1 r 0 r 1"])
def test_a_problem_that_leaves_the_doubles_is_bad_data_of_its_line(pendula, problem):
    good = "0.01 0.5 1 1 r 0 r 1\n"
    done = pendula(text=good + problem + "\n" + good)
    assert done.returncode == 1 and b"nan" not in done.stdout and b"inf" not in done.stdout
    assert done.stdout.startswith(pendula(text=good).stdout) and done.stdout.count(b"\n\n\n") == 1
    assert done.stderr.startswith(b"pendula: problem 2, line 2: from row 2 on, t = ")
    assert b"fila 2" in pendula("--lang", "es", text=problem).stderr


def test_a_shaken_pivot_holds_the_pendulum_upright(table):
    """P^2 > 2 alpha Omega^2: Kapitza's pendulum swings about the top, without it falls."""
    upright = [
        "--theta0",
        "179deg",
        "--beta",
        "0.1",
        "--drive-frequency",
        "50",
        "--until",
        "20",
        "--every",
        "1",
        "--dt",
        "0.001",
    ]
    shaken = numbers(table, *upright, "--pivot-amplitude", "100")
    assert all(abs(theta) > math.radians(170) for _, theta, _ in shaken)
    assert any(abs(theta) < 1 for _, theta, _ in numbers(table, *upright))


def test_one_row_only_is_remarked_on(pendula):
    for arguments, text, place in (
        (["solve", "--theta0", "1", "--every", "2", "--until", "1"], "", ""),
        ([], "0.1 2 1 1 r 0 r 1", "problem 1, line 1: "),
    ):
        done = pendula(*arguments, text=text)
        assert done.returncode == 0 and done.stdout.count(b"\n") == 2
        assert done.stderr.decode() == f"pendula: {place}the time between rows is longer than the run: there is one row\n"


def test_the_closed_form_is_refused_later_than_it_is_right(pendula):
    """2^52 periods of 6.69998 s are 3.017e16 s."""
    late = ["--dt", "1e16", "--every", "1e16", "--until", "4e16"]
    for arguments in (["--method", "exact", *late[2:]], ["--columns", "t,exact", *late], ["--columns", "error", *late]):
        done = pendula("solve", "--theta0", "1", *arguments)
        assert (done.returncode, done.stdout) == (2, b"")
        assert done.stderr.decode().startswith("pendula: the closed form is right up to t = 3017")
    done = pendula("--method", "exact", text="1 1e16 2e16 1 r 0 r 1")
    assert (done.returncode, done.stdout) == (1, b"")
    assert done.stderr.startswith(b"pendula: problem 1, line 1: the closed form is right up to t = 3017")
    assert pendula("solve", "--theta0", "1", "--method", "exact", "--every", "1e16", "--until", "3e16").returncode == 0
