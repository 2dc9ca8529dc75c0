"""Sections, mean velocities and Lyapunov exponents of ranges of pendulums."""

import json
import math
import signal
import time

import pytest
from processes import rest

PUBLISHED = ("--theta0", "0.2", "--beta", "0.5", "--drive-frequency", repr(2 / 3))
CHAOTIC = (*PUBLISHED, "--drive-amplitude", "1.5")


def output(pendula, *arguments, **options):
    done = pendula(*arguments, **options)
    assert (done.returncode, done.stderr) == (0, b"")
    return done.stdout.decode()


def test_a_section_has_a_line_for_each_point(pendula):
    text = output(pendula, "section", *PUBLISHED, "--drive-amplitude", "1.07", "--periods", "4", "--steps", "200")
    header, *lines = text.splitlines()
    points = [tuple(map(float, line.split())) for line in lines]
    assert header == "# theta omega" and len(points) == 4
    assert points[0] == points[2] != points[1] == points[3]  # period 2
    assert all(-math.pi <= theta < math.pi for theta, _ in points)


def test_ranges_multiply_in_the_order_given_and_the_last_varies_fastest(pendula):
    arguments = ("--alpha", "1", "--torque", "0:0.2:3", "--beta", "0.5:1:2", "--periods", "1", "--transient", "0")
    lines = output(pendula, "velocity", *arguments).splitlines()
    assert lines[0] == "# torque beta velocity"
    assert [line.split()[:2] for line in lines[1:]] == [
        ["0", "0.5"], ["0", "1"], [], ["0.1", "0.5"], ["0.1", "1"], [], ["0.2", "0.5"], ["0.2", "1"], []
    ]  # fmt: skip


def test_of_three_ranges_each_ends_with_an_empty_line(pendula):
    arguments = ("--beta", "0:1:2", "--torque", "0:1:2", "--omega0", "0:1:2", "--periods", "1", "--transient", "0")
    lines = output(pendula, "velocity", *arguments).splitlines()[1:]
    assert [bool(line) for line in lines] == [True, True, False, True, True, False, False] * 2


def test_a_single_range_makes_no_empty_lines(pendula):
    assert "\n\n" not in output(pendula, "section", "--theta0", "0:1:3", "--periods", "2")


def test_ranges_hold_the_doubles_of_linspace(pendula):
    lines = output(pendula, "velocity", "--torque", "0.9:1.5:61", "--beta", "1", "--precision", "full", "--periods", "1").splitlines()[1:]
    step = (1.5 - 0.9) / 60
    assert [float(line.split()[0]) for line in lines] == [0.9 + i * step for i in range(60)] + [1.5]


def test_angles_range_in_degrees_too(pendula):
    lines = output(pendula, "section", "--theta0", "-90deg:90deg:3", "--transient", "0", "--periods", "1", "--precision", "full").splitlines()
    assert [float(line.split()[0]) for line in lines[1:]] == [-math.pi / 2, 0, math.pi / 2]


def test_gravity_over_length_is_alpha(pendula):
    by_length = output(pendula, "velocity", "--gravity", "9", "--length", "1:2.25:2", "--theta0", "3", "--precision", "full")
    by_alpha = output(pendula, "velocity", "--alpha", "9:4:2", "--theta0", "3", "--precision", "full")
    assert [line.split()[1] for line in by_length.splitlines()[1:]] == [line.split()[1] for line in by_alpha.splitlines()[1:]]
    assert by_length.startswith("# length velocity\n1 ")


def test_locked_orbits_turn_once_a_period(pendula):
    text = output(pendula, "velocity", *PUBLISHED, "--drive-amplitude", "1.35:1.47:2", "--steps", "200")
    assert [abs(float(line.split()[1])) * 1.5 for line in text.splitlines()[1:]] == pytest.approx([1, 1], abs=1e-5)


def test_exponents_come_with_their_errors_and_horizons(pendula):
    text = output(pendula, "lyapunov", *PUBLISHED, "--drive-amplitude", "0.9:1.5:2", "--steps", "200", "--format", "csv")
    header, regular, chaotic = (line.split(",") for line in text.splitlines())
    assert header == ["drive_amplitude", "lyapunov", "error", "horizon"]
    assert float(regular[1]) == pytest.approx(-0.25, abs=3 * float(regular[2])) and regular[3] == "inf"
    assert float(chaotic[3]) == pytest.approx(52 * math.log(2) / float(chaotic[1]), rel=1e-4)


def test_json_is_an_object_a_line_the_measure_first(pendula):
    text = output(pendula, "lyapunov", *PUBLISHED, "--drive-amplitude", "0.9:1.5:2", "--steps", "100", "--format", "json")
    head, *rows = map(json.loads, text.splitlines())
    assert head["measure"] == "lyapunov" and head["drive_amplitude"] == [0.9, 1.5, 2] and head["beta"] == 0.5
    assert [row["drive_amplitude"] for row in rows] == [0.9, 1.5] and rows[0]["horizon"] is None


@pytest.mark.parametrize("command, periods", [("section", "5"), ("velocity", "30"), ("lyapunov", "30")])
def test_bits_depend_on_neither_threads_nor_instruction_set(pendula, command, periods):
    arguments = (command, *PUBLISHED, "--drive-amplitude", "0.9:1.5:200", "--transient", "5", "--periods", periods)
    for method in (("--steps", "100"), ("--method", "taylor")):
        texts = {
            output(pendula, *arguments, *method, "--precision", "full", "--threads", threads, env={"PENDULA_ISA": isa})
            for threads, isa in [("1", "baseline"), ("1", "avx2"), ("2", "avx512"), ("3", "baseline"), ("7", "avx2")]
        }
        assert len(texts) == 1


def test_taylor_measures_too(pendula):
    arguments = ("section", *PUBLISHED, "--drive-amplitude", "0.9", "--periods", "1", "--precision", "full")
    by_taylor = output(pendula, *arguments, "--method", "taylor", "--tolerance", "1e-15").splitlines()[1].split()
    by_rk4 = output(pendula, *arguments, "--steps", "4000").splitlines()[1].split()
    assert [float(x) for x in by_taylor] == pytest.approx([float(x) for x in by_rk4], abs=1e-11)


def test_a_long_section_goes_on_past_what_memory_is_meant_for(pendula):
    points = 2**20 + 3
    text = output(pendula, "section", "--theta0", "1", "--transient", "0", "--periods", str(points), "--steps", "4", "--threads", "1")
    assert text.count("\n") == points + 1


BAD = [
    (("section", "--drive-amplitude", "1"), "--drive-frequency must be greater than 0 where --drive-amplitude is not 0"),
    (("section", "--drive-amplitude", "0:1:3", "--drive-frequency", "0:1:3"), "--drive-frequency must be greater than 0"),
    (("velocity", "--beta", "1e300"), "rk4 is stable from 2.26014e+300 steps a period on"),
    (("velocity", "--beta", "nan"), '--beta "nan": it must be a number not less than 0'),
    (("velocity", "--beta", "0:nan:3"), '--beta "0:nan:3": it must be a number not less than 0'),
    (("velocity", "--torque", "1:2:0"), "the count must be a whole number from 1"),
    (("velocity", "--torque", "1:2:-3"), "the count must be a whole number from 1"),
    (("velocity", "--torque", "1:2:2.5"), "the count must be a whole number from 1"),
    (("velocity", "--torque", "1:2"), "it must be one value, or a range first:last:count"),
    (("velocity", "--torque", "1:2:3:4"), "it must be one value, or a range first:last:count"),
    (("velocity", "--torque", ":2:3"), "it is not a number"),
    (("velocity", "--torque=-1e308:1e308:3"), "it is wider than the doubles"),
    (("velocity", "--periods", "0"), "it must be a whole number from 1"),
    (("velocity", "--transient", "0.5"), "it must be a whole number from 0"),
    (("velocity", "--steps", "2"), "rk4 is stable from 3 steps"),
    (("velocity", "--threads", "0"), "it must be a whole number from 1 to 256"),
    (("velocity", "--method", "verlet"), '"verlet" is none of'),
    (("velocity", "--method", "taylor", "--steps", "9"), "--steps goes with --method rk4"),
    (("velocity", "--tolerance", "1e-9"), "--tolerance goes with --method taylor"),
    (("velocity", "--gravity", "9.81"), "--gravity and --length go together"),
    (("velocity", "--until", "3"), "option --until belongs to pendula solve"),
]


@pytest.mark.parametrize("arguments, message", BAD, ids=[" ".join(arguments) for arguments, _ in BAD])
def test_what_cannot_be_measured_is_bad_usage(pendula, arguments, message):
    done = pendula(*arguments)
    assert done.returncode == 2 and done.stdout == b""
    assert message in done.stderr.decode() and done.stderr.count(b"\n") == 1


@pytest.mark.parametrize(
    "arguments",
    [
        ("--steps", "1e12", "--periods", "1e12"),
        ("--beta", "1e300", "--method", "taylor"),
        ("--beta", "0:1:9999999999", "--torque", "0:1:9999999999"),
    ],
)
def test_more_steps_or_pendulums_than_2_to_53_are_too_many(pendula, arguments):
    done = pendula("velocity", *arguments)
    assert done.returncode == 1 and done.stdout == b"" and "2^53" in done.stderr.decode()


def test_complaints_are_in_spanish_too(pendula):
    done = pendula("section", "--drive-amplitude", "1", env={"LANG": "es_ES.UTF-8"})
    assert "debe ser mayor que 0 donde --drive-amplitude no sea 0" in done.stderr.decode()


@pytest.mark.parametrize("command", ["section", "velocity", "lyapunov"])
def test_a_sweep_is_interrupted_at_the_end_of_a_line(start, command):
    process = start(command, *CHAOTIC, "--torque", "0:1:100000", "--transient", "0", "--periods", "20", "--steps", "100")
    text = process.stdout.read(300)
    process.send_signal(signal.SIGINT)
    text += rest(process.stdout)
    assert process.wait(timeout=10) == 130 and rest(process.stderr) == b""
    fields = len(text.splitlines()[1].split())
    assert text.endswith(b"\n") and {len(line.split()) for line in text.splitlines()[1:]} == {fields}


def test_a_measure_of_1e12_steps_is_interrupted_at_once(start):
    process = start("velocity", *CHAOTIC, "--steps", "1e12")
    time.sleep(0.3)
    process.send_signal(signal.SIGINT)
    since = time.monotonic()
    assert process.wait(timeout=10) == 130
    assert time.monotonic() - since < 1
    assert rest(process.stdout) == b"# velocity\n"
