"""The installed package serves a program outside the tree, by find_package and by pkg-config, from wherever it is moved; and
the READMEs show what happens."""

import math
import os
import re
import shutil
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
EXAMPLES = ROOT / "examples"
READMES = [ROOT / "README.md", ROOT / "README.es.md"]


def run(*command, **environment):
    done = subprocess.run([*map(str, command)], capture_output=True, text=True, env={**os.environ, **environment})
    assert done.returncode == 0, f"{command}:\n{done.stdout}{done.stderr}"
    return done.stdout


@pytest.fixture(scope="module")
def prefix(tmp_path_factory):
    """Installed in one place and moved to another."""
    folder = tmp_path_factory.mktemp("package")
    build = os.environ.get("PENDULA_BUILD", ROOT / "build" / "dev")
    run("cmake", "--install", build, "--prefix", folder / "first")
    return (folder / "first").rename(folder / "second")


def test_every_public_header_is_installed(prefix):
    public = {path.name for path in (ROOT / "include" / "pendula").iterdir()} | {"version.hpp"}  # made by the build
    assert {path.name for path in (prefix / "include" / "pendula").iterdir()} == public


@pytest.fixture(scope="module")
def examples(prefix, tmp_path_factory):
    """The folder of the programs of examples/, built by find_package."""
    folder = tmp_path_factory.mktemp("examples")
    sources = folder / "source"
    sources.mkdir()
    for source in (EXAMPLES / "CMakeLists.txt", *EXAMPLES.glob("*.cpp")):
        shutil.copy(source, sources)
    run("cmake", "-S", sources, "-B", folder / "build", f"-DCMAKE_PREFIX_PATH={prefix}")
    run("cmake", "--build", folder / "build")

    return folder


def printed(examples, name):
    """The numbers of each line that an example prints."""
    text = run("sh", "-c", f"cd {examples} && build/{name}")
    return [[float(x) for x in re.findall(r"(?<![\w^])[-+]?\d+(?:\.\d+)?", line)] for line in text.splitlines()]


def arithmetic_geometric_mean(a, b):
    while abs(a - b) > 1e-15:
        a, b = (a + b) / 2, math.sqrt(a * b)
    return a


def test_example_period_and_amplitude(examples):
    rows = {row[0]: row[1:] for row in printed(examples, "period_and_amplitude")[1:]}
    assert list(rows) == [1, 30, 90, 150, 179]
    for degrees, (period, series, measured) in rows.items():
        exact = 1 / arithmetic_geometric_mean(1, math.cos(math.radians(degrees) / 2))
        assert period == pytest.approx(exact, abs=6e-10)  # nine decimals are printed
        assert measured == pytest.approx(exact, abs=6e-10)
        if degrees == 1:
            assert series == pytest.approx(exact, abs=6e-10)


def test_example_phase_portrait(examples):
    rows = [row for row in printed(examples, "phase_portrait") if len(row) == 3]
    assert len(rows) == 6 * 21
    alpha = 9.81 / 0.5
    for number, of_top in enumerate((0.1, 0.5, 0.9, 1.0, 1.1, 2.0)):
        for _, theta, omega in rows[21 * number : 21 * number + 21]:
            energy = omega**2 / 2 + alpha * (1 - math.cos(theta))
            assert energy == pytest.approx(2 * alpha * of_top, abs=3e-5)  # six decimals times omega, and times alpha


def test_example_bifurcation(examples):
    rows = printed(examples, "bifurcation")[1:]
    assert [row[:2] for row in rows] == [
        [0.9, 1],
        [1.07, 2],
        [1.15, 0],
        [1.35, 1],
        [1.45, 2],
        [1.47, 4],
        [1.5, 0],
    ]  # as published
    exponents = [row[2] for row in rows]
    assert exponents[0] == exponents[3] == -0.25  # half the friction
    assert [x > 0 for x in exponents] == [period == 0 for _, period, _ in rows]
    assert len((examples / "bifurcation.txt").read_text().splitlines()) == 40_100


def test_example_current_voltage(examples):
    for current, voltage, law, driven in printed(examples, "current_voltage")[1:]:
        assert law == pytest.approx(math.sqrt(max(current**2 - 1, 0)) / 10, abs=6e-5)
        assert voltage == pytest.approx(law, abs=3e-4)  # of order alpha/beta^2, and a turn in 5000 periods
        if current in (1.1, 1.5):
            assert driven == 1  # on the first Shapiro step


def test_example_kapitza(examples):
    for part, departure in printed(examples, "kapitza")[1:]:
        assert departure > 3 if part < 1 else departure < 0.02


def compile_with_pkg_config(prefix, source, program):
    folder = next(prefix.rglob("pendula.pc")).parent
    flags = run("pkg-config", "--cflags", "--libs", "pendula", PKG_CONFIG_PATH=str(folder)).split()
    run("c++", "-std=c++20", source, *flags, "-o", program)
    return program


def test_pkg_config(prefix, examples, tmp_path):
    program = compile_with_pkg_config(prefix, EXAMPLES / "kapitza.cpp", tmp_path / "kapitza")
    assert run(program) == run(examples / "build" / "kapitza")


@pytest.mark.parametrize("readme", READMES, ids=lambda path: path.name)
def test_a_readme_shows_what_its_program_prints(prefix, readme, tmp_path):
    (code,) = re.findall(r"^```cpp\n(.*?)^```", readme.read_text(), re.MULTILINE | re.DOTALL)
    (tmp_path / "main.cpp").write_text(code)
    shown = re.search(r"printf.*// (.*)", code)[1] + "\n"
    assert run(compile_with_pkg_config(prefix, tmp_path / "main.cpp", tmp_path / "main")) == shown


@pytest.mark.parametrize("readme", READMES, ids=lambda path: path.name)
def test_a_readme_shows_what_its_command_prints(prefix, readme):
    command, shown = re.search(r"^\$ (.*)\n([^`]*)```", readme.read_text(), re.MULTILINE).groups()
    path = f"{prefix / 'bin'}:{os.environ['PATH']}"
    assert run("sh", "-c", command, PATH=path) == shown


@pytest.mark.parametrize("readme", READMES, ids=lambda path: path.name)
def test_a_readme_shows_commands_that_work(prefix, readme, tmp_path):
    path = f"{prefix / 'bin'}:{os.environ['PATH']}"
    commands = re.findall(r"^(?:pendula|echo) .*(?:\n    .*)*", readme.read_text(), re.MULTILINE)
    of_the_program = [command for command in commands if not re.search("pendula (plot|check)", command)]
    assert len(of_the_program) == 10
    for command in of_the_program:
        run("sh", "-c", f"cd {tmp_path} && {command}", PATH=path)
    assert {file.name for file in tmp_path.glob("*.png")} == {"bifurcation.png", "current_voltage.png"}
