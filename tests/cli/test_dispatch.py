"""Names that are none of the program's own run `pendula-NAME`."""

import os
import shutil

import pytest
from conftest import CLEAN, PROGRAM


def script(path, text='echo "$0" "$@"; exit 7'):
    path.parent.mkdir(exist_ok=True)
    path.write_text(f"#!/bin/sh\n{text}\n")
    path.chmod(0o755)


@pytest.fixture
def on_path(tmp_path):
    folder = tmp_path / "path"
    script(folder / "pendula-plot")
    return {"PATH": f"{folder}:{CLEAN['PATH']}"}


def test_a_program_on_path_gets_the_arguments_and_gives_its_status(pendula, on_path):
    done = pendula("plot", "a b", "--help", "", env=on_path)
    assert done.stdout.endswith(b"/pendula-plot a b --help \n") and done.returncode == 7


def test_an_option_before_the_name_is_handed_on(pendula, on_path):
    assert pendula("--lang", "es", "plot", "x", env=on_path).stdout.endswith(b"/pendula-plot --lang es x\n")


def test_a_program_beside_goes_before_one_on_path(on_path, tmp_path):
    import subprocess

    shutil.copy(PROGRAM, tmp_path / "pendula")
    script(tmp_path / "pendula-plot", "echo beside")
    link = tmp_path / "path" / "linked"
    link.symlink_to(tmp_path / "pendula")
    for program in (tmp_path / "pendula", link):
        assert subprocess.run([program, "plot"], capture_output=True, env=CLEAN | on_path).stdout == b"beside\n"


def test_standard_input_is_handed_on(pendula, tmp_path):
    script(tmp_path / "pendula-cat", "cat")
    assert pendula("cat", text="x\n", env={"PATH": f"{tmp_path}:{CLEAN['PATH']}"}).stdout == b"x\n"


@pytest.mark.parametrize(
    "name, message",
    [
        ("slove", 'unknown command "slove"; did you mean solve?'),
        ("analyse", 'unknown command "analyse"; did you mean analyze?'),
        ("plt", 'unknown command "plt"; did you mean plot?'),
        ("frobnicate", 'unknown command "frobnicate"; there are analyze, lyapunov, plot, section, solve, velocity'),
        ("", 'unknown command ""; there are analyze, lyapunov, plot, section, solve, velocity'),
        ("../plot", 'unknown command "../plot"; there are analyze, lyapunov, plot, section, solve, velocity'),
    ],
)
def test_a_name_that_is_nowhere_is_bad_usage_with_the_nearest(pendula, on_path, name, message):
    done = pendula(name, env=on_path)
    assert (done.returncode, done.stdout) == (2, b"")
    assert done.stderr.decode() == f"pendula: {message}\n"


def test_a_name_that_is_nowhere_is_refused_in_spanish(pendula, on_path):
    done = pendula("--lang", "es", "slove", env=on_path)
    assert done.stderr.decode() == 'pendula: orden desconocida "slove"; ¿querías decir solve?\n'


def test_a_file_in_place_of_a_name_is_told_how_to_be_read(pendula, tmp_path):
    (tmp_path / "problems.txt").write_text("")
    done = pendula("problems.txt", cwd=tmp_path)
    assert done.returncode == 2
    assert done.stderr == b'pendula: "problems.txt" is a file, no command; to read problems from it: pendula < problems.txt\n'


def test_a_program_that_may_not_run_is_said_so(pendula, tmp_path):
    (tmp_path / "pendula-closed").write_text("")
    done = pendula("closed", env={"PATH": str(tmp_path)})
    assert (done.returncode, done.stderr) == (2, b'pendula: "pendula-closed" could not be run: permission denied\n')


def test_no_path_at_all_is_no_harm(pendula):
    environment = {name: value for name, value in os.environ.items() if name != "PATH"}
    import subprocess

    done = subprocess.run([PROGRAM, "nothing"], capture_output=True, env=environment)
    assert done.returncode == 2 and b"unknown command" in done.stderr
