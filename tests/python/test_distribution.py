"""What people install: one version, types, no warnings, and a README that tells the truth."""

import importlib.metadata
import io
import os
import re
import subprocess
import sys
import tarfile
import venv
import zipfile
from contextlib import redirect_stdout
from pathlib import Path

import numpy as np
import pendula
import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path.append(str(ROOT / "tools"))
import make_python_tables  # noqa: E402

READMES = [ROOT / "README.md", ROOT / "README.es.md"]


def run(*command, cwd=ROOT):
    done = subprocess.run([*map(str, command)], cwd=cwd, capture_output=True, text=True, timeout=1800)
    assert done.returncode == 0, f"{command}:\n{done.stdout}{done.stderr}"
    return done.stdout + done.stderr


def test_the_version_is_one(program):
    stated = re.search(r"project\(pendula VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text())[1]
    assert pendula.__version__ == importlib.metadata.version("pendula") == stated
    assert program("--version") == f"pendula {stated}\n"


def test_numpy_is_the_only_hard_dependency():
    requirements = importlib.metadata.requires("pendula")
    assert [re.match(r"\w+", each)[0] for each in requirements if "extra ==" not in each] == ["numpy"]
    assert set(importlib.metadata.metadata("pendula").get_all("Provides-Extra")) == {"pandas", "plot", "xarray", "all"}


def test_optional_packages_are_imported_only_where_used():
    loaded = "import sys, pendula; pendula.solve(1.0, 0.0); print(*{'matplotlib', 'xarray', 'scipy'} & set(sys.modules))"
    assert run(sys.executable, "-W", "error", "-c", loaded).strip() == ""


USERS = """
import pendula
angle: float = pendula.exact(1.0, 0.0, 1.0)[0]
regime: pendula.Regime = pendula.analyze(1.0, 0.0).regime
shape: tuple[int, ...] = pendula.solve([1.0, 2.0], 0.0, pivot_amplitude=[3.0, 4.0], drive_frequency=1).theta.shape
exponents = pendula.measure.lyapunov(0.1, 0.0, beta=0.5, periods=30).exponent + 1.0
"""


def test_users_code_has_types(tmp_path):
    pytest.importorskip("mypy")
    command = [
        sys.executable,
        "-m",
        "mypy",
        "--strict",
        "--cache-dir",
        ROOT / "build/mypy",
        "--python-executable",
        sys.executable,
    ]
    (tmp_path / "right.py").write_text(USERS)
    run(*command, tmp_path / "right.py", cwd=tmp_path)
    (tmp_path / "wrong.py").write_text(
        "import pendula\npendula.solve(1.0, 0.0, gamma=1.0)\npendula.measure.section(1.0, 0.0, rows=2)\n"
    )
    done = subprocess.run([*map(str, command), "wrong.py"], cwd=tmp_path, capture_output=True, text=True, timeout=600)
    assert re.findall(r'Unexpected keyword argument "(\w+)"', done.stdout) == ["gamma", "rows"]


@pytest.mark.parametrize("name", make_python_tables.FILES)
def test_what_is_made_of_the_cores_tables_is_committed(name):
    pytest.importorskip("ruff")
    assert make_python_tables.FILES[name]() == (make_python_tables.PACKAGE / name).read_text(encoding="utf-8")


@pytest.mark.parametrize("readme", READMES, ids=lambda path: path.name)
def test_a_readmes_example_prints_what_it_says(readme):
    example = re.search(r"```python\n(.*?)```", readme.read_text(), re.DOTALL)[1]
    printed = io.StringIO()
    with redirect_stdout(printed):
        exec(compile(example, readme.name, "exec"), {})
    assert printed.getvalue().splitlines() == re.findall(r"^print.*  # (.*)$", example, re.MULTILINE)


@pytest.fixture(scope="module")
def distributions(tmp_path_factory):
    """(sdist, wheel), the wheel built from the sdist as `python -m build` does, and what it had to say."""
    pytest.importorskip("build")
    folder = tmp_path_factory.mktemp("dist")
    said = run(sys.executable, "-m", "build", "--no-isolation", "--outdir", folder, ROOT)
    return next(folder.glob("*.tar.gz")), next(folder.glob("*.whl")), said


def test_building_gives_no_warnings(distributions):
    assert not re.search(r"warning|deprecat", distributions[2], re.IGNORECASE)


def test_distributions_hold_what_they_should(distributions):
    sdist, wheel, _ = distributions
    with tarfile.open(sdist) as archive:
        sources = {"/".join(name.split("/")[1:]) for name in archive.getnames()}
    with zipfile.ZipFile(wheel) as archive:
        installed = set(archive.namelist())
    assert {"pyproject.toml", "CMakeLists.txt", "LICENSE", "include/pendula/exact.hpp", "python/pendula/py.typed"} <= sources
    assert not any(name.startswith((".ci", "build", ".venv", ".stamps")) for name in sources)
    assert {"pendula/py.typed", "pendula/_core.pyi"} <= installed
    assert any(name.endswith(".data/scripts/pendula") for name in installed)
    assert not any(name.endswith((".hpp", ".cmake", ".a")) for name in installed)


def test_a_wheel_serves_a_fresh_environment(distributions, tmp_path):
    venv.create(tmp_path, with_pip=True)
    run(tmp_path / "bin/pip", "install", "--quiet", distributions[1])
    assert run(tmp_path / "bin/pendula", "--version") == f"pendula {pendula.__version__}\n"
    angle = run(tmp_path / "bin/python", "-W", "error", "-c", "import pendula; print(pendula.exact(1.0, 0.5, 2.0)[0].hex())")
    assert angle.strip() == np.float64(pendula.exact(1.0, 0.5, 2.0)[0]).hex()


@pytest.mark.parametrize("name", ["nosuch", ""])
def test_a_wrong_instruction_set_stops_the_import(name):
    done = subprocess.run(
        [sys.executable, "-c", "import pendula"],
        env=os.environ | {"PENDULA_ISA": name},
        capture_output=True,
        text=True,
        timeout=60,
    )
    assert done.returncode == 1
    assert "ImportError: PENDULA_ISA must be one of the instruction sets of this processor" in done.stderr
