"""Bad input, a line of data each: the status, the message in both languages, and that nothing is printed."""

import os
import subprocess

import pytest
from conftest import CLEAN, PROGRAM

LONG = "1" * 5000
FIRST = "problem 1, line 1: "
NOT_A_NUMBER = "it is not a number; write it like 90, 1.5 or 2e-3"
NOT_AN_OPTION = "it is not a number; write it like 1.5, 2e-3, 2/3 or 3pi/4"
POSITIVE = "must be positive and finite, got "
FINITE = "must be finite, got "
UNIT = "it must be r (radians) or s (sexagesimal degrees)"
SIZE = "its size must lie between 5e-324 and 1.8e308"
MISSING = "the input ends too soon; missing: "
EMPTY = "standard input holds no problem; one looks like this: 0.0001 0.02 1 90 s 0 r 1 (see pendula --help)"

PROBLEMS = [
    ("", EMPTY),
    (" \n\t\n", EMPTY),
    ("# nothing but a comment", EMPTY),
    ("\ufeff", EMPTY),
    ("0 0.02 1 90 s 0 r 1", FIRST + 'factorΔ "0" ' + POSITIVE),
    ("-0.0001 0.02 1 90 s 0 r 1", FIRST + 'factorΔ "-0.0001" ' + POSITIVE),
    ("-0 0.02 1 90 s 0 r 1", FIRST + 'factorΔ "-0" ' + POSITIVE),
    ("nan 0.02 1 90 s 0 r 1", FIRST + 'factorΔ "nan" ' + POSITIVE),
    ("0.0001 -0.02 1 90 s 0 r 1", FIRST + 'factorcout "-0.02" ' + POSITIVE),
    ("0.0001 inf 1 90 s 0 r 1", FIRST + 'factorcout "inf" ' + POSITIVE),
    ("0.0001 0.02 0 90 s 0 r 1", FIRST + 'factortSimul "0" ' + POSITIVE),
    ("0.0001 0.02 -1 90 s 0 r 1", FIRST + 'factortSimul "-1" ' + POSITIVE),
    ("0.0001 0.02 1 90 s 0 r 0", FIRST + 'α "0" ' + POSITIVE),
    ("0.0001 0.02 1 90 s 0 r -1", FIRST + 'α "-1" ' + POSITIVE),
    ("0.0001 0.02 1 90 s 0 r infinity", FIRST + 'α "infinity" ' + POSITIVE),
    ("0.0001 0.02 1 90 s 0 r -INF", FIRST + 'α "-INF" ' + POSITIVE),
    ("0.0001 0.02 1 90 s 0 r 1e-400", FIRST + 'α "1e-400": ' + SIZE),
    ("0.0001 0.02 1 nan s 0 r 1", FIRST + 'θ0 "nan" ' + FINITE),
    ("0.0001 0.02 1 -inf s 0 r 1", FIRST + 'θ0 "-inf" ' + FINITE),
    ("0.0001 0.02 1 90 s NaN r 1", FIRST + 'ω0 "NaN" ' + FINITE),
    ("0.0001 0.02 1 90 s 1e999 r 1", FIRST + 'ω0 "1e999": ' + SIZE),
    ("0,0001 0.02 1 90 s 0 r 1", FIRST + 'factorΔ "0,0001": it has a decimal comma; write "0.0001", with a point'),
    ("0.0001 0.02 1 1,5 r 0 r 1", FIRST + 'θ0 "1,5": it has a decimal comma; write "1.5", with a point'),
    ("0.0001 0.02 1 1,5e3 r 0 r 1", FIRST + 'θ0 "1,5e3": it has a decimal comma; write "1.5e3", with a point'),
    ("0.0001 0.02 1 1,234.5 r 0 r 1", FIRST + 'θ0 "1,234.5": ' + NOT_A_NUMBER),
    ("0.0001, 0.02 1 90 s 0 r 1", FIRST + 'factorΔ "0.0001,": ' + NOT_A_NUMBER),
    ("0x1p-3 0.02 1 90 s 0 r 1", FIRST + 'factorΔ "0x1p-3": hexadecimal is not read; write it in decimal'),
    ("0.0001 0.02 1 -0X10 s 0 r 1", FIRST + 'θ0 "-0X10": hexadecimal is not read; write it in decimal'),
    ("0.0001 0.02 1 90s 0 r 1", FIRST + 'θ0 "90s": leave a space between the number and its unit s'),
    ("0.0001 0.02 1 90 s 0.5r 1", FIRST + 'ω0 "0.5r": leave a space between the number and its unit r'),
    ("x 0.02 1 90 s 0 r 1", FIRST + 'factorΔ "x": ' + NOT_A_NUMBER),
    ("1e 0.02 1 90 s 0 r 1", FIRST + 'factorΔ "1e": ' + NOT_A_NUMBER),
    ("1.2.3 0.02 1 90 s 0 r 1", FIRST + 'factorΔ "1.2.3": ' + NOT_A_NUMBER),
    ("+-1 0.02 1 90 s 0 r 1", FIRST + 'factorΔ "+-1": ' + NOT_A_NUMBER),
    ("++1 0.02 1 90 s 0 r 1", FIRST + 'factorΔ "++1": ' + NOT_A_NUMBER),
    ("1/2 0.02 1 90 s 0 r 1", FIRST + 'factorΔ "1/2": ' + NOT_A_NUMBER),
    ("0.0001 0.02 1 . s 0 r 1", FIRST + 'θ0 ".": ' + NOT_A_NUMBER),
    ("0.0001 0.02 1 - s 0 r 1", FIRST + 'θ0 "-": ' + NOT_A_NUMBER),
    ("0.0001 0.02 1 π r 0 r 1", FIRST + 'θ0 "π": ' + NOT_A_NUMBER),
    ("0.0001 0.02 1 90° r 0 r 1", FIRST + 'θ0 "90°": it has a degree sign; write "90", and the unit s behind it'),
    ("0.0001 0.02 1 −90 s 0 r 1", FIRST + 'θ0 "−90": it has a typographic minus; write "-90", with a hyphen'),
    ("0.0001 0.02 1 90º s 0 r 1", FIRST + 'θ0 "90º": it has a degree sign; write "90", and the unit s behind it'),
    ("0.0001 0.02 1 −1,5 r 0 r 1", FIRST + 'θ0 "−1,5": it has a decimal comma; write "-1.5", with a point'),
    ("0.0001 0.02 1 1\u00a0000 s 0 r 1", FIRST + 'θ0 "1\u00a0000": it has a no-break space; write "1000"'),
    ("0.0001 0.02 1 1\u202f000 s 0 r 1", FIRST + 'θ0 "1\u202f000": it has a no-break space; write "1000"'),
    ("0.0001 0.02 1 90\u00a0s 0 r 1", FIRST + 'θ0 "90\u00a0s": it has a no-break space; type a plain one'),
    ("0.0001 0.02 1 90 g 0 r 1", FIRST + 'the unit of θ0 "g": ' + UNIT),
    ("0.0001 0.02 1 90 S 0 r 1", FIRST + 'the unit of θ0 "S": ' + UNIT),
    ("0.0001 0.02 1 90 deg 0 r 1", FIRST + 'the unit of θ0 "deg": ' + UNIT),
    ("0.0001 0.02 1 90 0 r 1", FIRST + 'the unit of θ0 "0": ' + UNIT),
    ("0.0001 0.02 1 90 s 0 rad 1", FIRST + 'the unit of ω0 "rad": ' + UNIT),
    ("0.0001", FIRST + MISSING + "factorcout, factortSimul, θ0, the unit of θ0, ω0, the unit of ω0, α"),
    ("0.0001 0.02 1 90 s", FIRST + MISSING + "ω0, the unit of ω0, α"),
    ("0.0001 0.02 1 90 s 0 r", FIRST + MISSING + "α"),
    ("0.0001 0.02 1 90 s 0 r # 1", FIRST + MISSING + "α"),
    ("\n0.0001 0.02\n\n1 90 s 0 r\n\n\n", "problem 1, line 4: " + MISSING + "α"),
    ("# one\n0.0001 0.02\n1 90 x 0 r 1", 'problem 1, line 3: the unit of θ0 "x": ' + UNIT),
    (LONG, FIRST + 'factorΔ "' + "1" * 40 + '...": it is longer than 4096 bytes'),
    (b"\x00", FIRST + 'factorΔ "\\x00": ' + NOT_A_NUMBER),
    (b"\x1b[31m 1", FIRST + 'factorΔ "\\x1b[31m": ' + NOT_A_NUMBER),
    (b"\xff\xfe0\x00", FIRST + 'factorΔ "\\xff\\xfe0\\x00": ' + NOT_A_NUMBER),
    (b"\x7fELF\x02\x01\x01" + bytes(64), FIRST + 'factorΔ "\\x7fELF\\x02\\x01\\x01' + "\\x00" * 33 + '...": ' + NOT_A_NUMBER),
    ("x" * 41, FIRST + 'factorΔ "' + "x" * 40 + '...": ' + NOT_A_NUMBER),
    (
        "1e-20 1 1 90 s 0 r 1",
        FIRST
        + "it would take 99999999900000010240 steps, more than 2^53 = 9007199254740992; make them longer or the run shorter",
    ),
    (
        "1 1e-20 1 90 s 0 r 1",
        FIRST
        + "there would be 1.000000001e+20 rows, more than 2^53 = 9007199254740992; leave more time between them or make the run shorter",
    ),
    ("1 1e-300 1e300 90 s 0 r 1", FIRST + "there would be inf rows, more than 2^53"),
    ("1 1 1e308 90 s 0 r 1e-10", FIRST + "the length of the run, 1e+308 times 741630 s, is out of the range of doubles"),
    ("1e-200 1 1 90 s 0 r 1", FIRST + "it would take 9.99999999e+199 steps"),
    ("1e-200 1 1 90 s 0 r 1e300", FIRST + "the step, 1e-200 times 7.4163e-150 s, is out of the range of doubles"),
]

ANGLE = " (radians; degrees like 90deg)"

OPTIONS = [
    (["solve"], "--theta0 is missing: the initial angle, as 1.5 (radians) or 90deg"),
    (["solve", "--theta0"], "option --theta0 needs a value"),
    (["solve", "--theta0", ""], f'--theta0 "": {NOT_AN_OPTION} (radians; degrees like 90deg)'),
    (["solve", "--theta0", "90grad"], f'--theta0 "90grad": {NOT_AN_OPTION} (radians; degrees like 90deg)'),
    (["solve", "--theta0", "90deg/s"], f'--theta0 "90deg/s": {NOT_AN_OPTION} (radians; degrees like 90deg)'),
    (["solve", "--theta0", "1", "--omega0", "10deg"], f'--omega0 "10deg": {NOT_AN_OPTION} (radians; degrees like 90deg/s)'),
    (
        ["solve", "--theta0", "1,5"],
        '--theta0 "1,5": it has a decimal comma; write "1.5", with a point (radians; degrees like 90deg)',
    ),
    (["solve", "--theta0", "−pi/2"], f'--theta0 "−pi/2": it has a typographic minus; write "-pi/2", with a hyphen{ANGLE}'),
    (["solve", "--theta0", "1,5pi"], f'--theta0 "1,5pi": it has a decimal comma; write "1.5pi", with a point{ANGLE}'),
    (["solve", "--theta0", "pi/0"], f'--theta0 "pi/0": it divides by zero{ANGLE}'),
    (["solve", "--theta0", "pi/2deg"], f'--theta0 "pi/2": it is not a number of degrees; write it like 90 or 2/3{ANGLE}'),
    *[
        (["solve", "--theta0", text], f'--theta0 "{text}": {NOT_AN_OPTION}{ANGLE}')
        for text in ("pi2", "2/", "/2", "2/x", "3*", "*pi", "3**pi", "infpi", "1/-2", "2 pi", "pi/2/2", "--1", "+-pi", "Pi")
    ],
    (["solve", "--theta0", "1e308pi"], f'--theta0 "1e308pi": its size must lie between 5e-324 and 1.8e308{ANGLE}'),
    (["solve", "--theta0", "1", "--alpha", "-1/3"], f'--alpha "-1/3" {POSITIVE}-0.3333333333333333'),
    (
        ["solve", "--theta0", "1", "--steps", "9"],
        "option --steps belongs to pendula section, pendula mean-velocity, pendula lyapunov, pendula attractors, pendula orbit",
    ),
    (["solve", "--theta0", "nan"], '--theta0 "nan" must be finite, got nan (radians; degrees like 90deg)'),
    (["solve", "--theta0", "--omega0"], f'--theta0 "--omega0": {NOT_AN_OPTION} (radians; degrees like 90deg)'),
    (["solve", "--theta0", "1", "--alpha", "0"], f'--alpha "0" {POSITIVE}0'),
    (["solve", "--theta0", "1", "--alpha", "1", "--gravity", "1"], "--alpha and --gravity exclude each other"),
    (["solve", "--theta0", "1", "--gravity", "1"], "--gravity and --length go together"),
    (
        ["solve", "--theta0", "1", "--gravity", "1e300", "--length", "1e-300"],
        "--gravity over --length must be positive and finite, got inf",
    ),
    (["solve", "--theta0", "1", "--dt", "1", "--dt-factor", "1"], "--dt-factor and --dt exclude each other"),
    (["solve", "--theta0", "1", "--until", "-1"], f'--until "-1" {POSITIVE}-1'),
    (["solve", "--theta0", "1", "--theta0", "2"], "option --theta0 is given twice"),
    (
        ["solve", "--theta0", "1", "--method", "rk5"],
        '--method "rk5": "rk5" is none of rk4, euler, verlet, taylor, exact; did you mean rk4?',
    ),
    (["solve", "--theta0", "1", "--format", "xml"], '--format "xml": "xml" is none of text, csv, json'),
    (["solve", "--theta0", "1", "--precision", "0"], '--precision "0": it must be a whole number from 1 to 17, or full'),
    (["solve", "--theta0", "1", "--precision", "18"], '--precision "18": it must be a whole number from 1 to 17, or full'),
    (["solve", "--theta0", "1", "--precision", "6.0"], '--precision "6.0": it must be a whole number from 1 to 17, or full'),
    (
        ["solve", "--theta0", "1", "--columns", ""],
        '--columns "": "" is none of t, theta, omega, sine, exact, error, energy, turns',
    ),
    (
        ["solve", "--theta0", "1", "--columns", "t,thetta"],
        '--columns "t,thetta": "thetta" is none of t, theta, omega, sine, exact, error, energy, turns; did you mean theta?',
    ),
    (["solve", "--theta0", "1", "--columns", "t,t"], '--columns "t,t": t stands there twice'),
    (["solve", "--theta0", "1", "--output", ""], '--output "": it must be the name of a file, or - for standard output'),
    (["solve", "--theta", "1"], 'unknown option "--theta"; did you mean --theta0?'),
    (["solve", "--frobnicate", "1"], 'unknown option "--frobnicate"; see pendula --help'),
    (["solve", "-x"], 'unknown option "-x"; see pendula --help'),
    (["solve", "90deg"], 'unexpected argument "90deg"; options begin with --, see pendula --help'),
    (["solve", "--epsilon", "1"], "option --epsilon belongs to pendula analyze"),
    (
        ["--theta0", "1"],
        "option --theta0 belongs to pendula solve, pendula analyze, pendula section, pendula mean-velocity, pendula lyapunov, pendula attractors, pendula orbit",
    ),
    (["--lang", "fr"], '--lang "fr": "fr" is none of en, es'),
    (["analyze", "--tau", "7", "--theta0", "1"], "--tau and --theta0 exclude each other"),
    (["analyze", "--tau", "7", "--omega0", "1"], "--tau and --omega0 exclude each other"),
    (["analyze", "--tau", "7", "--method", "series"], "--tau and --method exclude each other"),
    (["analyze", "--tau", "7", "--epsilon", "1e-3"], "--tau and --epsilon exclude each other"),
    (["analyze", "--tau", "6.28"], "--tau must be at least 6.283185307179586 s, the period 2π/√α of small swings"),
    (
        ["analyze", "--tau", "7:6:3", "--alpha", "1:4:2"],
        "where --tau is 6, --alpha is 1: --tau must be at least 6.283185307179586 s, the period 2π/√α of small swings",
    ),
    (["analyze", "--tau", "0"], f'--tau "0" {POSITIVE}0'),
    (["solve", "--tau", "7"], "option --tau belongs to pendula analyze"),
    (
        ["analyze", "--theta0", "1:90deg:3"],
        '--theta0 "1:90deg:3": one end is in degrees and the other is not; type deg behind both or none',
    ),
    (["analyze", "--omega0", "1"], "--theta0 is missing: the initial angle, as 1.5 (radians) or 90deg"),
    (
        ["analyze", "--theta0", "1", "--method", "serie"],
        '--method "serie": "serie" is none of agm, series; did you mean series?',
    ),
    (["analyze", "--theta0", "1", "--epsilon", "1e-3"], "--epsilon does not go with --method agm"),
    (
        ["analyze", "--theta0", "1", "--method", "series", "--epsilon", "1"],
        '--epsilon "1" must be between 0 and 1, both excluded, got 1',
    ),
]


@pytest.mark.parametrize("text, message", PROBLEMS)
def test_a_bad_problem_ends_with_status_1_and_says_where_and_why(pendula, text, message):
    done = pendula(text=text)
    assert (done.returncode, done.stdout) == (1, b"")
    assert done.stderr.decode().startswith("pendula: " + message)
    assert done.stderr.count(b"\n") == 1


@pytest.mark.parametrize("arguments, message", OPTIONS)
def test_a_bad_option_ends_with_status_2_and_says_which_and_why(pendula, arguments, message):
    done = pendula(*arguments)
    assert (done.returncode, done.stdout) == (2, b"")
    assert done.stderr.decode() == f"pendula: {message}\n"


@pytest.mark.parametrize("text", [text for text, _ in PROBLEMS])
def test_the_same_problem_has_a_message_in_spanish(pendula, text):
    english, spanish = pendula(text=text).stderr, pendula("--lang", "es", text=text)
    assert (spanish.returncode, spanish.stdout) == (1, b"")
    assert spanish.stderr != english
    assert not {b"the", b"must", b"not", b"line"} & set(spanish.stderr.split())


@pytest.mark.parametrize("arguments", [arguments for arguments, _ in OPTIONS])
def test_the_same_option_has_a_message_in_spanish(pendula, arguments):
    english, spanish = pendula(*arguments).stderr, pendula(*arguments, env={"LANG": "es_ES.UTF-8"})
    assert (spanish.returncode, spanish.stdout) == (2, b"")
    assert spanish.stderr != english
    assert not {b"the", b"must", b"not", b"option"} & set(spanish.stderr.split())


def test_good_problems_before_a_bad_one_stay_printed(pendula):
    good = "0.01 0.5 1 1 r 0 r 1\n"
    done = pendula(text=good + good + "0.01 0.5 1 1 r 0 r -1\n" + good)
    assert done.returncode == 1
    assert done.stdout == pendula(text=good + good).stdout
    assert done.stderr.decode() == f'pendula: problem 3, line 3: α "-1" {POSITIVE}-1\n'


def test_a_series_of_too_many_terms_is_refused_before_it_starts(pendula):
    done = pendula("analyze", "--method", "series", "--theta0", "3.14159265")
    assert (done.returncode, done.stdout) == (2, b"")
    assert b"more than 1e+09; ask for a larger --epsilon" in done.stderr


@pytest.mark.parametrize(
    "line, message",
    [
        ("1 r 0 r", "the line ends too soon; missing: α"),
        ("1 r 0 r 1 2", '"2": nothing may follow α'),
        ("1 r 0 r 1 2 3", '"2": nothing may follow α'),
        ("1 x 0 y z", 'the unit of θ0 "x": ' + UNIT),
        ("1 r 0 r 0", 'α "0" ' + POSITIVE + "0"),
        ("1,5 r 0 r 1", 'θ0 "1,5": it has a decimal comma; write "1.5", with a point'),
        (LONG, 'θ0 "' + "1" * 40 + '...": it is longer than 4096 bytes'),
    ],
)
def test_analyze_puts_an_error_in_the_place_of_a_bad_line_and_goes_on(pendula, line, message):
    done = pendula("analyze", text=f"0 r 2 r 1\n\n{line} # bad\n1 r 0 r 1")
    assert done.stdout.decode() == f"0 3.14159 7.14932\nERROR: line 3: {message}\n-1 1 6.69998\n"
    assert (done.returncode, done.stderr) == (1, b"")


def test_analyze_of_no_lines_prints_nothing(pendula):
    for text in ("", "\n\n", "# nothing\n"):
        done = pendula("analyze", text=text)
        assert (done.returncode, done.stdout, done.stderr) == (0, b"", b"")


def test_standard_input_that_cannot_be_read_is_said_so():
    directory = os.open("/", os.O_RDONLY)
    done = subprocess.run([PROGRAM], stdin=directory, capture_output=True, env=CLEAN)
    os.close(directory)
    assert (done.returncode, done.stdout) == (1, b"")
    assert done.stderr == b"pendula: standard input could not be read: it is a directory\n"
