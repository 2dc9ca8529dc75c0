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


FREQUENCY = "a drive or a shaken pivot needs a frequency: --drive-frequency must be positive and finite, got 0"

BAD = [
    (("section", "--drive-amplitude", "1"), FREQUENCY),
    (("section", "--pivot-amplitude", "1"), FREQUENCY),
    (
        ("section", "--drive-amplitude", "0:1:3", "--drive-frequency", "0:1:3"),
        "where --drive-amplitude is 0.5, --drive-frequency is 0: " + FREQUENCY,
    ),
    (("mean-velocity", "--beta", "1e300", "--method", "rk4"), "--steps must be at least 2.2601385997048875e+300, or the method is unstable, got 1000"),
    (("mean-velocity", "--beta", "nan"), '--beta "nan" must be finite and not negative, got nan'),
    (("mean-velocity", "--beta", "0:nan:3"), '--beta "nan" must be finite and not negative, got nan'),
    (("mean-velocity", "--torque", "1:2:0"), "the count must be a whole number from 1"),
    (("mean-velocity", "--torque", "1:2:-3"), "the count must be a whole number from 1"),
    (("mean-velocity", "--torque", "1:2:2.5"), "the count must be a whole number from 1"),
    (("mean-velocity", "--torque", "1:2"), "it must be one value, or a range first:last:count"),
    (("mean-velocity", "--torque", "1:2:3:4"), "it must be one value, or a range first:last:count"),
    (("mean-velocity", "--torque", ":2:3"), "it is not a number"),
    (("mean-velocity", "--torque=-1e308:1e308:3"), "it is wider than the doubles"),
    (("mean-velocity", "--periods", "0"), "--periods must be a whole number from 1 to 2^53, got 0"),
    (("mean-velocity", "--transient", "0.5"), "--transient must be a whole number from 0 to 2^53, got 0.5"),
    (("mean-velocity", "--method", "rk4", "--steps", "2"), "--steps must be at least 3, or the method is unstable, got 2; or use method taylor"),
    (("mean-velocity", "--threads", "0"), "--threads must be a whole number from 1 to 256, got 0"),
    (("mean-velocity", "--threads", "1.5"), "--threads must be a whole number from 1 to 256, got 1.5"),
    (("mean-velocity", "--method", "verlet"), '--method "verlet": "verlet" is none of taylor, rk4'),
    (("mean-velocity", "--method", "taylor", "--steps", "9"), "--steps does not go with --method taylor"),
    (("mean-velocity", "--steps", "9"), "--steps does not go with --method taylor, which is what is used if none is given"),
    (("mean-velocity", "--tolerance", "1e-9", "--method", "rk4"), "--tolerance does not go with --method rk4"),
    (("mean-velocity", "--budget", "0.5"), "--budget must be a whole number from 1 to 2^53, got 0.5"),
    (("orbit", "--orbit-period", "0"), "--orbit-period must be a whole number from 1 to 2^53, got 0"),
    (("orbit", "--budget", "9"), "option --budget belongs to pendula section, pendula mean-velocity, pendula lyapunov, pendula attractors"),
    (("orbit", "--carry", "up", "--alpha", "1:2:3"), "option --carry belongs to pendula section"),
    (("section", "--level", "1"), "--level is for a section by a plane: it needs --plane theta or omega"),
    (("section", "--direction", "rising"), "--direction is for a section by a plane: it needs --plane theta or omega"),
    (("section", "--budget", "9"), "--budget is for a section by a plane: it needs --plane theta or omega"),
    (("section", "--plane", "theta", "--method", "rk4"), "--plane needs --method taylor"),
    (("section", "--plane", "x"), '--plane "x": "x" is none of strobe, theta, omega'),
    (("section", "--plane", "omega", "--level", "3deg"), '--level "3deg": it is not a number'),
    (("section", "--plane", "theta", "--level", "3deg/s"), '--level "3deg/s": it is not a number'),
    (("section", "--details=1",), "option --details takes no value"),
    (("section", "--details", "1",), 'unexpected argument "1"'),
    (("orbit", "--details"), "option --details belongs to pendula section, pendula mean-velocity, pendula lyapunov, pendula attractors"),
    (("mean-velocity", "--shares"), "option --shares belongs to pendula attractors"),
    (("attractors", "--shares", "--details"), "--shares and --details exclude each other"),
    (("attractors", "--shares", "--carry", "up", "--alpha", "1:2:3"), "--shares and --carry exclude each other"),
    (("mean-velocity", "--carry", "up"), "--carry needs a range to go along, as --torque 0:2:201"),
    (("mean-velocity", "--carry", "up", "--alpha", "1:2:3", "--theta0", "1:2:3"),
     "--carry goes along the last range, and --theta0 is only where a motion starts; give another range last"),
    (("mean-velocity", "--carry", "up", "--drive-phase", "1:2:3"), "--drive-phase is only where a motion starts"),
    (("section", "--carry", "up", "--alpha", "1:2:3", "--plane", "theta"), "--carry does not go with --plane theta"),
    (("section", "--carry", "up", "--alpha", "1:2:3", "--periods", "1e7"), "3e+07 rows are made in one piece, which takes at most 16777216"),
    (("section", "--details", "--periods", "1e8"), "1e+08 rows are made in one piece, which takes at most 16777216"),
    (("mean-velocity", "--carry", "sideways", "--alpha", "1:2:3"), '"sideways" is none of up, down, both'),
    (("mean-velocity", "--locate", "1e-3", "--alpha", "1:2:3"), "--locate needs --carry up, down or both"),
    (("mean-velocity", "--locate", "0", "--carry", "up", "--alpha", "1:2:3"), '--locate "0" must be positive and finite, got 0'),
    (("mean-velocity", "--locate", "1e-3", "--carry", "up", "--details", "--alpha", "1:2:3"), "--locate and --details exclude"),
    (("mean-velocity", "--locate", "1e-3", "--carry", "up", "--gravity", "1:2:3", "--length", "1"),
     "--locate needs a range of --alpha, not of --gravity"),
    (("section", "--locate", "1e-3"), "option --locate belongs to pendula mean-velocity, pendula lyapunov, pendula attractors"),
    (("mean-velocity", "--gravity", "9.81"), "--gravity and --length go together"),
    (("mean-velocity", "--gravity", "1:1e300:2", "--length", "1e-300:1:2"),
     "where --gravity is 1e+300, --length is 1e-300: --gravity over --length must be positive and finite, got inf"),
    (("mean-velocity", "--until", "3"), "option --until belongs to pendula solve"),
    (("section", "--match", "3"), "option --match belongs to pendula mean-velocity, pendula lyapunov, pendula attractors"),
    (("attractors", "--match", "0"), "--match must be positive and finite, got 0"),
    (("attractors", "--theta0", "0:1:16777217"), "takes at most 16777216 at once; the ranges make 16777217"),
]  # fmt: skip


@pytest.mark.parametrize("arguments, message", BAD, ids=[" ".join(arguments) for arguments, _ in BAD])
def test_what_cannot_be_measured_is_bad_usage(pendula, arguments, message):
    done = pendula(*arguments)
    assert done.returncode == 2 and done.stdout == b""
    assert message in done.stderr.decode() and done.stderr.count(b"\n") == 1


@pytest.mark.parametrize(
    "arguments",
    [
        ("--method", "rk4", "--steps", "1e12", "--periods", "1e12"),
        ("--beta", "1e300"),
        ("--beta", "0:1:9999999999", "--torque", "0:1:9999999999"),
    ],
)
def test_more_steps_of_a_pendulum_or_more_pendulums_than_2_to_53_are_too_many(pendula, arguments):
    done = pendula("mean-velocity", *arguments)
    assert done.returncode == 2 and done.stdout == b"" and "2^53" in done.stderr.decode()


def test_complaints_are_in_spanish_too(pendula):
    done = pendula("section", "--drive-amplitude", "1", env={"LANG": "es_ES.UTF-8"})
    assert "--drive-frequency debe ser un número finito mayor que 0" in done.stderr.decode()


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


@pytest.mark.parametrize(
    "arguments, place, least",
    [
        # 1000 steps of 2 pi/Omega are stable below sqrt(alpha) h = 2.82, which is from Omega = 2.2281e-3 on
        (["mean-velocity", "--drive-frequency", "0:1:1001", "--method", "rk4"], 0.001, 2229),
        (["lyapunov", "--drive-frequency", "0:1:201", "--method", "rk4", "--steps", "20"], 0.005, 446),
        (["attractors", "--drive-frequency", "0:1:201", "--method", "rk4", "--steps", "20"], 0.005, 446),
    ],
)
def test_every_member_of_a_sweep_is_checked_as_if_it_stood_alone(pendula, arguments, place, least):
    done = pendula(*arguments, "--theta0", "1")
    assert (done.returncode, done.stdout) == (2, b"")
    assert f"where --drive-frequency is {place}: --steps must be at least {least}" in done.stderr.decode()
    alone = pendula(*(str(place) if ":" in word else word for word in arguments), "--theta0", "1")
    assert alone.returncode == 2 and f"pendula: --steps must be at least {least}" in alone.stderr.decode()


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


@pytest.mark.parametrize("isa", ["", "sse9", "AVX2"])
def test_an_instruction_set_that_is_none_is_bad_usage(pendula, isa):
    for arguments in (["mean-velocity"], ["solve", "--theta0", "1"], []):
        done = pendula(*arguments, env={"PENDULA_ISA": isa})
        assert (done.returncode, done.stdout) == (2, b"")
        assert done.stderr.startswith(b"pendula: PENDULA_ISA must be one of")


LOST = "their motion leaves the range of doubles"
FASTER = "1 unbounded (a torque without friction accelerates them for ever)"


@pytest.mark.parametrize("method", ["rk4", "taylor"])
@pytest.mark.parametrize(
    "arguments, nans, why",
    [
        (("section", "--torque", "0:1e308:2", "--transient", "0", "--periods", "3"), "1 of 2", LOST),
        (("mean-velocity", "--torque", "0:3:2"), "1 of 2", FASTER),
        (("mean-velocity", "--torque", "0:1e308:2"), "1 of 2", FASTER),
        (("orbit", "--beta", "0.5", "--torque", "2:3:2"), "2 of 2",
         "Newton's method finds no periodic orbit from their initial states"),
    ],
)  # fmt: skip
def test_results_that_are_nan_are_told_with_their_number_and_cause(pendula, method, arguments, nans, why):
    done = pendula(*arguments, "--method", method)
    assert done.returncode == 1 and b"nan" in done.stdout
    assert done.stderr.decode() == f"pendula: results are nan for {nans} pendulums: {why}\n"


def test_nans_are_null_in_json_and_told_in_spanish(pendula):
    done = pendula("mean-velocity", "--torque", "3", "--format", "json", "--lang", "es")
    assert json.loads(done.stdout.splitlines()[1])["mean_velocity"] is None
    assert done.stderr.decode() == (
        "pendula: los resultados son nan para 1 de 1 péndulos: 1 unbounded (un par sin rozamiento los acelera para siempre)\n"
    )


def test_a_motion_that_has_not_settled_has_numbers_and_is_no_error(pendula):
    """One period of a budget of one settles nothing: the number is a mean with a wide error."""
    arguments = (*CHAOTIC, "--transient", "0", "--periods", "8", "--budget", "1", "--details")
    (_, row) = output(pendula, "mean-velocity", *arguments).splitlines()
    mean, error, kind, *_ = row.split()
    assert kind == "unsettled" and math.isfinite(float(mean)) and float(error) > 0.01


def test_a_long_section_ends_where_its_motion_does(pendula):
    done = pendula(
        "section", "--torque", "1e308", "--transient", "0", "--periods", "2000000", "--method", "rk4", "--steps", "10"
    )
    assert done.returncode == 1
    assert done.stderr.decode() == f"pendula: results are nan for 1 of 1 pendulums: {LOST}\n"
    assert len(done.stdout.splitlines()) == 1 + (1 << 20)
