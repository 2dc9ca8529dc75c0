"""`pendula check` answers within bounds of time and memory, whatever it is given."""

import contextlib
import json
import os
import signal
import subprocess
import sys

import pytest
from check_hostile import HOSTILE

SECONDS = 2.0
MEGABYTES = 200
NOMINAL = 0.05  # seconds of the calibration below, on the machine that SECONDS are for
KILLED = 20  # seconds

# Runs the command in this process and tells what it took beyond the imports. Not ru_maxrss, in which the process that started
# this one counts.
CHILD = """
import json, os, re, resource, sys, time

resource.setrlimit(resource.RLIMIT_AS, (1 << 32, 1 << 32))

from pendula.check._main import main

def peak():
    return int(re.search(r"VmHWM:\\s*(\\d+)", open("/proc/self/status").read())[1]) / 1024

def used():
    return sum(os.times()[:4])

start = time.process_time()
sum(number * number % 7 for number in range(10**6))
calibration = time.process_time() - start

told, *sys.argv[1:] = sys.argv[1:]
memory, processor, clock = peak(), used(), time.monotonic()
status = main()
# Other programs make the clock run on, and other threads the processors.
seconds = min(used() - processor, time.monotonic() - clock)
json.dump({"status": status, "seconds": seconds, "megabytes": peak() - memory, "calibration": calibration}, open(told, "w"))
"""


def run_for_a_while(command, errors):
    """Runs a program and, in the end, kills it with those that it has started."""
    with errors.open("wb") as file:
        streams = {"stdin": subprocess.DEVNULL, "stdout": subprocess.DEVNULL, "stderr": file}
        with subprocess.Popen(command, **streams, start_new_session=True) as process:
            with contextlib.suppress(subprocess.TimeoutExpired):
                process.wait(KILLED)
            with contextlib.suppress(ProcessLookupError):
                os.killpg(process.pid, signal.SIGKILL)


@pytest.fixture(scope="module", params=HOSTILE)
def answer(request, tmp_path_factory):
    """What the command took, and what it wrote to standard error."""
    folder = tmp_path_factory.mktemp("hostile")
    hostile = HOSTILE[request.param]
    (folder / "problems").write_text(hostile.problems)
    (folder / "table").write_bytes(hostile.table())
    command = [sys.executable, "-c", CHILD, folder / "told", folder / "table", "--input", folder / "problems"]
    run_for_a_while(command, folder / "errors")
    error = (folder / "errors").read_text()
    assert (folder / "told").exists(), error or "no answer"
    return json.loads((folder / "told").read_text()) | {"error": error}


pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="memory is measured as Linux tells it")


def test_every_input_has_an_answer_in_words(answer):
    assert answer["status"] in (1, 2)
    assert "Traceback" not in answer["error"]
    assert (answer["status"] == 2) == answer["error"].startswith("pendula")


def test_an_answer_takes_no_longer_than_a_moment(answer):
    assert answer["seconds"] <= SECONDS * max(1, answer["calibration"] / NOMINAL)


def test_an_answer_takes_no_more_memory_than_coursework_needs(answer):
    assert answer["megabytes"] <= MEGABYTES
