"""`pendula check` as a program: statuses, languages, reports, and inputs that mean ill."""

import json
import os
import subprocess

import pytest
from conftest import PROGRAM

PROBLEM = "0.001 0.02 1 90 s 0 r 1\n"
CLEAN = {name: value for name, value in os.environ.items() if name not in ("LC_ALL", "LC_MESSAGES", "LANG")}


@pytest.fixture
def check(tmp_path):
    """Runs `pendula check` on the bytes of a table, or on a path."""
    problem = tmp_path / "problem.txt"
    problem.write_text(PROBLEM)

    def run(table, *options, problem=problem, env=None, **more):
        if isinstance(table, bytes):
            (tmp_path / "table").write_bytes(table)
            table = tmp_path / "table"
        command = [PROGRAM, "check", table, "--input", problem, *options]
        return subprocess.run(command, capture_output=True, encoding="utf-8", env=CLEAN | (env or {}), timeout=120, **more)

    return run


@pytest.fixture
def right(program):
    return program(text=PROBLEM).encode()


def test_a_right_table_has_status_0(check, right):
    done = check(right)
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.startswith("Table 1: right\n")
    assert done.stdout.endswith("1 of 1 table right.\n")


def test_a_wrong_table_has_status_1_and_says_where(check, right):
    done = check(right.replace(b"1.5598", b"1.5599"))
    assert done.returncode == 1
    assert "line 3" in done.stdout
    assert "1.5599" in done.stdout


def test_a_remark_is_a_mistake_only_for_the_strict(check, right):
    headless = right.split(b"\n", 1)[1]
    assert check(headless).returncode == 0
    assert check(headless, "--strict").returncode == 1


@pytest.mark.parametrize(("options", "env"), [(["--lang", "es"], {}), ([], {"LANG": "es_ES.UTF-8"}), ([], {"LC_ALL": "es"})])
def test_it_speaks_the_students_language(check, right, options, env):
    assert check(right, *options, env=env).stdout.startswith("Tabla 1: bien\n")
    assert "vacío" in check(b"", *options, env=env).stderr


def test_it_reads_standard_input(check, right):
    assert check("-", input=right.decode()).returncode == 0


def test_the_report_for_machines_has_the_verdict_and_the_findings(check, right):
    report = json.loads(check(right.replace(b"1.5598", b"1.6598", 1), "--json").stdout)
    assert (report["verdict"], report["status"], report["right"], report["problems"]) == ("wrong", 1, 0, 1)
    (mark,) = report["marks"]
    assert mark["rows"] == {"expected": 51, "found": 51}
    assert mark["columns"]["omega"]["right"] == 51
    assert mark["columns"]["theta"]["right"] == 50
    assert [finding["name"] for finding in mark["findings"]] == ["wrong_cell"]


def test_the_report_for_machines_is_json_also_where_numbers_are_not_finite(check, right):
    table = right.replace(b"1.5708\n", b"nan\n", 1)
    (mark,) = json.loads(check(table, "--json").stdout, parse_constant=pytest.fail)["marks"]
    assert [finding["name"] for finding in mark["findings"]] == ["sine_not_numbers"]


def test_tables_that_are_missing_or_too_many_are_told(check, right, tmp_path):
    both = tmp_path / "both.txt"
    both.write_text(PROBLEM * 2)
    few, many = check(right, problem=both), check(right * 2)
    assert (few.returncode, many.returncode) == (1, 1)
    assert "There is no table for this problem." in few.stdout
    assert "The table that begins in line 54 belongs to none of the problems." in many.stdout
    report = json.loads(check(right * 2, "--json").stdout)
    assert (report["verdict"], report["right"]) == ("wrong", 1)
    assert [finding["name"] for finding in report["findings"]] == ["table_spare"]


@pytest.mark.parametrize(
    "data",
    [b"", b"\0" * 100, b"\xff\xfe\x00", b"hello", os.urandom(1000) + b"\0"],
    ids=["empty", "zeros", "half a character", "prose", "noise"],
)
def test_what_is_no_table_has_status_2_and_a_reason(check, data):
    done = check(data)
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr.startswith("pendula check: ")
    assert "Traceback" not in done.stderr
    assert json.loads(check(data, "--json").stdout)["verdict"] == "unreadable"


@pytest.mark.parametrize(
    "table",
    [
        b"0 nan nan\n1 inf -inf\n",
        b"0 1e300 1e300\n1 -1e300 1e300\n",
        b"1e300 1 1\n2e300 1 1\n",
        b"-5 1 2\n-4 1 2\n",
        b"0 1 2\n0 1 2\n0 1 2\n",
        b"0 1\n0 1 2 3 4 5\n" * 50,
        b"t t t t\n1 2 3 4\n",
        b"0 1 2 3 4 5 6 7 8 9\n" * 3,
        b"1e-320 5e-324 -0\n1e-310 0 0\n",
    ],
)
def test_hostile_tables_are_wrong_in_words(check, table):
    done = check(table)
    assert (done.returncode, done.stderr) == (1, "")
    assert "0 of 1 table right." in done.stdout
    assert json.loads(check(table, "--json").stdout, parse_constant=pytest.fail)["verdict"] == "wrong"


@pytest.mark.parametrize(
    "text",
    [
        "0.001 0.02 1 1 r 0 r 1e200",  # of which α² is no double
        "0.001 0.02 1 1 r 0 r 1e-200",
        "0.001 0.02 1 1e300 r 0 r 1",
        "0.001 0.02 1 1 r 1e160 r 1",
        "0.001 0.02 1 0 r 0 r 1",  # θM is 0
        "0.001 0.02 1 180 s 0 r 1",
    ],
)
def test_extreme_problems_have_wrong_tables_in_words(check, text, tmp_path):
    problem = tmp_path / "extreme.txt"
    problem.write_text(text)
    done = check(b"t angulo velocidad funcionSinusoidal\n0 1 0 3\n1 2 0 3\n", problem=problem)
    assert (done.returncode, done.stderr) == (1, "")
    assert "0 of 1 table right." in done.stdout


def test_paths_that_cannot_be_read_have_status_2(check, right, tmp_path):
    locked = tmp_path / "locked"
    locked.write_bytes(right)
    locked.chmod(0)
    empty = tmp_path / "empty"
    empty.mkdir()
    paths = [empty, tmp_path / "nowhere", *([locked] if os.geteuid() else [])]
    for path in paths:
        assert check(path).returncode == 2
        assert check(right, problem=path).returncode == 2


def test_a_table_too_large_for_coursework_is_refused(check, tmp_path):
    large = tmp_path / "large"
    with large.open("wb") as file:
        file.truncate(1 << 40)
    assert "larger than" in check(large).stderr


def test_a_problem_that_is_none_has_status_2_and_its_place(check, right, tmp_path):
    bad = tmp_path / "bad.txt"
    for text, why in [("0.001 0.02 1 90 x 0 r 1", "line 1"), ("", "holds no problem")]:
        bad.write_text(text)
        done = check(right, problem=bad)
        assert done.returncode == 2
        assert why in done.stderr
    assert "problema 1, línea 1" in check(right, "--lang", "es", problem=tmp_path / "table").stderr


def test_what_a_table_says_is_never_executed(check, tmp_path):
    trap = tmp_path / "trap"
    table = f"0 1 2\n__import__('os').mkdir('{trap}') $(mkdir {trap}) {{0.__class__}}\n=cmd|' /C calc'!A0 1 2\n"
    assert check(table.encode()).returncode == 1
    assert not trap.exists()
