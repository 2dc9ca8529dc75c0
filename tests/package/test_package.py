"""The installed package serves a program outside the tree, by find_package and by pkg-config, and from wherever it is moved."""

import os
import shutil
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
CONSUMER = Path(__file__).parent / "consumer"
OUTPUT = "2.36784 -1.5708\n"  # 4 K(sin 45 deg)/sqrt(9.81), and the other end of the swing


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


def test_find_package(prefix, tmp_path):
    shutil.copytree(CONSUMER, tmp_path / "source")
    run("cmake", "-S", tmp_path / "source", "-B", tmp_path / "build", f"-DCMAKE_PREFIX_PATH={prefix}")
    run("cmake", "--build", tmp_path / "build")
    assert run(tmp_path / "build" / "consumer") == OUTPUT


def test_pkg_config(prefix, tmp_path):
    folder = next(prefix.rglob("pendula.pc")).parent
    flags = run("pkg-config", "--cflags", "--libs", "pendula", PKG_CONFIG_PATH=str(folder)).split()
    run("c++", "-std=c++20", CONSUMER / "main.cpp", *flags, "-o", tmp_path / "consumer")
    assert run(tmp_path / "consumer") == OUTPUT


def test_the_program_is_installed(prefix):
    assert "0.148326 1.5598 -0.148324 1.55841" in subprocess.run(
        [prefix / "bin" / "pendula"], input="0.0001 0.02 1 90 s 0 r 1", capture_output=True, text=True, check=True
    ).stdout.splitlines()
