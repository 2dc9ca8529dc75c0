"""The builds of `golden` that must agree, and how each is run. As a program it rewrites golden.txt after an intended change."""

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

    def __str__(self):
        return " ".join(filter(None, (self.compiler, self.flags, self.toolchain)))

    @property
    def directory(self):
        return ROOT / "build" / "bits" / str(self).replace(" ", "")

    def make(self):
        """Builds `golden` and returns its path."""
        how = [f"--toolchain={ROOT / 'cmake' / self.toolchain}.cmake"] if self.toolchain else [f"-DCMAKE_CXX_COMPILER={self.compiler}"]
        options = [f"-DCMAKE_CXX_FLAGS_NONE={self.flags}", "-DCMAKE_BUILD_TYPE=None", "-DPENDULA_BITS=ON", "-DPENDULA_PROGRAM=OFF"]
        run("cmake", "-S", ROOT, "-B", self.directory, "-G", "Ninja", *how, *options)
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
AARCH64 = Build("aarch64-linux-gnu-g++", "-O2", "aarch64")
WASM32 = Build("clang++-19", "-O2", "wasm32")


def run(*command, **environment):
    """The standard output of a command that must succeed."""
    done = subprocess.run([*map(str, command)], capture_output=True, text=True, env={**os.environ, **environment})
    assert done.returncode == 0, f"{command}:\n{done.stdout}{done.stderr}"
    return done.stdout


def instruction_sets():
    """Those of the kernels' sets that this processor has."""
    info = Path("/proc/cpuinfo")
    flags = set(info.read_text().split()) if info.exists() else set()
    return ["baseline"] + [name for name, flag in {"avx2": "avx2", "avx512": "avx512dq"}.items() if flag in flags]


def missing(*programs):
    return ", ".join(program for program in programs if not shutil.which(program))


if __name__ == "__main__":
    GOLDEN.write_text(run(GCC.make()))
