"""What the console scripts share: languages, options, statuses, and what is written where."""

import os
import re
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from conftest import PROGRAM
from pendula import _command, _core
from pendula._command import RefusedError

SCRIPTS = ("check", "plot")
PROBLEM = "0.001 0.02 1 90 s 0 r 1\n"
HIDDEN = ("DISPLAY", "WAYLAND_DISPLAY", "LC_ALL", "LC_MESSAGES", "LANG")
CLEAN = {name: value for name, value in os.environ.items() if name not in HIDDEN}


def script(name):
    return PROGRAM.with_name(f"pendula-{name}")


def run(name, *arguments, env=None, **options):
    """One of the scripts, whose streams are pipes unless given."""
    streams = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE} | options
    return subprocess.run([script(name), *arguments], env=CLEAN | (env or {}), encoding="utf-8", timeout=120, **streams)


@pytest.fixture
def files(tmp_path, program):
    """The arguments of a check whose table is right."""
    (tmp_path / "problem").write_text(PROBLEM)
    (tmp_path / "table").write_text(program(text=PROBLEM))
    return [tmp_path / "table", "--input", tmp_path / "problem"]


@pytest.mark.parametrize(
    ("name", "arguments", "english", "spanish"),
    [
        ("check", [], "TABLE is missing", "falta TABLE"),
        ("check", ["table"], "--input is missing", "falta --input"),
        ("check", ["a", "--input", "b", "--json", "--json-lines"], "exclude each other", "se excluyen"),
        ("check", ["a", "--input", "b", "--points", "-1"], "--points must be", "--points debe ser"),
        ("check", ["--explain", "eulr"], "there is no finding 'eulr'; is it 'euler'?", "¿es 'euler'?"),
        ("check", ["--nonsense"], "unknown option '--nonsense'", "opción desconocida '--nonsense'"),
        ("check", ["-x"], "unknown option '-x'", "opción desconocida '-x'"),
        ("check", ["--input"], "option --input needs a value", "la opción --input necesita un valor"),
        ("check", ["--input", "--json"], "option --input needs a value", "la opción --input necesita un valor"),
        ("check", ["--json=1"], "option --json takes no value", "la opción --json no lleva valor"),
        ("plot", ["--flow", "--flow"], "option --flow is given twice", "la opción --flow está dos veces"),
        ("plot", ["--output="], "option --output needs a value", "la opción --output necesita un valor"),
        ("plot", ["--nonsense", "--output", "a.png"], 'unknown option "--nonsense"', 'opción desconocida "--nonsense"'),
    ],
)
def test_bad_usage_has_status_2_and_a_reason_in_the_language_chosen(name, arguments, english, spanish):
    for lang, words in (("en", english), ("es", spanish)):
        for chosen, env in ((["--lang", lang], {}), ([], {"LANG": f"{lang}_XX.UTF-8"})):
            done = run(name, *arguments, *chosen, env=env, stdin=subprocess.DEVNULL)
            assert (done.returncode, done.stdout) == (2, ""), (lang, done.stderr)
            assert words in done.stderr
            assert len(done.stderr.splitlines()) == 1


@pytest.mark.parametrize("name", SCRIPTS)
def test_a_language_that_it_does_not_speak_is_bad_usage(name):
    assert run(name, "--lang", "fr").stderr == f"pendula {name}: --lang must be en or es, got 'fr'\n"
    assert run(name, "--lang", "fr", env={"LC_ALL": "es_ES"}).stderr == f"pendula {name}: --lang debe ser en o es, y es 'fr'\n"


@pytest.mark.parametrize(
    ("arguments", "environment", "lang"),
    [
        ([], {}, "en"),
        ([], {"LANG": "es_ES.UTF-8"}, "es"),
        ([], {"LANG": "es", "LC_MESSAGES": "C"}, "en"),
        ([], {"LANG": "C", "LC_MESSAGES": "C", "LC_ALL": "es_AR"}, "es"),
        ([], {"LANG": "es", "LC_ALL": ""}, "es"),
        (["--lang", "es"], {"LC_ALL": "C"}, "es"),
        (["--flow", "--lang=en"], {"LC_ALL": "es"}, "en"),
        (["--lang"], {"LC_ALL": "es"}, "es"),
        (["--lang", "fr"], {"LC_ALL": "es"}, "es"),
    ],
)
def test_the_option_goes_before_the_environment(monkeypatch, arguments, environment, lang):
    for name in HIDDEN:
        monkeypatch.delenv(name, raising=False)
    for name, value in environment.items():
        monkeypatch.setenv(name, value)
    assert _core.language_of(arguments) == lang


@pytest.mark.parametrize("name", SCRIPTS)
def test_the_manual_names_every_option_in_both_languages(name):
    english, spanish = run(name, "--help"), run(name, "-h", "--lang", "es")
    assert (english.returncode, spanish.returncode) == (0, 0)
    assert english.stdout.startswith(f"usage: pendula {name} ")
    assert spanish.stdout.startswith(f"uso: pendula {name} ")
    options = [re.findall(r"^  (--\S+)", page.stdout, re.MULTILINE) for page in (english, spanish)]
    assert options[0] == options[1]
    assert {"--lang", "--help", "--version"} < {*options[0]}
    assert max(len(line) for page in (english, spanish) for line in page.stdout.splitlines()) <= 80


@pytest.mark.parametrize("name", SCRIPTS)
def test_the_version_is_that_of_the_program(name, program):
    assert run(name, "--version").stdout == program("--version").replace("pendula", f"pendula {name}")


@pytest.mark.parametrize(
    "arguments", [["--help"], ["--version"], ["--list"], ["--explain", "euler"], "files", "json", "class", "lines"]
)
def test_standard_output_is_never_silently_short(arguments, files):
    several = [files[0].with_name("*"), *files]
    given = {"files": files, "json": [*files, "--json"], "class": several, "lines": [*several, "--json-lines"]}
    arguments = given.get(str(arguments), arguments)
    with Path("/dev/full").open("w") as full:
        done = run("check", *arguments, stdout=full)
    assert (done.returncode, done.stderr) == (
        3,
        "pendula check: standard output could not be written: No space left on device\n",
    )
    closed = subprocess.run(["sh", "-c", '"$@" >&-', "sh", script("check"), *arguments], capture_output=True, env=CLEAN)
    assert (closed.returncode, closed.stderr) == (3, b"pendula check: standard output could not be written: it is closed\n")


@pytest.mark.parametrize("arguments", [["--help"], "files"])
def test_a_closed_pipe_is_the_reader_s_choice(arguments, files):
    reading, writing = os.pipe()
    os.close(reading)
    try:
        done = run("check", *(files if arguments == "files" else arguments), stdout=writing)
    finally:
        os.close(writing)
    assert (done.returncode, done.stderr) == (0, "")


@pytest.mark.parametrize("name", SCRIPTS)
def test_messages_that_nobody_can_read_change_no_status(name):
    with Path("/dev/full").open("w") as full:
        assert run(name, "--lang", "fr", stderr=full).returncode == 2
    closed = subprocess.run(["sh", "-c", '"$@" 2>&-', "sh", script(name), "--lang", "fr"], capture_output=True, env=CLEAN)
    assert (closed.returncode, closed.stdout) == (2, b"")


def test_text_is_utf_8_whatever_the_locale(files):
    done = run("check", *files, "--lang", "es", env={"PYTHONIOENCODING": "ascii", "PYTHONUTF8": "0", "LC_ALL": "C"})
    assert (done.returncode, done.stderr) == (0, "")
    assert "error máximo" in done.stdout
    assert "vacío" in run("check", "/dev/null", "--input", files[2], "--lang", "es", env={"PYTHONIOENCODING": "ascii"}).stderr


def test_ctrl_c_ends_plot_and_the_program(tmp_path):
    (tmp_path / "problem").write_text("1e-6 1 1e9 1 r 0 r 1")  # a year's work
    with (tmp_path / "problem").open() as problem:
        process = subprocess.Popen(
            [script("plot"), "--output", tmp_path / "a.png"],
            stdin=problem,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            env=CLEAN,
            preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),  # a script in the background ignores it
        )
    children = Path(f"/proc/{process.pid}/task/{process.pid}/children")
    deadline = time.monotonic() + 60
    child, exe = "", ""
    while not exe.endswith("/pendula") and time.monotonic() < deadline:  # started and running, not a fork of the script
        time.sleep(0.2)
        child = children.read_text().strip()
        exe = os.readlink(f"/proc/{child}/exe") if child else ""
    process.send_signal(signal.SIGINT)  # to the script only
    assert process.communicate(timeout=60) == (b"", b"")
    assert process.returncode == 130
    assert not Path(f"/proc/{child}").exists()


INTERRUPTED_WHILE_IMPORTING = """
import os, signal, sys

class Interruption:
    def find_spec(self, name, *_):
        if name == "numpy":
            os.kill(os.getpid(), signal.SIGINT)

signal.signal(signal.SIGINT, signal.default_int_handler)
sys.meta_path.insert(0, Interruption())
import pendula_scripts
pendula_scripts.{0}()
"""


@pytest.mark.parametrize("name", SCRIPTS)
def test_ctrl_c_is_quiet_also_while_numpy_is_imported(name):
    command = [sys.executable, "-c", INTERRUPTED_WHILE_IMPORTING.format(name)]
    done = subprocess.run(command, capture_output=True, env=CLEAN, timeout=120)
    assert (done.returncode, done.stdout, done.stderr) == (130, b"", b"")


@pytest.mark.parametrize("entries", ["", ":", ".:", "::/nowhere"])
def test_the_program_is_never_one_of_the_current_directory(monkeypatch, tmp_path, entries):
    (tmp_path / "pendula").write_text("#!/bin/sh\n")
    (tmp_path / "pendula").chmod(0o755)
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("sysconfig.get_path", lambda *_: "/nowhere")
    monkeypatch.setenv("PATH", entries)
    with pytest.raises(RefusedError, match="neither among this Python's scripts nor on PATH") as refused:
        _command.path()
    assert refused.value.status == 2
    monkeypatch.setenv("PATH", f"{entries}:{tmp_path}")
    assert _command.path() == str(tmp_path / "pendula")


def test_a_table_of_the_program_has_a_largest_size(monkeypatch):
    arguments = ["--theta0", "1", "--omega0", "0"]
    (solved,) = _command.solve(arguments, states_problem=True)
    assert solved.solution.t[-1] == solved.until
    monkeypatch.setattr(_command, "MOST_CHARACTERS", 1000)
    with pytest.raises(RefusedError, match="too many rows"):
        _command.solve(arguments, states_problem=True)
