"""Same bits everywhere: compilers, optimisation, instruction sets, processors and WebAssembly."""

from __future__ import annotations

import platform
from pathlib import Path

import pytest
from builds import AARCH64, FAST, GCC, GOLDEN, HERE, NATIVE, ROOT, SHARED, WASM32, attempt, instruction_sets, missing, run


def needs(*programs: str) -> None:
    if missing(*programs):
        pytest.skip(f"not installed: {missing(*programs)}")


def check(output: str) -> None:
    assert output.splitlines() == GOLDEN.read_text().splitlines()


@pytest.mark.parametrize("build", [*NATIVE, *SHARED, *FAST], ids=str)
def test_native_builds_agree_for_every_instruction_set(build):
    needs(build.compiler)
    golden = build.make()
    assert run(golden, "--isa").split() == instruction_sets()[-1:]
    check(run(golden))
    for isa in instruction_sets():
        assert run(golden, "--isa", PENDULA_ISA=isa).split() == [isa]
        check(run(golden, PENDULA_ISA=isa))


def test_an_old_processor_agrees_and_runs_baseline():
    needs(GCC.compiler, "qemu-x86_64")
    nehalem = "qemu-x86_64", "-cpu", "Nehalem", GCC.make()
    assert run(*nehalem, "--isa").split() == ["baseline"]
    check(run(*nehalem))


def test_aarch64_agrees():
    needs(AARCH64.compiler, "qemu-aarch64")
    check(run("qemu-aarch64", AARCH64.make()))


def test_webassembly_without_imports_agrees():
    needs(WASM32.compiler, "node")
    check(run("node", HERE / "golden.mjs", WASM32.make()))


@pytest.mark.parametrize("name", ["", "avx", "AVX2", "baseline ", "neon"])
def test_a_name_of_no_instruction_set_is_refused(name):
    done = attempt(GCC.make(), "--isa", PENDULA_ISA=name)
    assert (done.returncode, done.stdout) == (1, "")


def test_an_instruction_set_that_the_processor_lacks_is_refused():
    needs(GCC.compiler, "qemu-x86_64")
    done = attempt("qemu-x86_64", "-cpu", "Nehalem", GCC.make(), "--isa", PENDULA_ISA="avx2")
    assert (done.returncode, done.stdout) == (1, "")


REFUSED = [
    ("g++", "-ffast-math"),
    ("g++", "-Ofast"),
    ("g++", "-ffinite-math-only"),
    ("g++", "-funsafe-math-optimizations"),
    ("g++", "-freciprocal-math"),
    ("clang++-19", "-ffast-math"),
    ("clang++-19", "-Ofast"),
    ("clang++-19", "-ffinite-math-only"),
    *([("g++", "-mfpmath=387")] if platform.machine() == "x86_64" else []),
]


@pytest.mark.parametrize("compiler, flag", REFUSED)
def test_the_arithmetic_does_not_compile_under_a_flag_that_changes_results(tmp_path: Path, compiler, flag):
    needs(compiler)
    unit = tmp_path / "unit.cpp"
    unit.write_text('#include "arithmetic/pack.hpp"\n')
    compile_it = compiler, "-std=c++20", "-Wno-psabi", f"-I{ROOT / 'src'}", "-c", unit, "-o", tmp_path / "unit.o"
    assert attempt(*compile_it).returncode == 0
    done = attempt(*compile_it, flag)
    assert done.returncode != 0 and "pendula gives the same bits everywhere only" in done.stderr


def test_a_build_with_ofast_is_refused(tmp_path):
    done = attempt("cmake", "-S", ROOT, "-B", tmp_path, "-DCMAKE_CXX_FLAGS=-Ofast")
    assert done.returncode != 0 and "pendula gives the same bits everywhere only" in done.stderr
