"""What type checkers know of the package: names, words and results."""

import re
import subprocess
import sys

import pytest

PROGRAM = """\
import numpy as np
import pendula
from pendula import measure

reveal_type(measure.mean_velocity(1, 0, torque=[1.0, 2.0], method="rk4", periods=9))
reveal_type(measure.lyapunov(1, 0, rows=3).history)
reveal_type(measure.attractors(np.ones(3), 0).label)
reveal_type(measure.section(1, 0, plane="theta", direction="rising").t)
reveal_type(measure.jumps(1, 0, torque=[1.0, 2.0], jump_tolerance=1e-6, carry="both").value)
reveal_type(pendula.analyze(1.0, 0.0, gravity=9.81, length=1.0).tau)
reveal_type(pendula.analyze(np.ones(3), 0.0, alpha=2.0).tau)
reveal_type(pendula.to_radians(90))
measure.section(1, 0, betta=1)
measure.section(1, 0, method="rk5")
measure.section(1, 0, plane="thta")
measure.mean_velocity(1, 0, plane="theta")
measure.orbit(1, 0, carry="up")
measure.lyapunov(1, 0, rows="3")
measure.jumps(1, 0, torque=[1.0, 2.0])
pendula.solve(1, 0, method="rk5")
pendula.solve(1, 0, gama=1)
pendula.analyze(1, 0, gravty=9.81)
"""
SAID = [
    (5, "Revealed type is .*MeanVelocity"),
    (6, "Revealed type is .*ndarray.*float64"),
    (7, "Revealed type is .*ndarray.*(int64|signedinteger)"),
    (8, "Revealed type is .*ndarray.*float64"),
    (9, "Revealed type is .*ndarray.*float64"),
    (10, "Revealed type is .*float64"),
    (11, "Revealed type is .*ndarray.*float64"),
    (12, "Revealed type is .*float64"),
    (13, 'Unexpected keyword argument "betta" for "section"; did you mean "beta"'),
    (14, 'Argument "method" to "section" has incompatible type .*rk5.*; expected .*taylor.*rk4'),
    (15, 'Argument "plane" to "section" has incompatible type .*thta'),
    (16, 'Unexpected keyword argument "plane" for "mean_velocity"'),
    (17, 'Unexpected keyword argument "carry" for "orbit"'),
    (18, 'Argument "rows" to "lyapunov" has incompatible type "str"; expected "int"'),
    (19, 'Missing named argument "jump_tolerance" for "jumps"'),
    (20, 'Argument "method" to "solve" has incompatible type .*rk5'),
    (21, 'Unexpected keyword argument "gama" for "solve"'),
    (22, 'No overload variant of "analyze" matches'),
]


@pytest.fixture(scope="module")
def said(tmp_path_factory):
    """What mypy says of the program, by line."""
    folder = tmp_path_factory.mktemp("types")
    (folder / "program.py").write_text(PROGRAM)
    command = [sys.executable, "-m", "mypy", "--strict", "--config-file=", "--cache-dir=cache", "--no-pretty", "program.py"]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=300)
    lines: dict[int, str] = {}
    for line, words in re.findall(r"^program\.py:(\d+): (?:error|note): (.*)$", done.stdout, re.MULTILINE):
        lines[int(line)] = f"{lines.get(int(line), '')} {words}"
    return lines


@pytest.mark.parametrize(("line", "words"), SAID)
def test_type_checkers_know(said, line, words):
    assert re.search(words, said.get(line, "nothing")), said.get(line)


def test_type_checkers_accept_what_is_right(said):
    assert set(said) == {line for line, _ in SAID}
