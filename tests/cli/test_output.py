"""Where output goes, and what happens when it cannot go there."""

import os
import resource
import signal
import subprocess
from typing import Any

import pytest
from conftest import CLEAN, GOOD, PROGRAM
from processes import rest

LONG_RUN = "0.01 0.01 1e9 1 r 0 r 1\n"


def test_output_goes_to_the_file_named(pendula, tmp_path):
    file = tmp_path / "table.txt"
    file.write_text("what it held before, which is longer than the table " * 100)
    done = pendula("--output", str(file), text=GOOD)
    assert (done.returncode, done.stdout, done.stderr) == (0, b"", b"")
    assert file.read_bytes() == pendula(text=GOOD).stdout


def test_a_hyphen_is_standard_output(pendula, tmp_path):
    done = pendula("--output", "-", text=GOOD, cwd=tmp_path)
    assert (done.returncode, done.stdout, list(tmp_path.iterdir())) == (0, pendula(text=GOOD).stdout, [])


@pytest.mark.parametrize("kind", ["name", "hard link", "symbolic link", "/dev/stdin", "append"])
@pytest.mark.parametrize("arguments, text", [([], GOOD), (["analyze"], "1 r 0 r 1\n")])
def test_the_file_that_is_read_is_never_written(tmp_path, kind, arguments, text):
    problems, other = tmp_path / "problems.txt", tmp_path / "other.txt"
    problems.write_text(text)
    if kind == "hard link":
        other.hardlink_to(problems)
    elif kind == "symbolic link":
        other.symlink_to(problems)
    path = {"name": problems, "/dev/stdin": "/dev/stdin"}.get(kind, other)
    with open(problems, "rb") as given, open(problems, "ab") as appended:
        where: dict[str, Any] = {"stdout": appended} if kind == "append" else {"stdout": subprocess.PIPE}
        option = [] if kind == "append" else ["--output", str(path)]
        done = subprocess.run(
            [PROGRAM, *arguments, *option], stdin=given, stderr=subprocess.PIPE, env=CLEAN, timeout=60, **where
        )
    assert done.returncode == 2 and b"is what standard input is read from" in done.stderr
    assert problems.read_text() == text


def test_devices_may_be_read_and_written(pendula):
    assert pendula("--output", "/dev/null", text=GOOD).returncode == 0
    command = [PROGRAM, "analyze", "--output", "/dev/null"]
    assert subprocess.run(command, stdin=subprocess.DEVNULL, env=CLEAN, timeout=60).returncode == 0


@pytest.mark.parametrize("text", ["", "0.1 0.1 1 1 x 0 r 1"])
def test_a_bad_first_problem_leaves_the_file_alone(pendula, tmp_path, text):
    old, new = tmp_path / "old.txt", tmp_path / "new.txt"
    old.write_text("kept")
    assert pendula("--output", str(old), text=text).returncode == 1
    assert pendula("--output", str(new), text=text).returncode == 1
    assert old.read_text() == "kept" and not new.exists()


@pytest.mark.parametrize("name, reason", [("", "it is a directory"), ("no/such", "no such file or directory")])
def test_a_file_that_cannot_be_opened_is_status_3(pendula, tmp_path, name, reason):
    done = pendula("--output", f"{tmp_path}/{name}", text=GOOD)
    assert (done.returncode, done.stdout) == (3, b"")
    assert done.stderr.decode().endswith(f" could not be written: {reason}\n")


@pytest.mark.parametrize("arguments", [[], ["--format", "json"], ["--help"], ["--version"], ["analyze", "--theta0", "1"]])
def test_a_full_disk_is_status_3(pendula, arguments):
    with open("/dev/full", "wb") as full:
        done = pendula(*arguments, text=GOOD, stdout=full)
    assert done.returncode == 3
    assert done.stderr == b"pendula: standard output could not be written: no space left on the device\n"


def test_a_full_disk_is_said_in_spanish(pendula):
    with open("/dev/full", "wb") as full:
        done = pendula("--lang", "es", text=GOOD, stdout=full)
    assert done.stderr.decode() == "pendula: no se ha podido escribir la salida estándar: no queda espacio en el dispositivo\n"


def test_a_closed_standard_output_is_status_3(pendula):
    done = pendula(text=GOOD, stdout=None, preexec_fn=lambda: os.close(1))
    assert (done.returncode, done.stderr) == (3, b"pendula: standard output could not be written: it is closed\n")


def test_messages_never_reach_a_file_in_place_of_a_closed_standard_error(pendula, tmp_path):
    file = tmp_path / "table.txt"
    done = pendula("--output", str(file), text=GOOD + "bad", preexec_fn=lambda: os.close(2))
    assert done.returncode == 1
    assert file.read_bytes() == pendula(text=GOOD).stdout


@pytest.mark.parametrize("limit", [100_000, 65_536, 1_000_001])
@pytest.mark.parametrize("through_option", [False, True])
def test_a_file_that_may_not_grow_ends_with_a_whole_row(pendula, tmp_path, limit, through_option):
    file = tmp_path / "table.txt"
    limited = {"preexec_fn": lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))}
    if through_option:
        done = pendula("--output", str(file), text=LONG_RUN, **limited)
    else:
        with open(file, "wb") as out:
            done = pendula(text=LONG_RUN, stdout=out, **limited)
    written = file.read_bytes()
    assert done.returncode == 3 and b"the file would be too large" in done.stderr
    assert limit - 100 < len(written) <= limit
    assert written.endswith(b"\n") and {line.count(b" ") for line in written.splitlines()} == {3}


def test_a_cut_after_an_append_keeps_what_was_there(pendula, tmp_path):
    file = tmp_path / "table.txt"
    file.write_text("before\n")
    with open(file, "ab") as out:
        pendula(text=LONG_RUN, stdout=out, preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (9999, 9999)))
    assert file.read_bytes().startswith(b"before\nt angulo") and file.read_bytes().endswith(b"\n")


def read_a_little_and_close(start, **options):
    process = start(text=LONG_RUN.encode(), **options)
    process.stdout.read(1000)
    process.stdout.close()
    return process.wait(timeout=20), rest(process.stderr)


def test_a_closed_pipe_ends_it_quietly(start):
    assert read_a_little_and_close(start) == (-signal.SIGPIPE, b"")


def test_a_closed_pipe_ends_it_quietly_where_the_signal_is_ignored(start):
    ignored = {"restore_signals": False, "preexec_fn": lambda: signal.signal(signal.SIGPIPE, signal.SIG_IGN)}
    assert read_a_little_and_close(start, **ignored) == (0, b"")


def test_a_table_is_there_before_the_next_problem_is_typed(start):
    process = start(text=b"0.01 0.5 1 1 r 0 r 1\n")
    assert [process.stdout.readline().count(b" ") for _ in range(4)] == [3] * 4
    process.stdin.close()
    assert process.wait(timeout=20) == 0


def test_a_line_is_analysed_before_the_next_is_typed(start):
    process = start("analyze")
    for _ in range(3):
        process.stdin.write(b"1 r 0 r 1\n")
        process.stdin.flush()
        assert process.stdout.readline() == b"-1 1 6.69998\n"
    process.stdin.close()
    assert process.wait(timeout=20) == 0


def within(mebibytes):
    return {"preexec_fn": lambda: resource.setrlimit(resource.RLIMIT_AS, (mebibytes << 20, mebibytes << 20))}


@pytest.mark.parametrize(
    "text",
    [
        "1 1e-6 1 1 r 0 r 1",
        "1 1 1 1 r 0 r 1\n" * 100_000,
        "1 1 1 1 r 0 r 1 #" + "x" * (32 << 20),
        " " * (32 << 20) + "1 1 1 1 r 0 r 1",
    ],
    ids=["rows", "problems", "comment", "space"],
)
def test_memory_does_not_grow_with_the_run(pendula, text):
    assert pendula("--method", "exact", text=text, stdout=subprocess.DEVNULL, **within(16)).returncode == 0


def test_a_huge_token_takes_no_memory(pendula):
    done = pendula(text="1" * (32 << 20), **within(16))
    assert done.returncode == 1 and b"longer than 4096 bytes" in done.stderr
