"""The installed package serves a program outside the tree, by find_package and by pkg-config, from wherever it is moved; and
the READMEs show what happens."""

import os
import re
import shutil
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
EXAMPLE = ROOT / "examples" / "library"
OUTPUT = "0.148326 1.5598 -0.148324\n"
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


def test_find_package(prefix, tmp_path):
    shutil.copytree(EXAMPLE, tmp_path / "source")
    run("cmake", "-S", tmp_path / "source", "-B", tmp_path / "build", f"-DCMAKE_PREFIX_PATH={prefix}")
    run("cmake", "--build", tmp_path / "build")
    assert run(tmp_path / "build" / "example") == OUTPUT


def test_pkg_config(prefix, tmp_path):
    folder = next(prefix.rglob("pendula.pc")).parent
    flags = run("pkg-config", "--cflags", "--libs", "pendula", PKG_CONFIG_PATH=str(folder)).split()
    run("c++", "-std=c++20", EXAMPLE / "main.cpp", *flags, "-o", tmp_path / "example")
    assert run(tmp_path / "example") == OUTPUT


@pytest.mark.parametrize("readme", READMES, ids=lambda path: path.name)
def test_a_readme_shows_the_example_and_what_the_program_prints(prefix, readme):
    text = readme.read_text()
    assert (EXAMPLE / "main.cpp").read_text() in text
    command, shown = re.search(r"^\$ (.*)\n([^`]*)```", text, re.MULTILINE).groups()
    path = f"{prefix / 'bin'}:{os.environ['PATH']}"
    assert run("sh", "-c", command, PATH=path) == shown


@pytest.mark.parametrize("readme", READMES, ids=lambda path: path.name)
def test_a_readme_shows_commands_that_work(prefix, readme, tmp_path):
    path = f"{prefix / 'bin'}:{os.environ['PATH']}"
    commands = re.findall(r"^(?:pendula|echo) .*(?:\n    .*)*", readme.read_text(), re.MULTILINE)
    of_the_program = [command for command in commands if not re.search("pendula (plot|check)", command)]
    assert len(of_the_program) == 6
    for command in of_the_program:
        run("sh", "-c", f"cd {tmp_path} && {command}", PATH=path)
    assert {file.name for file in tmp_path.glob("*.png")} == {"bifurcation.png", "current_voltage.png"}
