"""At a terminal: what to type, and how far a long run is."""

import os
import pty
import re
import select
import subprocess
import time

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


def test_a_terminal_is_told_what_to_type_in_its_language():
    for environment, pattern in (({}, "type problems, eight values each"), ({"LANG": "es_ES.UTF-8"}, "escribe problemas, cada uno de ocho valores")):
        terminal = Terminal(env=environment)
        terminal.read_until(pattern)
        terminal.type("\x04")
        assert terminal.process.wait(timeout=10) == 1


def test_what_to_type_goes_to_standard_error():
    terminal = Terminal(streams=("stdin",))
    terminal.type(GOOD + "\x04")
    output, message = terminal.process.communicate(timeout=10)
    assert terminal.process.returncode == 0
    assert output.startswith(b"t angulo") and b"type problems" in message


def test_a_table_follows_each_problem_typed():
    terminal = Terminal()
    terminal.read_until("0.0001 0.02 1 90 s 0 r 1\r\n")
    terminal.type("0.01 0.5 1 1 r 0 r 1\n")
    terminal.read_until("t angulo velocidad funcionSinusoidal\r\n0 1 0 1\r\n")
    terminal.type("0.01 0.5 1 0 r 3 r 1\n")
    terminal.read_until("\r\n\r\n\r\nt angulo velocidad\r\n0 0 3\r\n")
    terminal.type("\x04")
    assert terminal.process.wait(timeout=10) == 0


def test_analyze_answers_each_line_typed():
    terminal = Terminal("analyze")
    terminal.read_until("type lines")
    terminal.type("0 r 2 r 1\n")
    terminal.read_until("0 3.14159 7.14932\r\n")
    terminal.type("0 r 2 r\n")
    terminal.read_until("ERROR: line 2: the line ends too soon; missing: α")
    terminal.type("\x04")
    assert terminal.process.wait(timeout=10) == 1


def test_a_long_run_shows_how_far_it_is_and_leaves_no_trace():
    terminal = Terminal(streams=("stderr",))
    terminal.process.stdin.write(b"1e-9 0.1 1e3 1 r 0 r 1\n")
    terminal.process.stdin.flush()
    terminal.read_until(r"\r\x1b\[Kpendula: 0 %, \d+ s left")
    terminal.process.terminate()
    assert terminal.process.wait(timeout=10) == 130
    assert re.search(r"s left\r\x1b\[K$", terminal.read_until(r"left\r\x1b\[K$"))


def test_a_short_run_shows_nothing():
    terminal = Terminal(streams=("stderr",))
    terminal.process.stdin.write(GOOD.encode())
    terminal.process.stdin.close()
    assert terminal.process.wait(timeout=10) == 0
    assert not select.select([terminal.own], [], [], 0)[0] or os.read(terminal.own, 1) == b""


def test_without_a_terminal_a_long_run_says_nothing(pendula):
    process = subprocess.Popen([PROGRAM], stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE, env=CLEAN)
    process.stdin.write(b"1e-9 0.1 1e3 1 r 0 r 1\n")
    process.stdin.flush()
    time.sleep(1.5)
    process.terminate()
    _, message = process.communicate(timeout=10)
    assert (process.returncode, message) == (130, b"")
