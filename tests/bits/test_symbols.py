"""What the linker sees of the core: nothing of libm, no function that could serve the wrong processor, and of a shared library
the public names only."""

from __future__ import annotations

import platform
import re
from pathlib import Path

import pytest
from builds import GCC, ROOT, SHARED, run


@pytest.fixture(scope="module")
def directory() -> Path:
    GCC.make()
    return GCC.directory / "src"


def symbols(*arguments: str | Path) -> list[tuple[str, str]]:
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


@pytest.fixture(scope="module", params=SHARED, ids=str)
def shared_library(request) -> Path:
    request.param.make()
    return next((request.param.directory / "src").glob("libpendula.so.*.*.*"))


def declarations(directory: Path) -> set[str]:
    """The functions and tables of the public headers: names that stand before a parenthesis or an array's brackets."""
    headers = [*(ROOT / "include" / "pendula").glob("*.hpp"), directory / "include" / "pendula" / "version.hpp"]
    code = "".join(re.sub(r"//.*", "", header.read_text()) for header in headers)
    return set(re.findall(r"\b(\w+)(?:\(|\[\])", code))


def test_a_shared_library_exports_what_the_public_headers_declare(shared_library):
    listed = run("nm", "--dynamic", "--defined-only", "--demangle", shared_library).splitlines()
    exported = [line.split(maxsplit=2)[2] for line in listed]
    assert any(name.startswith("pendula::analyze(") for name in exported)
    declared = declarations(shared_library.parents[1])
    public = re.compile(r"pendula::(?:actividad3::)?(\w+)(?:\[abi:cxx11\])?(?:\(.*)?")
    assert [name for name in exported if not ((match := public.fullmatch(name)) and match[1] in declared)] == []


def test_the_soname_says_which_versions_are_compatible(shared_library):
    """The package's rule is one minor version (SameMinorVersion in cmake/install.cmake)."""
    major, minor, _ = shared_library.name.removeprefix("libpendula.so.").split(".")
    assert f"[libpendula.so.{major}.{minor}]" in run("readelf", "--dynamic", "--wide", shared_library)
