"""Programs that tests start: whatever goes wrong in one, it neither runs nor writes without end."""

from __future__ import annotations

import contextlib
import subprocess
import threading
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import IO, Any

MOST = 1 << 26  # bytes; no test expects a tenth of it


def rest(stream: IO[bytes]) -> bytes:
    """What is left to read until the stream ends."""
    data = stream.read(MOST)
    assert len(data) < MOST, "the program writes without end"
    return data


@contextlib.contextmanager
def killed_after(seconds: float, process: subprocess.Popen[bytes]):
    timer = threading.Timer(seconds, process.kill)
    timer.start()
    try:
        yield
    finally:
        timer.cancel()


def finished(
    command: Sequence[str | Path], text: bytes, seconds: float = 60, **options: Any
) -> subprocess.CompletedProcess[bytes]:
    """Runs a program to its end: as subprocess.run with captured output, killed after so many seconds or MOST bytes."""
    streams = {"stdin": subprocess.PIPE, "stdout": subprocess.PIPE, "stderr": subprocess.PIPE} | options
    with subprocess.Popen(command, **streams) as process, killed_after(seconds, process), ThreadPoolExecutor(2) as pool:

        def captured(stream: IO[bytes] | None) -> bytes | None:
            try:
                return rest(stream) if stream else None
            except AssertionError:
                process.kill()
                raise

        output, errors = pool.submit(captured, process.stdout), pool.submit(captured, process.stderr)
        with contextlib.suppress(BrokenPipeError):  # it need not read all that it is given
            process.stdin.write(text)
        with contextlib.suppress(BrokenPipeError):
            process.stdin.close()
        return subprocess.CompletedProcess(command, process.wait(), output.result(), errors.result())
