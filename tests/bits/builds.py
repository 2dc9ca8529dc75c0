"""The builds of `golden` that must agree, and how each is run. As a program it rewrites golden.txt after an intended change."""

from __future__ import annotations

import os
import shutil
import subprocess
from dataclasses import dataclass
from pathlib import Path

HERE = Path(__file__).parent
ROOT = HERE.parents[1]
GOLDEN = HERE / "golden.txt"


@dataclass(frozen=True)
class Build:
    compiler: str
    flags: str
    toolchain: str = ""
    is_shared: bool = False

    def __str__(self) -> str:
        return " ".join(filter(None, (self.compiler, self.flags, self.toolchain, "shared" if self.is_shared else "")))

    @property
    def directory(self) -> Path:
        return ROOT / "build" / "bits" / str(self).replace(" ", "")

    def make(self) -> Path:
        """Builds `golden` and returns its path."""
        how = (
            [f"--toolchain={ROOT / 'cmake' / self.toolchain}.cmake"]
            if self.toolchain
            else [f"-DCMAKE_CXX_COMPILER={self.compiler}"]
        )
        options = [
            f"-DCMAKE_CXX_FLAGS_NONE={self.flags}",
            "-DCMAKE_BUILD_TYPE=None",
            "-DPENDULA_BITS=ON",
            "-DPENDULA_PROGRAM=OFF",
        ]
        shared = f"-DBUILD_SHARED_LIBS={'ON' if self.is_shared else 'OFF'}"
        run("cmake", "-S", ROOT, "-B", self.directory, "-G", "Ninja", *how, *options, shared)
        run("cmake", "--build", self.directory, "-j", "2")
        return next(self.directory / name for name in ("golden", "golden.wasm") if (self.directory / name).exists())


GCC = Build("g++", "-O2")
NATIVE = [
    GCC,
    Build("g++", "-O0"),
    Build("g++", "-O3 -march=x86-64-v3"),
    Build("clang++-19", "-O0"),
    Build("clang++-19", "-O2"),
    Build("clang++-19", "-O3"),
]
SHARED = [Build("g++", "-O3", is_shared=True), Build("clang++-19", "-O1", is_shared=True)]
# Flags of a user that the build takes back.
FAST = [Build("g++", "-O2 -ffast-math"), Build("clang++-19", "-O2 -ffast-math")]
AARCH64 = Build("aarch64-linux-gnu-g++", "-O2", "aarch64")
WASM32 = Build("clang++-19", "-O2", "wasm32")


def attempt(*command: str | Path, **environment: str) -> subprocess.CompletedProcess[str]:
    """A command that may fail, in an environment that names no instruction set unless it is given one."""
    clean = {name: value for name, value in os.environ.items() if name != "PENDULA_ISA"}
    return subprocess.run([*map(str, command)], capture_output=True, text=True, env=clean | environment)


def run(*command: str | Path, **environment: str) -> str:
    """The standard output of a command that must succeed."""
    done = attempt(*command, **environment)
    assert done.returncode == 0, f"{command}:\n{done.stdout}{done.stderr}"
    return done.stdout


def instruction_sets() -> list[str]:
    """Those of the kernels' sets that this processor has, the widest last."""
    info = Path("/proc/cpuinfo")
    flags = set(info.read_text().split()) if info.exists() else set()
    return ["baseline"] + [name for name, flag in {"avx2": "avx2", "avx512": "avx512dq"}.items() if flag in flags]


def missing(*programs: str) -> str:
    return ", ".join(program for program in programs if not shutil.which(program))


if __name__ == "__main__":
    GOLDEN.write_text(run(GCC.make()))
