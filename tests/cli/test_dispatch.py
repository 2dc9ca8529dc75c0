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
        ("velocity", 'unknown command "velocity"; did you mean mean-velocity?'),
        ("mean_velocity", 'unknown command "mean_velocity"; did you mean mean-velocity?'),
        ("plt", 'unknown command "plt"; did you mean plot?'),
        (
            "frobnicate",
            'unknown command "frobnicate"; there are analyze, attractors, lyapunov, mean-velocity, orbit, plot, section, solve',
        ),
        ("", 'unknown command ""; there are analyze, attractors, lyapunov, mean-velocity, orbit, plot, section, solve'),
        (
            "../plot",
            'unknown command "../plot"; there are analyze, attractors, lyapunov, mean-velocity, orbit, plot, section, solve',
        ),
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
    file = tmp_path / "pendula-closed"
    file.write_text("")
    done = pendula("closed", env={"PATH": str(tmp_path)})
    assert (done.returncode, done.stderr.decode()) == (2, f'pendula: "{file}" could not be run: permission denied\n')


def test_a_program_whose_interpreter_is_gone_is_said_so(pendula, tmp_path):
    file = tmp_path / "pendula-old"
    script(file)
    file.write_text("#! /no/such/python -I\n")
    done = pendula("old", env={"PATH": str(tmp_path)})
    assert done.returncode == 2
    assert done.stderr.decode() == f'pendula: "{file}" could not be run: its interpreter "/no/such/python" is missing\n'


def test_a_link_to_a_program_that_is_gone_is_said_so(pendula, tmp_path):
    file = tmp_path / "pendula-gone"
    file.symlink_to("nowhere")
    done = pendula("gone", env={"PATH": str(tmp_path)})
    assert (done.returncode, done.stderr.decode()) == (
        2,
        f'pendula: "{file}" could not be run: it links to a file that is missing\n',
    )


def test_a_program_that_runs_goes_before_one_that_may_not(pendula, tmp_path, on_path):
    (tmp_path / "pendula-plot").write_text("")
    assert pendula("plot", env={"PATH": f"{tmp_path}:{on_path['PATH']}"}).returncode == 7


@pytest.mark.parametrize("path", ["", ":/usr/bin", "/usr/bin::/bin", "/usr/bin:", ".", "./", "bin:../x", "sub"])
def test_nothing_of_the_current_directory_is_ever_run(pendula, tmp_path, path):
    script(tmp_path / "pendula-evil", "echo evil")
    script(tmp_path / "sub" / "pendula-evil", "echo evil")
    done = pendula("evil", cwd=tmp_path, env={"PATH": path})
    assert (done.returncode, done.stdout) == (2, b"")
    assert b'unknown command "evil"; there are' in done.stderr and b" evil" not in done.stderr


def test_folders_and_files_that_cannot_run_are_not_offered(pendula, tmp_path):
    (tmp_path / "pendula-folder").mkdir()
    (tmp_path / "pendula-data").write_text("")
    for name in ("folder", "foldr", "dat"):
        done = pendula(name, env={"PATH": str(tmp_path)})
        assert done.returncode == 2 and b"unknown command" in done.stderr
        assert b"folder?" not in done.stderr and b"data" not in done.stderr


def test_no_path_at_all_is_no_harm():
    environment = {name: value for name, value in os.environ.items() if name != "PATH"}
    import subprocess

    done = subprocess.run([PROGRAM, "nothing"], capture_output=True, env=environment)
    assert done.returncode == 2 and b"unknown command" in done.stderr
