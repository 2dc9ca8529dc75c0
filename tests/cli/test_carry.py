"""Carried sweeps, the jumps that end their branches, and the shares of attractors."""

import csv
import io
import itertools
import json
import math

import pytest

DRIVEN = ("--beta", "0.5", "--drive-frequency", "2/3")
JUNCTION = ("--beta", "0.2")


def output(pendula, *arguments):
    done = pendula(*arguments)
    assert (done.returncode, done.stderr) == (0, b""), arguments
    return done.stdout.decode()


def rows(pendula, *arguments):
    return list(csv.DictReader(io.StringIO(output(pendula, *arguments, "--format", "csv"))))


def test_a_current_voltage_curve_is_hysteretic(pendula):
    """At rest up to torque = alpha, where the equilibrium ends; turning down to about 4 beta/pi (Stewart and McCumber, 1968)."""
    curve = rows(pendula, "mean-velocity", *JUNCTION, "--torque", "0:1.5:31", "--carry", "both")
    up, down = ([row for row in curve if row["carry"] == carry] for carry in ("up", "down"))
    assert [row["torque"] for row in up] == [row["torque"] for row in down]  # both in the order up
    for row in up:
        assert (float(row["mean_velocity"]) == 0) == (float(row["torque"]) < 1)
    for row in down:
        assert (float(row["mean_velocity"]) == 0) == (float(row["torque"]) < 4 * 0.2 / math.pi)


def test_both_directions_are_two_blocks_of_text(pendula):
    up = output(pendula, "mean-velocity", *JUNCTION, "--torque", "0:1:3", "--carry", "up").splitlines()
    down = output(pendula, "mean-velocity", *JUNCTION, "--torque", "0:1:3", "--carry", "down").splitlines()
    both = output(pendula, "mean-velocity", *JUNCTION, "--torque", "0:1:3", "--carry", "both").splitlines()
    assert both[0] == "# carry " + up[0][2:] and up[0] == down[0]
    assert both[1:4] == ["up " + line for line in up[1:]]
    assert both[4:6] == ["", ""]  # gnuplot's index
    assert both[6:] == ["down " + line for line in down[1:]]


def test_each_starts_from_where_its_neighbour_ended(pendula):
    """From the state that is printed in full, a measure by itself gives the same bits."""
    arguments = ("mean-velocity", *DRIVEN, "--precision", "full")
    line = rows(pendula, *arguments, "--drive-amplitude", "1.35:1.36:3", "--carry", "up", "--details")
    theta, omega = "0", "0"
    for row in line:
        start = ("--theta0", theta, "--omega0", omega, "--drive-amplitude", row["drive_amplitude"])
        (alone,) = rows(pendula, *arguments, *start, "--details")
        assert alone == {name: row[name] for name in alone}
        theta, omega = row["theta"], row["omega"]


def test_lines_of_outer_ranges_are_carried_by_themselves(pendula):
    arguments = ("lyapunov", "--drive-frequency", "2/3", "--drive-amplitude", "0.9:1:3", "--carry", "down")
    both = rows(pendula, *arguments[:3], "--beta", "0.5:0.6:2", *arguments[3:])
    for beta in ("0.5", "0.6"):
        alone = rows(pendula, *arguments, "--beta", beta)
        assert [{"beta": beta} | row for row in alone] == [row for row in both if row["beta"] == beta]


@pytest.mark.parametrize("command", ["section", "mean-velocity", "lyapunov", "attractors"])
def test_bits_of_carried_sweeps_do_not_depend_on_threads(pendula, command):
    line = (*DRIVEN, "--theta0", "0:1:5", "--drive-amplitude", "1:1.05:4", "--carry", "both", "--precision", "full")
    short = ("--transient", "20", "--periods", "10") + (() if command == "section" else ("--budget", "100"))
    texts = {output(pendula, command, *line, *short, "--threads", threads) for threads in ("1", "3")}
    assert len(texts) == 1


def test_a_carried_section_follows_one_of_two_mirror_orbits(pendula):
    """Started at the bottom, each would choose anew between the orbits that the symmetry of the pendulum mirrors."""
    line = ("section", *DRIVEN, "--drive-amplitude", "1.02:1.06:41", "--transient", "60", "--periods", "1")
    thetas = [float(row["theta"]) for row in rows(pendula, *line, "--carry", "up")]
    assert len(thetas) == 41 and max(abs(b - a) for a, b in itertools.pairwise(thetas)) < 0.2


@pytest.mark.parametrize("text", ["text", "json"])
def test_the_ends_of_branches_are_located(pendula, text):
    """Up: the equilibrium ends at torque = alpha. Down: the turning ends near 4 beta/pi, with a correction of order beta^2."""
    arguments = ("mean-velocity", *JUNCTION, "--torque", "0.1:1.5:16", "--carry", "both", "--locate", "1e-4", "--format", text)
    lines = output(pendula, *arguments).splitlines()
    if text == "json":
        head, *found = map(json.loads, lines)
        assert head["carry"] == "both" and head["locate"] == 1e-4
    else:
        header = lines[0][2:].split()
        assert header == ["carry", "torque", "error", "gap", "before", "after"] and lines[2:4] == ["", ""]
        found = [dict(zip(header, line.split(), strict=True)) for line in lines[1:] if line]
    up, down = found
    assert (up["carry"], up["before"], down["carry"], down["before"]) == ("up", "fixed_point", "down", "rotating")
    assert down["after"] == "fixed_point"
    assert abs(float(up["torque"]) - 1) <= float(up["error"]) <= 1e-4
    assert float(down["torque"]) == pytest.approx(4 * 0.2 / math.pi, rel=0.02) and float(down["error"]) <= 1e-4


def test_located_jumps_stand_behind_the_outer_ranges(pendula):
    found = rows(
        pendula,
        "mean-velocity",
        "--alpha",
        "1:2:2",
        "--beta",
        "0.2",
        "--torque",
        "0.6:2.4:4",
        "--carry",
        "up",
        "--locate",
        "1e-2",
    )
    assert [row["alpha"] for row in found] == ["1", "2"]
    for row in found:
        assert abs(float(row["torque"]) - float(row["alpha"])) <= float(row["error"]) + 1e-6  # six digits are printed


def wilson(count, trials):
    """The larger distance from the share to an end of Wilson's interval: the roots p of (share - p)^2 = z^2 p (1 - p)/trials."""
    share, z2 = count / trials, 1.96**2
    a, b, c = 1 + z2 / trials, -(2 * share + z2 / trials), share**2
    root = math.sqrt(b * b - 4 * a * c)
    return max(abs((-b - root) / (2 * a) - share), abs((-b + root) / (2 * a) - share))


def test_shares_count_the_starts_that_end_on_each_attractor(pendula):
    line = ("attractors", *DRIVEN, "--theta0=-3:3:10", "--drive-amplitude", "1.06:1.07:2", "--omega0=-1:1:6")
    members = rows(pendula, *line)
    shares = rows(pendula, *line, "--shares", "--precision", "full")
    assert list(shares[0]) == [
        "drive_amplitude", "label", "kind", "period", "rotation", "theta", "omega", "members", "share", "error"
    ]  # fmt: skip
    for amplitude, period in (("1.06", "1"), ("1.07", "2")):  # mirror orbits of period 1, then doubled
        table = [row for row in shares if row["drive_amplitude"] == amplitude]
        assert [(row["label"], row["kind"], row["period"]) for row in table] == [
            ("1", "periodic", period),
            ("2", "periodic", period),
        ]
        for row in table:
            count = sum((m["drive_amplitude"], m["label"]) == (amplitude, row["label"]) for m in members)
            assert int(row["members"]) == count and float(row["share"]) == count / 60
            assert float(row["error"]) == pytest.approx(wilson(count, 60), rel=1e-12)
        assert sum(int(row["members"]) for row in table) == 60


def test_starts_on_no_attractor_are_shared_by_kind(pendula):
    done = pendula("attractors", "--torque", "0:3:2", "--theta0", "0:1:3", "--shares")
    assert (done.returncode, done.stderr) == (0, b"")
    header, *lines = done.stdout.decode().splitlines()
    assert header == "# torque label kind period rotation theta omega members share error"
    assert [line.rpartition(" ")[0] for line in lines] == [
        "0 1 fixed_point 1 0 0 0 1 0.333333",
        "0 0 conservative 0 nan nan nan 2 0.666667",
        "",
        "3 0 unbounded 0 nan nan nan 3 1",
    ]
