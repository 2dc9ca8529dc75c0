"""Measures that are refused, and results that cannot be had."""

import json

import pytest

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


def test_a_long_section_ends_where_its_motion_does(pendula):
    done = pendula(
        "section", "--torque", "1e308", "--transient", "0", "--periods", "2000000", "--method", "rk4", "--steps", "10"
    )
    assert done.returncode == 1
    assert done.stderr.decode() == f"pendula: results are nan for 1 of 1 pendulums: {LOST}\n"
    assert len(done.stdout.splitlines()) == 1 + (1 << 20)
