"""Same bits everywhere: compilers, optimisation, instruction sets, processors and WebAssembly."""

import pytest
from builds import AARCH64, GCC, GOLDEN, HERE, NATIVE, WASM32, instruction_sets, missing, run


def needs(*programs):
    if missing(*programs):
        pytest.skip(f"not installed: {missing(*programs)}")


def check(output):
    assert output.splitlines() == GOLDEN.read_text().splitlines()


@pytest.mark.parametrize("build", NATIVE, ids=str)
def test_native_builds_agree_for_every_instruction_set(build):
    needs(build.compiler)
    golden = build.make()
    check(run(golden))
    for isa in instruction_sets():
        check(run(golden, PENDULA_ISA=isa))


def test_an_old_processor_agrees():
    needs(GCC.compiler, "qemu-x86_64")
    check(run("qemu-x86_64", "-cpu", "Nehalem", GCC.make()))


def test_aarch64_agrees():
    needs(AARCH64.compiler, "qemu-aarch64")
    check(run("qemu-aarch64", AARCH64.make()))


def test_webassembly_without_imports_agrees():
    needs(WASM32.compiler, "node")
    check(run("node", HERE / "golden.mjs", WASM32.make()))


def test_packs_and_threads_change_nothing():
    hashes = dict(line.split() for line in GOLDEN.read_text().splitlines())
    assert hashes["exact"] == hashes["exact_in_packs"]
    assert len({value for name, value in hashes.items() if name.startswith("ensembles")}) == 1
