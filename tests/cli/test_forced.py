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
        (["--beta", "0.1", "--method", "exact"], "--method exact needs a pendulum without friction, torque and drive"),
        (["--torque", "1", "--columns", "t,sine"], "--columns sine needs a pendulum without friction, torque and drive"),
        (["--beta", "0.1", "--method", "verlet"], "--method verlet needs a pendulum without friction"),
        (["--drive-amplitude", "1"], "a drive needs a --drive-frequency above 0"),
        (["--beta", "-1"], '--beta "-1": it must be a number not less than 0'),
        (["--tolerance", "1e-9"], "--tolerance goes with --method taylor"),
        (["--tolerance", "1", "--method", "taylor"], '--tolerance "1": it must be a number between 0 and 1'),
    ],
)
def test_what_cannot_be_done_is_refused(pendula, arguments, message):
    result = pendula("solve", "--theta0", "1", *arguments)
    assert (result.returncode, result.stdout) == (2, b"")
    assert message in result.stderr.decode()
