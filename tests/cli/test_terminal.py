"""At a terminal: what to type, and how far a long run is."""

import os
import pty
import re
import select
import subprocess
import time

import pytest
from conftest import CLEAN, GOOD, PROGRAM


class Terminal:
    """The program with a terminal for the streams named, and pipes for the others."""

    def __init__(self, *arguments, streams=("stdin", "stdout", "stderr"), env=None):
        self.own, other = pty.openpty()
        ends = {name: other if name in streams else subprocess.PIPE for name in ("stdin", "stdout", "stderr")}
        self.process = subprocess.Popen([PROGRAM, *arguments], env=CLEAN | (env or {}), start_new_session=True, **ends)
        os.close(other)
        self.seen = ""

    def type(self, text):
        os.write(self.own, text.encode())

    def read_until(self, pattern, seconds=10):
        deadline = time.monotonic() + seconds
        while not re.search(pattern, self.seen):
            ready, _, _ = select.select([self.own], [], [], max(0, deadline - time.monotonic()))
            assert ready, f"no {pattern!r} in {self.seen!r}"
            self.seen += os.read(self.own, 4096).decode()
        return self.seen

    def close(self):
        self.process.kill()
        self.process.wait()
        os.close(self.own)
        for stream in (self.process.stdin, self.process.stdout, self.process.stderr):
            if stream:
                stream.close()


@pytest.fixture
def terminal():
    opened = []

    def make(*arguments, **options):
        opened.append(Terminal(*arguments, **options))
        return opened[-1]

    yield make
    for one in opened:
        one.close()


def test_a_terminal_is_told_what_to_type_in_its_language(terminal):
    for environment, pattern in (
        ({}, "type problems, eight values each"),
        ({"LANG": "es_ES.UTF-8"}, "escribe problemas, cada uno de ocho valores"),
    ):
        at = terminal(env=environment)
        at.read_until(pattern)
        at.type("\x04")
        assert at.process.wait(timeout=10) == 1


def test_what_to_type_goes_to_standard_error(terminal):
    at = terminal(streams=("stdin",))
    at.type(GOOD + "\x04")
    output, message = at.process.communicate(timeout=10)
    assert at.process.returncode == 0
    assert output.startswith(b"t angulo") and b"type problems" in message


def test_a_table_follows_each_problem_typed(terminal):
    at = terminal()
    at.read_until("0.0001 0.02 1 90 s 0 r 1\r\n")
    at.type("0.01 0.5 1 1 r 0 r 1\n")
    at.read_until("t angulo velocidad funcionSinusoidal\r\n0 1 0 1\r\n")
    at.type("0.01 0.5 1 0 r 3 r 1\n")
    at.read_until("\r\n\r\n\r\nt angulo velocidad\r\n0 0 3\r\n")
    at.type("\x04")
    assert at.process.wait(timeout=10) == 0


def test_analyze_answers_each_line_typed(terminal):
    at = terminal("analyze")
    at.read_until("type lines")
    at.type("0 r 2 r 1\n")
    at.read_until("0 3.14159 7.14932\r\n")
    at.type("0 r 2 r\n")
    at.read_until("ERROR: line 2: the line ends too soon; missing: α")
    at.type("\x04")
    assert at.process.wait(timeout=10) == 1


def test_a_long_run_shows_how_far_it_is_and_leaves_no_trace(terminal):
    at = terminal(streams=("stderr",))
    at.process.stdin.write(b"1e-9 0.1 1e3 1 r 0 r 1\n")
    at.process.stdin.flush()
    at.read_until(r"\r\x1b\[Kpendula: 0 %, \d+ s left")
    at.process.terminate()
    assert at.process.wait(timeout=10) == 130
    at.read_until(r"left\r\x1b\[K$")


def test_a_long_sweep_shows_how_far_it_is_too(terminal):
    driven = ("--beta", "0.5", "--drive-amplitude", "1.5", "--drive-frequency", "2/3")
    one = terminal("mean-velocity", *driven, "--method", "rk4", "--steps", "1e9", streams=("stderr",))
    one.read_until(r"\r\x1b\[Kpendula: 0 %")
    one.process.terminate()
    assert one.process.wait(timeout=10) == 130


def test_a_long_series_shows_how_far_it_is_too_and_is_interrupted(terminal):
    """Half a million series: the range makes the time certain."""
    one = terminal("analyze", "--method", "series", "--theta0", "3.1412:3.1412:500000", streams=("stderr",))
    one.read_until(r"\r\x1b\[Kpendula: 0 %, \d+ s left")
    one.process.terminate()
    assert one.process.wait(timeout=1) == 130
    assert set(one.process.stdout.read().splitlines()) <= {b"3.1412 -1 3.1412 39.6881"}


def test_a_short_run_shows_nothing(terminal):
    at = terminal(streams=("stderr",))
    at.process.stdin.write(GOOD.encode())
    at.process.stdin.close()
    assert at.process.wait(timeout=10) == 0
    with pytest.raises(OSError):  # the terminal's other end is closed, and nothing was written before
        os.read(at.own, 1)


def test_without_a_terminal_a_long_run_says_nothing(start):
    process = start(text=b"1e-9 0.1 1e3 1 r 0 r 1\n")
    time.sleep(1.5)
    process.terminate()
    _, message = process.communicate(timeout=10)
    assert (process.returncode, message) == (130, b"")
