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
    text = output(
        pendula, "section", *PUBLISHED, "--drive-amplitude", "1.07", "--periods", "4", "--method", "rk4", "--steps", "200"
    )
    header, *lines = text.splitlines()
    points = [tuple(map(float, line.split())) for line in lines]
    assert header == "# theta omega" and len(points) == 4
    assert points[0] == points[2] != points[1] == points[3]  # period 2
    assert all(-math.pi <= theta < math.pi for theta, _ in points)


def test_ranges_multiply_in_the_order_given_and_the_last_varies_fastest(pendula):
    arguments = ("--alpha", "1", "--torque", "0:0.2:3", "--beta", "0.5:1:2", "--periods", "1", "--transient", "0")
    lines = output(pendula, "mean-velocity", *arguments).splitlines()
    assert lines[0] == "# torque beta mean_velocity error"
    assert [line.split()[:2] for line in lines[1:]] == [
        ["0", "0.5"], ["0", "1"], [], ["0.1", "0.5"], ["0.1", "1"], [], ["0.2", "0.5"], ["0.2", "1"], []
    ]  # fmt: skip


def test_of_three_ranges_each_ends_with_an_empty_line(pendula):
    arguments = ("--beta", "0:1:2", "--torque", "0:1:2", "--omega0", "0:1:2", "--periods", "1", "--transient", "0")
    lines = output(pendula, "section", *arguments).splitlines()[1:]
    assert [bool(line) for line in lines] == [True, True, False, True, True, False, False] * 2


def test_a_single_range_makes_no_empty_lines(pendula):
    assert "\n\n" not in output(pendula, "section", "--theta0", "0:1:3", "--periods", "2")


def test_ranges_hold_the_doubles_of_linspace(pendula):
    lines = output(
        pendula, "mean-velocity", "--torque", "0.9:1.5:61", "--beta", "1", "--precision", "full", "--periods", "1"
    ).splitlines()[1:]
    step = (1.5 - 0.9) / 60
    assert [float(line.split()[0]) for line in lines] == [0.9 + i * step for i in range(60)] + [1.5]


def test_a_range_in_degrees_is_printed_in_degrees(pendula):
    options = ["--transient", "0", "--periods", "1", "--precision", "full"]
    header, *lines = output(pendula, "section", "--theta0", "-90deg:90deg:3", *options).splitlines()
    assert header == "# theta0_deg theta omega" and [line.split()[0] for line in lines] == ["-90", "0", "90"]
    in_radians = output(pendula, "section", "--theta0=-pi/2:pi/2:3", *options).splitlines()[1:]
    assert [line.split()[1:] for line in lines] == [line.split()[1:] for line in in_radians]


def test_gravity_over_length_is_alpha(pendula):
    by_length = output(
        pendula, "section", "--gravity", "9", "--length", "1:2.25:2", "--theta0", "3", "--periods", "1", "--precision", "full"
    )
    by_alpha = output(pendula, "section", "--alpha", "9:4:2", "--theta0", "3", "--periods", "1", "--precision", "full")
    assert [line.split()[1] for line in by_length.splitlines()[1:]] == [line.split()[1] for line in by_alpha.splitlines()[1:]]
    assert by_length.startswith("# length theta omega\n1 ")


def test_locked_orbits_turn_once_a_period(pendula):
    text = output(pendula, "mean-velocity", *PUBLISHED, "--drive-amplitude", "1.35:1.47:2", "--method", "rk4", "--steps", "200")
    assert [abs(float(line.split()[1])) * 1.5 for line in text.splitlines()[1:]] == pytest.approx([1, 1], abs=1e-5)


@pytest.mark.parametrize(
    "arguments, velocity",
    [
        # overdamped: sqrt(torque^2 - alpha^2)/beta, up to 1/beta^2 (Ambegaokar and Halperin, 1969)
        (("--beta", "100", "--torque", "1.5"), math.sqrt(1.25) / 100),
        (("--beta", "300", "--torque", "1.5"), math.sqrt(1.25) / 300),
        # the period of the limit cycle by SciPy's DOP853 with tolerances of 1e-12
        (("--beta", "10", "--torque", "1.01", "--omega0", "2.101"), 0.0141776),
        (("--beta", "0.2", "--torque", "0.26", "--omega0", "3.3"), 0.893291),
    ],
)
def test_mean_velocities_of_undriven_pendulums(pendula, arguments, velocity):
    (_, row) = output(pendula, "mean-velocity", *arguments).splitlines()
    mean, error = map(float, row.split())
    assert mean == pytest.approx(velocity, rel=1e-4 if "--omega0" not in arguments else 1e-6) and error < 1e-9 * mean


def test_details_are_further_columns_and_kinds_are_words(pendula):
    arguments = ("lyapunov", "--theta0", "0.2", "--beta", "0.5")
    (plain, row), (header, detailed) = (
        [line.split() for line in output(pendula, *arguments, *more).splitlines()] for more in ((), ("--details",))
    )
    assert plain == ["#", "lyapunov", "error", "horizon"]
    assert header == [*plain, "second", "dimension", "dimension_error", "kind", "theta", "omega"]
    assert detailed[:3] == row and detailed[6] == "fixed_point"
    assert [float(x) for x in detailed[0:4:3]] == [-0.25, -0.25]  # the real parts of the eigenvalues at the bottom
    (described,) = map(json.loads, output(pendula, *arguments, "--details", "--format", "json").splitlines()[1:])
    assert described["kind"] == "fixed_point"


def test_an_orbit_is_found_with_its_multipliers(pendula):
    """Their product is exp(-beta T), by Liouville's theorem, for any orbit."""
    arguments = (
        "orbit",
        "--theta0",
        "0.2",
        *PUBLISHED[2:],
        "--drive-amplitude",
        "1.07",
        "--orbit-period",
        "2",
        "--format",
        "json",
    )
    head, orbit = map(json.loads, output(pendula, *arguments, "--precision", "full").splitlines())
    assert head["orbit_period"] == 2 and "periods" not in head
    product = orbit["first"] * orbit["second"]
    assert product == pytest.approx(math.exp(-0.5 * 2 * 2 * math.pi * 1.5), rel=1e-6)


def test_the_strobe_may_stand_at_any_phase(pendula):
    """A quarter of a period later than phase 0, the driven linear response has moved on by the motion of that time."""
    arguments = (*PUBLISHED, "--drive-amplitude", "0.5", "--precision", "full", "--format", "json", "--periods", "1")
    rows = [
        json.loads(output(pendula, "section", *arguments, "--strobe-phase", phase).splitlines()[1]) for phase in ("0", "90deg")
    ]
    start = ("--theta0", repr(rows[0]["theta"]), "--omega0", repr(rows[0]["omega"]), *PUBLISHED[2:], "--drive-amplitude", "0.5")
    times = ("--until", "2.356194490192345", "--every", "2.356194490192345", "--method", "taylor", "--precision", "full")
    _, theta, omega = map(float, output(pendula, "solve", *start, *times).splitlines()[-1].split())
    assert (theta, omega) == pytest.approx((rows[1]["theta"], rows[1]["omega"]), abs=1e-12)


def agm(a, b):
    while abs(a - b) > 1e-15 * a:
        a, b = (a + b) / 2, math.sqrt(a * b)
    return a


@pytest.mark.parametrize("direction, crossings", [("both", (1, 3, 5)), ("falling", (1, 5, 9)), ("rising", (3, 7, 11))])
def test_a_section_by_a_plane_has_the_times_of_crossings(pendula, direction, crossings):
    """A swing passes the bottom at odd quarters of its period 2 pi/agm(1, cos(theta0/2)), with velocity 2 sin(theta0/2)."""
    arguments = (
        "--theta0",
        "1",
        "--plane",
        "theta",
        "--direction",
        direction,
        "--transient",
        "0",
        "--periods",
        "3",
        "--details",
    )
    lines = output(pendula, "section", *arguments, "--precision", "full").splitlines()
    assert lines[0] == "# theta omega turns t"
    for crossing, line in zip(crossings, lines[1:], strict=True):
        theta, omega, turns, t = map(float, line.split())
        assert t == pytest.approx(crossing / 4 * 2 * math.pi / agm(1, math.cos(0.5)), rel=1e-13)
        assert omega == pytest.approx((1 if crossing % 4 == 3 else -1) * 2 * math.sin(0.5), rel=1e-13)
        assert abs(theta) < 1e-13 and turns == 0


def test_a_plane_may_stand_at_degrees_and_at_a_velocity(pendula):
    at_angle = ("--plane", "theta", "--level", "30deg", "--periods", "1", "--format", "csv")
    assert output(pendula, "section", "--theta0", "1", *at_angle).splitlines()[1].startswith("0.523599,")
    at_velocity = ("--plane", "omega", "--level", "10deg/s", "--periods", "1", "--format", "csv")
    assert output(pendula, "section", "--theta0", "1", *at_velocity).splitlines()[1].endswith(",0.174533")


def test_a_plane_that_is_not_crossed_is_told(pendula):
    done = pendula("section", "--theta0", "1:3:2", "--plane", "theta", "--level", "2", "--periods", "2", "--budget", "30")
    assert done.returncode == 1 and len(done.stdout.splitlines()) == 5 and done.stdout.count(b"1 nan nan\n") == 2
    assert done.stderr.decode() == (
        "pendula: results are nan for 1 of 2 pendulums: they cross the plane fewer than 2 times in 30 periods (--budget)\n"
    )


def test_exponents_come_with_their_errors_and_horizons(pendula):
    text = output(
        pendula,
        "lyapunov",
        *PUBLISHED,
        "--drive-amplitude",
        "0.9:1.5:2",
        "--method",
        "rk4",
        "--steps",
        "200",
        "--format",
        "csv",
    )
    header, regular, chaotic = (line.split(",") for line in text.splitlines())
    assert header == ["drive_amplitude", "lyapunov", "error", "horizon"]
    assert float(regular[1]) == pytest.approx(-0.25, abs=float(regular[2]) + 1e-6) and regular[3] == "inf"
    assert float(chaotic[3]) == pytest.approx(52 * math.log(2) / float(chaotic[1]), rel=1e-4)


def test_json_is_an_object_a_line_the_measure_first(pendula):
    text = output(
        pendula,
        "lyapunov",
        *PUBLISHED,
        "--drive-amplitude",
        "0.9:1.5:2",
        "--method",
        "rk4",
        "--steps",
        "100",
        "--format",
        "json",
    )
    head, *rows = map(json.loads, text.splitlines())
    assert head["measure"] == "lyapunov" and head["drive_amplitude"] == [0.9, 1.5, 2] and head["beta"] == 0.5
    assert [row["drive_amplitude"] for row in rows] == [0.9, 1.5] and rows[0]["horizon"] is None


@pytest.mark.parametrize("command, periods", [("section", "5"), ("mean-velocity", "30"), ("lyapunov", "30")])
def test_bits_depend_on_neither_threads_nor_instruction_set(pendula, command, periods):
    arguments = (command, *PUBLISHED, "--drive-amplitude", "0.9:1.5:200", "--transient", "5", "--periods", periods)
    arguments += () if command == "section" else ("--budget", "50")
    for method in (("--method", "rk4", "--steps", "100"), ("--method", "taylor")):
        texts = {
            output(pendula, *arguments, *method, "--precision", "full", "--threads", threads, env={"PENDULA_ISA": isa})
            for threads, isa in [("1", "baseline"), ("1", "avx2"), ("2", "avx512"), ("3", "baseline"), ("7", "avx2")]
        }
        assert len(texts) == 1


def test_taylor_measures_too(pendula):
    arguments = ("section", *PUBLISHED, "--drive-amplitude", "0.9", "--periods", "1", "--precision", "full")
    by_taylor = output(pendula, *arguments, "--method", "taylor", "--tolerance", "1e-15").splitlines()[1].split()
    by_rk4 = output(pendula, *arguments, "--method", "rk4", "--steps", "4000").splitlines()[1].split()
    assert [float(x) for x in by_taylor] == pytest.approx([float(x) for x in by_rk4], abs=1e-11)


def test_a_long_section_goes_on_past_what_memory_is_meant_for(pendula):
    points = 2**20 + 3
    text = output(
        pendula, "section", "--theta0", "1", "--transient", "0", "--periods", str(points), "--method", "rk4", "--steps", "4"
    )
    assert text.count("\n") == points + 1


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGHUP])
@pytest.mark.parametrize("command", ["section", "mean-velocity", "lyapunov"])
def test_a_sweep_is_interrupted_at_the_end_of_a_line(start, command, number):
    short = ("--transient", "0", "--periods", "20") + (() if command == "section" else ("--budget", "20"))
    process = start(command, *CHAOTIC, "--torque", "0:1:100000", *short)
    text = process.stdout.read(300)
    process.send_signal(number)
    text += rest(process.stdout)
    assert process.wait(timeout=10) == 130 and rest(process.stderr) == b""
    fields = len(text.splitlines()[1].split())
    assert text.endswith(b"\n") and {len(line.split()) for line in text.splitlines()[1:]} == {fields}


def test_a_measure_of_1e12_steps_is_interrupted_at_once(start):
    process = start("mean-velocity", *CHAOTIC, "--method", "rk4", "--steps", "1e12")
    time.sleep(0.3)
    process.send_signal(signal.SIGINT)
    since = time.monotonic()
    assert process.wait(timeout=10) == 130
    assert time.monotonic() - since < 1
    assert rest(process.stdout) == b"# mean_velocity error\n"


def test_attractors_are_numbered_over_the_whole_sweep(pendula):
    """At 1.0 the published pendulum has two mirror orbits; starts on both sides of the top find both, 5000 of them in one call."""
    arguments = (
        "attractors",
        *PUBLISHED[2:],
        "--drive-amplitude",
        "1.0",
        "--theta0",
        "-3:3:5000",
        "--method",
        "rk4",
        "--steps",
        "100",
    )
    header, *lines = output(pendula, *arguments).splitlines()
    assert header == "# theta0 label kind period rotation theta omega" and len(lines) == 5000
    orbits = {tuple(line.split()[1:]) for line in lines}
    assert {orbit[0] for orbit in orbits} == {str(1 + i) for i in range(len(orbits))}


def test_columns_of_attractors_have_names_in_every_format(pendula):
    arguments = ("attractors", *PUBLISHED, "--drive-amplitude", "1.07", "--method", "rk4", "--steps", "200")
    (row,) = map(json.loads, output(pendula, *arguments, "--format", "json").splitlines()[1:])
    assert row["label"] == 1 and row["kind"] == "periodic" and row["period"] == 2 and row["rotation"] == 0
    assert output(pendula, *arguments, "--format", "csv").startswith("label,kind,period,rotation,theta,omega\n1,periodic,2,0,")


def test_a_pivot_is_swept_like_any_parameter(pendula):
    lines = output(
        pendula, "section", "--pivot-amplitude", "0:2:3", "--drive-frequency", "2", "--transient", "0", "--periods", "1"
    ).splitlines()
    assert [line.split()[0] for line in lines] == ["#", "0", "1", "2"]


def test_a_motion_that_has_not_settled_has_numbers_and_is_no_error(pendula):
    """One period of a budget of one settles nothing: the number is a mean with a wide error."""
    arguments = (*CHAOTIC, "--transient", "0", "--periods", "8", "--budget", "1", "--details")
    (_, row) = output(pendula, "mean-velocity", *arguments).splitlines()
    mean, error, kind, *_ = row.split()
    assert kind == "unsettled" and math.isfinite(float(mean)) and float(error) > 0.01
