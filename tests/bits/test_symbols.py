"""What the linker sees of the core: nothing of libm, and no copy of a function that could serve the wrong processor."""

import platform

import pytest
from builds import GCC, run


@pytest.fixture(scope="module")
def directory():
    GCC.make()
    return GCC.directory / "src"


def symbols(*arguments):
    """(kind, name) of each symbol that nm lists."""
    lines = (line.split() for line in run("nm", "--no-demangle", *arguments).splitlines())
    return [(fields[-2], fields[-1].split("@")[0]) for fields in lines if len(fields) >= 2]


def test_the_core_needs_nothing_of_libm(directory):
    libm = run(GCC.compiler, "-print-file-name=libm.so.6").strip()
    exported = {name for _, name in symbols("--dynamic", "--defined-only", libm)}
    needed = {name for _, name in symbols("--undefined-only", directory / "libpendula.a")}
    assert {"sin", "fmod", "floor"} <= exported
    assert needed & exported == set()


@pytest.mark.parametrize("isa", ["baseline", "avx2", "avx512"] if platform.machine() == "x86_64" else ["baseline"])
def test_a_kernel_defines_no_function_outside_the_namespace_of_its_instruction_set(directory, isa):
    objects = list((directory / "CMakeFiles" / f"pendula_{isa}.dir").rglob("*.o"))
    assert objects
    functions = [name for kind, name in symbols("--defined-only", *objects) if kind in "TW"]  # data serves any processor
    assert [name for name in functions if f"{len(isa)}{isa}" not in name] == []
