"""Signals: status 130, and whole rows only."""

import os
import signal
import subprocess
import sys
import time

import pytest
from processes import rest

MANY_ROWS = b"0.01 0.01 1e9 1 r 0 r 1\n"
MANY_STEPS = b"1e-12 0.5 1 1 r 0 r 1\n"


def assert_whole_rows(output):
    assert output.endswith(b"\n") and {line.count(b" ") for line in output.splitlines()} == {3}


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM, signal.SIGHUP])
def test_a_run_into_a_file_is_interrupted_at_the_end_of_a_row(start, tmp_path, number):
    file = tmp_path / "table.txt"
    with open(file, "wb") as out:
        process = start(stdout=out, text=MANY_ROWS)
    time.sleep(0.3)
    process.send_signal(number)
    assert process.wait(timeout=10) == 130
    assert rest(process.stderr) == b""
    assert_whole_rows(file.read_bytes())


def test_a_run_into_a_slow_pipe_is_interrupted_at_the_end_of_a_row(start):
    process = start(text=MANY_ROWS)
    output = process.stdout.read(10_001)
    time.sleep(0.3)  # the pipe is full, the program waits in the middle of a row
    process.send_signal(signal.SIGINT)
    output += rest(process.stdout)
    assert process.wait(timeout=10) == 130
    assert_whole_rows(output)


def test_a_second_signal_kills_though_nobody_reads(start):
    process = start(text=MANY_ROWS)
    time.sleep(0.3)
    for _ in range(2):
        process.send_signal(signal.SIGINT)
        time.sleep(0.2)
    assert process.wait(timeout=10) in (130, -signal.SIGINT)


def test_long_steps_between_rows_are_interrupted_too(start):
    process = start(text=MANY_STEPS)
    time.sleep(0.3)
    process.send_signal(signal.SIGINT)
    since = time.monotonic()
    assert process.wait(timeout=10) == 130
    assert time.monotonic() - since < 1
    assert rest(process.stdout) == b"t angulo velocidad funcionSinusoidal\n0 1 0 1\n"


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM, signal.SIGHUP])
@pytest.mark.parametrize("arguments", [[], ["analyze"]])
@pytest.mark.parametrize("text", [b"", b"1 1 1 "])
def test_waiting_for_input_is_interrupted(start, arguments, text, number):
    process = start(*arguments, text=text)
    time.sleep(0.2)
    process.send_signal(number)
    assert process.wait(timeout=10) == 130
    assert (rest(process.stdout), rest(process.stderr)) == (b"", b"")


def test_a_file_cut_short_by_an_interruption_is_left_with_whole_rows(start, tmp_path):
    file = tmp_path / "table.txt"
    process = start("--output", str(file), text=MANY_ROWS)
    while not file.exists() or file.stat().st_size == 0:
        time.sleep(0.01)
    process.send_signal(signal.SIGINT)
    assert process.wait(timeout=10) == 130
    assert_whole_rows(file.read_bytes())


def test_an_ignored_signal_stays_ignored(start):
    process = start(preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_IGN), text=b"0.01 0.5 1 1 r 0 r 1\n")
    process.send_signal(signal.SIGINT)
    time.sleep(0.1)
    process.send_signal(signal.SIGINT)
    output, _ = process.communicate(timeout=10)
    assert process.returncode == 0 and output.count(b"\n") == 4


def test_programs_start_with_default_signals_where_the_tests_run_in_the_background_of_a_script():
    def ignore():
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            signal.signal(number, signal.SIG_IGN)

    tests = [sys.executable, "-m", "pytest", "-q", __file__, "-k", "waiting_for_input_is_interrupted or into_a_slow_pipe"]
    done = subprocess.run(tests, preexec_fn=ignore, capture_output=True, text=True, timeout=60)
    assert done.returncode == 0 and " passed" in done.stdout, done.stdout


def test_no_moment_is_bad_for_a_signal(start):
    for delay in range(30):
        process = start(text=b"0.01 0.001 1 1 r 0 r 1\n")
        time.sleep(delay * 0.0005)
        os.kill(process.pid, signal.SIGINT)
        output, _ = process.communicate(timeout=10)
        # Before it has set itself up the signal kills; afterwards it is 130.
        assert process.returncode in (130, -signal.SIGINT)
        if output:
            assert_whole_rows(output)
