"""Columns, formats and precision: what is printed is what was computed."""

import csv
import io
import json
import math
import struct

import pytest

COLUMNS = "t,theta,omega,sine,exact,error,energy,turns"
SWING = "0.001 0.05 2 90 s 0.1 r 2\n"
ROTATION = "0.001 0.05 2 0 r 3 r 2\n"


def bits(value):
    return struct.pack("<d", value)


def records(done):
    return [json.loads(line) for line in done.stdout.splitlines()]


def test_the_default_columns_have_the_assignments_header_in_text(pendula):
    assert pendula(text=SWING).stdout.startswith(b"t angulo velocidad funcionSinusoidal\n")
    assert pendula(text=ROTATION).stdout.startswith(b"t angulo velocidad\n")


def test_csv_names_its_columns_as_the_option_does(pendula):
    assert pendula("--format", "csv", text=SWING).stdout.startswith(b"t,theta,omega,sine\n")
    assert pendula("--format", "csv", "--columns", COLUMNS, text=SWING).stdout.decode().startswith(COLUMNS + "\n")


def test_columns_come_in_the_order_asked(table):
    everything = table("--columns", COLUMNS, text=SWING)
    reordered = table("--columns", "turns,omega,t", text=SWING)
    assert reordered == [[row[7], row[2], row[0]] for row in everything]


def test_the_three_formats_hold_the_same_numbers(pendula):
    arguments = ["--columns", COLUMNS, "--precision", "full"]
    text = [[float(word) for word in line.split()] for line in pendula(*arguments, text=SWING).stdout.splitlines()[1:]]
    comma = list(csv.reader(io.StringIO(pendula(*arguments, "--format", "csv", text=SWING).stdout.decode())))[1:]
    objects = records(pendula(*arguments, "--format", "json", text=SWING))[1:]
    assert len(text) == 41
    assert text == [[float(word) for word in row] for row in comma]
    assert text == [[row[name] for name in COLUMNS.split(",")] for row in objects]


def test_full_is_the_shortest_that_reads_back_to_the_same_double(table):
    full = table("--precision", "full", "--columns", COLUMNS, text=SWING)
    seventeen = table("--precision", "17", "--columns", COLUMNS, text=SWING)
    for row, wide in zip(full, seventeen, strict=True):
        for word, digits in zip(row, wide, strict=True):
            assert bits(float(word)) == bits(float(digits))
            assert float(word) == float(repr(float(word))) and len(word) <= len(digits)


@pytest.mark.parametrize("precision", range(1, 18))
def test_precision_rounds_to_that_many_digits_as_streams_do(table, precision):
    full = table("--precision", "full", text=SWING)
    rounded = table("--precision", str(precision), text=SWING)
    assert rounded == [[f"{float(word):.{precision}g}" for word in row] for row in full]


def test_json_begins_with_the_problem_and_its_analysis(pendula):
    problem, *rows = records(pendula("--format", "json", text=SWING))
    assert problem["problem"] == 1 and problem["method"] == "rk4"
    assert (problem["alpha"], problem["theta0"], problem["omega0"]) == (2, math.pi / 2, 0.1)
    assert (problem["k"], problem["regime"]) == (-1, "oscillation")
    assert problem["rows"] == len(rows) == 41
    assert problem["every"] == 0.05 * problem["tau"] and problem["until"] == 2 * problem["tau"]
    assert problem["dt"] == 0.001 * problem["tau"]
    assert list(rows[0]) == ["t", "theta", "omega", "sine"]


def test_json_numbers_its_problems(pendula):
    done = records(pendula("--format", "json", text=SWING + ROTATION + SWING))
    assert [record["problem"] for record in done if "problem" in record] == [1, 2, 3]


def test_the_sinusoid_is_missing_where_nothing_oscillates(pendula, table):
    assert {row[1] for row in table("--columns", "t,sine", text=ROTATION)} == {"nan"}
    rows = records(pendula("--columns", "t,sine", "--format", "json", text=ROTATION))[1:]
    assert {row["sine"] for row in rows} == {None}


def test_error_is_what_theta_lacks_to_exact(table):
    for problem in (SWING, ROTATION):
        for method in ("rk4", "euler", "verlet", "exact"):
            for theta, exact, error in table(
                "--method", method, "--columns", "theta,exact,error", "--precision", "full", text=problem
            ):
                assert -math.pi <= float(error) < math.pi
                assert math.remainder(float(theta) - float(exact) - float(error), 2 * math.pi) == pytest.approx(0, abs=1e-15)


def test_exact_has_no_error_and_rk4_a_small_one(table):
    assert {row[0] for row in table("--columns", "error", "--method", "exact", text=SWING)} == {"0"}
    assert 0 < max(abs(float(row[0])) for row in table("--columns", "error", text=SWING)) < 1e-9


def test_energy_is_kept(table):
    energies = [float(row[0]) for row in table("--columns", "energy", "--precision", "full", text=SWING)]
    assert max(energies) - min(energies) < 1e-9 * energies[0]


def test_turns_count_a_rotation(table):
    rows = table("solve", "--theta0", "0", "--omega0", "-3", "--until-factor", "5", "--every-factor", "1", "--columns", "turns")
    assert [abs(int(turns) + j) for j, (turns,) in enumerate(rows)] <= [1] * 6


def test_seconds_and_factors_mean_the_same_times(table):
    rows = table("solve", "--theta0", "1", "--every", "0.25", "--until", "1", "--dt", "0.001", "--columns", "t")
    assert [row[0] for row in rows] == ["0", "0.25", "0.5", "0.75", "1"]


def test_the_last_row_is_there_though_the_times_are_rounded(table):
    assert len(table(text="0.01 0.1 1 1 r 0 r 1")) == 11
    assert len(table(text="0.01 0.3 1 1 r 0 r 1")) == 4


def test_analyze_has_the_three_formats(pendula):
    line = "90 s 0 r 1\nx\n"
    assert pendula("analyze", text=line).stdout.startswith(b"-1 1.5708 7.4163\nERROR: line 2: ")
    assert pendula("analyze", "--format", "csv", text=line).stdout.startswith(
        b"k,thetaM,tau\n-1,1.5708,7.4163\nERROR: line 2: "
    )
    good, bad = records(pendula("analyze", "--format", "json", "--precision", "full", text=line))
    assert list(good) == ["k", "regime", "thetaM", "tau"]
    assert good["thetaM"] == math.pi / 2 and good["regime"] == "oscillation"
    assert bad["error"].startswith('line 2: θ0 "x": ')


@pytest.mark.parametrize("line, regime", [("1 r 0 r 1", "oscillation"), ("0 r 2 r 1", "separatrix"), ("0 r 3 r 1", "rotation")])
def test_analyze_names_the_regime_in_json(pendula, line, regime):
    (record,) = records(pendula("analyze", "--format", "json", text=line))
    assert record["regime"] == regime


def test_analyze_goes_through_ranges_and_prints_them_as_typed(pendula):
    done = pendula("analyze", "--theta0", "60deg:90deg:2", "--omega0", "0:2:3")
    rows = [line.split() for line in done.stdout.decode().splitlines()]
    assert (done.returncode, done.stderr, rows[3]) == (0, b"", [])
    assert [row[:2] for row in rows if row] == [[theta, omega] for theta in ("60", "90") for omega in ("0", "1", "2")]
    for theta, omega, *analysis in filter(None, rows):
        alone = pendula("analyze", "--theta0", theta + "deg", "--omega0", omega)
        assert alone.stdout.decode().split() == analysis
    assert pendula("analyze", "--theta0", "1", "--alpha", "1:2:2", "--format", "csv").stdout.startswith(
        b"alpha,k,thetaM,tau\n1,-1,1,"
    )
    (first, _) = records(pendula("analyze", "--theta0", "1:2:2", "--format", "json"))
    assert list(first) == ["theta0", "k", "regime", "thetaM", "tau"]
    (first, _) = records(pendula("analyze", "--theta0", "0:9deg:2", "--omega0", "0:1:1", "--format", "json"))
    assert list(first) == ["theta0_deg", "omega0", "k", "regime", "thetaM", "tau"]


def test_analyze_goes_through_gravity_and_length(pendula):
    done = pendula("analyze", "--theta0", "1", "--gravity", "9.81", "--length", "0.5:2:4")
    by_length = [line.split() for line in done.stdout.decode().splitlines()]
    assert [row[0] for row in by_length] == ["0.5", "1", "1.5", "2"]
    for length, *analysis in by_length:
        alone = pendula("analyze", "--theta0", "1", "--alpha", f"9.81/{length}")
        assert alone.stdout.decode().split() == analysis


def test_analyze_inverts_itself(pendula):
    """The amplitude of a period has that period: its derivative is at most 1e4 rad/s here, and analyze is right to 4 ulp."""
    done = pendula("analyze", "--tau", "6.3:40:30", "--alpha", "1:2:2", "--precision", "full", "--format", "json")
    rows = records(done)
    assert (done.returncode, len(rows)) == (0, 60)
    for row in rows:
        assert row["regime"] == "oscillation"
        back = pendula("analyze", "--theta0", repr(row["thetaM"]), "--alpha", repr(row["alpha"]), "--precision", "full")
        _, amplitude, tau = map(float, back.stdout.split())
        slope = 1 / math.cos(amplitude / 2)  # of the period against the amplitude, up to a factor below 2
        assert amplitude == pytest.approx(row["thetaM"], rel=1e-15)
        assert abs(tau - row["tau"]) <= 4 * math.ulp(tau) + 4 * slope * math.ulp(amplitude)


def test_the_shortest_and_the_longest_periods_have_amplitudes(pendula):
    assert pendula("analyze", "--tau", "2pi").stdout == b"-1 0 6.28319\n"
    assert pendula("analyze", "--tau", "1e300", "--precision", "full").stdout == b"-1 3.141592653589793 1e+300\n"
    assert pendula("analyze", "--tau", "pi", "--alpha", "4").stdout == b"-1 0 3.14159\n"


def test_a_dry_run_checks_all_problems_and_prints_no_rows(pendula):
    problems = "0.0001 0.02 1 90 s 0 r 1\n1e-12 0.02 1000 0 r 2.01 r 1\n"  # the second is of 10^15 steps
    done = pendula("--dry-run", "--format", "json", text=problems)
    first, second = map(json.loads, done.stdout.splitlines())
    assert (first["k"], first["rows"], second["k"], second["rows"]) == (-1, 51, 1, 50001)
    text = pendula("--dry-run", text=problems).stdout
    assert text == b"t angulo velocidad funcionSinusoidal\n\n\nt angulo velocidad\n"
    bad = pendula("--dry-run", text=problems + "0.0001 0.02 1 90 s 0 r -1\n")
    assert bad.returncode == 1
    assert b"problem 3" in bad.stderr
    one = pendula("solve", "--theta0", "1", "--dry-run", "--format", "csv").stdout
    assert one == b"t,theta,omega,sine\n"


def test_a_dry_run_leaves_the_file_of_an_earlier_run_as_it_is(pendula, tmp_path):
    earlier = tmp_path / "earlier.csv"
    earlier.write_text("rows of hours")
    for command, text in ((("solve", "--theta0", "1"), ""), ((), "0.0001 0.02 1 90 s 0 r 1\n")):
        done = pendula(*command, "--dry-run", "--output", "earlier.csv", text=text, cwd=tmp_path)
        assert (done.returncode, done.stdout) == (0, b"t angulo velocidad funcionSinusoidal\n")
        assert b'leaves "earlier.csv" as it is' in done.stderr
        assert earlier.read_text() == "rows of hours"
    assert pendula("--dry-run", "--output", "-", text="0.0001 0.02 1 90 s 0 r 1\n").stderr == b""
