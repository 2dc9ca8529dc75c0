"""Numbers of options as people type them: each is the double nearest to what was typed."""

import json
import math
import random
from fractions import Fraction

import pytest

# pi to 50 decimals (OEIS A000796): fractions with it are right to 1e-49, and a double nearest to one is right but for a tie.
PI = Fraction(314159265358979323846264338327950288419716939937510, 10**50)


def read(pendula, texts, option="torque"):
    """What the program reads, which it writes in json in full."""
    values = []
    for text in texts:
        done = pendula("section", f"--{option}={text}", "--format", "json", "--transient", "0", "--periods", "1")
        assert (done.returncode, done.stderr) == (0, b""), text
        values.append(json.loads(done.stdout.splitlines()[0])[option])
    return values


def spelled(rng):
    """A number in one of the spellings, and its exact value."""
    sign, factor = rng.choice([("", 1), ("-", -1), ("+", 1)])
    a = rng.choice(
        [str(rng.randint(1, 99)), f"{rng.uniform(0, 50):.{rng.randint(1, 12)}f}", f"{rng.randint(1, 9)}e-{rng.randint(1, 9)}"]
    )
    b = rng.choice([str(rng.randint(1, 99)), f"{rng.uniform(1, 9):.3f}"])
    pi = rng.choice(["pi", "*pi", "π"])
    text, value = rng.choice(
        [
            (f"{a}/{b}", Fraction(a) / Fraction(b)),
            (f"{a}{pi}", Fraction(a) * PI),
            (f"{a}{pi}/{b}", Fraction(a) * PI / Fraction(b)),
            (f"pi/{b}", PI / Fraction(b)),
        ]
    )
    return sign + text, factor * value


def test_fractions_and_multiples_of_pi_are_rounded_once(pendula):
    rng = random.Random(7)
    cases = [spelled(rng) for _ in range(300)]
    assert read(pendula, [text for text, _ in cases]) == [float(value) for _, value in cases]


NAMED = {
    "2/3": 2 / 3,
    "1/3": 1 / 3,
    "1e-3": 1e-3,
    ".5": 0.5,
    "pi": math.pi,
    "π": math.pi,
    "-pi": -math.pi,
    "2pi": 2 * math.pi,
    "pi/2": math.pi / 2,
    "pi/6": 0.5235987755982989,  # and not math.pi/6, which is rounded twice
    "2pi/3": 2.0943951023931957,
    "3pi/4": 2.356194490192345,
    "3*pi/4": 2.356194490192345,
    "0/3": 0,
    "0pi": 0,
    "0.1/0.3": 1 / 3,
    "1e300/1e299": 10,
}


def test_named_numbers_are_read(pendula):
    assert read(pendula, NAMED) == list(NAMED.values())


def test_degrees_are_rounded_once(pendula):
    rng = random.Random(8)
    degrees = ["30", "-90", "180", "0.1", "33.3", "1e-7", "540", "2/3", "180/7"]
    degrees += [f"{rng.uniform(-400, 400):.{rng.randint(0, 9)}f}" for _ in range(60)]
    exact = [Fraction(text.split("/")[0]) / Fraction(text.partition("/")[2] or 1) * PI / 180 for text in degrees]
    assert read(pendula, [f"{text}deg" for text in degrees], "theta0") == [float(value) for value in exact]


def test_every_option_reads_the_same_spelling(pendula):
    options = ["--drive-amplitude", "2/3", "--drive-frequency", "2/3", "--drive-phase", "pi/3", "--strobe-phase", "-pi/4"]
    typed = pendula("section", *options, "--transient", "6/2", "--periods", "4/2", "--precision", "full")
    values = ["--drive-amplitude", repr(2 / 3), "--drive-frequency", repr(2 / 3), "--drive-phase", "1.0471975511965979"]
    values += ["--strobe-phase", repr(-math.pi / 4), "--transient", "3", "--periods", "2", "--precision", "full"]
    assert typed.returncode == 0 and typed.stdout == pendula("section", *values).stdout
    by_fraction = pendula("solve", "--theta0", "pi/3", "--until", "1/3", "--every", "1/6", "--precision", "full")
    in_decimals = ["--theta0", "1.0471975511965979", "--until", repr(1 / 3), "--every", repr(1 / 6), "--precision", "full"]
    assert by_fraction.returncode == 0 and by_fraction.stdout == pendula("solve", *in_decimals).stdout


def test_both_ends_of_a_range_are_typed_alike(pendula):
    done = pendula("analyze", "--theta0", "pi/6:2pi/3:2", "--precision", "full")
    assert [line.split()[0] for line in done.stdout.decode().splitlines()] == ["0.5235987755982989", "2.0943951023931957"]


@pytest.mark.parametrize(
    "text, message",
    [
        ("90", "--theta0 90: 90 rad is 14 turns and 2.03541 rad; for degrees type 90deg"),
        ("-180", "--theta0 -180: -180 rad is -28 turns and -4.07081 rad; for degrees type -180deg"),
        ("7", "--theta0 7: 7 rad is 1 turn and 0.716815 rad; for degrees type 7deg"),
        ("-180:180:3", "--theta0: from -180 to 180 radians; for degrees type -180deg:180deg:3"),
    ],
)
def test_whole_radians_beyond_a_turn_are_done_and_remarked_on(pendula, text, message):
    done = pendula("analyze", "--theta0", text)
    assert (done.returncode, done.stderr.decode()) == (0, f"pendula: {message}\n")
    assert len(done.stdout.splitlines()) == (3 if ":" in text else 1)


@pytest.mark.parametrize("text", ["6", "6.5", "90.5", "4pi", "90deg", "0:10:3", "-90deg:90deg:3", "100000"])
def test_other_angles_are_not_remarked_on(pendula, text):
    done = pendula("analyze", "--theta0", text)
    assert (done.returncode, done.stderr) == (0, b"")


def test_an_angular_velocity_is_not_remarked_on(pendula):
    assert pendula("analyze", "--theta0", "0", "--omega0", "90").stderr == b""


def test_the_remark_is_in_spanish_too(pendula):
    done = pendula("analyze", "--theta0", "90", "--lang", "es")
    assert done.stderr.decode() == "pendula: --theta0 90: 90 rad son 14 vueltas y 2.03541 rad; en grados se escribe 90deg\n"
