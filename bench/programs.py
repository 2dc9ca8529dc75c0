"""Times of whole processes: pendula, and the program of a student (student.cpp), on the problems of the assignment."""

import os
import time
from pathlib import Path

EXAMPLES = Path(__file__).parent.parent / "examples/datosTarea_03.txt"
FIGURES = ("3.1", "3.2", "3.3", "3.4")


def run(program, data):
    """The time [s] from the start of a process to its end."""
    null = (os.POSIX_SPAWN_OPEN, 1, os.devnull, os.O_WRONLY, 0)
    given = (os.POSIX_SPAWN_OPEN, 0, data, os.O_RDONLY, 0)
    start = time.perf_counter()
    process = os.posix_spawn(program, [program], os.environ, file_actions=[given, null])
    _, status = os.waitpid(process, 0)
    seconds = time.perf_counter() - start
    if status != 0:
        raise RuntimeError(f"{program} failed on {data}")
    return seconds


def cases(build):
    """Yields a name and a call that runs one process and returns its time."""
    lines = [line for line in EXAMPLES.read_text().splitlines() if line and not line.startswith("#")]
    for figure, line in zip(FIGURES, lines, strict=True):
        data = build / f"figure_{figure}.txt"
        data.write_text(line + "\n")
        for side, program in (("pendula", build / "pendula"), ("student", build / "bench/student")):
            yield f"program_{figure}/{side}", lambda program=program, data=data: run(str(program), str(data))
