"""The installed package, and the program that came with it."""

import json
import sysconfig
from pathlib import Path

import numpy as np
import pytest
from hypothesis import settings
from processes import finished

PROGRAM = Path(sysconfig.get_path("scripts")) / "pendula"

# The same examples in every run, however slow the machine.
settings.register_profile("repeatable", derandomize=True, deadline=None)
settings.load_profile("repeatable")


@pytest.fixture(scope="session")
def program():
    """Runs the program and returns what it prints."""

    def run(*arguments, text=""):
        done = finished([PROGRAM, *arguments], text.encode(), seconds=600)
        assert (done.returncode, done.stderr) == (0, b"")
        return done.stdout.decode()

    return run


@pytest.fixture(scope="session")
def table(program):
    """The columns that the program prints for a problem, as doubles, by name."""

    def columns(names, **options):
        words = [word for name, value in options.items() for word in (f"--{name.replace('_', '-')}", str(value))]
        text = program("solve", "--columns", names, "--precision", "full", "--format", "json", *words)
        rows = [json.loads(line) for line in text.splitlines()[1:]]
        return {name: np.array([np.nan if row[name] is None else row[name] for row in rows]) for name in names.split(",")}

    return columns
