"""Drives the real program, at the path in PENDULA_PROGRAM, in an environment of which every test states what matters."""

import os
import subprocess
from contextlib import ExitStack

import pytest
from processes import finished, killed_after

PROGRAM = os.path.abspath(os.environ["PENDULA_PROGRAM"])
CLEAN = {name: value for name, value in os.environ.items() if name not in ("LC_ALL", "LC_MESSAGES", "LC_NUMERIC", "LANG")}

GOOD = "0.0001 0.02 1 90 s 0 r 1\n"
HEADER = "t angulo velocidad funcionSinusoidal\n"


@pytest.fixture
def pendula():
    """Runs the program on an input; streams are text, line ends untouched."""

    def run(*arguments, text="", env=None, **options):
        text = text.encode() if isinstance(text, str) else text
        return finished([PROGRAM, *arguments], text, env=CLEAN | (env or {}), **options)

    return run


@pytest.fixture
def start():
    """Starts the program with pipes for its streams, so that a test can talk to it; what is left is cleared away."""
    started = []
    watched = ExitStack()

    def popen(*arguments, text=b"", **options):
        streams = {"stdin": subprocess.PIPE, "stdout": subprocess.PIPE, "stderr": subprocess.PIPE} | options
        process = subprocess.Popen([PROGRAM, *arguments], env=CLEAN, **streams)
        started.append(process)
        watched.enter_context(killed_after(60, process))  # no test waits for ever
        process.stdin.write(text)
        process.stdin.flush()
        return process

    with watched:
        yield popen
    for process in started:
        process.kill()
        process.wait()
        for stream in (process.stdin, process.stdout, process.stderr):
            if stream:
                stream.close()


@pytest.fixture
def table(pendula):
    """The rows of a run that has to succeed, as lists of words, without the header."""

    def rows(*arguments, text=""):
        done = pendula(*arguments, text=text)
        assert (done.returncode, done.stderr) == (0, b"")
        return [line.split() for line in done.stdout.decode().splitlines()[1:]]

    return rows
